// SPDX-License-Identifier: MIT
#include "core/demo_hand/choreography.h"

#include <algorithm>
#include <cmath>

#include "core/demo_hand/contact.h"
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
        for (std::size_t k = 1; k < keys.size(); ++k)
            if (keys[k].stageFromWrist.dot(keys[k - 1].stageFromWrist) < 0)
                keys[k].stageFromWrist.coeffs() = -keys[k].stageFromWrist.coeffs();
        for (int i = 0; i < 3; ++i)
            m_wrist.push_back(curve(keys, [i](const HandKey& key) { return key.wristInStage[i]; }));
        for (int i = 0; i < 4; ++i)
            m_turn.push_back(curve(keys, [i](const HandKey& key) { return key.stageFromWrist.coeffs()[i]; }));
        for (Eigen::Index i = 0; i < keys.front().anglesRad.size(); ++i)
            m_angles.push_back(curve(keys, [i](const HandKey& key) { return key.anglesRad[i]; }));
    }

    HandKey at(double frame) const {
        HandKey key{frame, {}, {}, Eigen::VectorXd(static_cast<Eigen::Index>(m_angles.size()))};
        for (int i = 0; i < 3; ++i)
            key.wristInStage[i] = m_wrist[i](frame);
        for (int i = 0; i < 4; ++i)
            key.stageFromWrist.coeffs()[i] = m_turn[i](frame);
        key.stageFromWrist.normalize();
        for (Eigen::Index i = 0; i < key.anglesRad.size(); ++i)
            key.anglesRad[i] = m_angles[i](frame);
        return key;
    }

private:
    std::vector<MonotoneCubic> m_wrist, m_turn, m_angles;
};

/// Place of the stage in the world over time; nothing moves without keys.
class StageCurves {
public:
    explicit StageCurves(std::vector<StageKey> keys) {
        if (keys.empty())
            keys.emplace_back();
        for (int i = 0; i < 3; ++i) {
            m_place.push_back(curve(
                keys, [i](const StageKey& key) { return key.stageInWorld[i]; }));
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

/// The least smooth curve that lies nowhere below `values`, by `reach` samples to both sides: the highest in the
/// neighbourhood, then the weighted mean over the neighbourhood.
std::vector<double> smoothEnvelope(const std::vector<double>& values, int reach) {
    const int count = static_cast<int>(values.size());
    const auto sample = [&](const std::vector<double>& list, int i) { return list[std::clamp(i, 0, count - 1)]; };
    std::vector<double> highest(values), smooth(values);
    for (int i = 0; i < count; ++i)
        for (int k = -reach; k <= reach; ++k)
            highest[i] = std::max(highest[i], sample(values, i + k));
    for (int i = 0; i < count; ++i) {
        double sum = 0, weights = 0;
        for (int k = -reach; k <= reach; ++k) {
            const double weight = reach + 1 - std::abs(k);
            sum += weight * sample(highest, i + k);
            weights += weight;
        }
        smooth[i] = sum / weights;
    }
    return smooth;
}

/// How far the hands must move apart in each frame for the wanted gap. Where no part of one hand lies over the other
/// there is nothing to keep apart: 0.
std::vector<double> neededShifts(const ContactRule& rule, const StageCurves& stage, const std::vector<HandModel>& hands,
                                 const Motion& motion) {
    const MonotoneCubic wantedGap = curve(rule.gaps, [](const GapKey& key) { return key.gapMm; });
    std::vector<double> shifts;
    for (std::size_t frame = 0; frame < motion.size(); ++frame) {
        const auto time = static_cast<double>(frame);
        const double gap = gapAlong(stage.worldFromStage(time).rotation * rule.direction.normalized(),
                                    posedVertices(hands[0], motion[frame][0]), hands[0].mesh.triangles,
                                    posedVertices(hands[1], motion[frame][1]), hands[1].mesh.triangles);
        shifts.push_back(std::isfinite(gap) ? wantedGap(time) - gap : 0);
    }
    return shifts;
}

void keepInTouch(const ContactRule& rule, const StageCurves& stage, const std::vector<HandModel>& hands,
                 Motion& motion) {
    const std::vector<double> shifts = smoothEnvelope(neededShifts(rule, stage, hands, motion), rule.smoothFrames);
    for (std::size_t frame = 0; frame < motion.size(); ++frame) {
        const Eigen::Vector3d apart =
            shifts[frame] * (stage.worldFromStage(static_cast<double>(frame)).rotation * rule.direction.normalized());
        motion[frame][0].head<3>() -= (1 - rule.secondShare) * apart;
        motion[frame][1].head<3>() += rule.secondShare * apart;
    }
}

} // namespace

Motion play(const Choreography& choreography, const std::vector<HandModel>& hands) {
    std::vector<HandCurves> curves;
    for (const std::vector<HandKey>& keys : choreography.keys)
        curves.emplace_back(keys);
    const StageCurves stage(choreography.stage);
    Motion motion;
    for (int frame = 0; frame < choreography.frameCount; ++frame) {
        const RigidMotion worldFromStage = stage.worldFromStage(frame);
        HandPoses poses;
        for (std::size_t h = 0; h < hands.size(); ++h)
            poses.push_back(poseOf(hands[h].skeleton, worldFromStage, curves[h].at(frame)));
        motion.push_back(std::move(poses));
    }
    if (choreography.contact && hands.size() == 2)
        keepInTouch(*choreography.contact, stage, hands, motion);
    return motion;
}

} // namespace core
