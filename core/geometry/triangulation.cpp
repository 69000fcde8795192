// SPDX-License-Identifier: MIT
#include "core/geometry/triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace core {

namespace {

/// One observation, ready for use.
struct View {
    const Camera* camera = nullptr;
    int cameraIndex = 0;
    Eigen::Vector2d px;
    double weight = 1;      ///< 1 / sigma^2, 1/px^2
    double gatePx2 = 0;     ///< squared residual above which it is an outlier
    Eigen::Vector3d centre; ///< of the camera, mm
    Eigen::Vector3d direction;
    bool hasRay = false;
};

constexpr double kUnseen = std::numeric_limits<double>::infinity();

double sigmaOf(const Observation& observation, const TriangulationOptions& options) {
    return observation.sigmaPx > 0 ? observation.sigmaPx : options.sigmaOf(observation.camera);
}

std::vector<View> prepare(const std::vector<Camera>& cameras, const std::vector<Observation>& observations,
                          const TriangulationOptions& options) {
    std::vector<View> views;
    views.reserve(observations.size());
    for (const Observation& observation : observations) {
        View view;
        view.camera = &cameras.at(static_cast<std::size_t>(observation.camera));
        view.cameraIndex = observation.camera;
        view.px = observation.px;
        const double sigma = sigmaOf(observation, options);
        const double gatePx = std::max(options.outlierFactor * sigma, options.isSigmaAssumed ? kAssumedGatePx : 0);
        view.weight = 1 / (sigma * sigma);
        view.gatePx2 = gatePx * gatePx;
        view.centre = view.camera->centreInWorld();
        if (const auto ray = viewingRay(*view.camera, view.px)) {
            view.direction = ray->direction;
            view.hasRay = true;
        }
        views.push_back(view);
    }
    return views;
}

double squaredResidual(const View& view, const Eigen::Vector3d& point) {
    const auto px = project(*view.camera, point);
    return px ? (*px - view.px).squaredNorm() : kUnseen;
}

/// Cost in units of sigma^2 in which an outlier counts as much as a residual at the gate. Gives up above `enough`.
double truncatedCost(const std::vector<View>& views, const Eigen::Vector3d& point, double enough = kUnseen) {
    double cost = 0;
    for (const View& view : views) {
        cost += view.weight * std::min(squaredResidual(view, point), view.gatePx2);
        if (cost > enough)
            break;
    }
    return cost;
}

/// The least-squares problem of one point over chosen views.
struct Normal {
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    double cost = 0; ///< infinite if a view does not see the point
};

template <typename Chosen>
Normal normalEquations(const std::vector<View>& views, Chosen&& chosen, const Eigen::Vector3d& point) {
    Normal normal;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!chosen(i))
            continue;
        const View& view = views[i];
        const auto projection = projectWithJacobian(*view.camera, point);
        if (!projection) {
            normal.cost = kUnseen;
            return normal;
        }
        const Eigen::Vector2d residual = projection->px - view.px;
        const Matrix23d& jacobian = projection->pxByPointInWorld;
        normal.hessian.noalias() += view.weight * jacobian.transpose() * jacobian;
        normal.gradient.noalias() += view.weight * jacobian.transpose() * residual;
        normal.cost += view.weight * residual.squaredNorm();
    }
    return normal;
}

template <typename Chosen>
double costOf(const std::vector<View>& views, Chosen&& chosen, const Eigen::Vector3d& point) {
    double cost = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (chosen(i))
            cost += views[i].weight * squaredResidual(views[i], point);
    return cost;
}

/// Gauss-Newton with halved steps over the chosen views; empty if `start` is not in front of all of them or the views
/// leave a direction open. Ends when a step is below 1e-6 mm or no longer lowers the cost.
template <typename Chosen>
std::optional<Eigen::Vector3d> refine(const std::vector<View>& views, Chosen&& chosen, const Eigen::Vector3d& start,
                                      int maxIterations) {
    Eigen::Vector3d point = start;
    for (int iteration = 0; iteration < maxIterations; ++iteration) {
        const Normal normal = normalEquations(views, chosen, point);
        if (!std::isfinite(normal.cost))
            return std::nullopt;
        const Eigen::LDLT<Eigen::Matrix3d> solver(normal.hessian);
        Eigen::Vector3d step = -solver.solve(normal.gradient);
        if (solver.info() != Eigen::Success || !step.allFinite())
            return std::nullopt;
        constexpr double kSmallestStepMm = 1e-6; // the error left is smaller still: the steps shrink fast
        if (step.norm() < kSmallestStepMm)
            return point + step;
        constexpr int kMaxHalvings = 12;
        int halvings = 0;
        while (costOf(views, chosen, point + step) > normal.cost && halvings < kMaxHalvings) {
            step *= 0.5;
            ++halvings;
        }
        if (halvings == kMaxHalvings)
            return point; // no step lowers the cost: this is the minimum to rounding
        point += step;
    }
    return point;
}

