// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/fitting/method.h"

namespace core {

/// Which values an option can have: a number, or one of two words.
struct OptionDomain {
    double low = 0; ///< numbers: least and greatest, both allowed
    double high = 0;
    bool isWhole = false;                    ///< numbers: without decimals
    std::array<std::string_view, 2> words{}; ///< of choices; empty for numbers

    bool isNumber() const { return words.front().empty(); }
};

/// An option of a method's name, `key=value`. The table of them is the only list: parsing, names, error messages and
/// the report read it.
struct MethodOption {
    std::string_view key;
    unsigned methods;             ///< which methods have it, see appliesTo
    std::string_view meaning;     ///< English, with the unit
    std::string_view defaultText; ///< as the value is written, or in words where it depends on the distance
    std::string_view source;      ///< of the default: "paper", or "own" and what the paper says
    OptionDomain domain;

    /// Sets the option. The answer says what is wrong with the value; it is empty if the option was set.
    std::string (*parse)(Method& method, std::string_view value);
    /// The value as parse reads it.
    std::string (*print)(const Method& method);

    bool appliesTo(const Method& method) const;
};

/// All options, in the order in which a method's name holds them.
std::span<const MethodOption> methodOptions();

/// The option of that key. Throws std::out_of_range if there is none.
const MethodOption& methodOption(std::string_view key);

} // namespace core
