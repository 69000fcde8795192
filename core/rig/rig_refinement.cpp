// SPDX-License-Identifier: MIT
#include "core/rig/rig_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <ceres/ceres.h>

#include "core/numeric/median.h"

namespace core {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// (projected - clicked) / sigma by the camera's correction and the point.
class ClickCost : public ceres::SizedCostFunction<2, 9, 3> {
public:
    ClickCost(const Camera& camera, const Eigen::Vector2d& px, double sigmaPx)
        : m_camera(camera)
        , m_px(px)
        , m_sigmaPx(sigmaPx) {}

    bool Evaluate(double const* const* unknowns, double* residual, double** jacobians) const override {
        const CameraCorrection correction = Eigen::Map<const CameraCorrection>(unknowns[0]);
        const Eigen::Vector3d point = Eigen::Map<const Eigen::Vector3d>(unknowns[1]);
        const auto projection = projectWithJacobian(corrected(m_camera, correction), point);
        if (!projection)
            return false;
        Eigen::Map<Eigen::Vector2d>{residual} = (projection->px - m_px) / m_sigmaPx;
        if (jacobians && jacobians[0]) {
            Eigen::Map<Eigen::Matrix<double, 2, 9, Eigen::RowMajor>>{jacobians[0]} =
                *pxByCorrection(m_camera, correction, point) / m_sigmaPx;
        }
        if (jacobians && jacobians[1]) {
            Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>>{jacobians[1]} =
                projection->pxByPointInWorld / m_sigmaPx;
        }
        return true;
    }

private:
    const Camera& m_camera;
    Eigen::Vector2d m_px;
    double m_sigmaPx;
};

/// Each unknown over its prior's standard deviation.
class PriorCost : public ceres::SizedCostFunction<9, 9> {
public:
    explicit PriorCost(const CameraCorrection& sigma)
        : m_sigma(sigma) {}

    bool Evaluate(double const* const* unknowns, double* residual, double** jacobians) const override {
        const Eigen::Map<const CameraCorrection> correction(unknowns[0]);
        Eigen::Map<CameraCorrection>{residual} = correction.cwiseQuotient(m_sigma);
        if (jacobians && jacobians[0]) {
            Eigen::Map<Eigen::Matrix<double, 9, 9, Eigen::RowMajor>>{jacobians[0]} =
                m_sigma.cwiseInverse().asDiagonal();
        }
        return true;
    }

private:
    CameraCorrection m_sigma;
};

class StopCallback : public ceres::IterationCallback {
public:
    explicit StopCallback(std::stop_token stop)
        : m_stop(std::move(stop)) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return m_stop.stop_requested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

private:
    std::stop_token m_stop;
};

/// The adjustment and its unknowns.
class Bundle {
public:
    Bundle(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints, const RigResiduals& residuals,
           const RigRefinementOptions& options)
        : m_cameras(cameras)
        , m_joints(joints)
        , m_options(options)
        , m_corrections(cameras.size(), CameraCorrection::Zero())
        , m_start(residuals)
        , m_points(m_start.pointInWorld) {
        m_left.resize(joints.size());
        for (std::size_t j = 0; j < joints.size(); ++j)
            m_left[j].assign(joints[j].clicks.size(), false);
    }

    ceres::Solver::Summary solve(double sigmaPx, std::stop_token stop) {
        ceres::Problem problem;
        auto* ordering = new ceres::ParameterBlockOrdering;
        addClicks(problem, *ordering, sigmaPx);
        addPriors(problem, *ordering);
        ceres::Solver::Options options;
        options.linear_solver_type = ceres::DENSE_SCHUR;
        options.linear_solver_ordering.reset(ordering);
        options.num_threads = 1; // more would sum in another order
        options.max_num_iterations = m_options.maxIterations;
        options.function_tolerance = m_options.functionTolerance;
        options.logging_type = ceres::SILENT;
        StopCallback callback(std::move(stop));
        options.callbacks.push_back(&callback);
        ceres::Solver::Summary summary;
        ceres::Solve(options, &problem, &summary);
        return summary;
    }

