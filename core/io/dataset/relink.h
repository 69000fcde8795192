// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/io/dataset/footage_presence.h"

namespace core {

/// Why footage was not found.
enum class RelinkReason {
    None,        ///< it was found, or nothing has its name
    SeveralFit,  ///< `places` begins with two that fit equally well
    OtherFootage ///< what has its name, the one of `places`, is other footage of the dataset
};

/// One piece of footage of a dataset, and where it is now.
struct RelinkFinding {
    std::string sequence;
    std::string camera;   ///< empty for masks of all cameras
    std::string from, to; ///< as dataset.json names them, relative to its folder; `to` is empty if nothing was found
    RelinkReason reason = RelinkReason::None;
    std::vector<std::string> places{}; ///< what the reason is about
    FootageProblem problem{};          ///< of footage that was found
    bool isMask = false;
};

/// The reason or the problem in English, for the command line; empty if there is neither.
std::string relinkNoteText(const RelinkFinding& finding);

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
