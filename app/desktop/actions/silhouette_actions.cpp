// SPDX-License-Identifier: MIT
#include "app/desktop/actions/silhouette_actions.h"

#include <QApplication>
#include <QUndoGroup>
#include <QWindow>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"
#include "app/desktop/windows/page_window.h"
#include "widgets/panels/silhouettes/silhouette_page.h"
#include "widgets/presenters/silhouette_overlay.h"

namespace app {

namespace {

constexpr double kBrushFactor = 1.25;

widgets::SilhouettePage& showSilhouettes(MainWindow& window, widgets::SilhouetteOverlay& overlay) {
    return showPage<widgets::SilhouettePage>(
        window, MainWindow::tr("Silhouettes"),
        [&window, &overlay] {
            auto* page = new widgets::SilhouettePage(window.session().silhouettes, window.session().selection);
            QObject::connect(page, &widgets::SilhouettePage::brushRequested, &overlay,
                             &widgets::SilhouetteOverlay::setBrushOn);
            QObject::connect(page, &widgets::SilhouettePage::brushRadiusRequested, &overlay,
                             &widgets::SilhouetteOverlay::setBrushRadius);
            QObject::connect(
                &overlay, &widgets::SilhouetteOverlay::brushChanged, page,
                [page, &overlay] { page->showBrush(overlay.isBrushOn(), overlay.brushRadius()); });
            QObject::connect(
                page, &QObject::destroyed, &overlay, [&overlay] { emit overlay.brushChanged(); });
            for (const char* name : {"edit.undo", "edit.redo"}) // whose shortcuts work in that window, too
                page->addAction(window.actions().action(id(name)));
            return page;
        },
        PageWindow::Place::AtRight);
}

void bindBrush(MainWindow& window, widgets::SilhouetteOverlay& overlay) {
    Actions& actions = window.actions();
    QAction* brush = actions.action(id("annotation.silhouetteBrush"));
    actions.bindToggle(
        id("annotation.silhouetteBrush"),
        [&window, &overlay](bool on) {
            if (on)
                showSilhouettes(window, overlay);
            overlay.setBrushOn(on);
        });
    QObject::connect(
        &overlay, &widgets::SilhouetteOverlay::brushChanged, brush,
        [brush, &overlay] { brush->setChecked(overlay.isBrushOn()); });
    actions.bind(
        id("annotation.largerBrush"), [&overlay] { overlay.setBrushRadius(overlay.brushRadius() * kBrushFactor); });
    actions.bind(id("annotation.smallerBrush"),
                 [&overlay] { overlay.setBrushRadius(overlay.brushRadius() / kBrushFactor); });
}

/// Undo and redo are of brush strokes while the brush is on and in the silhouettes' own window, else of annotations.
void routeUndo(MainWindow& window, widgets::SilhouetteOverlay& overlay) {
    auto* stacks = window.findChild<QUndoGroup*>();
    QUndoStack* strokes = window.session().silhouettes.undoStack();
    stacks->addStack(strokes);
    const auto choose = [&window, &overlay, stacks, strokes] {
        const auto* page = window.findChild<widgets::SilhouettePage*>();
        const QWindow* focus = QGuiApplication::focusWindow();
        const bool isTouching =
            overlay.isBrushOn() || (page && page->isVisible() && focus && page->window()->windowHandle() == focus);
        stacks->setActiveStack(isTouching ? strokes : window.session().document.undoStack());
    };
    QObject::connect(&overlay, &widgets::SilhouetteOverlay::brushChanged, &window, choose);
    QObject::connect(qApp, &QGuiApplication::focusWindowChanged, &overlay, choose);
}

/// The run is seen in the status line, too; the dataset is opened again once its sequence has other masks.
void announceSilhouettes(MainWindow& window) {
    widgets::StatusLine& line = window.statusLine();
    widgets::SilhouetteStudy& study = window.session().silhouettes;
    QObject::connect(
        &study, &widgets::SilhouetteStudy::runningChanged, &line,
        [&line, &study] {
            study.isRunning() ? line.showWork(MainWindow::tr("Making silhouettes"), 0) : line.hideWork();
        });
    QObject::connect(&study, &widgets::SilhouetteStudy::progressed, &line,
                     [&line](double fraction) { line.showWork(MainWindow::tr("Making silhouettes"), fraction); });
    QObject::connect(&line, &widgets::StatusLine::stopRequested, &study, &widgets::SilhouetteStudy::stop);
    QObject::connect(&study, &widgets::SilhouetteStudy::made, &window, [&window](int, int, bool attached) {
        widgets::WindowSession& session = window.session();
        if (attached && session.opened.dataset() && session.opened.sequence())
            window.openDataset(QString::fromStdString(session.opened.dataset()->folder.string()),
                               QString::fromStdString(session.opened.sequence()->name), session.selection.frame());
    });
}

} // namespace

void bindSilhouetteActions(MainWindow& window) {
    auto* overlay = new widgets::SilhouetteOverlay(window.session().silhouettes, *window.workspaces().grid(), &window);
    window.actions().bind(
        id("annotation.silhouettes"), [&window, overlay] { showSilhouettes(window, *overlay); });
    window.actions().bind(id("annotation.makeSilhouettes"),
                          [&window, overlay] { showSilhouettes(window, *overlay).run(); });
    bindBrush(window, *overlay);
    routeUndo(window, *overlay);
    announceSilhouettes(window);
}

} // namespace app
