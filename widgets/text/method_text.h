// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <QString>

namespace widgets {

/// What an option of a method does, with its unit, in the person's language; empty for an unknown key.
QString optionMeaning(std::string_view key);

/// What is wrong with a method as written on the command line, in one sentence; empty if nothing is.
QString methodProblem(const QString& method);

} // namespace widgets
