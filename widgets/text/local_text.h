// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <QLocale>
#include <QString>

namespace widgets {

/// A text of core, in UTF-8.
inline QString toQString(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// A number as the person's language writes it, with that many decimals.
inline QString localNumber(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

} // namespace widgets