    /// Robust scatter per axis of the clicks in use: the median of r^2 over that of chi^2 with two degrees of freedom,
    /// and for the unknowns that were fitted.
    double sigmaPx() const {
        std::vector<double> squares;
        double unknowns = 6.0 * static_cast<double>(m_cameras.size());
        for (std::size_t j = 0; j < m_joints.size(); ++j) {
            unknowns += isUsed(j) ? 3 : 0;
            for (std::size_t k = 0; isUsed(j) && k < m_left[j].size(); ++k)
                squares.push_back(residual(j, k).squaredNorm());
        }
        const double share = 1 - unknowns / (2.0 * static_cast<double>(squares.size()));
        constexpr double kLeastSigmaPx = 0.02; // exact clicks of a script
        return std::max(kLeastSigmaPx, std::sqrt(medianOf(squares) / kMedianOfChiSquare2 / std::max(share, 0.1)));
    }

    /// Leaves out clicks beyond `gatePx`; returns how many.
    int leaveOut(double gatePx) {
        int count = 0;
        for (std::size_t j = 0; j < m_joints.size(); ++j) {
            for (std::size_t k = 0; isUsed(j) && k < m_left[j].size(); ++k) {
                m_left[j][k] = residual(j, k).norm() > gatePx;
                count += m_left[j][k];
            }
        }
        return count;
    }

    const RigResiduals& start() const { return m_start; }
    bool isUsed(std::size_t j) const { return m_points[j].allFinite(); }
    bool hasPoints() const {
        return std::any_of(
            m_points.begin(), m_points.end(), [](const auto& point) { return point.allFinite(); });
    }
    bool isLeftOut(std::size_t j, std::size_t k) const { return m_left[j][k]; }
    const Eigen::Vector3d& point(std::size_t j) const { return m_points[j]; }
    std::vector<Camera> cameras() const {
        std::vector<Camera> result;
        for (std::size_t c = 0; c < m_cameras.size(); ++c)
            result.push_back(corrected(m_cameras[c], m_corrections[c]));
        return result;
    }
    const CameraCorrection& correction(std::size_t c) const { return m_corrections[c]; }

    Eigen::Vector2d residual(std::size_t j, std::size_t k) const {
        const Observation& click = m_joints[j].clicks[k];
        const auto c = static_cast<std::size_t>(click.camera);
        const auto px = project(corrected(m_cameras[c], m_corrections[c]), m_points[j]);
        return px ? Eigen::Vector2d(click.px - *px) : Eigen::Vector2d::Constant(1e6);
    }

private:
    void addClicks(ceres::Problem& problem, ceres::ParameterBlockOrdering& ordering, double sigmaPx) {
        for (std::size_t j = 0; j < m_joints.size(); ++j) {
            if (!isUsed(j))
                continue;
            bool isSeen = false;
            for (std::size_t k = 0; k < m_left[j].size(); ++k) {
                if (m_left[j][k])
                    continue;
                const Observation& click = m_joints[j].clicks[k];
                const auto c = static_cast<std::size_t>(click.camera);
                problem.AddResidualBlock(new ClickCost(m_cameras[c], click.px, sigmaPx),
                                         new ceres::HuberLoss(m_options.robustFactor), m_corrections[c].data(),
                                         m_points[j].data());
                isSeen = true;
            }
            if (isSeen)
                ordering.AddElementToGroup(m_points[j].data(), 0);
        }
    }
    void addPriors(ceres::Problem& problem, ceres::ParameterBlockOrdering& ordering) {
        CameraCorrection sigma;
        sigma << Eigen::Vector3d::Constant(m_options.turnDeg * kRadPerDeg),
            Eigen::Vector3d::Constant(m_options.shiftMm), m_options.focalShare, m_options.distortion,
            m_options.distortion;
        for (CameraCorrection& correction : m_corrections) {
            problem.AddResidualBlock(new PriorCost(sigma), nullptr, correction.data());
            ordering.AddElementToGroup(correction.data(), 1);
        }
    }

