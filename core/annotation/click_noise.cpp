// SPDX-License-Identifier: MIT
#include "core/annotation/click_noise.h"

#include <algorithm>
#include <cmath>

#include "core/annotation/reconstruction.h"

namespace core {

namespace {

/// The clicks of one joint in one frame.
using Clicks = std::vector<Observation>;

std::vector<Clicks> collectClicks(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                  const std::string& rater) {
    std::map<std::string, int> cameraIndex;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        cameraIndex[cameras[i].name] = static_cast<int>(i);
    std::vector<Clicks> all;
    const MarkKey* before = nullptr;
    for (const auto& [key, mark] : set.marks) {
        const auto camera = cameraIndex.find(key.camera);
        if (key.rater != rater || camera == cameraIndex.end() ||
            !isEvidenceIn(mark, cameras[static_cast<std::size_t>(camera->second)]))
            continue;
        if (!before || before->frame != key.frame || before->joint != key.joint)
            all.emplace_back();
        before = &key;
        all.back().push_back({camera->second, mark.px});
    }
    return all;
}

/// Sums over the residuals of one camera, or of all.
struct Sum {
    double squaredPx2 = 0;
    double freedom = 0; ///< expected squared residual in units of sigma^2
    int clicks = 0;

    std::optional<double> sigma() const {
        return freedom > 0.5 ? std::optional(std::sqrt(squaredPx2 / freedom)) : std::nullopt;
    }
};

struct Round {
    Sum all;
    std::map<std::string, Sum> byCamera;
    int joints = 0;
    int outliers = 0;
};

void addJoint(Round& round, const std::vector<Camera>& cameras, const Clicks& clicks, const TriangulatedPoint& point,
              double sigmaPx) {
    for (std::size_t k = 0; k < clicks.size(); ++k) {
        if (!point.inlier[k]) {
            ++round.outliers;
            continue;
        }
        const Camera& camera = cameras[static_cast<std::size_t>(clicks[k].camera)];
        const auto projection = projectWithJacobian(camera, point.pointInWorld);
        const Matrix23d& jacobian = projection->pxByPointInWorld;
        const double leverage = (jacobian * point.covariance * jacobian.transpose()).trace() / (sigmaPx * sigmaPx);
        for (Sum* sum : {&round.all, &round.byCamera[camera.name]}) {
            sum->squaredPx2 += point.residualPx[k] * point.residualPx[k];
            sum->freedom += 2 - leverage;
            ++sum->clicks;
        }
    }
    ++round.joints;
}

Round measure(const std::vector<Camera>& cameras, const std::vector<Clicks>& all, const TriangulationOptions& options) {
    Round round;
    for (const Clicks& clicks : all) {
        const auto result = triangulate(cameras, clicks, options);
        if (result.point && std::count(result.point->inlier.begin(), result.point->inlier.end(), true) >= 3)
            addJoint(round, cameras, clicks, *result.point, options.sigmaPx);
    }
    return round;
}

} // namespace

std::optional<ClickNoise> estimateClickNoise(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                             const std::string& rater, const TriangulationOptions& options,
                                             double startSigmaPx, int leastJoints) {
    const std::vector<Clicks> clicks = collectClicks(set, cameras, rater);
    TriangulationOptions current = options;
    current.sigmaPx = startSigmaPx;
    constexpr int kMaxRounds = 12;
    constexpr double kLeastSigmaPx = 0.02; // exact clicks of a script
    Round round;
    for (int i = 0; i < kMaxRounds; ++i) {
        round = measure(cameras, clicks, current);
        const auto sigma = round.all.sigma();
        if (!sigma || round.joints < leastJoints)
            return std::nullopt;
        const double next = std::max(*sigma, kLeastSigmaPx);
        const bool isSettled = std::abs(next - current.sigmaPx) < 1e-3 * next;
        current.sigmaPx = next;
        if (isSettled)
            break;
    }
    ClickNoise noise{*round.all.sigma(), {}, round.all.clicks, round.all.freedom, round.outliers};
    constexpr int kLeastClicksPerCamera = 10;
    for (const auto& [camera, sum] : round.byCamera)
        if (sum.clicks >= kLeastClicksPerCamera && sum.sigma())
            noise.sigmaPxByCamera[camera] = *sum.sigma();
    return noise;
}

} // namespace core
