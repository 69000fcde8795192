// SPDX-License-Identifier: MIT
#include "core/annotation/raters.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/median.h"
#include "core/numeric/random.h"

namespace core {

namespace {

/// Differences first - second of one joint, or of all.
Agreement agreementOf(const std::vector<Eigen::Vector3d>& differences) {
    Agreement agreement;
    agreement.count = static_cast<int>(differences.size());
    if (differences.empty())
        return agreement;
    const double n = agreement.count;
    std::vector<double> distances;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& difference : differences) {
        distances.push_back(difference.norm());
        agreement.meanMm += difference.norm() / n;
        agreement.maxMm = std::max(agreement.maxMm, difference.norm());
        mean += difference / n;
    }
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& difference : differences)
        squares += (difference - mean).cwiseAbs2();
    for (int axis = 0; axis < 3; ++axis)
        agreement.axes[axis] = {mean[axis], agreement.count > 1 ? std::sqrt(squares[axis] / (n - 1)) : 0};
    agreement.medianMm = medianOf(std::move(distances));
    return agreement;
}

void compareClicks(const AnnotationSet& set, RaterComparison& comparison) {
    double sum = 0;
    for (const auto& [key, mark] : set.marks) {
        if (key.rater != comparison.first || !mark.isEvidence())
            continue;
        const auto other = markAt(set, {key.frame, comparison.second, key.joint, key.camera});
        if (other && other->isEvidence()) {
            sum += (mark.px - other->px).squaredNorm();
            ++comparison.clicks;
        }
    }
    comparison.clickRmsPx = comparison.clicks > 0 ? std::sqrt(sum / comparison.clicks) : 0;
}

RaterComparison compared(const AnnotationSet& set, const std::string& first, const SequencePoints& firstPoints,
                         const std::string& second, const SequencePoints& secondPoints) {
    std::vector<Eigen::Vector3d> all;
    std::map<JointId, std::vector<Eigen::Vector3d>> byJoint;
    for (const auto& [frame, joints] : firstPoints) {
        const auto others = secondPoints.find(frame);
        for (const auto& [id, point] : joints) {
            if (others != secondPoints.end() && others->second.contains(id)) {
                const Eigen::Vector3d difference = point.pointInWorld - others->second.at(id).pointInWorld;
                all.push_back(difference);
                byJoint[id].push_back(difference);
            }
        }
    }
    RaterComparison comparison{first, second, agreementOf(all), {}};
    for (const auto& [id, differences] : byJoint)
        comparison.byJoint[id] = agreementOf(differences);
    compareClicks(set, comparison);
    return comparison;
}

} // namespace

std::optional<RaterComparison> compareRaters(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                             const std::string& first, const std::string& second,
                                             const TriangulationOptions& options) {
    auto comparison = compared(set, first, sequencePoints(set, cameras, first, options), second,
                               sequencePoints(set, cameras, second, options));
    const bool shareNothing = comparison.all.count == 0 && comparison.clicks == 0;
    return shareNothing ? std::nullopt : std::optional(std::move(comparison));
}

std::vector<RaterComparison> compareAllRaters(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                              const ClickSigmas& sigmas) {
    std::map<std::string, SequencePoints> points;
    for (const std::string& rater : ratersOf(set))
        points[rater] = sequencePoints(set, cameras, rater, sigmas.optionsFor(rater));
    return compareAllRaters(set, points);
}

std::vector<RaterComparison> compareAllRaters(const AnnotationSet& set,
                                              const std::map<std::string, SequencePoints>& points) {
    std::vector<RaterComparison> comparisons;
    for (auto first = points.begin(); first != points.end(); ++first) {
        for (auto second = std::next(first); second != points.end(); ++second) {
            auto comparison = compared(set, first->first, first->second, second->first, second->second);
            if (comparison.all.count > 0 || comparison.clicks > 0)
                comparisons.push_back(std::move(comparison));
        }
    }
    return comparisons;
}

