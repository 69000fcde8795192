// SPDX-License-Identifier: MIT
#include "app/desktop/actions/figure_actions.h"

#include <QDir>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"
#include "app/desktop/script/comparison_report.h"
#include "app/desktop/windows/ask_for_file.h"
#include "core/error.h"
#include "widgets/text/error_text.h"
#include "widgets/views/picture_export.h"
#include "widgets/workspaces/inspect_film.h"
#include "widgets/workspaces/inspect_picture.h"

namespace app {

namespace {

/// The page with a fitted pair in front, or the hint that there is none.
bool showComparison(MainWindow& window) {
    if (!window.session().fits.outcome()) {
        window.statusLine().sayBriefly(MainWindow::tr("Fit a pair first."));
        return false;
    }
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    return true;
}

/// As a file's name.
QString comparisonName(MainWindow& window) {
    const auto& outcome = *window.session().fits.outcome();
    return QStringLiteral("%1-%2-%3")
        .arg(QString::fromStdString(outcome.sequence))
        .arg(outcome.request.start)
        .arg(outcome.request.test);
}

void saySaved(MainWindow& window, const QString& path) {
    window.statusLine().sayBriefly(MainWindow::tr("Saved to %1").arg(QDir::toNativeSeparators(path)));
}

void savePicture(MainWindow& window) {
    const std::vector<FileKind> kinds{{MainWindow::tr("Pictures (*.png)"), QStringLiteral("png")},
                                      {MainWindow::tr("Drawings (*.svg)"), QStringLiteral("svg")},
                                      {MainWindow::tr("Pages (*.pdf)"), QStringLiteral("pdf")}};
    askForFile(window, MainWindow::tr("Save the comparison as a picture"), kinds, comparisonName(window),
               [&window](const QString& path, std::size_t) {
                   if (widgets::savePicture(widgets::comparisonSource(*window.workspaces().inspectPage()), path))
                       saySaved(window, path);
                   else
                       window.showMessage(MainWindow::tr("%1 could not be written.").arg(path));
               });
}

void saveReport(MainWindow& window) {
    askForFile(
        window, MainWindow::tr("Report of this comparison"),
        {{MainWindow::tr("Pages (*.html)"), QStringLiteral("html")}}, comparisonName(window),
        [&window](const QString& path, std::size_t) {
            try {
                saveComparisonReport(window, path.toStdString());
                saySaved(window, path);
            } catch (const core::Error& error) {
                window.showMessage(widgets::errorInWords(error));
            }
        });
}

void bindFilm(MainWindow& window) {
    auto* film = new widgets::InspectFilm(*window.workspaces().inspectPage(), window.session().pool, &window);
    widgets::StatusLine* status = &window.statusLine();
    QObject::connect(film, &widgets::InspectFilm::progressed, status,
                     [status](double fraction) { status->showWork(MainWindow::tr("Saving the film"), fraction); });
    QObject::connect(film, &widgets::InspectFilm::finished, status, [&window, status](const QString& path) {
        status->hideWork();
        saySaved(window, path);
    });
    QObject::connect(film, &widgets::InspectFilm::stopped, status, &widgets::StatusLine::hideWork);
    QObject::connect(film, &widgets::InspectFilm::failed, &window, [&window, status](const QString& message) {
        status->hideWork();
        window.showMessage(message);
    });
    QObject::connect(status, &widgets::StatusLine::stopRequested, film, &widgets::InspectFilm::stop);
    const std::vector<FileKind> kinds{{MainWindow::tr("Films (*.mp4)"), QStringLiteral("mp4")},
                                      {MainWindow::tr("Films (*.avi)"), QStringLiteral("avi")}};
    window.actions().bind(id("file.comparisonFilm"), [&window, film, kinds] {
        if (!showComparison(window))
            return;
        askForFile(window, MainWindow::tr("Save the iterations as a film"), kinds, comparisonName(window),
                   [film](const QString& path, std::size_t) { film->save(path); });
    });
}

} // namespace

void bindFigureActions(MainWindow& window) {
    window.actions().bind(
        id("file.comparisonPicture"),
        [&window] {
            if (showComparison(window))
                savePicture(window);
        });
    window.actions().bind(id("file.comparisonReport"), [&window] {
        if (showComparison(window))
            saveReport(window);
    });
    bindFilm(window);
}

} // namespace app
