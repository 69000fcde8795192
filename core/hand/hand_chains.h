// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace core {

/// The five fingers, thumb first.
inline constexpr std::array<std::string_view, 5> kFingers{"thumb", "index", "middle", "ring", "little"};
/// The joints of a finger, base to tip; the thumb has no pip and dip, the others no ip.
inline constexpr std::array<std::string_view, 6> kFingerJoints{"cmc", "mcp", "pip", "ip", "dip", "tip"};

/// The joint on whose far end `joint` sits, going by names alone: index_pip for index_dip, thumb_mcp for thumb_ip.
/// Empty for the first joint of a finger, the wrist, the forearm and unknown names.
std::optional<std::string> previousJoint(std::string_view joint);

} // namespace core
