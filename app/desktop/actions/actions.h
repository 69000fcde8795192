// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <QString>

#include "app/desktop/actions/action_table.h"

class QSettings;

namespace app {

/// A text of the action table in the person's language, without its mnemonic.
QString plainActionText(const char* source);

/// The window's actions, made from the action table. Shortcuts can be changed; two actions never share one.
class Actions : public QObject {
    Q_OBJECT

public:
    /// The actions belong to `window`, where their shortcuts work.
    Actions(QWidget* window, QSettings& settings);

    /// Throws std::out_of_range for an id that is not in the table.
    QAction* action(const QString& id) const;
    bool contains(const QString& id) const { return m_actions.count(id) > 0; }

    /// What a plain action does.
    void bind(const QString& id, std::function<void()> run);
    /// What an action that is on or off (or held) does.
    void bindToggle(const QString& id, std::function<void(bool)> run);

    bool isBound(const QString& id) const { return m_bound.count(id) > 0; }

    /// The id of another action with that shortcut, if there is one.
    std::optional<QString> clash(const QString& id, const QKeySequence& shortcut) const;
    /// Sets and keeps a shortcut; refuses a clash and returns false. An empty one takes it away.
    bool setShortcut(const QString& id, const QKeySequence& shortcut);
    void resetShortcuts();

    /// The action's text without mnemonic, in the person's language.
    QString plainText(const QString& id) const;

signals:
    void shortcutsChanged();

protected:
    /// Ends held actions when their key is released or the window loses the keyboard.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void giveWayToKeptShortcuts();
    QAction* makeAction(const ActionRow& row, QWidget* window);
    void refreshToolTip(const QString& id);
    void endHeld();

    QSettings& m_settings;
    std::map<QString, QAction*> m_actions;
    std::map<QString, const ActionRow*> m_rows;
    std::set<QString> m_bound;
    QAction* m_held = nullptr;
    int m_heldKey = 0;
};

} // namespace app