namespace {

/// Clicks of one camera share its systematic error q: k of them, each with the variance s^2 + k q^2, have a mean with
/// the variance s^2 / k + q^2.
void shareSystematicError(std::vector<Observation>& observations, const ClickSigmas& sigmas) {
    std::map<int, int> clicks;
    for (const Observation& observation : observations)
        ++clicks[observation.camera];
    for (Observation& observation : observations) {
        const auto camera = static_cast<std::size_t>(observation.camera);
        if (camera < sigmas.systematicPx.size())
            observation.sigmaPx = std::hypot(observation.sigmaPx,
                                             std::sqrt(clicks[observation.camera] - 1.0) * sigmas.systematicPx[camera]);
    }
}

} // namespace

Consensus consensus(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const JointId& joint,
                    const ClickSigmas& sigmas, const TriangulationOptions& options) {
    Consensus result;
    std::vector<Observation> observations;
    TriangulationOptions together = options;
    for (const auto& [key, mark] : marksOfFrame(set, frame)) {
        const auto camera = std::find_if(cameras.begin(), cameras.end(),
                                         [&name = key.camera](const Camera& c) { return c.name == name; });
        if (key.joint != joint || camera == cameras.end() || !isEvidenceIn(mark, *camera))
            continue;
        const auto index = static_cast<int>(camera - cameras.begin());
        const TriangulationOptions own = sigmas.optionsFor(key.rater, options);
        observations.push_back({index, mark.px, own.sigmaOf(index)});
        together.isSigmaAssumed = together.isSigmaAssumed || own.isSigmaAssumed;
        result.clicks.push_back({key.rater, key.camera, mark.px, 0, false});
    }
    shareSystematicError(observations, sigmas);
    result.result = triangulate(cameras, observations, together);
    for (std::size_t k = 0; result.result.point && k < result.clicks.size(); ++k) {
        result.clicks[k].errorPx = result.result.point->residualPx[k];
        result.clicks[k].outlier = !result.result.point->inlier[k];
    }
    return result;
}

std::vector<RepeatTask> drawRepeatTasks(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                        const std::string& rater, double share, unsigned seed,
                                        const TriangulationOptions& options) {
    std::vector<RepeatTask> finished;
    for (const auto& [frame, joints] : sequencePoints(set, cameras, rater, options))
        for (const auto& [id, point] : joints)
            finished.push_back({frame, id});
    const int size = static_cast<int>(finished.size());
    const int count = std::clamp(static_cast<int>(std::lround(share * size)), std::min(1, size), size);
    RandomGenerator random(seed);
    std::vector<RepeatTask> tasks;
    for (const int index : sampleWithoutReplacement(size, count, random))
        tasks.push_back(finished[static_cast<std::size_t>(index)]);
    return tasks;
}

namespace {

constexpr std::string_view kAgain = " (again)";

} // namespace

std::string repeatRaterName(const std::string& rater) {
    return rater + std::string(kAgain);
}
bool isRepeatRater(const std::string& rater) {
    return rater.ends_with(kAgain);
}
std::string ownRaterName(const std::string& rater) {
    return isRepeatRater(rater) ? rater.substr(0, rater.size() - kAgain.size()) : rater;
}

std::vector<RaterWork> raterWork(const AnnotationSet& set) {
    std::map<std::string, RaterWork> work;
    std::map<std::string, int> lastFrames;
    for (const auto& [key, mark] : set.marks) { // by frame
        if (!mark.isSettled())
            continue;
        RaterWork& own = work[key.rater];
        own.rater = key.rater;
        ++own.marks;
        const auto [last, isFirst] = lastFrames.emplace(key.rater, key.frame);
        own.frames += isFirst || last->second != key.frame ? 1 : 0;
        last->second = key.frame;
    }
    std::vector<RaterWork> list;
    for (const auto& [rater, own] : work)
        list.push_back(own);
    return list;
}

} // namespace core
