// SPDX-License-Identifier: MIT
// Every text of the window is translated, with the places of its values.
#include <set>

#include <QApplication>
#include <QDir>
#include <QDomDocument>
#include <QFile>
#include <QRegularExpression>

#include <gtest/gtest.h>

#include "app/desktop/actions/action_table.h"
#include "app/desktop/language.h"

namespace {

struct Message {
    QString context, source;
    QStringList translations; ///< plural forms, or one
    bool finished = true;
};

std::vector<Message> messagesOf(const QString& file) {
    QFile stream(file);
    QDomDocument document;
    EXPECT_TRUE(stream.open(QIODevice::ReadOnly) && document.setContent(&stream)) << file.toStdString();
    std::vector<Message> messages;
    const QDomNodeList nodes = document.elementsByTagName(QStringLiteral("message"));
    for (int i = 0; i < nodes.count(); ++i) {
        const QDomElement element = nodes.at(i).toElement();
        const QDomElement translation = element.firstChildElement(QStringLiteral("translation"));
        Message message;
        message.context = element.parentNode().firstChildElement(QStringLiteral("name")).text();
        message.source = element.firstChildElement(QStringLiteral("source")).text();
        message.finished = translation.attribute(QStringLiteral("type")).isEmpty();
        const QDomNodeList forms = translation.elementsByTagName(QStringLiteral("numerusform"));
        for (int form = 0; form < forms.count(); ++form)
            message.translations << forms.at(form).toElement().text();
        if (forms.isEmpty())
            message.translations << translation.text();
        messages.push_back(message);
    }
    return messages;
}

std::multiset<QString> placesOf(const QString& text) {
    std::multiset<QString> places;
    static const QRegularExpression kPlace(QStringLiteral("%([0-9]|n|p)"));
    for (auto match = kPlace.globalMatch(text); match.hasNext();)
        places.insert(match.next().captured(0));
    return places;
}

QStringList translationFiles() {
    const QDir folder(QStringLiteral(HANDLENS_SOURCE_DIR "/translations"));
    QStringList files;
    for (const QString& name : folder.entryList({QStringLiteral("handlens_*.ts")}))
        files << folder.filePath(name);
    return files;
}

TEST(Translations, AreWhole) {
    ASSERT_GE(translationFiles().size(), 2);
    for (const QString& file : translationFiles()) {
        const bool pluralsOnly = file.endsWith(QStringLiteral("_en.ts"));
        const auto messages = messagesOf(file);
        EXPECT_GT(messages.size(), pluralsOnly ? 10u : 300u);
        for (const Message& message : messages) {
            EXPECT_TRUE(message.finished) << file.toStdString() << ": " << message.source.toStdString();
            for (const QString& translation : message.translations) {
                EXPECT_FALSE(translation.isEmpty()) << file.toStdString() << ": " << message.source.toStdString();
                std::multiset<QString> places = placesOf(translation), wanted = placesOf(message.source);
                places.erase(QStringLiteral("%n")); // "one mark" needs no number
                wanted.erase(QStringLiteral("%n"));
                EXPECT_EQ(places, wanted) << file.toStdString() << ": " << message.source.toStdString();
            }
        }
    }
}

/// The action table is data: a text that is not marked for translation would stay English without a warning.
TEST(Translations, KnowEveryAction) {
    for (const QString& file : translationFiles()) {
        if (file.endsWith(QStringLiteral("_en.ts")))
            continue;
        std::set<QString> known;
        for (const Message& message : messagesOf(file))
            if (message.context == QStringLiteral("app::ActionTable"))
                known.insert(message.source);
        for (const app::ActionRow& row : app::actionTable()) {
            EXPECT_TRUE(known.count(QString::fromUtf8(row.text))) << row.id;
            EXPECT_TRUE(!*row.tip || known.count(QString::fromUtf8(row.tip))) << row.id;
        }
    }
}

TEST(Translations, AreCompiledIn) {
    EXPECT_TRUE(app::availableLanguages().contains(QStringLiteral("de")));
    EXPECT_TRUE(app::availableLanguages().contains(QStringLiteral("en")));
}

} // namespace
