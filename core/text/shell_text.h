// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace core {

/// A word of a POSIX shell's command line: in quotes only if the shell would take it apart.
std::string shellWord(const std::string& text);

} // namespace core
