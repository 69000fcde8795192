// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"

namespace core {

/// One piece of footage of a dataset, and where it is now.
struct RelinkFinding {
    std::string sequence;
    std::string camera;   ///< empty for masks of all cameras
    std::string from, to; ///< as dataset.json names them, relative to its folder; `to` is empty if nothing was found
    std::string
        note; ///< what a person should know, English: too few frames, another size, several candidates; else empty
    bool isMask = false;
};

struct RelinkResult {
    std::vector<RelinkFinding> found; ///< had moved and has a new place
    std::vector<RelinkFinding> notFound;
    std::vector<RelinkFinding> unchanged; ///< is where the dataset says
};

/// Looks below `root` for videos, images and masks that are not where the dataset says, and changes their paths in
/// `dataset` (in memory: rewriteDatasetFile keeps it). Footage is known by its file name and by as much of its folders'
/// names, from the last one on, as makes it unambiguous; no file is taken for two different pieces of footage. Throws
/// Error if `root` is not a folder; a stop leaves `dataset` as it was.
RelinkResult relinkFootage(Dataset& dataset, const std::filesystem::path& root, std::stop_token stop = {});

} // namespace core
