// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/dataset/dataset.h"

namespace core {

/// Whether the view has a picture at this instant of its sequence: false for views of kind None and for instants that
/// are missing.
bool hasPictureAt(const ViewSource& view, int instant);
/// The same for a camera of the sequence by its name.
bool hasPictureAt(const Sequence& sequence, const std::string& camera, int instant);

/// The frame of the video, or the number of the image, that shows this instant.
int footageFrameAt(const ViewSource& view, int instant);

/// How many instants lack a picture.
int countInstants(const std::vector<InstantRange>& ranges);

} // namespace core
