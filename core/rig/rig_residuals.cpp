// SPDX-License-Identifier: MIT
#include "core/rig/rig_residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "core/numeric/median.h"

namespace core {

namespace {

constexpr double kLeastSpreadPx = 0.02; // exact clicks of a script
constexpr double kStartSpreadPx = 2;

bool isPlaced(const Eigen::Vector3d& point) {
    return point.allFinite();
}

/// A first place for a joint: robust with a wide gate, so that a camera that moved does no more than disagree.
Eigen::Vector3d startPoint(const std::vector<Camera>& cameras, const RigJoint& joint) {
    TriangulationOptions options;
    for (const double sigmaPx : {5.0, 40.0}) {
        options.sigmaPx = sigmaPx;
        if (const auto found = triangulate(cameras, joint.clicks, options).point)
            return found->pointInWorld;
    }
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

/// Gauss-Newton steps of a joint's point over all of its clicks, [first, last) of `clicks`, and what it leaves.
class JointAdjustment {
public:
    JointAdjustment(const std::vector<Camera>& cameras, RigResiduals& rig, std::size_t first, std::size_t last)
        : m_cameras(cameras)
        , m_rig(rig)
        , m_first(first)
        , m_last(last) {}

    /// False if the point left the front of a camera or is not fixed by its clicks.
    bool iterate(int steps) {
        for (int i = 0; i < steps; ++i) {
            if (!linearise())
                return false;
            point() += m_covariance * m_gradient;
        }
        return linearise();
    }

    /// Residuals with and without each view.
    void judge() {
        for (std::size_t k = m_first; k < m_last; ++k) {
            RigResidual& click = m_rig.clicks[k];
            const Matrix23d& jacobian = m_jacobians[k - m_first];
            const double information = informationOf(click);
            const Eigen::Matrix2d spread = jacobian * m_covariance * jacobian.transpose();
            const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() - information * spread;
            if (std::abs(rest.determinant()) < 1e-9) { // two views: nothing is left of the point
                click.leftOutPx.setZero();
                click.othersPx2.setConstant(std::numeric_limits<double>::infinity());
                continue;
            }
            const Eigen::Matrix2d inverse = rest.inverse();
            click.leftOutPx = inverse * click.residualPx;
            click.othersPx2 = inverse * spread; // J (sum of the others)^-1 J^T, by Woodbury
        }
    }

private:
    Eigen::Vector3d& point() { return m_rig.pointInWorld[static_cast<std::size_t>(m_rig.clicks[m_first].joint)]; }
    double informationOf(const RigResidual& click) const {
        const double spread = m_rig.spreadPx[static_cast<std::size_t>(click.camera)];
        return click.weight / (spread * spread);
    }
    bool linearise() {
        m_jacobians.clear();
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
        m_gradient.setZero();
        for (std::size_t k = m_first; k < m_last; ++k) {
            RigResidual& click = m_rig.clicks[k];
            const auto projection = projectWithJacobian(m_cameras[static_cast<std::size_t>(click.camera)], point());
            if (!projection)
                return false;
            click.residualPx = click.px - projection->px;
            const Matrix23d& jacobian = projection->pxByPointInWorld;
            information += informationOf(click) * jacobian.transpose() * jacobian;
            m_gradient += informationOf(click) * jacobian.transpose() * click.residualPx;
            m_jacobians.push_back(jacobian);
        }
        bool isFixed = false;
        information.computeInverseWithCheck(m_covariance, isFixed, 1e-24);
        return isFixed && m_covariance.allFinite();
    }

    const std::vector<Camera>& m_cameras;
    RigResiduals& m_rig;
    std::size_t m_first, m_last;
    std::vector<Matrix23d> m_jacobians;
    Eigen::Matrix3d m_covariance = Eigen::Matrix3d::Zero();
    Eigen::Vector3d m_gradient = Eigen::Vector3d::Zero();
};

/// Where the clicks of each joint begin and end.
std::vector<std::pair<std::size_t, std::size_t>> rangesOf(const std::vector<RigResidual>& clicks) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    for (std::size_t first = 0, k = 1; k <= clicks.size(); ++k) {
        if (k == clicks.size() || clicks[k].joint != clicks[first].joint) {
            ranges.emplace_back(first, k);
            first = k;
        }
    }
    return ranges;
}

void adjustPoints(const std::vector<Camera>& cameras, RigResiduals& rig, int steps) {
    for (const auto& [first, last] : rangesOf(rig.clicks)) {
        JointAdjustment adjustment(cameras, rig, first, last);
        if (adjustment.iterate(steps))
            adjustment.judge();
        else
            rig.pointInWorld[static_cast<std::size_t>(rig.clicks[first].joint)].setConstant(
                std::numeric_limits<double>::quiet_NaN());
    }
    std::erase_if(rig.clicks, [&rig](const RigResidual& click) {
        return !isPlaced(rig.pointInWorld[static_cast<std::size_t>(click.joint)]);
    });
}

/// A camera's spread: what its disagreement with the others has beyond the uncertainty of the others.
void estimateSpreads(RigResiduals& rig) {
    std::vector<std::vector<double>> excess(rig.spreadPx.size());
    for (const RigResidual& click : rig.clicks) {
        const double others = click.othersPx2.trace();
        if (std::isfinite(others))
            excess[static_cast<std::size_t>(click.camera)].push_back(click.leftOutPx.squaredNorm() - others);
    }
    for (std::size_t c = 0; c < excess.size(); ++c) {
        constexpr std::size_t kLeastClicks = 3;
        if (excess[c].size() < kLeastClicks)
            continue;
        const double found = std::sqrt(std::max(medianOf(excess[c]), 0.0) / 2);
        // Half way in each round, and never to zero: two cameras must not raise each other's weight without end.
        rig.spreadPx[c] = std::max(kLeastSpreadPx, std::sqrt(rig.spreadPx[c] * std::max(found, rig.spreadPx[c] / 4)));
    }
    // No camera is trusted far more than the typical one: clicks are of one kind.
    const double floorPx = 0.3 * medianOf(rig.spreadPx);
    for (double& spread : rig.spreadPx)
        spread = std::max(spread, floorPx);
}

/// Clicks that are off by far more than their camera and the others explain hardly count (Cauchy).
void weighClicks(RigResiduals& rig) {
    for (RigResidual& click : rig.clicks) {
        const double spread = rig.spreadPx[static_cast<std::size_t>(click.camera)];
        const double expected = 2 * spread * spread + click.othersPx2.trace();
        const double ratio = std::isfinite(expected) ? click.leftOutPx.squaredNorm() / (9 * expected / 2) : 0;
        click.weight = 1 / (1 + ratio * ratio);
    }
}

bool areSettled(const std::vector<double>& before, const std::vector<double>& after) {
    constexpr double kSettled = 0.005; // as a share
    for (std::size_t c = 0; c < after.size(); ++c)
        if (std::abs(after[c] - before[c]) > kSettled * after[c])
            return false;
    return true;
}

} // namespace

RigResiduals computeRigResiduals(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints) {
    RigResiduals rig;
    rig.spreadPx.assign(cameras.size(), kStartSpreadPx);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        rig.pointInWorld.push_back(startPoint(cameras, joints[j]));
        if (isPlaced(rig.pointInWorld.back()))
            for (const Observation& click : joints[j].clicks)
                rig.clicks.push_back({static_cast<int>(j), click.camera, click.px});
    }
    constexpr int kMaxRounds = 15, kFirstSteps = 3, kLastSteps = 2;
    for (int i = 0; i < kMaxRounds && !rig.clicks.empty(); ++i) {
        adjustPoints(cameras, rig, i == 0 ? kFirstSteps : 1);
        const std::vector<double> before = rig.spreadPx;
        estimateSpreads(rig);
        weighClicks(rig);
        if (areSettled(before, rig.spreadPx))
            break;
    }
    adjustPoints(cameras, rig, kLastSteps);
    return rig;
}

} // namespace core
