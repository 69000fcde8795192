// SPDX-License-Identifier: MIT
#include "app/desktop/script/workspace_file.h"

#include <numbers>

#include <nlohmann/json.hpp>

#include "app/desktop/main_window.h"
#include "core/error.h"
#include "core/io/files/json_file.h"

namespace app {

namespace {

void addColumns(MainWindow& window, Workspace& workspace) {
    const widgets::InspectPage& page = *window.workspaces().inspectPage();
    const auto& cameras = window.session().opened.dataset()->cameras;
    for (std::size_t column = 0; column < page.columns()->count(); ++column) {
        const std::string id = widgets::columnId(page.columns()->columns()[column]);
        workspace.columns.push_back(id);
        for (std::size_t camera = 0; camera < cameras.size(); ++camera)
            if (!page.columns()->isShown(column, static_cast<int>(camera)))
                workspace.hidden.push_back({id, cameras[camera].name});
    }
    workspace.cameras = page.views()->chosenCameras();
    for (const widgets::Tracker& tracker : page.columns()->trackers())
        workspace.trackers.push_back({tracker.name, tracker.file.toStdString()});
}

const std::map<widgets::MeshStyle, const char*> kStyles{{widgets::MeshStyle::Shaded, "shaded"},
                                                        {widgets::MeshStyle::Wireframe, "wireframe"},
                                                        {widgets::MeshStyle::Off, "off"}};

/// How it is looked at.
void addLook(MainWindow& window, Workspace& workspace) {
    const widgets::InspectPage& page = *window.workspaces().inspectPage();
    const auto& columns = page.columns()->columns();
    const auto& cameras = window.session().opened.dataset()->cameras;
    const auto nameOf = [&](int camera) { return cameras[static_cast<std::size_t>(camera)].name; };
    if (page.columns()->current() < columns.size())
        workspace.column = widgets::columnId(columns[page.columns()->current()]);
    const widgets::LayerPresenter& layers = *window.workspaces().layers();
    const widgets::LayerLook& look = layers.look();
    workspace.meshes = {kStyles.at(look.style),
                        look.opacity,
                        look.leftShown,
                        look.rightShown,
                        layers.isLayerShown(QLatin1String(widgets::LayerPresenter::kStart)),
                        layers.isLayerShown(QLatin1String(widgets::LayerPresenter::kRecorded))};
    for (std::size_t row = 0; row < page.views()->rowCameras().size(); ++row)
        if (const auto region = page.views()->region(row))
            workspace.regions.push_back(
                {nameOf(page.views()->rowCameras()[row]), region->centrePx.x(), region->centrePx.y(), region->widthPx});
    if (const auto& pin = page.probePin()->pinned())
        workspace.probe = {widgets::columnId(pin->column), nameOf(pin->camera), pin->px.x(), pin->px.y()};
    const widgets::ColumnWipe& wipe = *page.views()->wipe();
    if (wipe.kind() != widgets::ColumnWipe::Kind::None)
        workspace.wipe = {wipe.kind() == widgets::ColumnWipe::Kind::Wipe ? "wipe" : "blink", wipe.place()};
}

void readLook(const nlohmann::json& document, Workspace& workspace) {
    workspace.column = document.value("column", std::string());
    if (document.contains("meshes")) {
        const nlohmann::json& written = document["meshes"];
        Workspace::Meshes meshes;
        meshes.style = written.value("style", meshes.style);
        meshes.opacity = written.value("opacity", meshes.opacity);
        meshes.left = written.value("left", meshes.left);
        meshes.right = written.value("right", meshes.right);
        meshes.start = written.value("start", meshes.start);
        meshes.silhouette = written.value("silhouette", meshes.silhouette);
        workspace.meshes = meshes;
    }
    for (const nlohmann::json& one : document.value("views", nlohmann::json::array()))
        workspace.regions.push_back({one["camera"].get<std::string>(), one["centre"][0].get<double>(),
                                     one["centre"][1].get<double>(), one["widthPx"].get<double>()});
    if (document.contains("probe")) {
        const nlohmann::json& probe = document["probe"];
        workspace.probe = {probe["column"].get<std::string>(), probe["camera"].get<std::string>(),
                           probe["px"][0].get<double>(), probe["px"][1].get<double>()};
    }
    if (document.contains("wipe"))
        workspace.wipe = {document["wipe"].value("kind", std::string("wipe")), document["wipe"].value("place", 0.5)};
}

void writeLook(const Workspace& workspace, nlohmann::json& document) {
    if (!workspace.column.empty())
        document["column"] = workspace.column;
    if (const auto& meshes = workspace.meshes)
        document["meshes"] = {{"style", meshes->style}, {"opacity", meshes->opacity},
                              {"left", meshes->left},   {"right", meshes->right},
                              {"start", meshes->start}, {"silhouette", meshes->silhouette}};
    for (const Workspace::Region& region : workspace.regions)
        document["views"].push_back(
            {{"camera", region.camera}, {"centre", {region.x, region.y}}, {"widthPx", region.widthPx}});
    if (const auto& probe = workspace.probe)
        document["probe"] = {{"column", probe->column}, {"camera", probe->camera}, {"px", {probe->x, probe->y}}};
    if (const auto& wipe = workspace.wipe)
        document["wipe"] = {{"kind", wipe->kind}, {"place", wipe->place}};
}

std::optional<Workspace::Trial> currentTrial(MainWindow& window) {
    const widgets::WhatIfPanel& panel = *window.workspaces().whatIfPanel();
    const widgets::WhatIfCase what = panel.currentCase();
    if (what == widgets::WhatIfCase() && panel.triedSettings().empty())
        return {};
    Workspace::Trial trial{what.outlineNoisePx, what.draw, {}, panel.triedSettings()};
    const auto& cameras = window.session().opened.dataset()->cameras;
    for (std::size_t camera = 0; camera < cameras.size(); ++camera)
        if (what.isLeftOut(camera))
            trial.without.push_back(cameras[camera].name);
    return trial;
}

std::optional<Workspace::Trial> trialOf(const nlohmann::json& document) {
    if (!document.contains("trial"))
        return {};
    const nlohmann::json& written = document["trial"];
    Workspace::Trial trial;
    trial.outlineNoisePx = written.value("outlineNoisePx", 0.0);
    trial.draw = written.value("draw", 0);
    trial.without = written.value("without", trial.without);
    for (const nlohmann::json& one : written.value("settings", nlohmann::json::array()))
        trial.settings[one["column"].get<std::string>()] = one["method"].get<std::string>();
    return trial;
}

nlohmann::json trialJson(const Workspace::Trial& trial) {
    nlohmann::json settings = nlohmann::json::array();
    for (const auto& [column, method] : trial.settings)
        settings.push_back({{"column", column}, {"method", method}});
    return {{"outlineNoisePx", trial.outlineNoisePx},
            {"draw", trial.draw},
            {"without", trial.without},
            {"settings", settings}};
}

} // namespace

Workspace currentWorkspace(MainWindow& window) {
    const auto& outcome = window.session().fits.outcome();
    if (!outcome)
        throw core::Error(core::ErrorCode::Usage, {}, "do", "nothing was fitted yet");
    const widgets::InspectPage& page = *window.workspaces().inspectPage();
    Workspace workspace;
    workspace.sequence = outcome->sequence;
    workspace.start = outcome->request.start;
    workspace.test = outcome->request.test;
    workspace.target = outcome->request.target == widgets::FitTarget::Masks ? "masks" : "recorded";
    workspace.methods = outcome->request.methods;
    workspace.iteration = page.iteration();
    workspace.camera = window.session().selection.camera();
    workspace.rows = page.rows();
    for (const widgets::InspectLayer layer : widgets::kInspectLayers)
        if (page.overlays()->isShown(layer))
            workspace.layers.push_back(widgets::inspectLayerId(layer).toStdString());
    workspace.fieldDirectionDeg = page.overlays()->fieldAngleRad() * 180 / std::numbers::pi;
    workspace.matches = widgets::matchChoiceId(page.overlays()->matchChoice()).toStdString();
    addColumns(window, workspace);
    addLook(window, workspace);
    workspace.trial = currentTrial(window);
    return workspace;
}

Workspace readWorkspace(const std::filesystem::path& file) {
    const nlohmann::json document = core::readOwnFile(file, "workspace");
    Workspace workspace;
    workspace.sequence = document["sequence"].get<std::string>();
    workspace.start = document["start"].get<int>();
    workspace.test = document["test"].get<int>();
    workspace.target = document.value("target", std::string());
    workspace.methods = document["methods"].get<std::vector<std::string>>();
    workspace.iteration = document.value("iteration", 0);
    workspace.camera = document.value("camera", std::string());
    workspace.rows = document.value("rows", workspace.rows);
    workspace.layers = document.value("layers", workspace.layers);
    workspace.fieldDirectionDeg = document.value("fieldDirectionDeg", 0.0);
    workspace.matches = document.value("matches", workspace.matches);
    workspace.columns = document.value("columns", workspace.columns);
    workspace.cameras = document.value("cameras", workspace.cameras);
    for (const nlohmann::json& hidden : document.value("hidden", nlohmann::json::array()))
        workspace.hidden.push_back({hidden["column"].get<std::string>(), hidden["camera"].get<std::string>()});
    for (const nlohmann::json& tracker : document.value("trackers", nlohmann::json::array())) {
        const std::filesystem::path path = tracker["file"].get<std::string>(); // beside the workspace, or absolute
        workspace.trackers.push_back({tracker["name"].get<std::string>(), (file.parent_path() / path).string()});
    }
    readLook(document, workspace);
    workspace.trial = trialOf(document);
    return workspace;
}

void writeWorkspace(const std::filesystem::path& file, const Workspace& workspace) {
    nlohmann::json hidden = nlohmann::json::array(), trackers = nlohmann::json::array();
    for (const Workspace::Hidden& one : workspace.hidden)
        hidden.push_back({{"column", one.column}, {"camera", one.camera}});
    for (const Workspace::Tracker& tracker : workspace.trackers)
        trackers.push_back({{"name", tracker.name}, {"file", tracker.file}});
    nlohmann::json document = {{"format", "handlens-workspace"},
                               {"version", 1},
                               {"sequence", workspace.sequence},
                               {"start", workspace.start},
                               {"test", workspace.test},
                               {"target", workspace.target},
                               {"methods", workspace.methods},
                               {"iteration", workspace.iteration},
                               {"camera", workspace.camera},
                               {"rows", workspace.rows},
                               {"layers", workspace.layers},
                               {"fieldDirectionDeg", workspace.fieldDirectionDeg},
                               {"matches", workspace.matches},
                               {"columns", workspace.columns},
                               {"cameras", workspace.cameras},
                               {"hidden", hidden},
                               {"trackers", trackers}};
    writeLook(workspace, document);
    if (workspace.trial)
        document["trial"] = trialJson(*workspace.trial);
    core::writeJsonFile(file, document);
}

} // namespace app
