// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace core {

/// Text with &, <, > and quotes escaped for HTML.
std::string htmlEscaped(const std::string& text);

/// The look that all reports share, the content of a <style> element: plain, readable in print, numbers in tabular
/// figures.
extern const char* const kReportStyle;

/// A cell of a table's body: text to the left; numbers to the right, empty if there is none.
std::string htmlTextCell(const std::string& text);
std::string htmlNumberCell(double value, int digits);

} // namespace core
