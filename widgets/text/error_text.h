// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

#include <QString>

namespace widgets {

/// What went wrong, in the person's language: file, field and a sentence by the error's code. The error's own detail is
/// English: an English window shows it in place of the sentence, any other keeps it behind the text (detailOf).
QString errorInWords(const std::exception& error);

/// The part of a message that is shown.
QString withoutDetail(const QString& message);
/// The English detail behind a message, for a tool tip; empty if there is none.
QString detailOf(const QString& message);
/// Both, for a terminal or a script's answer: "TEXT (DETAIL)".
QString withDetailBehind(const QString& message);

} // namespace widgets
