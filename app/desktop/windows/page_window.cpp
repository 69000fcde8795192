// SPDX-License-Identifier: MIT
#include "app/desktop/windows/page_window.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr QSize kRoomForResults(640, 620); // fits 1366 x 768
constexpr int kMarginPx = 36;              // the status line stays in sight

} // namespace

PageWindow::PageWindow(const QString& title, QWidget* page, QWidget* parent, Place place)
    : QDialog(parent) {
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->addWidget(page, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    if (place == Place::AtRight) {
        resize(sizeHint());
        const QRect around = parent->window()->geometry();
        move(around.right() - width() - kMarginPx, around.bottom() - height() - kMarginPx);
    } else {
        resize(sizeHint().expandedTo(kRoomForResults)); // texts and tables come later
    }
}

void PageWindow::present() {
    show();
    raise();
    activateWindow();
}

} // namespace app
