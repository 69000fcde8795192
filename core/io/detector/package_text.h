// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace core {

/// Bytes [begin, end) of a file that others are packed into.
struct PackedRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Where a package's loader, a script whose last call is loadPackage({...}), says that the file `wanted` is packed.
/// `size`: of the file that it is packed into, `packedInto`: that one's name. `file` names the script in errors.
/// Throws Error: BadInput if there is no such list or it makes no sense, NotFound if the file is not in it.
PackedRange packedRange(std::string_view script, const std::string& file, const std::string& wanted, std::size_t size,
                        const std::string& packedInto);

/// Name and version as an npm package's package.json has them, "?" for what it lacks. `file` names it in errors.
/// Throws Error(BadInput) if it is not JSON.
std::string packageTitle(std::string_view manifest, const std::string& file);

} // namespace core
