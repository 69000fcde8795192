// SPDX-License-Identifier: MIT
#include "app/desktop/actions/compare_actions.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"

namespace app {

namespace {

constexpr double kWipeStep = 0.05; ///< of the views' width

using widgets::ColumnWipe;
using widgets::InspectColumn;
using widgets::InspectColumns;

/// What these actions need is there; else it is said.
bool isFitted(MainWindow& window) {
    if (window.session().fits.outcome()) {
        window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
        return true;
    }
    window.statusLine().sayBriefly(MainWindow::tr("Fit a pair first."));
    return false;
}

void bindFitted(MainWindow& window, const char* name, const std::function<void()>& run) {
    window.actions().bind(
        id(name),
        [&window, run] {
            if (isFitted(window))
                run();
        });
}

void askForTracker(MainWindow& window) {
    auto* dialog = new QFileDialog(&window, MainWindow::tr("A tracker's estimates"));
    dialog->setNameFilters({MainWindow::tr("Estimates (*.csv *.json)")});
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::fileSelected, &window, [&window](const QString& file) {
        window.workspaces().inspectPage()->columns()->addTracker(QFileInfo(file).completeBaseName().toStdString(),
                                                                 file);
    });
    dialog->open();
}

void addFixed(MainWindow& window, InspectColumn::Kind kind) {
    InspectColumns* columns = window.workspaces().inspectPage()->columns();
    if (columns->isAvailable({kind, {}}))
        columns->add({kind, {}});
    else
        window.statusLine().sayBriefly(MainWindow::tr("This sequence has no recorded motion."));
}

void bindColumns(MainWindow& window) {
    InspectColumns* columns = window.workspaces().inspectPage()->columns();
    bindFitted(
        window, "compare.addStart", [&window] { addFixed(window, InspectColumn::Kind::Start); });
    bindFitted(
        window, "compare.addTruth", [&window] { addFixed(window, InspectColumn::Kind::Truth); });
    bindFitted(
        window, "compare.addTracker", [&window] { askForTracker(window); });
    bindFitted(
        window, "compare.removeColumn", [columns] { columns->remove(columns->current()); });
    bindFitted(
        window, "compare.previousColumn",
        [columns] {
            if (columns->current() > 0)
                columns->setCurrent(columns->current() - 1);
        });
    bindFitted(
        window, "compare.nextColumn", [columns] { columns->setCurrent(columns->current() + 1); });
    bindFitted(
        window, "compare.columnLeft",
        [columns] {
            if (columns->current() > 0)
                columns->move(columns->current(), columns->current() - 1);
        });
    bindFitted(window, "compare.columnRight", [columns] { columns->move(columns->current(), columns->current() + 1); });
    bindFitted(
        window, "compare.hideHere",
        [&window, columns] {
            const widgets::InspectGrid* views = window.workspaces().inspectPage()->views();
            const int view = views->currentView(), camera = views->cameraOf(view);
            columns->setShown(views->columnOf(view), camera, !columns->isShown(views->columnOf(view), camera));
        });
    QObject::connect(window.workspaces().inspectPage()->columnBar(), &widgets::ColumnBar::trackerWanted, &window,
                     [&window] { askForTracker(window); });
}

void bindWipe(MainWindow& window) {
    ColumnWipe* wipe = window.workspaces().inspectPage()->views()->wipe();
    const auto bindKind = [&](const char* name, ColumnWipe::Kind kind) {
        QAction* action = window.actions().action(id(name));
        window.actions().bindToggle(id(name), [&window, wipe, action, kind](bool on) {
            if (on && !isFitted(window))
                action->setChecked(false);
            else if (on || wipe->kind() == kind)
                wipe->setKind(on ? kind : ColumnWipe::Kind::None);
        });
        QObject::connect(wipe, &ColumnWipe::changed, action,
                         [wipe, action, kind] { action->setChecked(wipe->kind() == kind); });
    };
    bindKind("compare.wipe", ColumnWipe::Kind::Wipe);
    bindKind("compare.blink", ColumnWipe::Kind::Blink);
    bindFitted(
        window, "compare.wipeLeft", [wipe] { wipe->setPlace(std::max(kWipeStep, wipe->place() - kWipeStep)); });
    bindFitted(window, "compare.wipeRight",
               [wipe] { wipe->setPlace(std::min(1 - kWipeStep, wipe->place() + kWipeStep)); });
}

void bindSettings(MainWindow& window) {
    widgets::Workspaces& spaces = window.workspaces();
    widgets::WhatIfPanel* panel = spaces.whatIfPanel();
    bindFitted(
        window, "compare.whatIf",
        [&spaces, panel] {
            panel->showColumn(spaces.inspectPage()->columns()->current());
            spaces.raisePanel(panel);
        });
    bindFitted(
        window, "compare.useSettings", [panel] { panel->apply(); });
    bindFitted(
        window, "compare.addSettings", [panel] { panel->addColumn(); });
    bindFitted(window, "compare.resetSettings", [panel] { panel->goBack(); });
    bindFitted(window, "compare.sweep", [&spaces, panel] {
        spaces.raisePanel(panel);
        panel->sweepOrStop();
    });
    bindFitted(window, "compare.measureCameras", [&spaces, panel] {
        spaces.raisePanel(panel);
        panel->measureCameras();
    });
}

/// The menu of a right click in an inspected view.
void showMenu(MainWindow& window, int view, const QPoint& position) {
    auto* menu = new QMenu(&window);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const char* name :
         {"compare.hideHere", "compare.whatIf", "compare.columnLeft", "compare.columnRight", "compare.removeColumn"})
        menu->addAction(window.actions().action(id(name)));
    menu->addSeparator();
    for (const char* name : {"compare.wipe", "compare.blink"})
        menu->addAction(window.actions().action(id(name)));
    menu->addSeparator();
    window.workspaces().inspectPage()->grid()->view(view)->addPictureActions(*menu);
    menu->popup(position);
}

} // namespace

void bindCompareActions(MainWindow& window) {
    bindColumns(window);
    bindWipe(window);
    bindSettings(window);
    QObject::connect(window.workspaces().inspectPage()->views(), &widgets::InspectGrid::menuRequested, &window,
                     [&window](int view, const QPoint& position) { showMenu(window, view, position); });
}

} // namespace app
