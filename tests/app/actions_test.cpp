// SPDX-License-Identifier: MIT
#include "app/desktop/actions/actions.h"

#include <map>
#include <set>

#include <QAbstractItemModelTester>

#include "app/desktop/windows/shortcut_model.h"
#include "tests/app/window_fixture.h"

namespace {

using namespace app;

TEST(ActionTable, IdsAndShortcutsAreUnique) {
    std::set<std::string> ids;
    std::map<QKeySequence, std::string> shortcuts;
    for (const ActionRow& row : actionTable()) {
        EXPECT_TRUE(ids.insert(row.id).second) << row.id;
        const QKeySequence keys =
            QKeySequence::fromString(QString::fromLatin1(row.shortcut), QKeySequence::PortableText);
        EXPECT_FALSE(keys.isEmpty()) << row.id << " has no shortcut";
        EXPECT_EQ(shortcuts.count(keys), 0u) << row.id << " and " << shortcuts[keys];
        shortcuts[keys] = row.id;
    }
}

class ActionsTest : public test::WindowTest {};

TEST_F(ActionsTest, EveryActionDoesSomething) {
    for (const ActionRow& row : actionTable())
        EXPECT_TRUE(window->actions().isBound(QString::fromLatin1(row.id))) << row.id;
}

TEST_F(ActionsTest, ShortcutsCanBeChangedButNeverShared) {
    Actions& actions = window->actions();
    const QString undo = QStringLiteral("edit.undo");
    EXPECT_FALSE(actions.setShortcut(undo, QKeySequence(QStringLiteral("X"))));
    EXPECT_EQ(actions.action(undo)->shortcut(), QKeySequence(QStringLiteral("Ctrl+Z")));
    EXPECT_TRUE(actions.setShortcut(undo, QKeySequence(QStringLiteral("Ctrl+F12"))));
    restart();
    EXPECT_EQ(window->actions().action(undo)->shortcut(), QKeySequence(QStringLiteral("Ctrl+F12")));
    window->actions().resetShortcuts();
    EXPECT_EQ(window->actions().action(undo)->shortcut(), QKeySequence(QStringLiteral("Ctrl+Z")));
}

TEST_F(ActionsTest, ADefaultGivesWayToAKeyThatAPersonChoseBefore) {
    const QKeySequence key(QStringLiteral("R"));
    const QString proposes = QStringLiteral("annotation.propose"), undo = QStringLiteral("edit.undo");
    ASSERT_EQ(window->actions().action(proposes)->shortcut(), key);
    settings->setValue(QStringLiteral("shortcuts/") + undo, key.toString(QKeySequence::PortableText));
    restart();
    EXPECT_EQ(window->actions().action(undo)->shortcut(), key);
    EXPECT_TRUE(window->actions().action(proposes)->shortcut().isEmpty());
}

TEST_F(ActionsTest, TheShortcutPageListsEveryActionOfTheTable) {
    ShortcutModel model(window->actions());
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    EXPECT_EQ(model.rowCount(), static_cast<int>(actionTable().size()));
    QString message;
    QObject::connect(&model, &ShortcutModel::clashed, [&](const QString& text) { message = text; });
    EXPECT_FALSE(model.setData(model.index(0, ShortcutModel::Shortcut),
                               QVariant::fromValue(QKeySequence(QStringLiteral("Space")))));
    EXPECT_TRUE(message.contains(QStringLiteral("Accept")));
    EXPECT_TRUE(model.setData(model.index(0, ShortcutModel::Shortcut),
                              QVariant::fromValue(QKeySequence(QStringLiteral("Ctrl+F11")))));
    EXPECT_EQ(model.index(0, ShortcutModel::Shortcut).data().toString(), QStringLiteral("Ctrl+F11"));
}

} // namespace
