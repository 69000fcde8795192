// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace core {

/// Follows a MATLAB file of level 5 from element to element, unpacking on the way but keeping nothing, and throws
/// Error(BadInput) naming the file and the variable where an array says that it has more elements than there are bytes
/// for them, or where packed bytes are damaged: what reads such files makes room for all that they claim. Packed
/// variables of more than 64 MB are not followed.
/// (MathWorks, MAT-File Format, 2023, chapter 1.)
void checkMatClaims(const std::filesystem::path& file);

} // namespace core
