// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "app/desktop/actions/actions.h"

namespace app {

/// The action table as people read it: menu, action, shortcut, what it does. The shortcut can be changed.
class ShortcutModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Menu, Action, Shortcut, Tip, ColumnCount };

    explicit ShortcutModel(Actions& actions, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Takes a key sequence; refuses one that another action has, with clashed().
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

signals:
    void clashed(const QString& message);
    void accepted();

private:
    QString id(int row) const;

    Actions& m_actions;
};

} // namespace app
