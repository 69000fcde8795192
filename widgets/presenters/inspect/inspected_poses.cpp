// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspected_poses.h"

#include <algorithm>

#include "widgets/presenters/inspect/inspect_layers.h"
#include "widgets/presenters/inspect_columns.h"
#include "widgets/presenters/layer_presenter.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

MeshLayer layerOf(const core::Dataset& dataset, const core::HandPoses& poses, const QString& name,
                  const QColor& colour) {
    MeshLayer layer;
    layer.name = name;
    layer.colour = colour;
    for (std::size_t hand = 0; hand < dataset.hands.size() && hand < poses.size(); ++hand)
        if (poses[hand].size() > 0) // a tracker may have one hand only
            layer.surfaces.push_back(makeViewSurface(dataset.hands[hand], poses[hand]));
    return layer;
}

bool isSame(const core::HandPoses& a, const core::HandPoses& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const core::Pose& one, const core::Pose& other) {
            return one.size() == other.size() && (one.size() == 0 || one == other);
        });
}

} // namespace

const core::HandPoses& inspectedPosesAt(const FitOutcome& outcome, const MethodOutcome& method, int iteration) {
    const auto& history = method.result.history;
    if (method.isFixed)
        return method.result.poses;
    if (iteration <= 0 || history.empty())
        return history.empty() && iteration > 0 ? method.result.poses : outcome.startPoses;
    if (iteration >= static_cast<int>(history.size()))
        return method.result.poses;
    return history[static_cast<std::size_t>(iteration - 1)].poses;
}

bool isAtResult(const MethodOutcome& method, int iteration) {
    return method.isFixed || iteration >= static_cast<int>(method.result.history.size());
}

InspectedPoses inspectedPoses(const core::Dataset& dataset, const FitOutcome& outcome, int iteration,
                              const std::stop_token& stop, const InspectedPoses* before) {
    InspectedPoses poses;
    poses.start =
        before ? before->start
               : layerOf(dataset, outcome.startPoses, QLatin1String(LayerPresenter::kStart), methodColour("start"));
    poses.truth = before ? before->truth
                         : layerOf(dataset, outcome.truePoses, QLatin1String(LayerPresenter::kRecorded),
                                   methodColour("recorded"));
    if (outcome.request.target == FitTarget::Recorded) // else the observed outline is drawn
        poses.recorded = poses.truth;
    for (std::size_t column = 0; column < outcome.methods.size(); ++column) {
        if (stop.stop_requested())
            break;
        const MethodOutcome& method = outcome.methods[column];
        poses.poses.push_back(inspectedPosesAt(outcome, method, iteration));
        MeshLayer layer{QString::fromStdString(method.method), {}, columnColour(outcome, column)};
        if (before && column < before->poses.size() && isSame(before->poses[column], poses.poses.back())) {
            layer.surfaces = before->methods[column].surfaces;
            poses.methodsByError.push_back(layer);
            poses.methodsByError.back().surfaces = before->methodsByError[column].surfaces;
        } else {
            layer = layerOf(dataset, poses.poses.back(), layer.name, layer.colour);
            poses.methodsByError.push_back(colouredByError(layer, poses.truth));
        }
        poses.methods.push_back(std::move(layer));
    }
    return poses;
}

double inspectedErrorMm(const FitOutcome& outcome, const MethodOutcome& method, int iteration) {
    if (method.isFixed)
        return method.errorMm;
    if (iteration <= 0)
        return outcome.initialErrorMm;
    if (iteration > static_cast<int>(method.iterationErrorMm.size()))
        return method.errorMm;
    return method.iterationErrorMm[static_cast<std::size_t>(iteration - 1)];
}

std::vector<MeshLayer> inspectedColumn(const InspectedPoses& poses, std::size_t method, const LayerLook& look,
                                       bool startShown, bool recordedShown) {
    std::vector<MeshLayer> layers;
    const auto add = [&layers](const std::optional<MeshLayer>& layer) {
        if (layer)
            layers.push_back(*layer);
    };
    if (look.style != MeshStyle::Off) {
        if (startShown)
            add(withLook(poses.start, look));
        add(withLook(poses.methods[method], look));
    }
    if (recordedShown) { // only its edge
        LayerLook edge = look;
        edge.style = MeshStyle::Shaded;
        edge.opacity = 0;
        add(withLook(poses.recorded, edge));
    }
    return layers;
}

} // namespace widgets