    const std::vector<Camera>& m_cameras;
    const std::vector<RigJoint>& m_joints;
    const RigRefinementOptions& m_options;
    std::vector<CameraCorrection> m_corrections;
    const RigResiduals& m_start;           // with the cameras as given
    std::vector<Eigen::Vector3d> m_points; // NaN where a joint takes no part
    std::vector<std::vector<bool>> m_left; // clicks that are left out, parallel to the joints' clicks
};

/// Puts the rig as a whole back: the spread of the centres is that of `before`, the rotation between both is the one
/// that takes centres and viewing axes nearest to theirs (Umeyama 1991), and the middle of the clicked joints stays
/// where most cameras saw it (`meanFrom` goes to `meanTo`): a camera's centre is known less well than the rays that
/// meet in a joint. Projections of points that are transformed alike do not change.
void keepGauge(const std::vector<Camera>& before, std::vector<Camera>& after, const Eigen::Vector3d& meanFrom,
               const Eigen::Vector3d& meanTo) {
    Eigen::Vector3d meanBefore = Eigen::Vector3d::Zero(), meanAfter = Eigen::Vector3d::Zero();
    const double count = static_cast<double>(before.size());
    for (std::size_t c = 0; c < before.size(); ++c) {
        meanBefore += before[c].centreInWorld() / count;
        meanAfter += after[c].centreInWorld() / count;
    }
    Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
    double spreadBefore = 0, spreadAfter = 0;
    for (std::size_t c = 0; c < before.size(); ++c) {
        const Eigen::Vector3d from = after[c].centreInWorld() - meanAfter, to = before[c].centreInWorld() - meanBefore;
        spreadBefore += to.squaredNorm();
        spreadAfter += from.squaredNorm();
        correlation += to * from.transpose() / std::max(to.squaredNorm(), 1e-12) +
                       before[c].cameraFromWorld.rotation.transpose() * after[c].cameraFromWorld.rotation;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    const Eigen::Matrix3d rotation =
        svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
    const double scale = spreadAfter > 1e-6 ? std::sqrt(spreadBefore / spreadAfter) : 1;
    for (Camera& camera : after) {
        const Eigen::Vector3d centre = scale * (rotation * (camera.centreInWorld() - meanFrom)) + meanTo;
        RigidMotion& motion = camera.cameraFromWorld;
        motion.rotation = motion.rotation * rotation.transpose();
        motion.translation = -(motion.rotation * centre);
    }
}

/// The place for `before` of a point of `after`: the one whose projections differ least from those of `pointInAfter`,
/// robust against a camera that moved far.
Eigen::Vector3d samePlace(const std::vector<Camera>& before, const std::vector<Camera>& after,
                          const Eigen::Vector3d& pointInAfter, const Eigen::Vector3d& start) {
    std::vector<Observation> sight;
    for (std::size_t c = 0; c < after.size(); ++c)
        if (const auto px = project(after[c], pointInAfter))
            sight.push_back({static_cast<int>(c), *px});
    Eigen::Vector3d place = start;
    constexpr double kAgreePx = 3; // beyond, a camera counts linearly (Huber)
    constexpr int kRounds = 10;
    for (int i = 0; i < kRounds; ++i) {
        for (Observation& view : sight) {
            const auto px = project(before[static_cast<std::size_t>(view.camera)], place);
            view.sigmaPx = std::sqrt(px ? std::max((*px - view.px).norm() / kAgreePx, 1.0) : 1e6);
        }
        const auto next = refinePoint(before, sight, place);
        if (!next)
            return start;
        place = *next;
    }
    return place;
}

double rms(double sumOfSquares, int count) {
    return count > 0 ? std::sqrt(sumOfSquares / count) : kNan;
}

std::vector<CameraRefinement> changesOf(const std::vector<Camera>& before, const std::vector<RigJoint>& joints,
                                        const Bundle& bundle, const RigRefinement& refinement) {
    std::vector<CameraRefinement> changes(before.size());
    std::vector<double> squaresBefore(before.size(), 0), squaresAfter(before.size(), 0);
    std::vector<int> used(before.size(), 0);
    for (const RigResidual& click : bundle.start().clicks) {
        const auto c = static_cast<std::size_t>(click.camera);
        squaresBefore[c] += click.residualPx.squaredNorm();
        ++changes[c].clicks;
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
        for (std::size_t k = 0; bundle.isUsed(j) && k < joints[j].clicks.size(); ++k) {
            const auto c = static_cast<std::size_t>(joints[j].clicks[k].camera);
            if (!bundle.isLeftOut(j, k)) {
                squaresAfter[c] += bundle.residual(j, k).squaredNorm();
                ++used[c];
            }
        }
    }
    for (std::size_t c = 0; c < before.size(); ++c) {
        const Camera& after = refinement.cameras[c];
        CameraRefinement& change = changes[c];
        change.camera = before[c].name;
        change.beforeRmsPx = rms(squaresBefore[c], changes[c].clicks);
        change.afterRmsPx = rms(squaresAfter[c], used[c]);
        change.turnDeg =
            rotationLog(after.cameraFromWorld.rotation * before[c].cameraFromWorld.rotation.transpose()).norm() /
            kRadPerDeg;
        change.shiftMm = (after.centreInWorld() - before[c].centreInWorld()).norm();
        change.focalShare = after.intrinsics(0, 0) / before[c].intrinsics(0, 0) - 1;
    }
    return changes;
}

bool isEnough(const std::vector<RigJoint>& joints, const RigRefinementOptions& options) {
    std::set<int> seen;
    for (const RigJoint& joint : joints)
        for (const Observation& click : joint.clicks)
            seen.insert(click.camera);
    return seen.size() >= 3 && countWellSeenJoints(joints) >= options.leastJoints;
}

} // namespace

std::optional<Eigen::Matrix3d> worldCovariance(const std::vector<Camera>& given, const ClickSigmas& sigmas,
                                               const Eigen::Vector3d& middleInWorld) {
    if (sigmas.systematicPx.size() != given.size())
        return std::nullopt;
    TriangulationOptions options;
    constexpr double kLeastPx = 1e-3; // an exact rig
    std::vector<Observation> sight;
    for (std::size_t c = 0; c < given.size(); ++c) {
        options.sigmaPxByCamera.push_back(std::max(kLeastPx, sigmas.systematicPx[c]));
        if (project(given[c], middleInWorld))
            sight.push_back({static_cast<int>(c), {}});
    }
    bool isFixed = false;
    Eigen::Matrix3d covariance;
    triangulationInformation(given, sight, middleInWorld, options).computeInverseWithCheck(covariance, isFixed, 1e-24);
    return isFixed ? std::optional(covariance) : std::nullopt;
}

int countWellSeenJoints(const std::vector<RigJoint>& joints) {
    return static_cast<int>(std::count_if(
        joints.begin(), joints.end(), [](const RigJoint& joint) { return joint.clicks.size() >= 3; }));
}

std::optional<RigRefinement> refineRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                                       const RigRefinementOptions& options, std::stop_token stop) {
    if (!isEnough(joints, options))
        return std::nullopt;
    return refineRig(cameras, joints, computeRigResiduals(cameras, joints), options, std::move(stop));
}

