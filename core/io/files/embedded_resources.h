// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace core {

/// The text of a JSON file of resources that is built into the library, named like "demo/hand.json"; empty if there
/// is none.
std::optional<std::string_view> findEmbeddedResource(std::string_view name);
/// The same; throws std::logic_error if there is none.
std::string_view embeddedResource(std::string_view name);

/// The same, parsed and checked against the schema of that kind. Throws Error as for a file of that name.
nlohmann::json embeddedOwnFile(const std::string& name, std::string_view kind);

} // namespace core
