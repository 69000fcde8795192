// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/jobs/first_pass.h"

namespace widgets {

/// The first pass of core: the hand detector whose networks are installed in the user's data folder.
FirstPassProgram detectorFirstPass();

} // namespace widgets
