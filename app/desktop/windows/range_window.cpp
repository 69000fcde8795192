// SPDX-License-Identifier: MIT
#include "app/desktop/windows/range_window.h"

#include <algorithm>

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>

namespace app {

RangeWindow::RangeWindow(const QString& title, const QString& button, int frame, int frameCount, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* form = new QFormLayout(this);
    auto* first = new QSpinBox(this);
    auto* last = new QSpinBox(this);
    for (QSpinBox* box : {first, last}) {
        box->setRange(0, std::max(0, frameCount - 1));
        box->setValue(frame);
        box->setAlignment(Qt::AlignRight);
    }
    form->addRow(tr("From frame"), first);
    form->addRow(tr("To frame"), last);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(button, QDialogButtonBox::AcceptRole);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(buttons, &QDialogButtonBox::accepted, this, [this, first, last] {
        emit chosen(std::min(first->value(), last->value()), std::max(first->value(), last->value()));
        close();
    });
}

} // namespace app
