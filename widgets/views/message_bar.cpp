// SPDX-License-Identifier: MIT
#include "widgets/views/message_bar.h"

#include "widgets/text/error_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

namespace widgets {

namespace {

struct BarColours {
    QColor background, stripe, text;
};
const BarColours kWarning{QColor(0x5C, 0x3B, 0x12), QColor(0xE5, 0x8E, 0x26), QColor(0xFF, 0xF1, 0xDC)};
const BarColours kNotice{QColor(0x1C, 0x3A, 0x57), QColor(0x4D, 0xA3, 0xFF), QColor(0xE3, 0xF0, 0xFF)};
constexpr int kNarrow = 460; ///< below this width the buttons stand under the text

const BarColours& coloursOf(MessageBar::Tone tone) {
    return tone == MessageBar::Tone::Warning ? kWarning : kNotice;
}

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent)
    , m_content(new QBoxLayout(QBoxLayout::LeftToRight))
    , m_buttons(new QBoxLayout(QBoxLayout::LeftToRight))
    , m_label(new QLabel(this)) {
    auto* close = new QToolButton(this);
    m_close = close;
    close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    close->setAutoRaise(true);
    close->setToolTip(tr("Dismiss"));
    close->setFocusPolicy(Qt::NoFocus);
    close->setIconSize({12, 12});
    m_label->setWordWrap(true);
    m_label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_content->addWidget(m_label, 1);
    m_content->addLayout(m_buttons);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 3, 3, 3);
    layout->addLayout(m_content, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    setColours(Tone::Warning);
    hide();
    connect(close, &QToolButton::clicked, this, [this] {
        setMessage({});
        emit dismissed();
    });
}

void MessageBar::setMessage(const QString& text) {
    offer(text, {}, Tone::Warning);
}

void MessageBar::offer(const QString& text, const std::vector<MessageAction>& actions, Tone tone) {
    while (QLayoutItem* item = m_buttons->takeAt(0)) {
        if (item->widget()) {
            item->widget()->hide();
            item->widget()->deleteLater(); // it may be the one that was pressed
        }
        delete item;
    }
    for (const MessageAction& action : actions) {
        auto* button = new QPushButton(action.text, this);
        button->setFocusPolicy(Qt::NoFocus);
        m_buttons->addWidget(button);
        button->show(); // at once, also where the bar is shown already
        connect(button, &QPushButton::clicked, this, [this, run = action.run] {
            setMessage({});
            run();
        });
    }
    m_buttons->addStretch(1);
    setColours(tone);
    m_label->setText(withoutDetail(text));
    m_label->setToolTip(detailOf(text));
    arrange(parentWidget() ? parentWidget()->width() : width());
    setVisible(!text.isEmpty());
}

void MessageBar::setDismissible(bool dismissible) {
    m_close->setVisible(dismissible);
}

QString MessageBar::message() const {
    return m_label->text();
}

void MessageBar::setColours(Tone tone) {
    m_tone = tone;
    QPalette colours = m_label->palette();
    colours.setColor(QPalette::WindowText, coloursOf(tone).text);
    m_label->setPalette(colours);
    update();
}

void MessageBar::arrange(int width) {
    m_content->setDirection(width < kNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void MessageBar::resizeEvent(QResizeEvent* event) {
    arrange(width());
    QWidget::resizeEvent(event);
}

void MessageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), coloursOf(m_tone).background);
    painter.fillRect(0, 0, 4, height(), coloursOf(m_tone).stripe);
}

} // namespace widgets
