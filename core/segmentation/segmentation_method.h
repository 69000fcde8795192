// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace core {

/// How silhouettes are found in pictures.
enum class SegmentationMethod {
    Landmarks,  ///< colours around the hand's joints
    Model,      ///< colours around the silhouette of the posed hand model
    Background, ///< what differs from the empty room
    Chroma,     ///< what has not the backdrop's colour
    Skin        ///< what has the colour of skin
};
inline constexpr std::array kSegmentationMethods{SegmentationMethod::Landmarks, SegmentationMethod::Model,
                                                 SegmentationMethod::Background, SegmentationMethod::Chroma,
                                                 SegmentationMethod::Skin};

/// "landmarks", "model", "background", "chroma", "skin".
std::string_view methodName(SegmentationMethod method);
std::optional<SegmentationMethod> segmentationMethodFromName(std::string_view name);

} // namespace core
