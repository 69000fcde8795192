// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/fitting/method.h"

namespace core {

/// Parses `ch`, `dch-thres:tau=22.5:signed=1`, `best:live=1`, ... Throws Error(Usage) naming the option at fault.
Method parseMethod(std::string_view text);
/// The text as given on the command line: name and the options that differ from the default.
std::string methodName(const Method& method);
/// The six plain names, in the paper's order.
std::vector<std::string> plainMethodNames();

} // namespace core
