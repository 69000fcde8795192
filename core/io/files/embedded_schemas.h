// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace core {

/// The text of resources/schemas/<kind>.schema.json, which is built into the library. Throws std::logic_error if there
/// is none.
std::string_view embeddedSchema(std::string_view kind);

} // namespace core
