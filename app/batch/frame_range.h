// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace app {

/// The frames of a range A:B:STEP as Python has it: from A on, up to B but without it, in steps. Each part may be left
/// out (0, all frames, 1). Throws Error(Usage) naming `option` if it is not such a range or holds no frame.
std::vector<int> framesOfRange(const std::string& range, int frameCount, const std::string& option);

} // namespace app
