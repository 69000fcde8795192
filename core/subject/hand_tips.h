// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/hand/hand_model.h"

namespace core {

/// The tip that lies at the end of a last bone: index_tip for index_dip; empty if the bone does not belong to a finger.
std::string tipAfter(const std::string& lastBone);

/// The hand with a bone at the end of every finger's last bone, where it has none: the joint that an annotated tip
/// belongs to. The new bones follow the others; they carry no surface and have no degrees of freedom, so that poses
/// stay what they are.
HandModel withTips(const HandModel& hand);

/// A hand that was shaped from withTips(hand), without the bones that were added: how far off they are is the length of
/// the bones that they hang on.
HandModel withoutTips(const HandModel& shaped, const HandModel& hand);

} // namespace core
