// SPDX-License-Identifier: MIT
#include "app/desktop/script/workspace_file.h"

#include <numbers>

#include <nlohmann/json.hpp>

#include "app/desktop/main_window.h"
#include "core/error.h"
#include "core/io/files/json_file.h"

namespace app {

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
    return workspace;
}

void writeWorkspace(const std::filesystem::path& file, const Workspace& workspace) {
    core::writeJsonFile(file, {{"format", "handlens-workspace"},
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
                               {"fieldDirectionDeg", workspace.fieldDirectionDeg}});
}

} // namespace app
