// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace widgets {

/// A text of core, in UTF-8.
inline QString toQString(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// Translates texts of one context that do not belong to a class with tr(). Call it as text(QT_TRANSLATE_NOOP(...)), so
/// that lupdate finds the text.
struct LocalText {
    const char* context;
    QString operator()(const char* source, int count = -1) const {
        return QCoreApplication::translate(context, source, nullptr, count);
    }
};

/// A number as the person's language writes it, with that many decimals.
inline QString localNumber(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

} // namespace widgets
