// SPDX-License-Identifier: MIT
#include "app/desktop/actions/actions.h"

#include <stdexcept>

#include <QApplication>
#include <QCoreApplication>
#include <QIcon>
#include <QKeyEvent>
#include <QRegularExpression>
#include <QSettings>

namespace app {

namespace {

QString translated(const char* source) {
    return *source ? QCoreApplication::translate("app::ActionTable", source) : QString();
}

QString settingOf(const QString& id) {
    return QStringLiteral("shortcuts/") + id;
}

QKeySequence defaultShortcut(const ActionRow& row) {
    return QKeySequence::fromString(QString::fromLatin1(row.shortcut), QKeySequence::PortableText);
}

/// Also without "(&X)", as languages write it whose letters are not on the keyboard.
QString withoutMnemonic(QString text) {
    static const QRegularExpression kInBrackets(QStringLiteral("\\(&.\\)"));
    text.remove(kInBrackets);
    text.replace(QLatin1String("&&"), QLatin1String("\x01"));
    text.remove(QLatin1Char('&'));
    text.replace(QLatin1Char('\x01'), QLatin1Char('&'));
    return text;
}

} // namespace

QString plainActionText(const char* source) {
    return withoutMnemonic(translated(source));
}

Actions::Actions(QWidget* window, QSettings& settings)
    : QObject(window)
    , m_settings(settings) {
    for (const ActionRow& row : actionTable()) {
        const QString id = QString::fromLatin1(row.id);
        m_rows[id] = &row;
        m_actions[id] = makeAction(row, window);
    }
    giveWayToKeptShortcuts();
    for (const auto& [id, row] : m_rows)
        refreshToolTip(id);
    qApp->installEventFilter(this);
}

/// A new version may give a default to an action that a person has given to another one long ago.
void Actions::giveWayToKeptShortcuts() {
    for (const auto& [id, row] : m_rows) {
        if (!m_settings.contains(settingOf(id)))
            continue;
        for (auto other = clash(id, action(id)->shortcut()); other && !m_settings.contains(settingOf(*other));
             other = clash(id, action(id)->shortcut()))
            action(*other)->setShortcut({});
    }
}

QAction* Actions::makeAction(const ActionRow& row, QWidget* window) {
    auto* action = new QAction(translated(row.text), window);
    const QString id = QString::fromLatin1(row.id);
    action->setObjectName(id);
    if (*row.icon)
        action->setIcon(QIcon::fromTheme(QString::fromLatin1(row.icon)));
    action->setCheckable(row.kind != ActionKind::Plain);
    action->setAutoRepeat(row.kind == ActionKind::Plain);
    const QVariant kept = m_settings.value(settingOf(id));
    action->setShortcut(kept.isValid() ? QKeySequence::fromString(kept.toString(), QKeySequence::PortableText)
                                       : defaultShortcut(row));
    action->setShortcutContext(Qt::WindowShortcut);
    window->addAction(action);
    return action;
}

QAction* Actions::action(const QString& id) const {
    return m_actions.at(id);
}

void Actions::bind(const QString& id, std::function<void()> run) {
    m_bound.insert(id);
    connect(action(id), &QAction::triggered, this, [run = std::move(run)] { run(); });
}

void Actions::bindToggle(const QString& id, std::function<void(bool)> run) {
    m_bound.insert(id);
    QAction* toggled = action(id);
    connect(toggled, &QAction::toggled, this, [run = std::move(run)](bool on) { run(on); });
    if (m_rows.at(id)->kind != ActionKind::Hold)
        return;
    connect(toggled, &QAction::triggered, this, [this, toggled](bool on) {
        endHeld();
        if (!on || toggled->shortcut().isEmpty())
            return;
        m_held = toggled;
        m_heldKey = toggled->shortcut()[0] & ~static_cast<int>(Qt::KeyboardModifierMask);
    });
}

void Actions::endHeld() {
    if (QAction* held = std::exchange(m_held, nullptr))
        held->setChecked(false);
}

bool Actions::eventFilter(QObject* watched, QEvent* event) {
    if (m_held && event->type() == QEvent::KeyRelease) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (!key->isAutoRepeat() && key->key() == m_heldKey)
            endHeld();
    } else if (m_held &&
               (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::ApplicationDeactivate)) {
        endHeld();
    }
    return QObject::eventFilter(watched, event);
}

std::optional<QString> Actions::clash(const QString& id, const QKeySequence& shortcut) const {
    if (shortcut.isEmpty())
        return std::nullopt;
    for (const auto& [other, action] : m_actions)
        if (other != id && action->shortcut() == shortcut)
            return other;
    return std::nullopt;
}

bool Actions::setShortcut(const QString& id, const QKeySequence& shortcut) {
    if (clash(id, shortcut))
        return false;
    action(id)->setShortcut(shortcut);
    if (shortcut == defaultShortcut(*m_rows.at(id)))
        m_settings.remove(settingOf(id));
    else
        m_settings.setValue(settingOf(id), shortcut.toString(QKeySequence::PortableText));
    refreshToolTip(id);
    emit shortcutsChanged();
    return true;
}

void Actions::resetShortcuts() {
    for (const auto& [id, row] : m_rows) {
        m_settings.remove(settingOf(id));
        m_actions[id]->setShortcut(defaultShortcut(*row));
        refreshToolTip(id);
    }
    emit shortcutsChanged();
}

QString Actions::plainText(const QString& id) const {
    return plainActionText(m_rows.at(id)->text);
}

void Actions::refreshToolTip(const QString& id) {
    QAction* changed = m_actions.at(id);
    QString text = plainText(id);
    if (!changed->shortcut().isEmpty())
        text += QStringLiteral(" (%1)").arg(changed->shortcut().toString(QKeySequence::NativeText));
    if (const QString tip = translated(m_rows.at(id)->tip); !tip.isEmpty())
        text += QLatin1Char('\n') + tip;
    changed->setToolTip(text);
}

} // namespace app
