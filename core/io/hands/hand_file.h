// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/hand/hand_model.h"

namespace core {

/// Reads a hand model (format "handlens-hand"). Throws Error naming the file and the field.
HandModel readHandModel(const std::filesystem::path& file);
/// Writes all numbers so that they read back exactly.
void writeHandModel(const std::filesystem::path& file, const HandModel& hand);

/// Everything that must hold for a hand of whatever origin: bones in order with distinct names and proper rest poses,
/// unit axes, triangles that refer to vertices, weights that are positive and sum to 1. Throws Error(BadInput) naming
/// `file` and the field.
void checkHandModel(const HandModel& hand, const std::string& file);

} // namespace core
