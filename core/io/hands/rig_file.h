// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/hand/rig.h"

namespace core {

/// Reads a rig (format "handlens-rig", resources/schemas/rig.schema.json). Throws Error naming the file and the field;
/// see rigFromJson.
Rig readRig(const std::filesystem::path& file);

/// A rig that is built in: "handlens" (joints named and oriented as in this program) or "webxr".
Rig defaultRig(const std::string& name);

/// A rig out of a parsed file that has passed its schema. Throws Error(BadInput) naming `file` and the field: a first
/// joint with a parent, a parent that does not come earlier, a joint named twice, a degree of freedom of the root or of
/// an unknown joint or named twice, an axis of no length, limits that do not hold the rest pose, joint axes that are
/// parallel.
Rig rigFromJson(const nlohmann::json& value, const std::string& file);

} // namespace core
