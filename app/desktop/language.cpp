// SPDX-License-Identifier: MIT
#include "app/desktop/language.h"

#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "app/desktop/resources.h"

namespace app {

namespace {

const QString kFolder = QStringLiteral(":/translations");
const QString kPrefix = QStringLiteral("handlens_");

} // namespace

std::optional<QString> knownLanguage(const QString& wanted) {
    const QStringList languages = availableLanguages();
    if (languages.contains(wanted))
        return wanted;
    const QString plain = wanted.section(QLatin1Char('_'), 0, 0);
    if (languages.contains(plain))
        return plain;
    for (const QString& language : languages)
        if (language.startsWith(plain + QLatin1Char('_')))
            return language;
    return std::nullopt;
}

QStringList availableLanguages() {
    initResources();
    QStringList languages{QStringLiteral("en")};
    for (const QString& file : QDir(kFolder).entryList({kPrefix + QStringLiteral("*.qm")})) {
        const QString language = file.mid(kPrefix.size()).chopped(3);
        if (!languages.contains(language))
            languages << language;
    }
    languages.sort();
    return languages;
}

QString applyLanguage(QApplication& application, const QString& language) {
    initResources();
    const QString chosen =
        knownLanguage(language.isEmpty() ? QLocale::system().name() : language).value_or(QStringLiteral("en"));
    QLocale::setDefault(chosen == QLatin1String("en") ? QLocale(QLocale::English, QLocale::UnitedKingdom)
                                                      : QLocale(chosen));
    auto* own = new QTranslator(&application);
    if (own->load(kPrefix + chosen, kFolder))
        application.installTranslator(own);
    auto* qt = new QTranslator(&application);
    const QString folder =
        QLibraryInfo::location(QLibraryInfo::TranslationsPath); // of Qt's own dialogs; older ones are named qt_
    if (qt->load(QStringLiteral("qtbase_") + chosen, folder) || qt->load(QStringLiteral("qt_") + chosen, folder))
        application.installTranslator(qt);
    return chosen;
}

} // namespace app
