// SPDX-License-Identifier: MIT
#include "app/desktop/windows/footage_page.h"

#include <algorithm>
#include <set>

#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "widgets/jobs/dataset_maker.h"

namespace app {

namespace {

enum FootageColumn { kFootage, kCamera, kFirstFrame };
constexpr int kMostFrames = 10'000'000;

} // namespace

FootagePage::FootagePage(QWidget* parent)
    : QWidget(parent)
    , m_table(new QTableWidget(0, 3, this))
    , m_sequence(new QLineEdit(QStringLiteral("1"), this)) {
    auto* introduction = new QLabel(tr("The videos of the cameras, or folders of numbered images. Drop them here, or a "
                                       "folder with all of them. Nothing is copied: the footage stays where it is."),
                                    this);
    introduction->setWordWrap(true);
    m_table->setHorizontalHeaderLabels({tr("Video or image folder"), tr("Camera"), tr("Starts at frame")});
    m_table->horizontalHeader()->setSectionResizeMode(kFootage, QHeaderView::Stretch);
    for (const int column : {kCamera, kFirstFrame})
        m_table->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_table->horizontalHeaderItem(kFirstFrame)
        ->setToolTip(tr("The frame of this footage that was recorded when the sequence begins."));
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTextElideMode(Qt::ElideLeft);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(introduction);
    column->addWidget(m_table, 1);
    addButtons(*column);
    auto* form = new QFormLayout;
    form->addRow(tr("Name of the sequence"), m_sequence);
    column->addLayout(form);
    connect(m_sequence, &QLineEdit::textChanged, this, &FootagePage::changed);
}

void FootagePage::addButtons(QVBoxLayout& column) {
    auto* videos = new QPushButton(tr("Add videos..."), this);
    auto* images = new QPushButton(tr("Add a folder..."), this);
    auto* remove = new QPushButton(tr("Remove"), this);
    connect(
        videos, &QPushButton::clicked, this, [this] { askForFootage(false); });
    connect(images, &QPushButton::clicked, this, [this] { askForFootage(true); });
    connect(remove, &QPushButton::clicked, this, [this] {
        m_table->removeRow(m_table->currentRow());
        emit changed();
    });
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {videos, images, remove}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    column.addLayout(buttons);
}

void FootagePage::askForFootage(bool isFolder) {
    auto* dialog =
        new QFileDialog(this, isFolder ? tr("A folder of numbered images, or of videos") : tr("Videos of the cameras"));
    dialog->setFileMode(isFolder ? QFileDialog::Directory : QFileDialog::ExistingFiles);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::filesSelected, this, &FootagePage::chosen);
    dialog->open();
}

QComboBox* FootagePage::choiceIn(int row) const {
    return qobject_cast<QComboBox*>(m_table->cellWidget(row, kCamera));
}

QStringList FootagePage::paths() const {
    QStringList all;
    for (int row = 0; row < m_table->rowCount(); ++row)
        all << m_table->item(row, kFootage)->text();
    return all;
}

void FootagePage::addFootage(const QStringList& added) {
    for (const QString& path : added) {
        if (paths().contains(path))
            continue;
        const int row = m_table->rowCount();
        m_table->insertRow(row);
        auto* item = new QTableWidgetItem(path);
        item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
        item->setToolTip(path);
        m_table->setItem(row, kFootage, item);
        auto* choice = new QComboBox(m_table);
        m_table->setCellWidget(row, kCamera, choice);
        connect(choice, qOverload<int>(&QComboBox::currentIndexChanged), this, &FootagePage::changed);
        auto* first = new QSpinBox(m_table);
        first->setRange(-1, kMostFrames);
        first->setValue(-1);
        first->setSpecialValueText(tr("its first"));
        m_table->setCellWidget(row, kFirstFrame, first);
    }
    setCameras(m_cameras);
}

void FootagePage::setCameras(const QStringList& names) {
    m_cameras = names;
    const QStringList matches = widgets::matchFootage(names, paths());
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QComboBox* choice = choiceIn(row);
        const QString before = choice->currentIndex() > 0 ? choice->currentText() : matches[row];
        const QSignalBlocker blocker(choice);
        choice->clear();
        choice->addItem(tr("not used"));
        choice->addItems(names);
        choice->setCurrentIndex(std::max(0, choice->findText(before)));
    }
    emit changed();
}

std::vector<core::Footage> FootagePage::footage() const {
    std::vector<core::Footage> all;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        if (choiceIn(row)->currentIndex() <= 0)
            continue;
        core::Footage one{choiceIn(row)->currentText().toStdString(),
                          m_table->item(row, kFootage)->text().toStdString()};
        if (const int first = qobject_cast<QSpinBox*>(m_table->cellWidget(row, kFirstFrame))->value(); first >= 0)
            one.offsetFrames = first;
        all.push_back(one);
    }
    return all;
}

QString FootagePage::problem() const {
    if (m_table->rowCount() == 0)
        return tr("Add the videos or image folders of the cameras.");
    std::set<std::string> used;
    for (const core::Footage& one : footage())
        if (!used.insert(one.camera).second)
            return tr("Two pieces of footage are given to %1.").arg(QString::fromStdString(one.camera));
    if (used.empty() && !m_cameras.isEmpty())
        return tr("Choose the camera of each piece of footage.");
    return sequence().isEmpty() ? tr("Give the sequence a name.") : QString();
}

} // namespace app
