// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

class QApplication;

namespace app {

/// The languages that the window speaks: "en", "de", ...
QStringList availableLanguages();
/// Loads the translations of the window and of Qt's own texts, and makes numbers follow. An empty language takes the system's;
/// one that is not available falls back to English. Returns the language that is used.
QString applyLanguage(QApplication& application, const QString& language);

} // namespace app
