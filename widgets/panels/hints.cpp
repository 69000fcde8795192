// SPDX-License-Identifier: MIT
#include "widgets/panels/hints.h"

#include <algorithm>

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"

namespace widgets {

Hints::Hints(QWidget* parent)
    : QFrame(parent) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(3 * kSpacing, 2 * kSpacing, 3 * kSpacing, 2 * kSpacing);
    column->setSpacing(kSpacing);
    const QString hints[] = {
        tr("Choose a joint on the left, then click it in two views: its 3D place appears at once."),
        tr("Space accepts a pre-placed mark, X deletes one, Ctrl+Z takes back anything."),
        tr("The wheel zooms, the middle button moves, a double click fills the window with one view; 9 frames the "
           "hands, 0 shows whole pictures."),
        tr("A and D step through the frames, W and S through the joints; F1 shows every key.")};
    for (const QString& hint : hints) {
        auto* label = new QLabel(QStringLiteral("\u2022  ") + hint, this);
        label->setWordWrap(true);
        column->addWidget(label);
    }
    auto* close = new QPushButton(tr("Got it (Esc)"), this);
    close->setFocusPolicy(Qt::NoFocus);
    column->addWidget(close, 0, Qt::AlignRight);
    connect(close, &QPushButton::clicked, this, &Hints::dismiss);
    parent->installEventFilter(this);
}

void Hints::dismiss() {
    hide();
    emit closed();
}

void Hints::place() {
    constexpr int kWidth = 620; // logical pixels, where there are as many
    const QWidget* around = parentWidget();
    const int width = std::min(kWidth, around->width() - 4 * kSpacing);
    setFixedSize(width, layout()->heightForWidth(width));
    move((around->width() - width) / 2, around->height() - height() - 4 * kSpacing);
    raise();
}

bool Hints::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

void Hints::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    place();
}

} // namespace widgets
