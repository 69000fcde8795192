// SPDX-License-Identifier: MIT
#include "core/rig/refinement_advice.h"

#include "core/rig/rig_refinement.h"

namespace core {

RefinementNeeds adviseRefinement(const RigHealth& health, const std::vector<RigJoint>& joints) {
    RefinementNeeds needs;
    needs.wellSeenJoints = countWellSeenJoints(joints);
    needs.leastJoints = RigRefinementOptions{}.leastJoints;
    if (needs.wellSeenJoints < needs.leastJoints)
        needs.advice = RefinementAdvice::NeedsMoreJoints;
    else if (!health.anyOff())
        needs.advice = RefinementAdvice::NotNeeded;
    else if (health.frames < needs.worthwhileFrames || needs.wellSeenJoints < needs.worthwhileJoints)
        needs.advice = RefinementAdvice::NeedsMoreFrames;
    else
        needs.advice = RefinementAdvice::Worthwhile;
    return needs;
}

} // namespace core
