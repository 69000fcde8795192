// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <QIcon>
#include <QStyledItemDelegate>

namespace widgets {

/// A small square in the method's colour, for tables, lists and check boxes; `start` and `recorded` have one, too.
QIcon methodChip(std::string_view method);

/// Draws a method's chip before its name. The cell's `role` holds the method's name as methodColour knows it.
class MethodDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit MethodDelegate(int role, QObject* parent = nullptr);

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    int m_role;
};

} // namespace widgets
