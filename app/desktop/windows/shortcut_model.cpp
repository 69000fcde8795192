// SPDX-License-Identifier: MIT
#include "app/desktop/windows/shortcut_model.h"

namespace app {

namespace {

const ActionRow& rowAt(int row) {
    return actionTable()[static_cast<std::size_t>(row)];
}

} // namespace

ShortcutModel::ShortcutModel(Actions& actions, QObject* parent)
    : QAbstractTableModel(parent)
    , m_actions(actions) {
    connect(
        &actions, &Actions::shortcutsChanged, this,
        [this] { emit dataChanged(index(0, Shortcut), index(rowCount() - 1, Shortcut)); });
}

QString ShortcutModel::id(int row) const {
    return QString::fromLatin1(rowAt(row).id);
}

int ShortcutModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(actionTable().size());
}

int ShortcutModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ShortcutModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const ActionRow& row = rowAt(index.row());
    if (role == Qt::EditRole && index.column() == Shortcut)
        return QVariant::fromValue(m_actions.action(id(index.row()))->shortcut());
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case Menu:
        return plainActionText(row.menu);
    case Action:
        return m_actions.plainText(id(index.row()));
    case Shortcut:
        return m_actions.action(id(index.row()))->shortcut().toString(QKeySequence::NativeText);
    default:
        return plainActionText(row.tip);
    }
}

QVariant ShortcutModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[ColumnCount] = {tr("Menu"), tr("Action"), tr("Shortcut"), tr("What it does")};
    return names[section];
}

Qt::ItemFlags ShortcutModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.column() == Shortcut ? flags | Qt::ItemIsEditable : flags;
}

bool ShortcutModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || index.column() != Shortcut)
        return false;
    const auto shortcut = value.value<QKeySequence>();
    const QString changed = id(index.row());
    if (const auto other = m_actions.clash(changed, shortcut)) {
        emit clashed(tr("%1 belongs to \u201c%2\u201d already: change that one first.")
                         .arg(shortcut.toString(QKeySequence::NativeText), m_actions.plainText(*other)));
        return false;
    }
    m_actions.setShortcut(changed, shortcut);
    emit accepted();
    return true;
}

} // namespace app
