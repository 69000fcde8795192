// SPDX-License-Identifier: MIT
#include "app/desktop/windows/path_field.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QToolButton>

namespace app {

QWidget* withChooser(QLineEdit* field, const QString& title, PathKind kind, QWidget* parent) {
    auto* both = new QWidget(parent);
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* choose = new QToolButton(both);
    choose->setText(QCoreApplication::translate("app::PathField", "Choose..."));
    choose->setToolTip(title);
    row->addWidget(field, 1);
    row->addWidget(choose);
    QObject::connect(choose, &QToolButton::clicked, both, [both, field, title, kind] {
        auto* dialog = new QFileDialog(both, title, QFileInfo(field->text()).path());
        dialog->setFileMode(kind == PathKind::Folder ? QFileDialog::Directory : QFileDialog::ExistingFile);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        QObject::connect(dialog, &QFileDialog::fileSelected, field, &QLineEdit::setText);
        dialog->open();
    });
    return both;
}

} // namespace app
