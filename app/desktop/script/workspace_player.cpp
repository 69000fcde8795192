// SPDX-License-Identifier: MIT
#include "app/desktop/script/workspace_player.h"

#include <algorithm>
#include <iostream>
#include <numbers>

#include <QJsonArray>

#include "app/desktop/main_window.h"
#include "app/desktop/script/comparison_report.h"
#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/script_steps.h"
#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"
#include "widgets/text/error_text.h"
#include "widgets/text/method_text.h"
#include "widgets/views/picture_export.h"

namespace app {

namespace {

constexpr int kPageWidth = 1920, kPageHeight = 1080; ///< of the window that the pictures are taken from

QJsonObject goToStep(const Workspace& workspace) {
    return {{QStringLiteral("do"), QStringLiteral("goto")},
            {QStringLiteral("sequence"), QString::fromStdString(workspace.sequence)},
            {QStringLiteral("frame"), workspace.test}};
}

QJsonObject fitStep(const Workspace& workspace) {
    QJsonArray methods;
    for (const std::string& method : workspace.methods)
        methods.append(QString::fromStdString(method));
    QJsonObject step{{QStringLiteral("do"), QStringLiteral("fit")},
                     {QStringLiteral("start"), workspace.start},
                     {QStringLiteral("test"), workspace.test},
                     {QStringLiteral("methods"), methods}};
    if (!workspace.target.empty())
        step[QStringLiteral("target")] = QString::fromStdString(workspace.target);
    return step;
}

void save(const QImage& picture, const QDir& folder, const QString& name, QStringList& saved) {
    const QString path = folder.absoluteFilePath(name);
    if (picture.isNull() || !widgets::savePicture({[&picture](double) { return picture; }, {}, name, {}}, path))
        throw core::Error(core::ErrorCode::Io, path.toStdString(), {}, "the picture could not be written");
    saved << name;
}

/// A method's name as part of a file's.
QString fileName(const std::string& method, const std::string& camera) {
    QString name = QString::fromStdString(method + "_" + camera + ".png");
    for (QChar& c : name)
        if (!c.isLetterOrNumber() && !QStringLiteral("-_.=").contains(c))
            c = QLatin1Char('-');
    return name;
}

} // namespace

namespace {

/// Fields that files of before have not.
void restoreColumns(MainWindow& window, const Workspace& workspace) {
    QJsonObject step{{QStringLiteral("do"), QStringLiteral("columns")}};
    const auto list = [](const std::vector<std::string>& texts) {
        QJsonArray array;
        for (const std::string& text : texts)
            array.append(QString::fromStdString(text));
        return array;
    };
    QJsonArray trackers;
    for (const Workspace::Tracker& tracker : workspace.trackers)
        trackers.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(tracker.name)},
                                    {QStringLiteral("file"), QString::fromStdString(tracker.file)}});
    step[QStringLiteral("trackers")] = trackers;
    step[QStringLiteral("cameras")] = list(workspace.cameras);
    step[QStringLiteral("show")] = list(workspace.columns.empty() ? workspace.methods : workspace.columns);
    ScriptSteps(window, QDir()).run(step);
    widgets::InspectColumns& columns = *window.workspaces().inspectPage()->columns();
    const auto isHidden = [&](const std::string& column, const std::string& camera) {
        return std::any_of(workspace.hidden.begin(), workspace.hidden.end(),
                           [&](const auto& one) { return one.column == column && one.camera == camera; });
    };
    const auto& cameras = window.session().opened.dataset()->cameras;
    for (std::size_t column = 0; column < columns.count(); ++column)
        for (std::size_t camera = 0; camera < cameras.size(); ++camera)
            columns.setShown(column, static_cast<int>(camera),
                             !isHidden(widgets::columnId(columns.columns()[column]), cameras[camera].name));
}

core::Error badTrial(const char* field, const std::string& what) {
    return {core::ErrorCode::BadInput, {}, std::string("trial.") + field, what};
}

void checkSettings(MainWindow& window, const Workspace::Trial& trial) {
    const auto& columns = window.workspaces().inspectPage()->columns()->columns();
    for (const auto& [name, method] : trial.settings) {
        if (std::none_of(columns.begin(), columns.end(),
                         [&](const auto& column) { return widgets::columnId(column) == name; }))
            throw badTrial("settings", "there is no column \"" + name + "\"");
        if (const QString problem = widgets::methodProblem(QString::fromStdString(method)); !problem.isEmpty())
            throw badTrial("settings", problem.toStdString());
    }
}

