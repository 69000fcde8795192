// SPDX-License-Identifier: MIT
#include "app/desktop/actions/panel_actions.h"

#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/actions/own_name.h"
#include "app/desktop/main_window.h"
#include "app/desktop/windows/preferences_window.h"
#include "app/desktop/windows/shortcut_window.h"
#include "widgets/text/edit_text.h"

namespace app {

namespace {

void bindNames(MainWindow& window) {
    window.actions().bind(
        id("edit.note"),
        [&window] {
            window.workspaces().setCurrent(widgets::Workspaces::Kind::Annotate);
            auto* note = window.workspaces().jointsPanel()->note();
            note->setFocus(
                Qt::OtherFocusReason); // a shortcut's would select what is there, and the next key replace it
            note->end(false);
        });
    window.actions().bind(id("edit.rater"), [&window] {
        auto* dialog = new QInputDialog(&window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setWindowTitle(MainWindow::tr("Your name"));
        dialog->setLabelText(MainWindow::tr("Your marks are kept under this name:"));
        dialog->setTextValue(ownName(window));
        QObject::connect(dialog, &QInputDialog::textValueSelected, &window,
                         [&window](const QString& name) { keepOwnName(window, name); });
        dialog->open();
    });
}

void bindIterations(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::InspectPage* page = window.workspaces().inspectPage();
    const auto show = [&window, page](int iteration) {
        window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
        page->setIteration(iteration);
    };
    actions.bind(
        id("compare.previousIteration"), [page, show] { show(page->iteration() - 1); });
    actions.bind(
        id("compare.nextIteration"), [page, show] { show(page->iteration() + 1); });
    actions.bind(id("compare.lastIteration"), [page, show] { show(page->lastIteration()); });
}

void bindLayers(MainWindow& window) {
    widgets::InspectOverlays* overlays = window.workspaces().inspectPage()->overlays();
    for (const widgets::InspectLayer layer : widgets::kInspectLayers) {
        QString name = widgets::inspectLayerId(layer);
        name[0] = name[0].toUpper();
        const QString action = QStringLiteral("compare.layer") + name;
        const auto nameBox = [&window, layer, action] { // name and tip stand in the table alone
            window.workspaces().inspectPage()->layerBar()->setLayerTexts(layer, window.actions().plainText(action),
                                                                         window.actions().action(action)->toolTip());
        };
        nameBox();
        QObject::connect(&window.actions(), &Actions::shortcutsChanged, &window, nameBox);
        window.actions().bindToggle(
            action,
            [&window, overlays, layer](bool on) {
                if (on)
                    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
                overlays->setShown(layer, on);
            });
        QObject::connect(overlays, &widgets::InspectOverlays::shownChanged, &window,
                         [&window, overlays, layer, action] {
                             window.actions().action(action)->setChecked(overlays->isShown(layer));
                         });
    }
}

void bindMatches(MainWindow& window) {
    widgets::InspectPage* page = window.workspaces().inspectPage();
    const QString name = id("compare.nextMatches");
    const auto showTip = [&window, page, name] {
        page->layerBar()->setMatchTip(window.actions().action(name)->toolTip());
    };
    showTip();
    QObject::connect(&window.actions(), &Actions::shortcutsChanged, &window, showTip);
    window.actions().bind(name, [&window, page] {
        window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
        widgets::InspectOverlays* overlays = page->overlays();
        const bool isShown =
            overlays->isShown(widgets::InspectLayer::Matches) || overlays->isShown(widgets::InspectLayer::Rim);
        if (!isShown) {
            overlays->setShown(widgets::InspectLayer::Matches, true);
            return;
        }
        const auto next = static_cast<std::size_t>(overlays->matchChoice()) + 1;
        overlays->setMatchChoice(widgets::kMatchChoices[next % widgets::kMatchChoices.size()]);
    });
}

void askForMasks(MainWindow& window) {
    const auto& dataset = window.session().opened.dataset();
    if (!dataset)
        return;
    auto* dialog = new QFileDialog(&window, MainWindow::tr("Attach a folder of masks"),
                                   QString::fromStdString(dataset->folder.string()));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::fileSelected, &window,
                     [&window](const QString& folder) { window.workspaces().masks()->attach(folder); });
    dialog->open();
}

void bindComparing(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::Workspaces& spaces = window.workspaces();
    widgets::BenchmarkPage* page = spaces.benchmarkPage();
    actions.bind(id("compare.nextMethod"), [&spaces] { spaces.scenePanel()->showNext(); });
    actions.bind(id("benchmark.run"), [&spaces, page] {
        spaces.setCurrent(widgets::Workspaces::Kind::Benchmark);
        page->runOrStop();
    });
    actions.bind(id("benchmark.filter"), [&spaces, page] {
        spaces.setCurrent(widgets::Workspaces::Kind::Benchmark);
        page->results()->pairs()->askForFilter();
    });
    actions.bind(
        id("benchmark.runSelected"),
        [&spaces, page] {
            spaces.setCurrent(widgets::Workspaces::Kind::Benchmark);
            page->runSelectedPairs();
        });
    actions.bind(
        id("file.saveResults"), [page] { page->askToSave(); });
    actions.bind(
        id("file.openResults"), [page] { page->askToOpen(); });
    actions.bind(
        id("file.attachMasks"), [&window] { askForMasks(window); });
    QObject::connect(spaces.fittingPanel(), &widgets::FittingPanel::masksRequested, &window,
                     [&window] { askForMasks(window); });
}

void bindPanels(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::Workspaces& spaces = window.workspaces();
    actions.bind(id("view.adjust"), [&spaces] { spaces.raisePanel(spaces.viewPanel()); });
    actions.bind(
        id("view.cameras"),
        [&spaces] {
            spaces.raisePanel(spaces.viewPanel());
            spaces.viewPanel()->askForCameras();
        });
    actions.bind(id("fit.show"), [&spaces] { spaces.raisePanel(spaces.fittingPanel()); });
    actions.bind(
        id("go.threshold"),
        [&spaces] {
            spaces.raisePanel(spaces.qualityPanel());
            spaces.qualityPanel()->askForThreshold();
        });
    actions.bind(
        id("edit.preferences"), [&window] { showPreferences(window); });
    actions.bind(id("edit.shortcuts"), [&window] { showPreferences(window).showKeys(); });
    actions.bind(
        id("help.shortcuts"),
        [&window] {
            auto* page = window.findChild<ShortcutWindow*>();
            if (!page)
                page = new ShortcutWindow(window.actions(), &window);
            page->show();
            page->raise();
            page->activateWindow();
        });
    actions.bind(id("help.hints"), [&window] { window.showHints(); });
    actions.bind(id("help.about"), [&window] {
        auto* about = new QMessageBox(
            QMessageBox::NoIcon, MainWindow::tr("About Handlens"),
            MainWindow::tr("<h3>Handlens %1</h3><p>3D hand ground truth in calibrated multi-camera footage.</p>"
                           "<p>MIT licence. Built with Qt, VTK, Eigen, OpenCV, SQLite and others.</p>")
                .arg(QStringLiteral(HANDLENS_VERSION)),
            QMessageBox::Close, &window);
        about->setAttribute(Qt::WA_DeleteOnClose);
        about->setModal(false);
        about->show();
    });
}

/// The menu of a right click: what can be done with the mark there, then with the picture.
void showViewMenu(MainWindow& window, int camera, const core::JointId& joint, const QPoint& position) {
    auto* menu = new QMenu(&window);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (!joint.joint.empty()) {
        window.session().selection.setJoint(joint);
        menu->addSection(widgets::jointText(joint));
    }
    for (const char* name : {"annotation.accept", "annotation.occluded", "annotation.unplaceable", "annotation.remove"})
        menu->addAction(window.actions().action(id(name)));
    menu->addSeparator();
    for (const char* name : {"view.frameHands", "view.fitAll", "view.zoomJoint", "view.adjust"})
        menu->addAction(window.actions().action(id(name)));
    menu->addSeparator();
    window.workspaces().grid()->view(camera)->addPictureActions(*menu);
    menu->popup(position);
}

/// The menu of the joint table's header: which joints, and in which order.
void showListMenu(MainWindow& window, const QPoint& position) {
    auto* menu = new QMenu(&window);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const char* name :
         {"annotation.jointsFourteen", "annotation.jointsTwentyOne", "annotation.jointsAll", "annotation.jointsFile"})
        menu->addAction(window.actions().action(id(name)));
    menu->addSeparator();
    for (const char* name : {"annotation.jointUp", "annotation.jointDown"})
        menu->addAction(window.actions().action(id(name)));
    menu->popup(position);
}

} // namespace

void bindPanelActions(MainWindow& window) {
    bindNames(window);
    bindPanels(window);
    bindIterations(window);
    bindLayers(window);
    bindMatches(window);
    bindComparing(window);
    QObject::connect(
        window.workspaces().jointsPanel(), &widgets::JointsPanel::listMenuRequested, &window,
        [&window](const QPoint& position) { showListMenu(window, position); });
    QObject::connect(&window.workspaces(), &widgets::Workspaces::viewMenuRequested, &window,
                     [&window](int camera, QPointF, const core::JointId& joint, const QPoint& position) {
                         showViewMenu(window, camera, joint, position);
                     });
}

} // namespace app