/// The point half way between two rays, in front of both; empty if they are parallel or meet behind.
std::optional<Eigen::Vector3d> midpoint(const View& a, const View& b) {
    const Eigen::Vector3d between = b.centre - a.centre;
    const double cosine = a.direction.dot(b.direction);
    const double sine2 = 1 - cosine * cosine;
    if (!(sine2 > 1e-14))
        return std::nullopt;
    const double alongA = between.dot(a.direction), alongB = between.dot(b.direction);
    const double depthA = (alongA - cosine * alongB) / sine2;
    const double depthB = (cosine * alongA - alongB) / sine2;
    if (!(depthA > 0) || !(depthB > 0))
        return std::nullopt;
    return 0.5 * (a.centre + depthA * a.direction + b.centre + depthB * b.direction);
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// What the pairs of views proposed: the best point, or why there is none.
struct Proposal {
    std::optional<Eigen::Vector3d> point;
    TriangulationFailure failure = TriangulationFailure::None;
};

/// With few views every pair counts: its midpoint is moved to its least squares first. With more, some pair is good.
constexpr std::size_t kRefinedPairsViews = 4;
constexpr int kPairIterations = 2;

Proposal bestPair(const std::vector<View>& views, const TriangulationOptions& options) {
    Proposal best{std::nullopt, TriangulationFailure::FewerThanTwoViews};
    double bestCost = kUnseen;
    const auto atLeast = [&best](TriangulationFailure failure) {
        // The further a pair came, the better it explains why there is no answer.
        if (!best.point && best.failure != TriangulationFailure::BehindCamera)
            best.failure = failure;
    };
    for (std::size_t i = 0; i < views.size(); ++i) {
        for (std::size_t j = i + 1; j < views.size(); ++j) {
            const View &a = views[i], &b = views[j];
            if (a.cameraIndex == b.cameraIndex)
                continue;
            if (!a.hasRay || !b.hasRay) {
                atLeast(TriangulationFailure::OutsideLensModel);
                continue;
            }
            const double angle = angleBetween(a.direction, b.direction);
            if (!(std::min(angle, M_PI - angle) >= options.minAngleRad)) {
                atLeast(TriangulationFailure::RaysNearlyParallel);
                continue;
            }
            auto point = midpoint(a, b);
            if (!point) {
                atLeast(TriangulationFailure::BehindCamera);
                continue;
            }
            if (views.size() <= kRefinedPairsViews) {
                const auto isPair = [i, j](std::size_t k) { return k == i || k == j; };
                point = refine(views, isPair, *point, kPairIterations).value_or(*point);
            }
            const double cost = truncatedCost(views, *point, bestCost);
            if (cost < bestCost) {
                bestCost = cost;
                best = {point, {}};
            }
        }
    }
    return best;
}

std::vector<bool> inliersOf(const std::vector<View>& views, const Eigen::Vector3d& point) {
    std::vector<bool> inlier(views.size());
    for (std::size_t i = 0; i < views.size(); ++i)
        inlier[i] = squaredResidual(views[i], point) <= views[i].gatePx2;
    return inlier;
}

/// Widest angle between two inlying rays, folded into [0, pi/2].
double widestAngle(const std::vector<View>& views, const std::vector<bool>& inlier, const Eigen::Vector3d& point) {
    double widest = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        for (std::size_t j = i + 1; j < views.size(); ++j) {
            if (inlier[i] && inlier[j] && views[i].cameraIndex != views[j].cameraIndex) {
                const double angle = angleBetween(point - views[i].centre, point - views[j].centre);
                widest = std::max(widest, std::min(angle, M_PI - angle));
            }
        }
    }
    return widest;
}

