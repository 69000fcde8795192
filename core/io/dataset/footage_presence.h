// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"

namespace core {

/// True if the view's video or any of its pictures exists.
bool hasAnyPicture(const Dataset& dataset, const Sequence& sequence, const ViewSource& view);
/// True if any mask of that camera, or of any camera if `camera` is empty, exists.
bool hasAnyMask(const Dataset& dataset, const Sequence& sequence, const std::string& camera);

/// What keeps a view's footage from being what the sequence needs.
enum class FootageProblemKind {
    None,
    TooFewFrames,   ///< a video with `count` frames where `needed` are needed
    TooFewPictures, ///< the same of images
    OtherSize,      ///< `size`, where the camera has `calibrated`
    Unreadable      ///< `detail` says why, in English
};
struct FootageProblem {
    FootageProblemKind kind = FootageProblemKind::None;
    int count = 0, needed = 0;
    ImageSize size{}, calibrated{};
    std::string camera{}, detail{};
};
FootageProblem footageProblem(const Dataset& dataset, const Sequence& sequence, const ViewSource& view);
/// The problem in English, for the command line; empty if there is none.
std::string footageProblemText(const FootageProblem& problem);

/// What is to be said about views whose files ask for another orientation than the dataset gives them, or than they are
/// stored in, unless the sequence's own notes say it. Footage that cannot be read is left to others.
std::vector<std::string> orientationNotes(const Dataset& dataset, const Sequence& sequence);

} // namespace core
