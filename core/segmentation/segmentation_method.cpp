// SPDX-License-Identifier: MIT
#include "core/segmentation/segmentation_method.h"

namespace core {

std::string_view methodName(SegmentationMethod method) {
    constexpr std::array<std::string_view, kSegmentationMethods.size()> kNames{"landmarks", "model", "background",
                                                                               "chroma", "skin"};
    return kNames.at(static_cast<std::size_t>(method));
}

std::optional<SegmentationMethod> segmentationMethodFromName(std::string_view name) {
    for (const SegmentationMethod method : kSegmentationMethods)
        if (methodName(method) == name)
            return method;
    return std::nullopt;
}

} // namespace core
