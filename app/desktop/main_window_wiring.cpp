// SPDX-License-Identifier: MIT
// What the window says and shows when something happens in the session.
#include "app/desktop/main_window.h"

#include <utility>

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include "widgets/text/store_text.h"

namespace app {

using widgets::Workspaces;

void MainWindow::connectSession() {
    widgets::DatasetSession& session = m_session.opened;
    connect(&session, &widgets::DatasetSession::opening, this, [this](const QString& what) {
        showMessage({});
        m_statusLine->showWork(tr("Opening %1").arg(QFileInfo(what).fileName()), -1);
    });
    connect(&session, &widgets::DatasetSession::openFailed, this, [this](const QString& message) {
        m_statusLine->hideWork();
        m_wantedFrame = 0;
        showMessage(tr("This could not be opened. %1").arg(message));
        if (m_session.opened.sequence())
            m_framesBar->setSequence(QString::fromStdString(m_session.opened.sequence()->name));
    });
    connect(&session, &widgets::DatasetSession::datasetOpened, this, [this] {
        const core::Dataset& dataset = *m_session.opened.dataset();
        m_framesBar->setDataset(dataset);
        remember(QString::fromStdString(dataset.folder.string()));
    });
    connect(
        &m_session, &widgets::WindowSession::ready, this,
        [this] {
            m_statusLine->hideWork();
            m_framesBar->setSequence(QString::fromStdString(m_session.opened.sequence()->name));
            m_framesBar->show();
            m_pages->setCurrentWidget(m_workspaces);
            m_workspaces->grid()->setFocus();
            m_playback.setFramesPerSecond(m_session.opened.sequence()->framesPerSecond);
            if (std::exchange(m_mayHint, false))
                showHints();
            refreshTitle();
            refreshTestFrames();
            sayIfFrameIsMissing();
        });
    connect(m_workspaces, &Workspaces::wordsChanged, m_statusLine,
            [this](const widgets::WorkWords& words) { m_statusLine->setWords(words.summary, words.advice); });
    connect(m_workspaces->benchmarkPage(), &widgets::BenchmarkPage::drawChanged, this, &MainWindow::refreshTestFrames);
    connect(m_framesBar, &widgets::FramesBar::sequenceRequested, this,
            [this](const QString& name) { m_session.opened.openSequence(name, 0); });
}

void MainWindow::connectDocument() {
    widgets::AnnotationDocument& document = m_session.document;
    connect(&document, &widgets::AnnotationDocument::saveFailed, this, [this](const QString& message) {
        m_saveFailed = true;
        showMessage(tr("Not saved yet, but nothing is lost: it is tried again every few seconds. %1").arg(message));
    });
    connect(&document, &widgets::AnnotationDocument::saved, this, [this] {
        m_mayLoseEdits = false;
        if (std::exchange(m_saveFailed, false))
            showMessage({});
    });
    connect(&document, &widgets::AnnotationDocument::refused, this, &MainWindow::showMessage);
    connect(&document, &widgets::AnnotationDocument::opened, this, [this] {
        const core::AnnotationStore* store = m_session.document.store();
        if (store && store->isReadOnly())
            showMessage(tr("Read-only: %1. You can look and export; edits are not possible.")
                            .arg(widgets::readOnlyInWords(store->readOnlyReason())));
        else if (store && !store->warnings().empty())
            showMessage(widgets::storeWarningInWords(store->warnings().front()));
    });
    connect(&m_session.annotator, &widgets::Annotator::nothingDone, m_statusLine, &widgets::StatusLine::sayBriefly);
    widgets::AnnotationFiles& files = m_session.files;
    connect(&files, &widgets::AnnotationFiles::failed, this, &MainWindow::showMessage);
    connect(&files, &widgets::AnnotationFiles::exported, this, [this](const QString& path) {
        m_statusLine->sayBriefly(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
    });
    connect(&files, &widgets::AnnotationFiles::reported, this, &MainWindow::offerReport);
    connect(&files, &widgets::AnnotationFiles::jointsRead, this, [this](const std::vector<std::string>& names) {
        if (m_session.opened.dataset())
            m_session.joints.setNames(names, *m_session.opened.dataset());
    });
    connect(&files, &widgets::AnnotationFiles::imported, this,
            [this](const QString& path, int marks, int notes, const QString& warnings) {
                const QString file = QFileInfo(path).fileName();
                QString text = tr("%n mark(s) imported from %1", nullptr, marks).arg(file);
                if (notes > 0)
                    text += QStringLiteral(", ") + tr("%n note(s)", nullptr, notes);
                m_statusLine->sayBriefly(
                    marks + notes > 0
                        ? text
                        : tr("Nothing was changed: %1 holds nothing that is not there already.").arg(file));
                if (!warnings.isEmpty())
                    showMessage(warnings);
            });
}

void MainWindow::connectWork() {
    widgets::FitRunner& fits = m_session.fits;
    connect(
        &fits, &widgets::FitRunner::started, this, [this] { m_statusLine->showWork(tr("Fitting"), 0); });
    connect(&fits, &widgets::FitRunner::progressed, this, [this](double fraction, const QString& method) {
        m_statusLine->showWork(tr("Fitting: %1").arg(method), fraction);
    });
    connect(&fits, &widgets::FitRunner::finished, m_statusLine, &widgets::StatusLine::hideWork);
    connect(&fits, &widgets::FitRunner::failed, m_statusLine, &widgets::StatusLine::hideWork);
    connect(&fits, &widgets::FitRunner::failed, m_statusLine,
            &widgets::StatusLine::sayBriefly); // the panel may be hidden
    connect(&fits, &widgets::FitRunner::cleared, m_statusLine, &widgets::StatusLine::hideWork);
    connect(m_statusLine, &widgets::StatusLine::stopRequested, &fits, &widgets::FitRunner::stop);
    widgets::BenchmarkRunner& benchmarks = m_session.benchmarks;
    connect(
        &benchmarks, &widgets::BenchmarkRunner::started, this, [this] { m_statusLine->showWork(tr("Benchmark"), 0); });
    connect(&benchmarks, &widgets::BenchmarkRunner::progressed, this, [this](double fraction, const QString& text) {
        m_statusLine->showWork(tr("Benchmark: %1").arg(text), fraction);
    });
    connect(&benchmarks, &widgets::BenchmarkRunner::finished, m_statusLine, &widgets::StatusLine::hideWork);
    connect(&benchmarks, &widgets::BenchmarkRunner::failed, m_statusLine, &widgets::StatusLine::hideWork);
    connect(&benchmarks, &widgets::BenchmarkRunner::cleared, m_statusLine, &widgets::StatusLine::hideWork);
    connect(m_statusLine, &widgets::StatusLine::stopRequested, &benchmarks, &widgets::BenchmarkRunner::stop);
    connect(
        &benchmarks, &widgets::BenchmarkRunner::saved, this,
        [this](const QString& folder) {
            m_statusLine->sayBriefly(tr("Results saved in %1").arg(QDir::toNativeSeparators(folder)));
        });
    connect(
        m_workspaces->benchmarkPage(), &widgets::BenchmarkPage::reportWanted, this,
        [](const QString& file) { QDesktopServices::openUrl(QUrl::fromLocalFile(file)); });
    connect(&benchmarks, &widgets::BenchmarkRunner::opened, this,
            [this] { m_workspaces->setCurrent(Workspaces::Kind::Benchmark); });
    connect(m_workspaces->masks(), &widgets::MaskAttacher::attached, m_statusLine, &widgets::StatusLine::sayBriefly);
    widgets::AnnotationFiles& files = m_session.files;
    connect(&files, &widgets::AnnotationFiles::working, m_statusLine, &widgets::StatusLine::showWork);
    connect(&files, &widgets::AnnotationFiles::idle, m_statusLine, &widgets::StatusLine::hideWork);
    connect(m_statusLine, &widgets::StatusLine::stopRequested, &files, &widgets::AnnotationFiles::stop);
}

} // namespace app
