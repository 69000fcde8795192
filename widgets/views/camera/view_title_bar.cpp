// SPDX-License-Identifier: MIT
#include "widgets/views/camera/view_title_bar.h"

#include <QMouseEvent>
#include <QPainter>

namespace widgets {

namespace {

const QColor kWarning(0xE5, 0x8E, 0x26);
constexpr int kPadding = 6;
constexpr int kChip = 8; // side of the colour's square, logical pixels

} // namespace

ViewTitleBar::ViewTitleBar(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void ViewTitleBar::setTitle(const ViewTitle& title) {
    if (title == m_title)
        return;
    m_title = title;
    QString tip = QStringList{title.name, title.detail, title.error, title.next}.join(QLatin1Char(' ')).simplified();
    if (!title.tip.isEmpty())
        tip += QLatin1Char('\n') + title.tip;
    setToolTip(tip);
    update();
}

void ViewTitleBar::setCurrent(bool current) {
    m_current = current;
    update();
}

QSize ViewTitleBar::sizeHint() const {
    return {120, fontMetrics().height() + 2};
}

void ViewTitleBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QPalette& colours = palette();
    const bool isNext = !m_title.next.isEmpty() && !m_title.warning;
    painter.fillRect(rect(),
                     m_title.warning ? kWarning : colours.color(isNext ? QPalette::Highlight : QPalette::Window));
    const QColor text =
        m_title.warning ? QColor(Qt::black) : colours.color(isNext ? QPalette::HighlightedText : QPalette::WindowText);
    QColor faint = text;
    faint.setAlphaF(0.62);
    QRect space = rect().adjusted(kPadding, 0, -kPadding, 0);

    const QFontMetrics metrics = fontMetrics();
    if (m_title.colour.isValid()) {
        painter.fillRect(QRect(space.left(), (height() - kChip) / 2, kChip, kChip), m_title.colour);
        space.setLeft(space.left() + kChip + kPadding);
    }
    QFont bold = font();
    bold.setBold(true);
    // The camera's name comes first: what stands on the right gets the rest, but at least half of the line.
    const int nameWidth = std::min(QFontMetrics(bold).horizontalAdvance(m_title.name) + kPadding, space.width() / 2);
    const QString right = metrics.elidedText(m_title.error.isEmpty() && isNext ? m_title.next : m_title.error,
                                             Qt::ElideRight, space.width() - nameWidth);
    painter.setPen(text);
    painter.drawText(space, Qt::AlignRight | Qt::AlignVCenter, right);
    space.setRight(space.right() - metrics.horizontalAdvance(right) - kPadding);

    painter.setFont(bold);
    painter.setPen(m_current && !m_title.warning && !isNext ? colours.color(QPalette::Highlight) : text);
    const int detailWidth =
        m_title.keepsDetail ? std::min(metrics.horizontalAdvance(m_title.detail) + kPadding, space.width() / 2) : 0;
    const QString name = QFontMetrics(bold).elidedText(m_title.name, Qt::ElideRight, space.width() - detailWidth);
    painter.drawText(space, Qt::AlignLeft | Qt::AlignVCenter, name);
    space.setLeft(space.left() + QFontMetrics(bold).horizontalAdvance(name) + kPadding);

    painter.setFont(font());
    painter.setPen(faint);
    painter.drawText(space, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(m_title.detail, Qt::ElideRight, space.width()));
}

void ViewTitleBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        emit clicked();
}

void ViewTitleBar::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        emit doubleClicked();
}

} // namespace widgets
