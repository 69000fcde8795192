// SPDX-License-Identifier: MIT
#include "core/hand/choreography.h"

#include <cmath>
#include <functional>

#include "core/numeric/monotone_cubic.h"

namespace core {

namespace {

/// A curve through one number of every key.
template <typename Key, typename Value>
MonotoneCubic curve(const std::vector<Key>& keys, Value&& value) {
    std::vector<double> x, y;
    for (const Key& key : keys) {
        x.push_back(key.frame);
        y.push_back(value(key));
    }
    return {x, y};
}

/// All curves of one hand.
class HandCurves {
public:
    explicit HandCurves(std::vector<HandKey> keys) {
        // q and -q are the same turn: choose the nearer one.
        for (std::size_t k = 1; k < keys.size(); ++k) {
            if (keys[k].stageFromWrist.dot(keys[k - 1].stageFromWrist) < 0) {
                keys[k].stageFromWrist.coeffs() = -keys[k].stageFromWrist.coeffs();
            }
        }
        for (int i = 0; i < 3; ++i) {
            m_wrist.push_back(curve(keys, [i](const HandKey& key) { return key.wristInStage[i]; }));
        }
        for (int i = 0; i < 4; ++i) {
            m_turn.push_back(curve(keys, [i](const HandKey& key) { return key.stageFromWrist.coeffs()[i]; }));
        }
        for (Eigen::Index i = 0; i < keys.front().anglesRad.size(); ++i) {
            m_angles.push_back(curve(keys, [i](const HandKey& key) { return key.anglesRad[i]; }));
        }
    }

    HandKey at(double frame) const {
        HandKey key{frame, {}, {}, Eigen::VectorXd(static_cast<Eigen::Index>(m_angles.size()))};
        for (int i = 0; i < 3; ++i) {
            key.wristInStage[i] = m_wrist[i](frame);
        }
        for (int i = 0; i < 4; ++i) {
            key.stageFromWrist.coeffs()[i] = m_turn[i](frame);
        }
        key.stageFromWrist.normalize();
        for (Eigen::Index i = 0; i < key.anglesRad.size(); ++i) {
            key.anglesRad[i] = m_angles[i](frame);
        }
        return key;
    }

private:
    std::vector<MonotoneCubic> m_wrist, m_turn, m_angles;
};

/// Place of the stage in the world over time; nothing moves without keys.
class StageCurves {
public:
    explicit StageCurves(std::vector<StageKey> keys) {
        if (keys.empty()) {
            keys.emplace_back();
        }
        for (int i = 0; i < 3; ++i) {
            m_place.push_back(curve(keys, [i](const StageKey& key) { return key.stageInWorld[i]; }));
            m_turn.push_back(curve(keys, [i](const StageKey& key) { return key.turnRad[i]; }));
        }
    }

    RigidMotion worldFromStage(double frame) const {
        return {rotationExp({m_turn[0](frame), m_turn[1](frame), m_turn[2](frame)}),
                {m_place[0](frame), m_place[1](frame), m_place[2](frame)}};
    }

private:
    std::vector<MonotoneCubic> m_place, m_turn;
};

/// The pose that brings the wrist's bone to the key's place.
Pose poseOf(const Skeleton& skeleton, const RigidMotion& worldFromStage, const HandKey& key) {
    const RigidMotion worldFromWrist =
        worldFromStage * RigidMotion{key.stageFromWrist.toRotationMatrix(), key.wristInStage};
    const RigidMotion worldFromRest = worldFromWrist * inverse(skeleton.bones.front().worldFromBoneAtRest);
    Pose pose = skeleton.restPose();
    pose.head<3>() = worldFromRest * skeleton.centreAtRest - skeleton.centreAtRest;
    pose.segment<3>(3) = rotationLog(worldFromRest.rotation);
    pose.tail(key.anglesRad.size()) = key.anglesRad;
    return pose;
}

/// Moves both hands along the rule's direction until their gap is the wanted one. Where the fingers pass beside each other
/// (no gap can be told), they stay.
void keepInTouch(const ContactRule& rule, double wantedGapMm, const Eigen::Vector3d& directionInWorld,
                 const std::vector<HandModel>& hands, HandPoses& poses) {
    const double gap = gapAlong(directionInWorld, posedVertices(hands[0], poses[0]), hands[0].mesh.triangles,
                                posedVertices(hands[1], poses[1]), hands[1].mesh.triangles);
    if (!std::isfinite(gap)) {
        return;
    }
    const Eigen::Vector3d apart = (wantedGapMm - gap) * directionInWorld;
    poses[0].head<3>() -= (1 - rule.secondShare) * apart;
    poses[1].head<3>() += rule.secondShare * apart;
}

} // namespace

std::vector<HandPoses> play(const Choreography& choreography, const std::vector<HandModel>& hands) {
    std::vector<HandCurves> curves;
    for (const std::vector<HandKey>& keys : choreography.keys) {
        curves.emplace_back(keys);
    }
    const StageCurves stage(choreography.stage);
    std::optional<MonotoneCubic> gap;
    if (choreography.contact && hands.size() == 2) {
        gap = curve(choreography.contact->gaps, [](const GapKey& key) { return key.gapMm; });
    }
    std::vector<HandPoses> motion;
    for (int frame = 0; frame < choreography.frameCount; ++frame) {
        const RigidMotion worldFromStage = stage.worldFromStage(frame);
        HandPoses poses;
        for (std::size_t h = 0; h < hands.size(); ++h) {
            poses.push_back(poseOf(hands[h].skeleton, worldFromStage, curves[h].at(frame)));
        }
        if (gap) {
            keepInTouch(*choreography.contact, (*gap)(frame),
                        worldFromStage.rotation * choreography.contact->direction.normalized(), hands, poses);
        }
        motion.push_back(std::move(poses));
    }
    return motion;
}

double meanDisplacementMm(const std::vector<HandModel>& hands, const std::vector<HandPoses>& motion, int apart) {
    double sum = 0;
    const std::size_t step = static_cast<std::size_t>(apart);
    for (std::size_t frame = 0; frame + step < motion.size(); ++frame) {
        sum += meanJointDistanceMm(hands, motion[frame], motion[frame + step]);
    }
    return motion.size() > step ? sum / static_cast<double>(motion.size() - step) : 0;
}

} // namespace core
