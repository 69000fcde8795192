// SPDX-License-Identifier: MIT
#include "app/desktop/actions/window_actions.h"

#include <algorithm>

#include <QActionGroup>
#include <QApplication>
#include <QUndoGroup>
#include <QUndoStack>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"
#include "app/desktop/palettes.h"
#include "widgets/session/navigation.h"

namespace app {

namespace {

using widgets::Direction;
using widgets::Workspaces;

void bindFile(MainWindow& window) {
    Actions& actions = window.actions();
    actions.bind(
        id("file.open"), [&window] { window.askForDataset(); });
    actions.bind(
        id("file.demo"), [&window] { window.openDemo(); });
    actions.bind(id("file.quit"), [&window] { window.close(); });
}

void bindUndo(MainWindow& window) {
    Actions& actions = window.actions();
    auto* stacks = new QUndoGroup(&window); // others join it (silhouette_actions.cpp)
    stacks->addStack(window.session().document.undoStack());
    stacks->setActiveStack(window.session().document.undoStack());
    QAction* undo = actions.action(id("edit.undo"));
    QAction* redo = actions.action(id("edit.redo"));
    actions.bind(
        id("edit.undo"), [stacks] { stacks->undo(); });
    actions.bind(id("edit.redo"), [stacks] { stacks->redo(); });
    const auto refresh = [stacks, undo, redo] {
        undo->setEnabled(stacks->canUndo());
        redo->setEnabled(stacks->canRedo());
        undo->setText(stacks->canUndo() ? MainWindow::tr("&Undo %1").arg(stacks->undoText()) : MainWindow::tr("&Undo"));
        redo->setText(stacks->canRedo() ? MainWindow::tr("&Redo %1").arg(stacks->redoText()) : MainWindow::tr("&Redo"));
    };
    QObject::connect(stacks, &QUndoGroup::indexChanged, &window, refresh);
    QObject::connect(stacks, &QUndoGroup::activeStackChanged, &window, refresh);
    QObject::connect(&window.session().document, &widgets::AnnotationDocument::opened, &window, refresh);
    refresh();
}

void bindWorkspaces(MainWindow& window) {
    auto* group = new QActionGroup(&window);
    const std::pair<const char*, Workspaces::Kind> kinds[] = {{"workspace.annotate", Workspaces::Kind::Annotate},
                                                              {"workspace.inspect", Workspaces::Kind::Inspect},
                                                              {"workspace.benchmark", Workspaces::Kind::Benchmark}};
    for (const auto& [name, kind] : kinds) {
        QAction* action = window.actions().action(id(name));
        group->addAction(action);
        action->setChecked(kind == Workspaces::Kind::Annotate);
        window.actions().bind(id(name), [&window, kind = kind] { window.workspaces().setCurrent(kind); });
    }
    QObject::connect(&window.workspaces(), &Workspaces::currentChanged, &window,
                     [&window, kinds](Workspaces::Kind current) {
                         for (const auto& [name, kind] : kinds)
                             if (kind == current)
                                 window.actions().action(id(name))->setChecked(true);
                     });
}

void bindOverlays(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::ViewOptions& options = window.viewOptions();
    widgets::MarkPresenter* marks = window.workspaces().marks();
    for (const char* name : {"view.skeleton", "view.guides", "view.proposals"})
        actions.action(id(name))->setChecked(true);
    actions.bindToggle(
        id("view.hideOverlays"), [&options](bool on) { options.setOverlaysHidden(on); });
    actions.bindToggle(
        id("view.longErrors"), [&options](bool on) { options.setLongErrors(on); });
    actions.bindToggle(
        id("view.loupe"), [&options](bool on) { options.setLoupeShown(on); });
    actions.bindToggle(
        id("view.labels"), [&options](bool on) { options.setLabelsShown(on); });
    actions.bindToggle(
        id("view.followJoint"), [&options](bool on) { options.setFollowingJoint(on); });
    actions.bindToggle(
        id("view.skeleton"), [marks](bool on) { marks->setSkeletonShown(on); });
    actions.bindToggle(
        id("view.guides"), [marks](bool on) { marks->setGuidesShown(on); });
    actions.bindToggle(id("view.proposals"), [marks](bool on) { marks->setProposalsShown(on); });
    widgets::HandFraming* framing = window.workspaces().framing();
    actions.bind(id("view.frameHands"), [&window, framing] {
        if (!framing->frameHands())
            window.statusLine().sayBriefly(
                MainWindow::tr("It is not known yet where the hands are: mark some joints, then frame them."));
    });
    actions.action(id("view.handLabels"))->setChecked(framing->labelsShown());
    actions.bindToggle(
        id("view.handLabels"), [framing](bool on) { framing->setLabelsShown(on); });
    actions.bind(
        id("view.fitAll"), [&options] { options.showWholeImages(); });
    actions.bind(id("view.zoomJoint"), [&options] { options.zoomToJoint(); });
}

void setMeshStyle(MainWindow& window, widgets::MeshStyle style) {
    widgets::LayerLook look = window.workspaces().layers()->look();
    look.style = style;
    window.workspaces().layers()->setLook(look);
}

void bindMeshStyles(MainWindow& window) {
    using widgets::MeshStyle;
    const std::pair<const char*, MeshStyle> styles[] = {{"view.meshShaded", MeshStyle::Shaded},
                                                        {"view.meshWireframe", MeshStyle::Wireframe},
                                                        {"view.meshOff", MeshStyle::Off}};
    auto* group = new QActionGroup(&window);
    for (const auto& [name, style] : styles) {
        QAction* action = window.actions().action(id(name));
        group->addAction(action);
        action->setChecked(style == window.workspaces().layers()->look().style);
        window.actions().bind(id(name), [&window, style = style] { setMeshStyle(window, style); });
    }
    QObject::connect(window.workspaces().layers(), &widgets::LayerPresenter::lookChanged, &window, [&window, styles] {
        for (const auto& [name, style] : styles)
            if (style == window.workspaces().layers()->look().style)
                window.actions().action(id(name))->setChecked(true);
    });
    window.actions().bind(id("view.meshNext"), [&window] {
        const MeshStyle style = window.workspaces().layers()->look().style;
        setMeshStyle(window, style == MeshStyle::Shaded      ? MeshStyle::Wireframe
                             : style == MeshStyle::Wireframe ? MeshStyle::Off
                                                             : MeshStyle::Shaded);
    });
}

void bindMeshLook(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::LayerPresenter* layers = window.workspaces().layers();
    const auto change = [layers](auto&& how) {
        widgets::LayerLook look = layers->look();
        how(look);
        layers->setLook(look);
    };
    constexpr double kStep = 0.1;
    actions.bind(
        id("view.meshMore"),
        [change] { change([](auto& look) { look.opacity = std::min(1.0, look.opacity + kStep); }); });
    actions.bind(id("view.meshLess"),
                 [change] { change([](auto& look) { look.opacity = std::max(0.05, look.opacity - kStep); }); });
    actions.action(id("view.recordedMesh"))->setChecked(true);
    layers->setLayerShown(id(widgets::LayerPresenter::kStart), false);
    actions.bindToggle(
        id("view.recordedMesh"),
        [layers](bool on) { layers->setLayerShown(id(widgets::LayerPresenter::kRecorded), on); });
    actions.bindToggle(
        id("view.modelOfMarks"), [&window](bool on) { window.session().model.setOn(on); });
    actions.bindToggle(id("view.startMesh"),
                       [layers](bool on) { layers->setLayerShown(id(widgets::LayerPresenter::kStart), on); });
}

/// A hand's mesh is shown if the hand is, and its mesh.
void bindHand(MainWindow& window, core::Side hand, const char* wholeHand, const char* meshOnly) {
    Actions& actions = window.actions();
    QAction* whole = actions.action(id(wholeHand));
    QAction* mesh = actions.action(id(meshOnly));
    whole->setChecked(true);
    mesh->setChecked(true);
    const auto showMesh = [&window, hand, whole, mesh] {
        widgets::LayerLook look = window.workspaces().layers()->look();
        (hand == core::Side::Left ? look.leftShown : look.rightShown) = whole->isChecked() && mesh->isChecked();
        window.workspaces().layers()->setLook(look);
    };
    actions.bindToggle(id(meshOnly), [showMesh](bool) { showMesh(); });
    actions.bindToggle(id(wholeHand), [&window, hand, mesh, showMesh](bool on) {
        mesh->setEnabled(on);
        window.workspaces().marks()->setHandShown(hand, on);
        window.workspaces().framing()->setHandShown(hand, on);
        showMesh();
    });
}

/// The grid of views that is in sight.
widgets::CameraGrid* gridInSight(MainWindow& window) {
    const bool isInspect = window.workspaces().current() == widgets::Workspaces::Kind::Inspect;
    return isInspect ? window.workspaces().inspectPage()->grid() : window.workspaces().grid();
}

/// In Annotate the view of that camera; where methods stand side by side, that view in reading order.
void maximiseView(MainWindow& window, int number) {
    widgets::CameraGrid* grid = gridInSight(window);
    if (grid != window.workspaces().grid()) {
        if (number <= grid->count())
            grid->setMaximised(number - 1);
        return;
    }
    const auto& shown = window.session().shownCameras.names();
    if (number > static_cast<int>(shown.size()))
        return;
    const auto& camera = shown[static_cast<std::size_t>(number - 1)];
    grid->setMaximised(window.session().opened.dataset()->cameraIndex(camera));
    window.session().selection.setCamera(camera);
}

void bindView(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::CameraGrid* grid = window.workspaces().grid();
    for (int number = 1; number <= 8; ++number) {
        actions.bind(
            QStringLiteral("view.maximise%1").arg(number), [&window, number] { maximiseView(window, number); });
    }
    actions.bind(id("view.restore"), [&window] {
        if (!window.closeHints()) // what lies on top goes first
            gridInSight(window)->setMaximised(-1);
    });
    widgets::SceneView* scene = window.workspaces().scene();
    actions.bind(
        id("view.resetScene"), [scene] { scene->resetView(); });
    actions.bindToggle(
        id("view.lookThrough"), [&window, scene, grid](bool on) { scene->lookThrough(on ? grid->current() : -1); });
    QObject::connect(grid, &widgets::CameraGrid::currentChanged, scene, [scene](int camera) {
        if (scene->lookedThrough() >= 0)
            scene->lookThrough(camera);
    });
    QAction* light = actions.action(id("view.light"));
    light->setChecked(lookFromName(window.settings().value(QStringLiteral("look")).toString()) == Look::Light);
    actions.bindToggle(
        id("view.light"),
        [&window](bool on) {
            const Look look = on ? Look::Light : Look::Dark;
            window.settings().setValue(QStringLiteral("look"), lookName(look));
            applyLook(*qApp, look);
        });
    actions.bindToggle(id("view.fullScreen"),
                       [&window](bool on) { on ? window.showFullScreen() : window.showNormal(); });
}

void bindMarks(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::Annotator& annotator = window.session().annotator;
    actions.bind(
        id("annotation.accept"), [&annotator] { annotator.accept(); });
    actions.bind(
        id("annotation.acceptAll"), [&annotator] { annotator.acceptAllViews(); });
    actions.bind(
        id("annotation.acceptFrame"), [&annotator] { annotator.acceptFrame(); });
    actions.bind(
        id("annotation.remove"), [&annotator] { annotator.remove(); });
    actions.bind(
        id("annotation.removeAll"), [&annotator] { annotator.removeInAllViews(); });
    actions.bind(
        id("annotation.occluded"), [&annotator] { annotator.toggleOccluded(); });
    actions.bind(
        id("annotation.unplaceable"), [&annotator] { annotator.toggleUnplaceable(); });
    actions.bind(
        id("annotation.previousJoint"), [&annotator] { annotator.stepJoint(-1); });
    actions.bind(
        id("annotation.nextJoint"), [&annotator] { annotator.stepJoint(1); });
    actions.bind(
        id("annotation.previousView"), [&annotator] { annotator.stepCamera(-1); });
    actions.bind(id("annotation.nextView"), [&annotator] { annotator.stepCamera(1); });
    const std::pair<const char*, Eigen::Vector2d> nudges[] = {{"annotation.nudgeLeft", {-1, 0}},
                                                              {"annotation.nudgeRight", {1, 0}},
                                                              {"annotation.nudgeUp", {0, -1}},
                                                              {"annotation.nudgeDown", {0, 1}}};
    constexpr double kFinePx = 0.25;
    for (const auto& [name, way] : nudges) {
        actions.bind(
            id(name), [&annotator, by = Eigen::Vector2d(way * kFinePx)] { annotator.nudge(by); });
        actions.bind(id(name) + QStringLiteral("Far"), [&annotator, by = way] { annotator.nudge(by); });
    }
    actions.action(id("annotation.autoAdvance"))->setChecked(annotator.autoAdvance());
    actions.bindToggle(id("annotation.autoAdvance"), [&annotator](bool on) { annotator.setAutoAdvance(on); });
}

void goTo(MainWindow& window, const std::optional<int>& frame, const QString& otherwise) {
    if (frame)
        window.session().selection.setFrame(*frame);
    else
        window.statusLine().sayBriefly(otherwise);
}

void bindFrames(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::WindowSession& session = window.session();
    const std::pair<const char*, int> steps[] = {
        {"go.previousFrame", -1}, {"go.nextFrame", 1}, {"go.back10", -10}, {"go.forward10", 10}};
    for (const auto& [name, frames] : steps)
        actions.bind(
            id(name), [&session, frames = frames] { session.annotator.stepFrame(frames); });
    actions.bind(
        id("go.firstFrame"), [&session] { session.selection.setFrame(0); });
    actions.bind(
        id("go.lastFrame"), [&session] { session.selection.setFrame(session.selection.frameCount() - 1); });
    actions.bind(
        id("go.frame"), [&window] { window.framesBar().askForFrame(); });
    actions.bindToggle(id("go.play"), [&window](bool on) { on ? window.playback().play() : window.playback().stop(); });
    QAction* play = actions.action(id("go.play"));
    QObject::connect(&window.playback(), &widgets::Playback::playingChanged, play, [play](bool playing) {
        play->setChecked(playing);
        play->setIcon(QIcon::fromTheme(playing ? QStringLiteral("media-playback-pause")
                                               : QStringLiteral("media-playback-start")));
    });
}

void bindJumps(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::WindowSession& session = window.session();
    const auto bind = [&](const char* name, auto find, const QString& otherwise) {
        actions.bind(
            id(name), [&window, find, otherwise] { goTo(window, find(), otherwise); });
    };
    const auto frame = [&session] { return session.selection.frame(); };
    const auto frames = [&session] { return session.coverage.frames(); };
    const QString noBad = MainWindow::tr("No bad joint in that direction.");
    bind(
        "go.nextBad", [=] { return widgets::nextBadFrame(frames(), frame(), Direction::Forward); }, noBad);
    bind(
        "go.previousBad", [=] { return widgets::nextBadFrame(frames(), frame(), Direction::Back); }, noBad);
    const auto unlabelled = [&session](Direction way) {
        return widgets::nextUnlabelledFrame(session.coverage.frames(), session.joints, session.selection.frameCount(),
                                            session.selection.frame(), way);
    };
    const QString allDone = MainWindow::tr("Every frame in that direction is done.");
    bind(
        "go.nextUnlabelled", [=] { return unlabelled(Direction::Forward); }, allDone);
    bind(
        "go.previousUnlabelled", [=] { return unlabelled(Direction::Back); }, allDone);
    const QString noMarks = MainWindow::tr("No frame with marks in that direction.");
    bind(
        "go.nextAnnotated", [=] { return widgets::nextAnnotatedFrame(frames(), frame(), Direction::Forward); },
        noMarks);
    bind(
        "go.previousAnnotated", [=] { return widgets::nextAnnotatedFrame(frames(), frame(), Direction::Back); },
        noMarks);
    const auto test = [&window, &session](Direction way) -> std::optional<int> {
        return widgets::nextOf(window.workspaces().benchmarkPage()->testFrames(), session.selection.frame(), way);
    };
    const QString noTest = MainWindow::tr("No test frame in that direction, as the benchmark is set.");
    bind(
        "go.nextTest", [=] { return test(Direction::Forward); }, noTest);
    bind(
        "go.previousTest", [=] { return test(Direction::Back); }, noTest);
    bind(
        "go.lastEdited", [&session] { return session.document.lastEditedFrame(); },
        MainWindow::tr("Nothing was edited yet."));
}

void bindFit(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::FittingPanel* panel = window.workspaces().fittingPanel();
    actions.bind(
        id("fit.run"), [panel] { panel->fitCurrentFrame(); });
    actions.bind(id("fit.stop"), [&window] { window.session().fits.stop(); });
}

} // namespace

void bindWindowActions(MainWindow& window) {
    bindFile(window);
    bindUndo(window);
    bindWorkspaces(window);
    bindOverlays(window);
    bindMeshStyles(window);
    bindMeshLook(window);
    bindHand(window, core::Side::Left, "view.leftMarks", "view.leftHand");
    bindHand(window, core::Side::Right, "view.rightMarks", "view.rightHand");
    bindView(window);
    bindMarks(window);
    bindFrames(window);
    bindJumps(window);
    bindFit(window);
}

} // namespace app