/// Alternates between refining over the inliers and judging who is one, until they stay the same.
std::optional<Eigen::Vector3d> settle(const std::vector<View>& views, Eigen::Vector3d point,
                                      const TriangulationOptions& options) {
    std::vector<bool> inlier = inliersOf(views, point);
    Eigen::Vector3d best = point;
    double bestCost = truncatedCost(views, point);
    constexpr int kMaxRounds = 10;
    for (int round = 0; round < kMaxRounds; ++round) {
        if (std::count(inlier.begin(), inlier.end(), true) < 2)
            return std::nullopt;
        const auto refined = refine(
            views, [&](std::size_t k) { return inlier[k]; }, point, options.maxIterations);
        if (!refined)
            break;
        point = *refined;
        const double cost = truncatedCost(views, point);
        if (cost <= bestCost) {
            bestCost = cost;
            best = point;
        }
        std::vector<bool> next = inliersOf(views, point);
        if (next == inlier)
            return point;
        inlier = std::move(next);
    }
    return best;
}

TriangulatedPoint report(const std::vector<View>& views, const std::vector<bool>& inlier, const Eigen::Vector3d& point,
                         const TriangulationOptions& options) {
    TriangulatedPoint result;
    result.pointInWorld = point;
    result.inlier = inlier;
    double sum = 0, squares = 0;
    int used = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double residual2 = squaredResidual(views[i], point);
        result.residualPx.push_back(std::sqrt(residual2));
        if (inlier[i]) {
            sum += residual2;
            squares += views[i].weight * residual2;
            ++used;
        }
    }
    result.rmsPx = std::sqrt(sum / used);
    result.covariance = normalEquations(
                            views, [&](std::size_t k) { return inlier[k]; }, point)
                            .hessian.inverse();
    if (options.isSigmaAssumed)
        result.covariance *= misfitFactor(squares, 2.0 * used - 3);
    return result;
}

} // namespace

double misfitFactor(double squaresOverSigma2, double degreesOfFreedom) {
    constexpr double kAssumption = 4; // degrees of freedom that the assumed sigma counts for
    return std::max(1.0, (squaresOverSigma2 + kAssumption) / (degreesOfFreedom + kAssumption));
}

std::string_view failureText(TriangulationFailure failure) {
    switch (failure) {
    case TriangulationFailure::FewerThanTwoViews:
        return "fewer than two views";
    case TriangulationFailure::OutsideLensModel:
        return "a click lies where the lens model cannot be inverted";
    case TriangulationFailure::RaysNearlyParallel:
        return "rays are nearly parallel";
    case TriangulationFailure::BehindCamera:
        return "the rays meet behind a camera";
    case TriangulationFailure::ViewsDisagree:
        return "views disagree";
    case TriangulationFailure::None:
        break;
    }
    return "";
}

TriangulationResult triangulate(const std::vector<Camera>& cameras, const std::vector<Observation>& observations,
                                const TriangulationOptions& options) {
    const std::vector<View> views = prepare(cameras, observations, options);
    const Proposal proposal = bestPair(views, options);
    if (!proposal.point)
        return {std::nullopt, proposal.failure};
    const auto point = settle(views, *proposal.point, options);
    if (!point)
        return {std::nullopt, TriangulationFailure::ViewsDisagree};
    const std::vector<bool> inlier = inliersOf(views, *point);
    if (!(widestAngle(views, inlier, *point) >= options.minAngleRad)) {
        // Too few inliers, or all of one camera, or all from one direction.
        const bool severalCameras = std::count(inlier.begin(), inlier.end(), true) >= 2;
        return {std::nullopt,
                severalCameras ? TriangulationFailure::RaysNearlyParallel : TriangulationFailure::ViewsDisagree};
    }
    return {report(views, inlier, *point, options), {}};
}

Eigen::Matrix3d triangulationInformation(const std::vector<Camera>& cameras,
                                         const std::vector<Observation>& observations,
                                         const Eigen::Vector3d& pointInWorld, const TriangulationOptions& options) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (const Observation& observation : observations) {
        const auto projection =
            projectWithJacobian(cameras.at(static_cast<std::size_t>(observation.camera)), pointInWorld);
        if (projection) {
            const double sigma = sigmaOf(observation, options);
            information += projection->pxByPointInWorld.transpose() * projection->pxByPointInWorld / (sigma * sigma);
        }
    }
    return information;
}

std::optional<Eigen::Vector3d> refinePoint(const std::vector<Camera>& cameras,
                                           const std::vector<Observation>& observations, const Eigen::Vector3d& start,
                                           const TriangulationOptions& options) {
    const std::vector<View> views = prepare(cameras, observations, options);
    return refine(
        views, [](std::size_t) { return true; }, start, options.maxIterations);
}

} // namespace core
