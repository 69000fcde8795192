// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QString>
#include <QStringList>

class QApplication;

namespace app {

/// The languages that the window speaks: "en", "de", ...
QStringList availableLanguages();
/// The language of the window that fits a wish such as "de", "de_AT" or "zh"; empty if there is none.
std::optional<QString> knownLanguage(const QString& wanted);
/// Loads the translations of the window and of Qt's own texts, and makes numbers follow. An empty language takes the
/// system's; one that is not available falls back to English. Returns the language that is used.
QString applyLanguage(QApplication& application, const QString& language);

} // namespace app
