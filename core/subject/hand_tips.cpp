// SPDX-License-Identifier: MIT
#include "core/subject/hand_tips.h"

#include <algorithm>

#include "core/hand/hand_chains.h"

namespace core {

std::string tipAfter(const std::string& lastBone) {
    const std::string finger = lastBone.substr(0, lastBone.find('_'));
    const bool isFinger = std::find(kFingers.begin(), kFingers.end(), finger) != kFingers.end();
    return isFinger && !lastBone.ends_with("_tip") ? finger + "_tip" : "";
}

HandModel withTips(const HandModel& hand) {
    HandModel extended = hand;
    const std::vector<Bone>& bones = hand.skeleton.bones;
    std::vector<bool> isParent(bones.size(), false);
    for (const Bone& bone : bones)
        if (bone.parent >= 0)
            isParent[static_cast<std::size_t>(bone.parent)] = true;
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const std::string tip = tipAfter(bones[b].name);
        if (isParent[b] || tip.empty() || bones[b].lengthMm <= 0 || hand.skeleton.boneIndex(tip) >= 0)
            continue;
        RigidMotion end = bones[b].worldFromBoneAtRest;
        end.translation += bones[b].lengthMm * end.rotation.col(0);
        extended.skeleton.bones.push_back({tip, static_cast<int>(b), end, 0});
    }
    return extended;
}

HandModel withoutTips(const HandModel& shaped, const HandModel& hand) {
    HandModel kept = shaped;
    std::vector<Bone>& bones = kept.skeleton.bones;
    for (std::size_t t = hand.skeleton.bones.size(); t < bones.size(); ++t) {
        Bone& last = bones[static_cast<std::size_t>(bones[t].parent)];
        last.lengthMm = (bones[t].worldFromBoneAtRest.translation - last.worldFromBoneAtRest.translation).norm();
    }
    bones.resize(hand.skeleton.bones.size());
    return kept;
}

} // namespace core
