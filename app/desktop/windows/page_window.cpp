// SPDX-License-Identifier: MIT
#include "app/desktop/windows/page_window.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>

namespace app {

PageWindow::PageWindow(const QString& title, QWidget* page, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->addWidget(page, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

void PageWindow::present() {
    show();
    raise();
    activateWindow();
}

} // namespace app
