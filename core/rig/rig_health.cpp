// SPDX-License-Identifier: MIT
#include "core/rig/rig_health.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/numeric/median.h"
#include "core/rig/residual_regression.h"

namespace core {

namespace {

/// Image velocity of a joint in a camera, px per frame, from its points in the frames beside it.
class Velocities {
public:
    Velocities(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints, const RigResiduals& rig,
               int widestGapFrames)
        : m_cameras(cameras)
        , m_joints(joints)
        , m_rig(rig)
        , m_widestGap(widestGapFrames) {
        for (std::size_t j = 0; j < joints.size(); ++j)
            if (rig.pointInWorld[j].allFinite())
                m_index[keyOf(joints[j], joints[j].frame)] = j;
    }

    std::optional<Eigen::Vector2d> of(const RigResidual& click) const {
        const RigJoint& joint = m_joints[static_cast<std::size_t>(click.joint)];
        const auto here = m_index.find(keyOf(joint, joint.frame));
        if (here == m_index.end())
            return std::nullopt;
        const auto before = here == m_index.begin() ? here : std::prev(here);
        const auto after = std::next(here);
        const std::size_t first = isNear(before, joint) ? before->second : here->second;
        const std::size_t last = after != m_index.end() && isNear(after, joint) ? after->second : here->second;
        if (first == last)
            return std::nullopt;
        const Camera& camera = m_cameras[static_cast<std::size_t>(click.camera)];
        const auto from = project(camera, m_rig.pointInWorld[first]), to = project(camera, m_rig.pointInWorld[last]);
        if (!from || !to)
            return std::nullopt;
        return (*to - *from) / static_cast<double>(m_joints[last].frame - m_joints[first].frame);
    }

private:
    using Key = std::tuple<int, std::string, JointId, int>;
    static Key keyOf(const RigJoint& joint, int frame) { return {joint.sequence, joint.rater, joint.joint, frame}; }
    bool isNear(std::map<Key, std::size_t>::const_iterator other, const RigJoint& joint) const {
        const auto& [sequence, rater, id, frame] = other->first;
        return sequence == joint.sequence && rater == joint.rater && id == joint.joint &&
               std::abs(frame - joint.frame) <= m_widestGap;
    }

    const std::vector<Camera>& m_cameras;
    const std::vector<RigJoint>& m_joints;
    const RigResiduals& m_rig;
    int m_widestGap;
    std::map<Key, std::size_t> m_index;
};

/// The clicks of one camera, with the regressions that judge it.
class CameraJudge {
public:
    CameraJudge(const std::vector<RigJoint>& joints, const Velocities& velocities, const RigHealthOptions& options,
                const Camera& camera)
        : m_joints(joints)
        , m_velocities(velocities)
        , m_options(options)
        , m_camera(camera) {}

    void add(const RigResidual& click) {
        m_squaredPx2 += click.residualPx.squaredNorm();
        ++m_count;
        if (click.othersPx2.allFinite())
            m_clicks.push_back(&click);
    }

    CameraHealth judge() {
        CameraHealth health;
        health.camera = m_camera.name;
        health.clicks = m_count;
        health.rmsPx = m_count > 0 ? std::sqrt(m_squaredPx2 / m_count) : 0;
        if (static_cast<int>(m_clicks.size()) < m_options.leastClicks)
            return health;
        health.isKnown = true;
        std::vector<double> distances;
        for (const RigResidual* click : m_clicks)
            distances.push_back(click->leftOutPx.norm());
        health.leaveOneOutPx = medianOf(distances);
        findMean(health);
        findVariation(health);
        findSpread(health);
        findDelay(health);
        findCourse(health);
        const double gatePx = 5 * health.scatterPx;
        for (const RigResidual* click : m_clicks)
            health.wrongClicks += (click->leftOutPx - health.meanPx).norm() > gatePx && click->weight < 0.1;
        return health;
    }

private:
    using Rows = Eigen::Matrix<double, 2, Eigen::Dynamic>;

