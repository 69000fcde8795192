// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"

namespace core {

/// Where masks are, as a person names it.
struct MaskSource {
    std::string camera; ///< empty: the masks of all cameras
    std::string from; ///< a pattern with {frame} (and {camera}), or a folder of numbered masks; relative to the working
                      ///< directory
    int offset = 0;   ///< the number in the mask's name at the sequence's first frame
};

enum class MaskNoteKind {
    Count,       ///< `count` of `frameCount` frames have a mask
    OtherNumbers ///< `count` masks have numbers that no frame needs
};

/// What a person should know about the masks of one camera.
struct MaskNote {
    MaskNoteKind kind = MaskNoteKind::Count;
    std::string camera;
    int count = 0;
    int frameCount = 0;                  ///< of the sequence
    int offset = 0;                      ///< the number that frame 0 needs
    int firstNumber = 0, lastNumber = 0; ///< of the masks; of OtherNumbers
    bool operator==(const MaskNote&) const = default;

    /// Whether the masks are numbered from another number than 0 on, so that an offset would probably help.
    bool suggestsOffset() const { return kind == MaskNoteKind::OtherNumbers && offset == 0 && firstNumber > 0; }
};

/// The note as an English sentence, for the command line.
std::string maskNoteText(const MaskNote& note);

/// Splits "cam0=masks/{frame}.png" if what stands before "=" is a camera of the dataset; else the text is of all
/// cameras.
MaskSource parseMaskSource(const Dataset& dataset, const std::string& text);

/// Gives a sequence of `dataset` (in memory: rewriteDatasetFile keeps it) its masks. A folder may hold
/// FOLDER/<camera>/<number>.png, FOLDER/<camera>_<number>.png and the like. Returns notes: how many frames of every
/// camera have a mask, then numbers that the sequence does not have. Throws Error, and leaves the dataset as it was, if
/// there is no mask of any frame, or one is unreadable or not of its camera's size.
std::vector<MaskNote> attachMasks(Dataset& dataset, const std::string& sequence,
                                  const std::vector<MaskSource>& sources);
/// The same for one pattern or folder that holds the masks of all cameras.
std::vector<MaskNote> attachMasks(Dataset& dataset, const std::string& sequence, const std::string& from);

} // namespace core
