// SPDX-License-Identifier: MIT
#include "core/text/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace core {

std::string fixedText(double value, int digits) {
    if (std::isnan(value))
        return "";
    std::array<char, 400> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits).ptr;
    return {text.data(), end};
}

std::string exactText(double value) {
    if (std::isnan(value))
        return "";
    std::array<char, 64> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

bool parseNumber(std::string_view word, double& value) {
    if (word.starts_with('+'))
        word.remove_prefix(1);
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    return failure == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

} // namespace core
