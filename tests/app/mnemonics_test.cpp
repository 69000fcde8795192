// SPDX-License-Identifier: MIT
#include "app/desktop/actions/mnemonics.h"

#include <map>

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <QTranslator>

#include "app/desktop/language.h"
#include "app/desktop/resources.h"
#include "tests/app/window_fixture.h"

namespace {

using app::withDistinctMnemonics;

TEST(Mnemonics, StayWhereTheyDoNotClash) {
    const QStringList texts{"&Open", "Clo&se", "Without a letter", "&Save && quit"};
    EXPECT_EQ(withDistinctMnemonics(texts), (QStringList{"&Open", "Clo&se", "Without a letter", "Save && &quit"}));
    EXPECT_EQ(withDistinctMnemonics({"&Open", "&Close"}), (QStringList{"&Open", "&Close"}));
}

TEST(Mnemonics, MoveToTheStartOfAnotherWordOrIntoAWord) {
    EXPECT_EQ(withDistinctMnemonics({"&Panel", "Show &panel"}), (QStringList{"&Panel", "&Show panel"}));
    EXPECT_EQ(withDistinctMnemonics({"&Stop", "&Panel", "S&cene", "&sp ice"}),
              (QStringList{"&Stop", "&Panel", "S&cene", "sp &ice"}));
    EXPECT_EQ(withDistinctMnemonics({"&Stop", "&So"}), (QStringList{"&Stop", "S&o"}));
    EXPECT_EQ(withDistinctMnemonics({"&A", "&B", "&AB"}), (QStringList{"&A", "&B", "AB"})) << "none is free";
}

TEST(Mnemonics, OfLanguagesWithoutLettersOnTheKeyboardStayInBrackets) {
    const QString first = QString::fromUtf8("停止(&A)"), second = QString::fromUtf8("保存(&A)...");
    EXPECT_EQ(withDistinctMnemonics({first, second}), (QStringList{first, QString::fromUtf8("保存(&B)...")}));
}

TEST(Mnemonics, DoNotMoveToLettersWithAccents) {
    EXPECT_EQ(withDistinctMnemonics({QString::fromUtf8("&Ö"), QString::fromUtf8("&ÖÄx")}),
              (QStringList{QString::fromUtf8("&Ö"), QString::fromUtf8("ÖÄ&x")}));
}

class MenusOfTheWindow : public test::WindowTest {
protected:
    void expectDistinct(const QWidget& menu, const std::string& language) {
        std::map<QString, QString> texts;
        for (const QAction* action : menu.actions()) {
            const QKeySequence keys = QKeySequence::mnemonic(action->text());
            if (!keys.isEmpty()) {
                const auto [other, isNew] = texts.emplace(keys.toString(), action->text());
                EXPECT_TRUE(isNew) << language << ": " << other->second.toStdString() << " and "
                                   << action->text().toStdString();
                ++m_letters;
            }
        }
    }
    int m_letters = 0;
};

TEST_F(MenusOfTheWindow, HaveNoLetterTwiceInAnyLanguage) {
    app::initResources();
    for (const QString& language : app::availableLanguages()) {
        QTranslator translator;
        if (translator.load(QStringLiteral("handlens_") + language, QStringLiteral(":/translations")))
            QCoreApplication::installTranslator(&translator);
        restart();
        m_letters = 0;
        expectDistinct(*window->menuBar(), language.toStdString());
        const QList<QMenu*> menus = window->menuBar()->findChildren<QMenu*>();
        EXPECT_GT(menus.size(), 10);
        for (const QMenu* menu : menus)
            expectDistinct(*menu, language.toStdString());
        EXPECT_GT(m_letters, 60) << language.toStdString();
        window.reset();
        QCoreApplication::removeTranslator(&translator);
    }
}

} // namespace