/// Fits what was tried once more; without a trial, all is as it was fitted.
void restoreTrial(MainWindow& window, const std::optional<Workspace::Trial>& trial) {
    widgets::WhatIfPanel& panel = *window.workspaces().whatIfPanel();
    if (!trial) {
        panel.goBack();
        return;
    }
    checkSettings(window, *trial);
    const core::Dataset& dataset = *window.session().opened.dataset();
    widgets::WhatIfCase what{{}, trial->outlineNoisePx, trial->draw};
    if (!trial->without.empty())
        what.cameras.assign(dataset.cameras.size(), true);
    for (const std::string& name : trial->without) {
        const int camera = dataset.cameraIndex(name);
        if (camera < 0)
            throw badTrial("without", "unknown camera \"" + name + "\"");
        what.cameras[static_cast<std::size_t>(camera)] = false;
    }
    if (std::none_of(what.cameras.begin(), what.cameras.end(), [](bool on) { return on; }) && !what.cameras.empty())
        throw badTrial("without", "no camera is left");
    panel.tryAgain(what, trial->settings);
    if (!waitFor(window, [&] { return !panel.isRunning() && window.session().pool.isIdle(); }))
        throw badTrial("settings", "no answer in time");
}

void setChecked(MainWindow& window, const char* action, bool on) {
    window.actions().action(QString::fromLatin1(action))->setChecked(on);
}

void restoreMeshes(MainWindow& window, const Workspace::Meshes& meshes) {
    using widgets::MeshStyle;
    widgets::LayerLook look = window.workspaces().layers()->look();
    look.style = meshes.style == "off"         ? MeshStyle::Off
                 : meshes.style == "wireframe" ? MeshStyle::Wireframe
                                               : MeshStyle::Shaded;
    look.opacity = meshes.opacity;
    window.workspaces().layers()->setLook(look);
    setChecked(window, "view.leftHand", meshes.left);
    setChecked(window, "view.rightHand", meshes.right);
    setChecked(window, "view.startMesh", meshes.start);
    setChecked(window, "view.recordedMesh", meshes.silhouette);
}

void restoreProbe(MainWindow& window, const std::optional<Workspace::Probe>& probe) {
    widgets::InspectPage& page = *window.workspaces().inspectPage();
    page.probePin()->unpin();
    if (!probe)
        return;
    const int camera = window.session().opened.dataset()->cameraIndex(probe->camera);
    const int view = page.views()->viewOf(probe->column, camera);
    if (view < 0)
        throw core::Error(core::ErrorCode::BadInput, {}, "probe",
                          "no view of \"" + probe->column + "\" and \"" + probe->camera + "\" is shown");
    page.probePin()->pin(view, {probe->x, probe->y});
}

void restoreRegions(MainWindow& window, const std::vector<Workspace::Region>& regions) {
    widgets::InspectGrid& views = *window.workspaces().inspectPage()->views();
    const auto& cameras = window.session().opened.dataset()->cameras;
    for (std::size_t row = 0; row < views.rowCameras().size(); ++row) {
        const std::string& camera = cameras[static_cast<std::size_t>(views.rowCameras()[row])].name;
        const auto found = std::find_if(regions.begin(), regions.end(),
                                        [&](const Workspace::Region& one) { return one.camera == camera; });
        if (found == regions.end())
            views.setRegion(row, {});
        else
            views.setRegion(row, widgets::InspectGrid::Region{{found->x, found->y}, found->widthPx});
    }
}

/// How it is looked at. What has its size from the window comes last.
void restoreLook(MainWindow& window, const Workspace& workspace) {
    const widgets::InspectPage& page = *window.workspaces().inspectPage();
    const auto& columns = page.columns()->columns();
    for (std::size_t column = 0; column < columns.size(); ++column)
        if (widgets::columnId(columns[column]) == workspace.column)
            page.columns()->setCurrent(column);
    if (workspace.meshes)
        restoreMeshes(window, *workspace.meshes);
    widgets::ColumnWipe& wipe = *page.views()->wipe();
    using Kind = widgets::ColumnWipe::Kind;
    wipe.setKind(!workspace.wipe ? Kind::None : workspace.wipe->kind == "blink" ? Kind::Blink : Kind::Wipe);
    if (workspace.wipe)
        wipe.setPlace(workspace.wipe->place);
    waitUntilIdle(window);
    restoreProbe(window, workspace.probe);
    waitUntilIdle(window);
    restoreRegions(window, workspace.regions);
    waitUntilIdle(window);
}

} // namespace

