// SPDX-License-Identifier: MIT
#include "core/labelling/palm_shape.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace core {

namespace {

constexpr std::size_t kFewestPalmFrames = 3; ///< that tell a palm's shape from a pose
constexpr int kRounds = 6;                   ///< of poses and palm in turn
constexpr double kPalmSigmaMm = 8;           ///< how far people's knuckles are from the model's, per axis

/// The bones whose origins make the palm: the first ones with a target on the way from the root to every fingertip.
std::vector<int> palmBones(const Skeleton& skeleton, const std::vector<std::vector<JointTarget>>& frames) {
    std::vector<bool> isSeen(skeleton.bones.size(), false), isBelow(skeleton.bones.size(), false);
    for (const auto& targets : frames)
        for (const JointTarget& target : targets)
            isSeen[static_cast<std::size_t>(target.bone)] = true;
    std::vector<int> palm;
    for (std::size_t b = 1; b < skeleton.bones.size(); ++b) {
        const auto parent = static_cast<std::size_t>(skeleton.bones[b].parent);
        isBelow[b] = parent > 0 && (isBelow[parent] || isSeen[parent]);
        if (isSeen[b] && !isBelow[b])
            palm.push_back(static_cast<int>(b));
    }
    return palm;
}

/// The mean of deviations of different certainty, drawn to zero by what is usual.
struct MeanDeviation {
    Eigen::Matrix3d information = Eigen::Matrix3d::Identity() / (kPalmSigmaMm * kPalmSigmaMm);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();

    void add(const Eigen::Vector3d& deviation, const Eigen::Matrix3d& covariance) {
        const Eigen::Matrix3d weight = covariance.inverse();
        information += weight;
        sum += weight * deviation;
    }
    Eigen::Vector3d value() const { return information.ldlt().solve(sum); }
};

/// How far the targets of the palm's joints are from the model's, in the frame of the root, mm: per bone.
std::vector<Eigen::Vector3d> palmDeviations(const HandModel& hand, const std::vector<std::vector<JointTarget>>& frames,
                                            const std::vector<Pose>& poses, const LandmarkFitOptions& options) {
    std::vector<MeanDeviation> means(hand.skeleton.bones.size());
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (poses[f].size() == 0)
            continue;
        const auto bones = boneTransforms(hand.skeleton, poses[f]);
        const Eigen::Matrix3d rootFromWorld = bones.front().rotation.transpose();
        const Eigen::Matrix3d model = options.modelSigmaMm * options.modelSigmaMm * Eigen::Matrix3d::Identity();
        for (const JointTarget& target : frames[f]) {
            const auto b = static_cast<std::size_t>(target.bone);
            means[b].add(rootFromWorld * (target.pointInWorld - bones[b].translation),
                         rootFromWorld * (target.covariance + model) * rootFromWorld.transpose());
        }
    }
    std::vector<Eigen::Vector3d> deviations;
    for (const MeanDeviation& mean : means)
        deviations.push_back(mean.value());
    return deviations;
}

/// Moves the palm's joints in the rest pose, each with all that hangs on it.
void movePalm(HandModel& hand, const std::vector<int>& palm, const std::vector<Eigen::Vector3d>& inRoot) {
    std::vector<Eigen::Vector3d> shift(hand.skeleton.bones.size(), Eigen::Vector3d::Zero());
    const Eigen::Matrix3d worldFromRoot = hand.skeleton.bones.front().worldFromBoneAtRest.rotation;
    for (std::size_t b = 1; b < hand.skeleton.bones.size(); ++b) {
        Bone& bone = hand.skeleton.bones[b];
        if (std::find(palm.begin(), palm.end(), static_cast<int>(b)) != palm.end())
            shift[b] = worldFromRoot * (inRoot[b] - inRoot.front());
        else
            shift[b] = shift[static_cast<std::size_t>(bone.parent)];
        bone.worldFromBoneAtRest.translation += shift[b];
    }
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v)
        for (int e = hand.weights.firstEntry[v]; e < hand.weights.firstEntry[v + 1]; ++e) {
            const SkinWeight& weight = hand.weights.entries[static_cast<std::size_t>(e)];
            hand.mesh.vertices[v] += weight.weight * shift[static_cast<std::size_t>(weight.bone)];
        }
}

} // namespace

HandModel withPalmOf(const HandModel& hand, const std::vector<std::vector<JointTarget>>& frames,
                     const LandmarkFitOptions& options) {
    const std::vector<int> palm = palmBones(hand.skeleton, frames);
    HandModel shaped = hand;
    std::vector<Pose> poses(frames.size());
    for (int round = 0; round < kRounds; ++round) {
        std::size_t seen = 0;
        for (std::size_t f = 0; f < frames.size(); ++f) {
            auto starts = usualStarts(hand.skeleton);
            if (poses[f].size() > 0)
                starts = {poses[f]};
            const auto fit = fitToTargets(shaped, frames[f], starts, options);
            poses[f] = fit ? fit->pose : Pose();
            seen += fit ? 1 : 0;
        }
        if (seen < kFewestPalmFrames)
            return hand;
        movePalm(shaped, palm, palmDeviations(shaped, frames, poses, options));
    }
    return shaped;
}

} // namespace core
