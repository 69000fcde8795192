// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace core {

/// One finding of a check. A note (such as recorded angles outside the limits) is worth knowing but no problem.
struct CheckFinding {
    bool isNote = false;
    std::string text; ///< FILE: FIELD: what
};

} // namespace core
