// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/dataset/check_finding.h"

namespace core {

/// Everything that is wrong with a dataset folder, or with one of our own files (cameras, hand): unlike readDataset it
/// goes on after the first problem where it can. Throws Error(NotFound) only if there is nothing of that name.
std::vector<CheckFinding> checkPath(const std::filesystem::path& path);

} // namespace core