void restoreWorkspace(MainWindow& window, const Workspace& workspace) {
    ScriptSteps steps(window, QDir());
    steps.run(goToStep(workspace));
    widgets::InspectPage* page = window.workspaces().inspectPage();
    if (!workspace.camera.empty()) {
        const auto& shown = window.session().shownCameras.names();
        if (std::find(shown.begin(), shown.end(), workspace.camera) == shown.end())
            throw core::Error(core::ErrorCode::BadInput, {}, "camera", "\"" + workspace.camera + "\" is not shown");
        window.session().selection.setCamera(workspace.camera);
    }
    page->setRows(workspace.rows);
    steps.run(fitStep(workspace));
    restoreColumns(window, workspace);
    restoreTrial(window, workspace.trial);
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    page->setIteration(workspace.iteration);
    page->overlays()->setMatchChoice(
        widgets::matchChoiceOf(QString::fromStdString(workspace.matches)).value_or(widgets::MatchChoice::ByDistance));
    page->overlays()->setFieldAngleRad(workspace.fieldDirectionDeg * std::numbers::pi / 180);
    for (const widgets::InspectLayer layer : widgets::kInspectLayers) {
        const std::string id = widgets::inspectLayerId(layer).toStdString();
        const bool isShown = std::find(workspace.layers.begin(), workspace.layers.end(), id) != workspace.layers.end();
        page->overlays()->setShown(layer, isShown);
    }
    restoreLook(window, workspace);
}

QStringList saveWorkspacePictures(MainWindow& window, const QDir& folder) {
    const widgets::InspectPage& page = *window.workspaces().inspectPage();
    const auto& methods = page.columns()->outcome()->methods;
    page.grid()->finishDrawing();
    QStringList saved;
    for (int index = 0; index < page.grid()->count(); ++index) {
        const widgets::CameraView* view = page.grid()->view(index);
        const std::string& method = methods[static_cast<std::size_t>(index) % methods.size()].method;
        save(view->grabPicture(), folder, fileName(method, view->camera().name), saved);
    }
    save(page.grid()->grabPicture(), folder, QStringLiteral("compare.png"), saved);
    save(page.errorPlot()->grabPicture(), folder, QStringLiteral("error.png"), saved);
    save(page.costPlot()->grabPicture(), folder, QStringLiteral("cost.png"), saved);
    return saved;
}

namespace {

/// Errors of the restoring name the file, too.
void restoreFrom(MainWindow& window, const std::string& file) {
    try {
        restoreWorkspace(window, readWorkspace(file));
    } catch (const core::Error& error) {
        if (!error.file().empty())
            throw;
        throw core::Error(error.code(), file, error.field(), error.detail());
    }
}

} // namespace

int renderWorkspace(MainWindow& window, const std::string& file, const std::string& outFolder) {
    try {
        const QDir folder(QString::fromStdString(outFolder));
        if (!QDir().mkpath(folder.absolutePath()))
            throw core::Error(core::ErrorCode::Io, outFolder, {}, "the folder cannot be made");
        window.resize(kPageWidth, kPageHeight);
        restoreFrom(window, file);
        for (const QString& name : saveWorkspacePictures(window, folder))
            std::cout << name.toStdString() << '\n';
        const QString report = QStringLiteral("report.html");
        core::writeFileAtomically(
            folder.absoluteFilePath(report).toStdString(),
            comparisonReportHtml(window, std::filesystem::path(file).filename().string(), core::readTextFile(file)));
        std::cout << report.toStdString() << '\n';
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "handlens: " << error.what() << std::endl;
        return 1;
    }
}

void openWorkspace(MainWindow& window, const std::string& file) {
    waitUntilIdle(window);
    try {
        restoreFrom(window, file);
    } catch (const core::Error& error) {
        window.showMessage(widgets::errorInWords(error));
    }
}

} // namespace app
