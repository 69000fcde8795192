// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace core {

// Numbers as files want them: a point whatever the language of the system. NaN is an empty text.

/// With that many digits after the point.
std::string fixedText(double value, int digits);
/// The shortest text that reads back as the same number.
std::string exactText(double value);

/// The number that a whole word is; false if the word is anything else, or not finite. A leading + is allowed.
bool parseNumber(std::string_view word, double& value);

} // namespace core