    /// Regression with the given columns per click.
    template <typename RowsOf>
    std::optional<Regression> explain(Eigen::Index columns, RowsOf rowsOf) const {
        std::vector<std::pair<Rows, Eigen::Vector2d>> used;
        for (const RigResidual* click : m_clicks) {
            Rows rows = Rows::Zero(2, columns);
            if (rowsOf(*click, rows))
                used.emplace_back(rows, click->leftOutPx);
        }
        const auto count = static_cast<Eigen::Index>(used.size());
        if (count < m_options.leastClicks || 2 * count < 2 * columns)
            return std::nullopt;
        Eigen::MatrixXd design(2 * count, columns);
        Eigen::VectorXd residuals(2 * count);
        for (Eigen::Index i = 0; i < count; ++i) {
            design.middleRows<2>(2 * i) = used[static_cast<std::size_t>(i)].first;
            residuals.segment<2>(2 * i) = used[static_cast<std::size_t>(i)].second;
        }
        return regress(design, residuals);
    }

    /// In halves of the image's larger side, from its middle.
    Eigen::Vector2d placeOf(const RigResidual& click) const {
        const Eigen::Vector2d middle(0.5 * m_camera.size.width, 0.5 * m_camera.size.height);
        return (click.px - middle) / (0.5 * std::max(m_camera.size.width, m_camera.size.height));
    }

    void findMean(CameraHealth& health) {
        const auto fit = explain(2, [](const RigResidual&, Rows& rows) {
            rows.leftCols<2>().setIdentity();
            return true;
        });
        if (!fit)
            return;
        health.meanPx = fit->unknowns;
        health.scatterPx = fit->scatterPx;
        // Clicks that share the errors of the other cameras do not average them out: those stay, whatever the number.
        double others = 0;
        for (const RigResidual* click : m_clicks)
            others += click->othersPx2.trace() / 2;
        const double count = static_cast<double>(m_clicks.size());
        m_othersPx = std::sqrt(std::max(0.0, others / count - fit->scatterPx * fit->scatterPx));
        health.meanSigmaPx = std::hypot(std::sqrt(fit->covariance(0, 0)), m_othersPx);
    }

    void findVariation(CameraHealth& health) const {
        const auto fit = explain(6, [&](const RigResidual& click, Rows& rows) {
            const Eigen::Vector2d place = placeOf(click);
            rows << 1, 0, place.x(), place.y(), 0, 0, 0, 1, 0, 0, place.x(), place.y();
            return true;
        });
        if (!fit)
            return;
        health.variationPx << fit->unknowns[2], fit->unknowns[3], fit->unknowns[4], fit->unknowns[5];
        health.scatterPx = fit->scatterPx;
    }

    /// What the camera's clicks have beyond the uncertainty of the others, wrong clicks left out; at least about its
    /// scatter, a tenth of which is the others'.
    void findSpread(CameraHealth& health) const {
        double sum = 0, weights = 0;
        for (const RigResidual* click : m_clicks) {
            if (click->weight < 0.1)
                continue;
            sum += click->leftOutPx.squaredNorm() - click->othersPx2.trace();
            weights += 2;
        }
        health.spreadPx = std::max(std::sqrt(std::max(weights > 0 ? sum / weights : 0.0, 0.0)), 0.9 * health.scatterPx);
    }

    bool isFar(const Eigen::Vector2d& meanPx, double sigmaPx, double scatterPx) const {
        const double px = meanPx.norm();
        return px > std::max(m_options.leastOffPx, 0.7 * scatterPx) && px > m_options.significance * sigmaPx;
    }

    /// Before and after a move, and at both ends of a drift.
    bool isOffThroughout(const SequenceHealth& sequence) const {
        Eigen::Vector2d first = sequence.meanPx, last = sequence.meanPx;
        if (sequence.step) {
            first = sequence.step->beforePx;
            last = sequence.step->afterPx;
        } else if (sequence.isDrifting) {
            const Eigen::Vector2d half = *sequence.driftPx * (sequence.lastFrame - sequence.firstFrame) / 200;
            first -= half;
            last += half;
        }
        return isFar(first, sequence.meanSigmaPx, 0) && isFar(last, sequence.meanSigmaPx, 0);
    }

