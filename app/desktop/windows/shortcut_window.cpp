// SPDX-License-Identifier: MIT
#include "app/desktop/windows/shortcut_window.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/desktop/windows/shortcut_page.h"

namespace app {

ShortcutWindow::ShortcutWindow(Actions& actions, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("Shortcuts"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(980, 640);
    auto* column = new QVBoxLayout(this);
    column->addWidget(new ShortcutPage(actions, this), 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

} // namespace app
