// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace core {

/// The name under which the person is logged in: of the environment (LOGNAME, USER), else of the system; "annotator" if
/// both are unknown.
std::string loginName();

} // namespace core