std::optional<RigRefinement> refineRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                                       const RigResiduals& residuals, const RigRefinementOptions& options,
                                       std::stop_token stop) {
    if (!isEnough(joints, options))
        return std::nullopt;
    Bundle bundle(cameras, joints, residuals, options);
    RigRefinement refinement;
    double sigmaPx = options.startSigmaPx;
    constexpr int kSolutions = 3;
    for (int i = 0; i < kSolutions; ++i) {
        if (!bundle.hasPoints())
            return std::nullopt;
        const ceres::Solver::Summary summary = bundle.solve(sigmaPx, stop);
        if (stop.stop_requested() || !summary.IsSolutionUsable())
            return std::nullopt;
        refinement.iterations += static_cast<int>(summary.iterations.size());
        refinement.converged = summary.termination_type == ceres::CONVERGENCE;
        sigmaPx = bundle.sigmaPx();
        constexpr double kWrongClick = 5; // sigma
        if (i + 1 < kSolutions)
            refinement.wrongClicks = bundle.leaveOut(kWrongClick * sigmaPx);
    }
    refinement.sigmaPx = sigmaPx;
    refinement.cameras = bundle.cameras();
    Eigen::Vector3d meanFrom = Eigen::Vector3d::Zero(), meanTo = Eigen::Vector3d::Zero();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (bundle.isUsed(j)) {
            ++refinement.joints;
            meanFrom += bundle.point(j);
            meanTo += bundle.start().pointInWorld[j];
        }
    }
    meanFrom /= refinement.joints;
    refinement.middleInWorld = samePlace(cameras, refinement.cameras, meanFrom, meanTo / refinement.joints);
    keepGauge(cameras, refinement.cameras, meanFrom, refinement.middleInWorld);
    refinement.frames = countFrames(joints);
    refinement.changes = changesOf(cameras, joints, bundle, refinement);
    return refinement;
}

} // namespace core
