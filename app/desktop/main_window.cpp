// SPDX-License-Identifier: MIT
#include "app/desktop/main_window.h"

#include <utility>

#include <QCloseEvent>
#include <QDesktopServices>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusTipEvent>
#include <QVBoxLayout>

#include "app/desktop/resources.h"
#include "core/io/files/login_name.h"
#include "widgets/panels/quality/refinement_page.h"
#include "widgets/panels/quality/subject_page.h"
#include "widgets/panels/silhouettes/silhouette_page.h"

namespace app {

using widgets::Workspaces;

namespace {

constexpr int kRecentDatasets = 8;
const char* const kRecentKey = "recentDatasets";

/// Files and folders that are not a dataset: videos, folders of images.
QStringList droppedFootage(const QMimeData* data) {
    QStringList paths;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile())
            paths << QFileInfo(url.toLocalFile()).absoluteFilePath();
    return paths;
}

/// The dataset that was dropped, as its folder or its file.
QString droppedFolder(const QMimeData* data) {
    for (const QUrl& url : data->urls()) {
        const QFileInfo file(url.toLocalFile());
        if (file.isDir() && QFileInfo::exists(file.filePath() + QStringLiteral("/dataset.json")))
            return file.absoluteFilePath();
        if (file.fileName() == QLatin1String("dataset.json"))
            return file.absolutePath();
    }
    return {};
}

/// The window of its own in which that page is shown; null if it is not.
template <class Page>
QWidget* windowOf(const QWidget& window) {
    const auto* page = window.findChild<Page*>();
    return page ? page->window() : nullptr;
}

} // namespace

MainWindow::MainWindow(QSettings& settings, const WindowOptions& options, QWidget* parent)
    : QMainWindow(parent)
    , m_settings(settings)
    , m_actions(this, settings)
    , m_playback(m_session.selection, m_session.frames) {
    initResources();
    build();
    connectSession();
    connectDocument();
    connectWork();
    m_mayAsk = options.hints;
    m_mayHint = options.hints && !settings.value(QStringLiteral("hintsSeen")).toBool();
    const QString rater = options.rater.empty() ? settings.value(QStringLiteral("rater")).toString()
                                                : QString::fromStdString(options.rater);
    m_session.document.setRater(rater.isEmpty() ? core::loginName() : rater.toStdString());
    restoreLayout();
    refreshTitle();
}

MainWindow::~MainWindow() {
    m_playback.stop();
    qDeleteAll(findChildren<QDialog*>(QString(),
                                      Qt::FindDirectChildrenOnly)); // they look at the actions, which go before them
    hide();
    delete takeCentralWidget(); // the panels look at the session, which goes with this object's members
}

void MainWindow::build() {
    auto* central = new QWidget(this);
    auto* column = new QVBoxLayout(central);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_message = new widgets::MessageBar(central);
    m_question = new widgets::MessageBar(central);
    m_banner = new widgets::MessageBar(central);
    m_framesBar =
        new widgets::FramesBar(m_session.selection, m_session.document, m_session.coverage, m_session.joints, central);
    m_pages = new QStackedWidget(central);
    m_empty = new widgets::EmptyState(m_pages);
    m_workspaces = new Workspaces(m_session, m_pages);
    m_statusLine = new widgets::StatusLine(m_session.document, m_session.reconstructions, m_session.selection, central);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_workspaces);
    for (widgets::MessageBar* bar : {m_banner, m_message, m_question})
        column->addWidget(bar);
    column->addWidget(m_framesBar);
    column->addWidget(m_pages, 1);
    column->addWidget(m_statusLine);
    setCentralWidget(central);
    setAcceptDrops(true);
    setWindowIcon(QIcon(QStringLiteral(":/icons/handlens.svg")));
    m_framesBar->setActions(m_actions.action(QStringLiteral("go.previousFrame")),
                            m_actions.action(QStringLiteral("go.nextFrame")),
                            m_actions.action(QStringLiteral("go.play")));
    m_framesBar->hide();
    m_statusLine->setIdleText(tr("Open a dataset to begin."));
    menuBar()->setCornerWidget(makeWorkspaceBar(), Qt::TopRightCorner);
    m_empty->setRecentDatasets(m_settings.value(kRecentKey).toStringList());
    connect(m_empty, &widgets::EmptyState::openRequested, this, &MainWindow::askForDataset);
    connect(m_empty, &widgets::EmptyState::demoRequested, this, &MainWindow::openDemo);
    connect(m_empty, &widgets::EmptyState::newRequested, m_actions.action(QStringLiteral("file.new")),
            &QAction::trigger);
    connect(m_empty, &widgets::EmptyState::recentRequested, this,
            [this](const QString& folder) { openDataset(folder); });
}

QWidget* MainWindow::makeWorkspaceBar() {
    m_workspaceBar = new QTabBar(this);
    m_workspaceBar->setDocumentMode(true);
    m_workspaceBar->setDrawBase(false);
    m_workspaceBar->setExpanding(false);
    m_workspaceBar->setFocusPolicy(Qt::NoFocus);
    for (const char* id : {"workspace.annotate", "workspace.inspect", "workspace.benchmark"})
        m_workspaceBar->addTab(m_actions.plainText(QString::fromLatin1(id)));
    connect(
        m_workspaceBar, &QTabBar::currentChanged, this,
        [this](int index) { m_workspaces->setCurrent(static_cast<Workspaces::Kind>(index)); });
    connect(m_workspaces, &Workspaces::currentChanged, m_workspaceBar,
            [this](Workspaces::Kind kind) { m_workspaceBar->setCurrentIndex(static_cast<int>(kind)); });
    return m_workspaceBar;
}

