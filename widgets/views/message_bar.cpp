// SPDX-License-Identifier: MIT
#include "widgets/views/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <QToolButton>

namespace widgets {

namespace {

const QColor kBackground(0x5C, 0x3B, 0x12);
const QColor kStripe(0xE5, 0x8E, 0x26);
const QColor kText(0xFF, 0xF1, 0xDC);

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent)
    , m_label(new QLabel(this)) {
    auto* close = new QToolButton(this);
    close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    close->setAutoRaise(true);
    close->setToolTip(tr("Dismiss"));
    close->setFocusPolicy(Qt::NoFocus);
    close->setIconSize({12, 12});
    m_label->setWordWrap(true);
    m_label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    QPalette colours = m_label->palette();
    colours.setColor(QPalette::WindowText, kText);
    m_label->setPalette(colours);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 3, 3, 3);
    layout->addWidget(m_label, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    hide();
    connect(close, &QToolButton::clicked, this, [this] {
        setMessage({});
        emit dismissed();
    });
}

void MessageBar::setMessage(const QString& text) {
    m_label->setText(text);
    setVisible(!text.isEmpty());
}

QString MessageBar::message() const {
    return m_label->text();
}

void MessageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), kBackground);
    painter.fillRect(0, 0, 4, height(), kStripe);
}

} // namespace widgets
