// SPDX-License-Identifier: MIT
#include "widgets/views/method_chip.h"

#include <QPainter>

#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr int kChip = 12;

} // namespace

QIcon methodChip(std::string_view method) {
    QPixmap pixmap(kChip, kChip);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(methodColour(method));
    painter.drawRoundedRect(QRectF(1, 1, kChip - 2, kChip - 2), 2, 2);
    return pixmap;
}

MethodDelegate::MethodDelegate(int role, QObject* parent)
    : QStyledItemDelegate(parent)
    , m_role(role) {}

void MethodDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    option->features |= QStyleOptionViewItem::HasDecoration;
    option->icon = methodChip(index.data(m_role).toString().toStdString());
    option->decorationSize = QSize(kChip, kChip);
}

} // namespace widgets