void MainWindow::openDataset(const QString& folder, const QString& sequence, int frame) {
    m_playback.stop();
    m_wantedFrame = frame;
    m_session.opened.openDataset(QFileInfo(folder).absoluteFilePath(), sequence, frame);
}

void MainWindow::askForDataset() {
    const QStringList recent = m_settings.value(kRecentKey).toStringList();
    auto* dialog = new QFileDialog(this, tr("Open a dataset"), recent.isEmpty() ? QDir::homePath() : recent.front());
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) { openDataset(folder); });
    dialog->open();
}

void MainWindow::openDemo() {
    m_playback.stop();
    m_session.opened.openDemo(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                              QStringLiteral("/demo"));
}

void MainWindow::showMessage(const QString& text) {
    m_message->setMessage(text);
}

void MainWindow::ask(const QString& question, const std::vector<widgets::MessageAction>& answers) {
    m_question->offer(question, answers);
}

/// A frame that was asked for and does not exist: the last one is shown instead.
void MainWindow::sayIfFrameIsMissing() {
    const core::Sequence& sequence = *m_session.opened.sequence();
    const int wanted = std::exchange(m_wantedFrame, 0);
    if (wanted >= sequence.frameCount && sequence.frameCount > 0)
        showMessage(tr("There is no frame %1: sequence \"%2\" has frames 0-%3. The last one is shown.")
                        .arg(wanted)
                        .arg(QString::fromStdString(sequence.name))
                        .arg(sequence.frameCount - 1));
}

void MainWindow::offerReport(const QString& path) {
    const QString text = tr("Report written to %1").arg(QDir::toNativeSeparators(path));
    m_statusLine->sayBriefly(text);
    ask(text, {{tr("Open"), [this, path] {
                    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absoluteFilePath())))
                        showMessage(tr("No program opened %1.").arg(QDir::toNativeSeparators(path)));
                }}});
}

void MainWindow::showHints() {
    if (!m_hints) {
        m_hints = new widgets::Hints(m_workspaces->grid());
        connect(m_hints, &widgets::Hints::closed, this,
                [this] { m_settings.setValue(QStringLiteral("hintsSeen"), true); });
    }
    m_hints->show();
}

bool MainWindow::closeHints() {
    const bool wereShown = m_hints && m_hints->isVisible();
    if (wereShown)
        m_hints->dismiss();
    return wereShown;
}

QWidget* MainWindow::part(const QString& name) {
    if (name == QLatin1String("window"))
        return this;
    if (name == QLatin1String("frames"))
        return m_framesBar;
    if (name == QLatin1String("status"))
        return m_statusLine;
    if (name == QLatin1String("refinement"))
        return windowOf<widgets::RefinementPage>(*this);
    if (name == QLatin1String("subject"))
        return windowOf<widgets::SubjectPage>(*this);
    if (name == QLatin1String("silhouettes"))
        return windowOf<widgets::SilhouettePage>(*this);
    return m_workspaces->part(name);
}

void MainWindow::remember(const QString& folder) {
    QStringList recent = m_settings.value(kRecentKey).toStringList();
    recent.removeAll(folder);
    recent.prepend(folder);
    while (recent.size() > kRecentDatasets)
        recent.removeLast();
    m_settings.setValue(kRecentKey, recent);
    m_empty->setRecentDatasets(recent);
}

void MainWindow::restoreLayout() {
    resize(QSize(1366, 768).boundedTo(screen()->availableSize()));
    restoreGeometry(m_settings.value(QStringLiteral("window/geometry")).toByteArray());
    m_workspaces->restoreState(m_settings.value(QStringLiteral("window/workspaces")).toByteArray());
}

void MainWindow::refreshTitle() {
    const auto& dataset = m_session.opened.dataset();
    if (!dataset || !m_session.opened.sequence()) {
        setWindowTitle(QStringLiteral("Handlens"));
        return;
    }
    setWindowTitle(
        QStringLiteral("%1 \u2013 %2 \u2013 Handlens")
            .arg(QString::fromStdString(dataset->name), QString::fromStdString(m_session.opened.sequence()->name)));
}

void MainWindow::refreshTestFrames() {
    m_framesBar->setTestFrames(m_workspaces->benchmarkPage()->testFrames());
}

/// What a part of the window tells, such as where a picture was saved.
bool MainWindow::event(QEvent* event) {
    if (event->type() == QEvent::StatusTip) {
        if (const QString tip = static_cast<QStatusTipEvent*>(event)->tip(); !tip.isEmpty())
            m_statusLine->sayBriefly(tip);
        return true;
    }
    return QMainWindow::event(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_playback.stop();
    if (!m_session.document.saveNow() && !std::exchange(m_mayLoseEdits, true)) {
        showMessage(tr("Your last edits are not saved yet. Make room or give permission where they are kept, or export "
                       "them elsewhere; closing once "
                       "more gives them up."));
        event->ignore();
        return;
    }
    m_session.document.close();
    m_settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    m_settings.setValue(QStringLiteral("window/workspaces"), m_workspaces->saveState());
    QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFootage(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString folder = droppedFolder(event->mimeData());
    if (!folder.isEmpty())
        openDataset(folder);
    else
        emit footageDropped(droppedFootage(event->mimeData()));
}

} // namespace app
