// SPDX-License-Identifier: MIT
#include "core/io/dataset/instants.h"

#include <algorithm>

namespace core {

namespace {

/// How many of the missing instants lie before this one.
int missingBefore(const std::vector<InstantRange>& missing, int instant) {
    int count = 0;
    for (const InstantRange& range : missing)
        count += std::clamp(instant - range.first, 0, range.count);
    return count;
}

} // namespace

bool hasPictureAt(const ViewSource& view, int instant) {
    return view.kind != ViewKind::None && std::none_of(
                                              view.missing.begin(), view.missing.end(),
                                              [&](const InstantRange& range) {
                                                  return instant >= range.first && instant - range.first < range.count;
                                              });
}

bool hasPictureAt(const Sequence& sequence, const std::string& camera, int instant) {
    const auto view = std::find_if(sequence.views.begin(), sequence.views.end(),
                                   [&](const ViewSource& one) { return one.camera == camera; });
    return view != sequence.views.end() && hasPictureAt(*view, instant);
}

int footageFrameAt(const ViewSource& view, int instant) {
    return view.offsetFrames + instant - (view.kind == ViewKind::Video ? missingBefore(view.missing, instant) : 0);
}

int countInstants(const std::vector<InstantRange>& ranges) {
    int count = 0;
    for (const InstantRange& range : ranges)
        count += range.count;
    return count;
}

} // namespace core