    /// Changes over the frames, and whether it is off always or at times.
    void findCourse(CameraHealth& health) const {
        std::vector<CourseClick> clicks;
        for (const RigResidual* click : m_clicks) {
            const RigJoint& joint = m_joints[static_cast<std::size_t>(click->joint)];
            clicks.push_back({joint.sequence, joint.frame, placeOf(*click), click->leftOutPx});
        }
        health.sequences =
            judgeCourse(std::move(clicks), {m_options.leastClicks, m_options.leastOffPx, m_options.significance});
        health.isOff = !health.isLate && isFar(health.meanPx, health.meanSigmaPx, health.scatterPx);
        double clearest = 0;
        bool isOffAlways = true;
        for (SequenceHealth& sequence : health.sequences) {
            sequence.meanSigmaPx = std::hypot(sequence.meanSigmaPx, m_othersPx);
            sequence.isOff = !health.isLate && isOffThroughout(sequence);
            isOffAlways = isOffAlways && sequence.isOff;
            health.hasMoved = health.hasMoved || sequence.step;
            health.isDrifting = health.isDrifting || sequence.isDrifting;
            if (sequence.driftPx && sequence.driftPx->norm() >= clearest * sequence.driftSigmaPx) {
                clearest = sequence.driftPx->norm() / sequence.driftSigmaPx;
                health.driftPx = sequence.driftPx;
                health.driftSigmaPx = sequence.driftSigmaPx;
            }
        }
        health.isOff = health.isOff && isOffAlways;
    }

    void findDelay(CameraHealth& health) const {
        const auto fit = explain(3, [this](const RigResidual& click, Rows& rows) {
            const auto velocity = m_velocities.of(click);
            if (velocity)
                rows << 1, 0, velocity->x(), 0, 1, velocity->y();
            return velocity.has_value();
        });
        if (!fit)
            return;
        // A picture that lies d frames behind shows the joint where it was: clicked - projected = -d * velocity.
        const double delay = -fit->unknowns[2], sigma = std::sqrt(fit->covariance(2, 2));
        health.delayFrames = delay;
        health.delaySigmaFrames = sigma;
        health.isLate = std::abs(delay) > std::max(m_options.leastDelayFrames, m_options.significance * sigma) &&
                        fit->scatterPx < 0.7 * health.scatterPx;
    }

    const std::vector<RigJoint>& m_joints;
    const Velocities& m_velocities;
    const RigHealthOptions& m_options;
    const Camera& m_camera;
    std::vector<const RigResidual*> m_clicks;
    double m_othersPx = 0; ///< what the others' errors, which all clicks share, add to a mean
    double m_squaredPx2 = 0;
    int m_count = 0;
};

} // namespace

bool RigHealth::anyOff() const {
    return std::any_of(
        cameras.begin(), cameras.end(), [](const CameraHealth& camera) { return camera.isOff; });
}

RigHealth judgeRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                   const RigHealthOptions& options) {
    return judgeRig(cameras, joints, computeRigResiduals(cameras, joints), options);
}

RigHealth judgeRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints, const RigResiduals& rig,
                   const RigHealthOptions& options) {
    const Velocities velocities(cameras, joints, rig, options.widestGapFrames);
    std::vector<CameraJudge> judges;
    for (const Camera& camera : cameras)
        judges.emplace_back(joints, velocities, options, camera);
    for (const RigResidual& click : rig.clicks)
        judges[static_cast<std::size_t>(click.camera)].add(click);
    RigHealth health;
    for (CameraJudge& judge : judges) {
        health.cameras.push_back(judge.judge());
        health.isKnown |= health.cameras.back().isKnown;
    }
    health.joints = static_cast<int>(std::count_if(rig.pointInWorld.begin(), rig.pointInWorld.end(),
                                                   [](const auto& point) { return point.allFinite(); }));
    health.frames = countFrames(joints);
    return health;
}

} // namespace core
