// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/hand/motion.h"

namespace core {

/// Reads recorded poses (format "handlens-motion") for these hands, in their order. Throws Error if the hands, the size
/// of a pose or the number of frames differ.
Motion readMotionFile(const std::filesystem::path& file, const std::vector<HandModel>& hands, int frameCount);
/// Writes all numbers so that they read back exactly. `motion` may not be empty.
void writeMotionFile(const std::filesystem::path& file, const std::vector<HandModel>& hands, const Motion& motion);

} // namespace core
