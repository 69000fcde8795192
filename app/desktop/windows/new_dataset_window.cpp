// SPDX-License-Identifier: MIT
#include "app/desktop/windows/new_dataset_window.h"

#include <array>

#include <QDialogButtonBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QMimeData>
#include <QVBoxLayout>

#include "app/desktop/main_window.h"
#include "app/desktop/windows/path_field.h"

namespace app {

namespace {

constexpr int kLookMs = 300;
constexpr std::array kSteps = {NewDatasetWindow::Step::Footage, NewDatasetWindow::Step::Calibration,
                               NewDatasetWindow::Step::Hands, NewDatasetWindow::Step::Silhouettes,
                               NewDatasetWindow::Step::Folder};

} // namespace

NewDatasetWindow::NewDatasetWindow(MainWindow& window)
    : QDialog(&window)
    , m_window(window)
    , m_maker(window.session().pool)
    , m_message(new widgets::MessageBar(this))
    , m_steps(new QListWidget(this))
    , m_pages(new QStackedWidget(this))
    , m_footage(new FootagePage(this))
    , m_calibration(new CalibrationPage(this))
    , m_hands(new HandsPage(this))
    , m_masks(new MasksPage(this))
    , m_folder(new QLineEdit(this))
    , m_summary(new QLabel(this))
    , m_reason(new QLabel(this)) {
    build();
    m_wait.setSingleShot(true);
    m_wait.setInterval(kLookMs);
    connect(&m_wait, &QTimer::timeout, this, &NewDatasetWindow::look);
    connect(m_footage, &FootagePage::chosen, this, &NewDatasetWindow::addFootage);
    connect(m_footage, &FootagePage::changed, this, [this] {
        m_wait.start(); // sizes are compared
        refresh();
    });
    connect(m_calibration, &CalibrationPage::changed, this, &NewDatasetWindow::look);
    connect(m_hands, &HandsPage::changed, this, &NewDatasetWindow::refresh);
    connect(m_masks, &MasksPage::changed, this, &NewDatasetWindow::refresh);
    connect(m_folder, &QLineEdit::textChanged, this, &NewDatasetWindow::refresh);
    connect(m_steps, &QListWidget::currentRowChanged, this, [this](int row) {
        m_pages->setCurrentIndex(std::max(0, row));
        refresh();
    });
    connectMaker();
    goTo(Step::Footage);
}

NewDatasetWindow* NewDatasetWindow::open(MainWindow& window, const QStringList& footage) {
    auto* dialog = window.findChild<NewDatasetWindow*>();
    if (!dialog) {
        dialog = new NewDatasetWindow(window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    if (!footage.isEmpty())
        dialog->addFootage(footage);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
    return dialog;
}

void NewDatasetWindow::build() {
    setWindowTitle(tr("Make a dataset"));
    setAcceptDrops(true);
    resize(860, 520);
    m_steps->addItems({tr("Footage"), tr("Calibration"), tr("Hands"), tr("Silhouettes"), tr("Folder")});
    m_steps->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    m_steps->setFixedWidth(m_steps->sizeHintForColumn(0) + 48);
    for (QWidget* page : std::initializer_list<QWidget*>{m_footage, m_calibration, m_hands, m_masks, folderPage()})
        m_pages->addWidget(page);
    m_reason->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_back = buttons->addButton(tr("Back"), QDialogButtonBox::ActionRole);
    m_next = buttons->addButton(tr("Next"), QDialogButtonBox::ActionRole);
    m_make = buttons->addButton(tr("Make the dataset"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(
        m_back, &QPushButton::clicked, this, [this] { m_steps->setCurrentRow(m_steps->currentRow() - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { m_steps->setCurrentRow(m_steps->currentRow() + 1); });
    connect(m_make, &QPushButton::clicked, this, &NewDatasetWindow::make);
    auto* middle = new QHBoxLayout;
    middle->addWidget(m_steps);
    middle->addWidget(m_pages, 1);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_reason, 1);
    bottom->addWidget(buttons);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_message);
    column->addLayout(middle, 1);
    column->addLayout(bottom);
}

QWidget* NewDatasetWindow::folderPage() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout;
    form->addRow(tr("Folder of the dataset"),
                 withChooser(m_folder, tr("An empty folder for the dataset"), PathKind::Folder, page));
    m_summary->setWordWrap(true);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addWidget(m_summary);
    column->addStretch(1);
    return page;
}

void NewDatasetWindow::connectMaker() {
    connect(&m_maker, &widgets::DatasetMaker::gathered, this, &NewDatasetWindow::takeFootage);
    connect(&m_maker, &widgets::DatasetMaker::camerasRead, this, [this](const widgets::CalibrationLook& look) {
        m_calibration->show(look);
        if (look.names() != m_cameras) {
            m_cameras = look.names();
            m_footage->setCameras(m_cameras); // and their sizes are compared
        }
        refresh();
    });
    connect(&m_maker, &widgets::DatasetMaker::lookFailed, this, [this](const QString& message) {
        m_calibration->showFailure(message);
        m_message->setMessage(message);
        refresh();
    });
    connect(&m_maker, &widgets::DatasetMaker::failed, m_message, &widgets::MessageBar::setMessage);
    connect(&m_maker, &widgets::DatasetMaker::idle, this, &NewDatasetWindow::refresh);
    connect(&m_maker, &widgets::DatasetMaker::made, this, [this](const QString& folder, const QString& notes) {
        m_window.openDataset(folder);
        if (!notes.isEmpty())
            m_window.showMessage(notes);
        close();
    });
}

void NewDatasetWindow::takeFootage(const widgets::GatheredFootage& found) {
    m_message->setMessage(found.footage.isEmpty() && found.calibration.isEmpty()
                              ? tr("There is neither a video, nor a folder of images, nor a calibration in what was "
                                   "dropped.")
                              : QString());
    if (!found.footage.isEmpty() && m_folder->text().isEmpty())
        setFolder(QFileInfo(found.footage.front()).path() + QStringLiteral("/dataset"));
    m_footage->addFootage(found.footage);
    if (!found.calibration.isEmpty() && m_calibration->path().isEmpty())
        setCalibration(found.calibration);
    else if (found.footage.isEmpty() && !found.calibration.isEmpty())
        setCalibration(found.calibration); // it alone was dropped: it is meant
}

void NewDatasetWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void NewDatasetWindow::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile())
            paths << url.toLocalFile();
    addFootage(paths);
}

void NewDatasetWindow::setFolder(const QString& path) {
    m_folder->setText(QDir::toNativeSeparators(path));
}

void NewDatasetWindow::goTo(Step step) {
    m_steps->setCurrentRow(static_cast<int>(step));
    refresh();
}

void NewDatasetWindow::look() {
    m_wait.stop();
    if (m_calibration->path().isEmpty() || !QFileInfo::exists(m_calibration->path())) {
        refresh();
        return;
    }
    m_message->setMessage({});
    m_maker.readCameras(request());
}

QString NewDatasetWindow::problem(Step step) const {
    switch (step) {
    case Step::Footage:
        return m_footage->problem();
    case Step::Calibration:
        return m_calibration->problem();
    case Step::Hands:
        return m_hands->problem();
    case Step::Silhouettes:
        return m_masks->problem();
    case Step::Folder: {
        const QString folder = m_folder->text().trimmed();
        if (folder.isEmpty())
            return tr("Choose a folder for the dataset.");
        const QFileInfo there(folder);
        if (there.exists() && (!there.isDir() || !QDir(folder).isEmpty()))
            return tr("The folder of the dataset is not empty: choose another.");
        return {};
    }
    }
    return {};
}

/// Says what is missing, of this step first; the buttons work when nothing is.
void NewDatasetWindow::refresh() {
    refreshSteps();
    const int row = m_steps->currentRow(), last = m_steps->count() - 1;
    const QString here = problem(kSteps[static_cast<std::size_t>(std::max(0, row))]);
    QString first;
    for (const Step step : kSteps)
        if (first.isEmpty())
            first = problem(step);
    const bool isBusy = m_maker.isRunning();
    m_back->setEnabled(row > 0 && !isBusy);
    m_next->setEnabled(row < last && here.isEmpty() && !isBusy);
    m_next->setToolTip(here);
    m_make->setEnabled(first.isEmpty() && !isBusy);
    m_make->setToolTip(first);
    (m_make->isEnabled() ? m_make : m_next)->setDefault(true);
    m_reason->setText(isBusy ? tr("The footage is looked at...") : !here.isEmpty() ? here : first);
    m_summary->setText(summary());
}

void NewDatasetWindow::refreshSteps() {
    QPixmap nothing(m_steps->iconSize().isValid() ? m_steps->iconSize() : QSize(16, 16));
    nothing.fill(Qt::transparent);
    for (const Step step : kSteps) {
        QListWidgetItem* item = m_steps->item(static_cast<int>(step));
        const QString missing = problem(step);
        item->setIcon(missing.isEmpty() ? QIcon::fromTheme(QStringLiteral("dialog-ok-apply")) : QIcon(nothing));
        item->setToolTip(missing);
    }
}

QString NewDatasetWindow::summary() const {
    return tr("%n piece(s) of footage", nullptr, static_cast<int>(m_footage->footage().size())) + QStringLiteral(", ") +
           tr("%n camera(s)", nullptr, static_cast<int>(m_cameras.size())) + QLatin1Char('.');
}

widgets::NewDatasetRequest NewDatasetWindow::request() const {
    widgets::NewDatasetRequest request;
    request.calibration = m_calibration->path().toStdString();
    request.mmPerUnit = m_calibration->mmPerUnit();
    request.footage = m_footage->footage();
    request.sequence = m_footage->sequence().toStdString();
    request.folder = QDir::cleanPath(m_folder->text().trimmed()).toStdString();
    m_hands->fill(request);
    m_masks->fill(request);
    return request;
}

void NewDatasetWindow::make() {
    m_message->setMessage({});
    m_maker.make(request());
    refresh();
}

} // namespace app
