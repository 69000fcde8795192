// SPDX-License-Identifier: MIT
#include "app/desktop/windows/new_dataset_window.h"

#include <set>

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/desktop/main_window.h"

namespace app {

namespace {

constexpr int kTypingMs = 400;
enum Column { kFootage, kCamera };

} // namespace

NewDatasetWindow::NewDatasetWindow(MainWindow& window)
    : QDialog(&window)
    , m_window(window)
    , m_maker(window.session().pool)
    , m_message(new widgets::MessageBar(this))
    , m_calibration(new QLineEdit(this))
    , m_unit(new QComboBox(this))
    , m_table(new QTableWidget(0, 2, this))
    , m_sequence(new QLineEdit(QStringLiteral("1"), this))
    , m_folder(new QLineEdit(this))
    , m_make(nullptr) {
    build();
    m_wait.setSingleShot(true);
    m_wait.setInterval(kTypingMs);
    connect(&m_wait, &QTimer::timeout, this, &NewDatasetWindow::readCameras);
    connect(m_calibration, &QLineEdit::textChanged, this, [this] { m_wait.start(); });
    connect(m_unit, qOverload<int>(&QComboBox::currentIndexChanged), this, &NewDatasetWindow::readCameras);
    for (const QLineEdit* field : {m_calibration, m_sequence, m_folder})
        connect(field, &QLineEdit::textChanged, this, &NewDatasetWindow::refresh);
    connect(m_make, &QPushButton::clicked, this, &NewDatasetWindow::make);
    connect(&m_maker, &widgets::DatasetMaker::camerasRead, this, &NewDatasetWindow::showCameras);
    connect(&m_maker, &widgets::DatasetMaker::failed, m_message, &widgets::MessageBar::setMessage);
    connect(&m_maker, &widgets::DatasetMaker::idle, this, &NewDatasetWindow::refresh);
    connect(&m_maker, &widgets::DatasetMaker::made, this, [this](const QString& folder, const QString& notes) {
        m_window.openDataset(folder);
        if (!notes.isEmpty())
            m_window.showMessage(notes);
        close();
    });
    refresh();
}

NewDatasetWindow* NewDatasetWindow::open(MainWindow& window, const QStringList& footage) {
    auto* dialog = window.findChild<NewDatasetWindow*>();
    if (!dialog) {
        dialog = new NewDatasetWindow(window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->addFootage(footage);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
    return dialog;
}

void NewDatasetWindow::build() {
    setWindowTitle(tr("Make a dataset"));
    resize(680, 460);
    m_unit->addItem(tr("unit: as usual for its kind"), 0.0);
    m_unit->addItem(tr("unit: millimetres"), 1.0);
    m_unit->addItem(tr("unit: centimetres"), 10.0);
    m_unit->addItem(tr("unit: metres"), 1000.0);
    m_table->setHorizontalHeaderLabels({tr("Video or image folder"), tr("Camera")});
    m_table->horizontalHeader()->setSectionResizeMode(kFootage, QHeaderView::Stretch);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    auto* introduction = new QLabel(tr("A calibration and the videos (or folders of numbered images) of its cameras. "
                                       "Nothing is copied: the footage stays where it is."),
                                    this);
    introduction->setWordWrap(true);
    auto* form = new QFormLayout;
    auto* calibrationRow = new QWidget(this);
    auto* row = new QHBoxLayout(calibrationRow);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(withChooser(m_calibration, tr("The calibration"), false), 1);
    row->addWidget(m_unit);
    form->addRow(tr("Calibration"), calibrationRow);
    addButtons(*form);
    form->addRow(tr("Name of the sequence"), m_sequence);
    form->addRow(tr("Folder of the dataset"), withChooser(m_folder, tr("An empty folder for the dataset"), true));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_make = buttons->addButton(tr("Make the dataset"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_message);
    column->addWidget(introduction);
    column->addLayout(form, 1);
    column->addWidget(buttons);
}

/// The table of the footage and what fills it.
void NewDatasetWindow::addButtons(QFormLayout& form) {
    auto* videos = new QPushButton(tr("Add videos..."), this);
    auto* images = new QPushButton(tr("Add a folder of images..."), this);
    auto* remove = new QPushButton(tr("Remove"), this);
    connect(
        videos, &QPushButton::clicked, this, [this] { askForFootage(false); });
    connect(images, &QPushButton::clicked, this, [this] { askForFootage(true); });
    connect(remove, &QPushButton::clicked, this, [this] {
        m_table->removeRow(m_table->currentRow());
        refresh();
    });
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {videos, images, remove}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    auto* column = new QVBoxLayout;
    column->addWidget(m_table, 1);
    column->addLayout(buttons);
    form.addRow(tr("Footage"), column);
}

QWidget* NewDatasetWindow::withChooser(QLineEdit* field, const QString& title, bool isFolder) {
    auto* both = new QWidget(this);
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* choose = new QToolButton(both);
    choose->setText(tr("Choose..."));
    row->addWidget(field, 1);
    row->addWidget(choose);
    connect(choose, &QToolButton::clicked, this, [this, field, title, isFolder] {
        auto* dialog = new QFileDialog(this, title, QFileInfo(field->text()).path());
        dialog->setFileMode(isFolder ? QFileDialog::Directory : QFileDialog::ExistingFile);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &QFileDialog::fileSelected, field, &QLineEdit::setText);
        dialog->open();
    });
    return both;
}

void NewDatasetWindow::askForFootage(bool isFolder) {
    auto* dialog =
        new QFileDialog(this, isFolder ? tr("A folder of numbered images of one camera") : tr("Videos of the cameras"));
    dialog->setFileMode(isFolder ? QFileDialog::Directory : QFileDialog::ExistingFiles);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::filesSelected, this, &NewDatasetWindow::addFootage);
    dialog->open();
}

QComboBox* NewDatasetWindow::choiceIn(int row) const {
    return qobject_cast<QComboBox*>(m_table->cellWidget(row, kCamera));
}

QStringList NewDatasetWindow::paths() const {
    QStringList all;
    for (int row = 0; row < m_table->rowCount(); ++row)
        all << m_table->item(row, kFootage)->text();
    return all;
}

void NewDatasetWindow::addFootage(const QStringList& added) {
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
        connect(choice, qOverload<int>(&QComboBox::currentIndexChanged), this, &NewDatasetWindow::refresh);
    }
    if (!added.isEmpty() && m_folder->text().isEmpty())
        setFolder(QFileInfo(added.front()).path() + QStringLiteral("/dataset"));
    showCameras(m_cameras);
}

void NewDatasetWindow::setCalibration(const QString& path) {
    m_calibration->setText(path);
    readCameras();
}

void NewDatasetWindow::setFolder(const QString& path) {
    m_folder->setText(QDir::toNativeSeparators(path));
}

void NewDatasetWindow::readCameras() {
    m_wait.stop();
    if (m_calibration->text().isEmpty() || !QFileInfo::exists(m_calibration->text()))
        return;
    m_message->setMessage({});
    m_maker.readCameras(request());
}

/// Fills the choices of cameras; what a person has chosen stays, the rest goes by name.
void NewDatasetWindow::showCameras(const QStringList& names) {
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
    refresh();
}

/// Says what is missing; the button works when nothing is.
void NewDatasetWindow::refresh() {
    QString missing;
    std::set<QString> used;
    QString twice;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QComboBox* choice = choiceIn(row);
        if (choice && choice->currentIndex() > 0 && !used.insert(choice->currentText()).second)
            twice = choice->currentText();
    }
    if (m_calibration->text().isEmpty())
        missing = tr("Choose the calibration of the cameras.");
    else if (used.empty())
        missing = tr("Add the videos or image folders, and choose the camera of each.");
    else if (!twice.isEmpty())
        missing = tr("Two pieces of footage are given to %1.").arg(twice);
    else if (m_sequence->text().trimmed().isEmpty())
        missing = tr("Give the sequence a name.");
    else if (m_folder->text().trimmed().isEmpty())
        missing = tr("Choose a folder for the dataset.");
    m_make->setEnabled(missing.isEmpty() && !m_maker.isRunning());
    m_make->setToolTip(missing);
}

widgets::NewDatasetRequest NewDatasetWindow::request() const {
    widgets::NewDatasetRequest request;
    request.calibration = m_calibration->text().toStdString();
    if (const double unit = m_unit->currentData().toDouble(); unit > 0)
        request.mmPerUnit = unit;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QComboBox* choice = choiceIn(row);
        if (choice->currentIndex() > 0)
            request.footage.push_back(
                {choice->currentText().toStdString(), m_table->item(row, kFootage)->text().toStdString(), 0});
    }
    request.sequence = m_sequence->text().trimmed().toStdString();
    request.folder = QDir::cleanPath(m_folder->text().trimmed()).toStdString();
    return request;
}

void NewDatasetWindow::make() {
    m_message->setMessage({});
    m_maker.make(request());
    m_make->setEnabled(false);
    m_make->setToolTip(tr("The footage is looked at..."));
}

} // namespace app
