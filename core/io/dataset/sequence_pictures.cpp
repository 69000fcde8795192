// SPDX-License-Identifier: MIT
#include "core/io/dataset/sequence_pictures.h"

#include <algorithm>

namespace core {

PictureGaps pictureGaps(const Dataset& dataset, const Sequence& sequence) {
    PictureGaps gaps;
    for (const Camera& camera : dataset.cameras) {
        const auto view = std::find_if(sequence.views.begin(), sequence.views.end(),
                                       [&](const ViewSource& source) { return source.camera == camera.name; });
        if (view == sequence.views.end() || view->kind == ViewKind::None) {
            gaps.cameras.insert(camera.name);
            continue;
        }
        for (const InstantRange& missing : view->missing)
            gaps.framesOf[camera.name].emplace_back(missing.first, missing.count);
    }
    if (gaps.cameras.size() == dataset.cameras.size())
        gaps.cameras.clear();
    return gaps;
}

} // namespace core
