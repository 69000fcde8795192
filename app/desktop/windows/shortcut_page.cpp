// SPDX-License-Identifier: MIT
#include "app/desktop/windows/shortcut_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "app/desktop/actions/actions.h"
#include "app/desktop/windows/shortcut_model.h"
#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/views/message_bar.h"

namespace app {

namespace {

/// Edits a shortcut by pressing it.
class ShortcutDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
        auto* editor = new QKeySequenceEdit(parent);
        connect(editor, &QKeySequenceEdit::editingFinished, this, [this, editor] {
            auto* self = const_cast<ShortcutDelegate*>(this);
            emit self->commitData(editor);
            emit self->closeEditor(editor);
        });
        return editor;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        static_cast<QKeySequenceEdit*>(editor)->setKeySequence(index.data(Qt::EditRole).value<QKeySequence>());
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        const QKeySequence pressed = static_cast<QKeySequenceEdit*>(editor)->keySequence();
        model->setData(index, QVariant::fromValue(pressed.isEmpty() ? pressed : QKeySequence(pressed[0])));
    }
};

} // namespace

ShortcutPage::ShortcutPage(Actions& actions, QWidget* parent)
    : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::kSpacing);
    auto* message = new widgets::MessageBar(this);
    auto* search = new QLineEdit(this);
    search->setPlaceholderText(tr("Search"));
    search->setClearButtonEnabled(true);
    auto* model = new ShortcutModel(actions, this);
    auto* proxy = new QSortFilterProxyModel(this);
    proxy->setSourceModel(model);
    proxy->setFilterKeyColumn(-1);
    proxy->setFilterCaseSensitivity(Qt::CaseInsensitive);
    auto* table = new QTableView(this);
    table->setModel(proxy);
    widgets::styleTable(*table);
    table->setWordWrap(true);
    table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(ShortcutModel::Tip, QHeaderView::Stretch);
    table->setItemDelegateForColumn(ShortcutModel::Shortcut, new ShortcutDelegate(table));
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto* reset = new QPushButton(tr("Reset all"), this);
    reset->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Double-click a shortcut to change it."), this), 1);
    row->addWidget(reset);
    column->addWidget(message);
    column->addWidget(search);
    column->addWidget(table, 1);
    column->addLayout(row);
    connect(search, &QLineEdit::textChanged, proxy, &QSortFilterProxyModel::setFilterFixedString);
    connect(reset, &QPushButton::clicked, &actions, &Actions::resetShortcuts);
    connect(model, &ShortcutModel::clashed, message, &widgets::MessageBar::setMessage);
    connect(model, &ShortcutModel::accepted, message, [message] { message->setMessage({}); });
}

} // namespace app
