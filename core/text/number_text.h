// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace core {

// Numbers as files want them: a point whatever the language of the system. NaN is an empty text.

/// With that many digits after the point.
inline std::string fixedText(double value, int digits) {
    if (std::isnan(value)) {
        return "";
    }
    std::array<char, 400> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits).ptr;
    return {text.data(), end};
}

/// The shortest text that reads back as the same number.
inline std::string exactText(double value) {
    if (std::isnan(value)) {
        return "";
    }
    std::array<char, 64> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

} // namespace core
