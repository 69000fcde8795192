// SPDX-License-Identifier: MIT
#include "app/desktop/windows/export_window.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/desktop/windows/annotation_format_text.h"
#include "core/io/formats/annotation_formats.h"
#include "widgets/panels/state_colours.h"
#include "widgets/text/local_text.h"

namespace app {

namespace {

constexpr int kTextWidth = 340; // logical pixels

QLabel* wrappedLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setMinimumWidth(kTextWidth);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

ExportWindow::ExportWindow(const QString& kind, QWidget* parent)
    : QDialog(parent)
    , m_kinds(new QListWidget(this))
    , m_holds(wrappedLabel(this))
    , m_readBy(wrappedLabel(this))
    , m_lost(wrappedLabel(this))
    , m_whose(wrappedLabel(this)) {
    setWindowTitle(tr("Export annotations"));
    setAttribute(Qt::WA_DeleteOnClose);
    for (const core::AnnotationFormat& format : core::annotationFormats()) {
        if (!format.canExport)
            continue;
        auto* item = new QListWidgetItem(annotationFormatText(format.kind).name, m_kinds);
        item->setData(Qt::UserRole, widgets::toQString(format.kind));
        if (widgets::toQString(format.kind) == kind)
            m_kinds->setCurrentItem(item);
    }
    if (!m_kinds->currentItem())
        m_kinds->setCurrentRow(0);
    m_kinds->setMinimumWidth(m_kinds->sizeHintForColumn(0) + 4 * widgets::kSpacing);
    m_kinds->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Expanding);
    auto* explanation = new QFormLayout;
    explanation->setRowWrapPolicy(QFormLayout::WrapAllRows);
    explanation->setVerticalSpacing(widgets::kSpacing);
    explanation->addRow(tr("<b>Holds</b>"), m_holds);
    explanation->addRow(tr("<b>Read by</b>"), m_readBy);
    explanation->addRow(tr("<b>Not in it</b>"), m_lost);
    explanation->addRow(tr("<b>Written are</b>"), m_whose);
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * widgets::kSpacing);
    row->addWidget(m_kinds);
    row->addLayout(explanation, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* go = buttons->addButton(tr("Choose where..."), QDialogButtonBox::AcceptRole);
    go->setDefault(true);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(buttons);
    connect(m_kinds, &QListWidget::currentItemChanged, this, &ExportWindow::explain);
    connect(m_kinds, &QListWidget::itemActivated, this, &ExportWindow::choose);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportWindow::choose);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    m_kinds->setFocus();
    explain();
}

QString ExportWindow::kind() const {
    return m_kinds->currentItem()->data(Qt::UserRole).toString();
}

void ExportWindow::explain() {
    const std::string chosenKind = kind().toStdString();
    const AnnotationFormatText format = annotationFormatText(chosenKind);
    m_holds->setText(format.holds);
    m_readBy->setText(format.readBy);
    m_lost->setText(format.lost);
    m_whose->setText(core::annotationFormat(chosenKind).namesRaters
                         ? tr("The annotations of all raters of this sequence, with their names")
                         : tr("Your own annotations of this sequence"));
}

void ExportWindow::choose() {
    const QString wanted = kind();
    close();
    emit chosen(wanted);
}

} // namespace app
