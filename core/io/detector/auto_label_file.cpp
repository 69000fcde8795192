// SPDX-License-Identifier: MIT
#include "core/io/detector/auto_label_file.h"

#include <nlohmann/json.hpp>

#include "core/annotation/edits.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/sequence_pictures.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::ordered_json;

namespace {

ordered_json landmarkJson(const Dataset& dataset, const SpatialHand& hand, std::size_t landmark, int pictures) {
    ordered_json views = ordered_json::array();
    const SpatialLandmark& found = *hand.landmarks[landmark];
    const TriangulatedPoint& point = found.triangulated;
    for (std::size_t i = 0; i < found.cameras.size(); ++i) {
        if (!point.inlier[i])
            continue;
        const Eigen::Vector2d& px = hand.views.at(found.cameras[i]).px[landmark];
        views.push_back({{"camera", dataset.cameras[static_cast<std::size_t>(found.cameras[i])].name},
                         {"px", {px.x(), px.y()}},
                         {"state", stateName(MarkState::Visible)},
                         {"placement", placementName(Placement::Auto)},
                         {"errorPx", point.residualPx[i]}});
    }
    const JointStatus status = static_cast<int>(views.size()) >= pictures ? JointStatus::Done : JointStatus::Partial;
    return {{"xyz", jsonOf(point.pointInWorld)},
            {"covariance", jsonOf(point.covariance)},
            {"rmsPx", point.rmsPx},
            {"views", views},
            {"unplaceable", ordered_json::array()},
            {"status", statusName(status)}};
}

ordered_json handsOfFrame(const Dataset& dataset, const std::vector<AutoHand>& hands, int pictures) {
    ordered_json result = ordered_json::object();
    for (const AutoHand& label : hands) {
        ordered_json joints = ordered_json::object();
        for (std::size_t i = 0; i < kLandmarkCount; ++i)
            if (label.hand.hand.landmarks[i])
                joints[std::string(landmarkName(i))] = landmarkJson(dataset, label.hand.hand, i, pictures);
        result[std::string(sideName(label.hand.side))] = {{"doubt", label.doubt}, {"joints", joints}};
    }
    return result;
}

} // namespace

void writeAutoLabels(const std::filesystem::path& file, const Dataset& dataset, const Sequence& sequence,
                     const AutoLabels& labels) {
    const PictureGaps gaps = pictureGaps(dataset, sequence);
    ordered_json frames = ordered_json::array(), joints = ordered_json::array();
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        joints.push_back(landmarkName(i));
    for (const auto& [frame, hands] : labels) {
        const int pictures = static_cast<int>(dataset.cameras.size() - gaps.at(frame).size());
        frames.push_back(
            {{"frame", frame}, {"raters", {{{"rater", "auto"}, {"hands", handsOfFrame(dataset, hands, pictures)}}}}});
    }
    writeJsonFile(file, {{"format", "handlens-ground-truth"},
                         {"version", 1},
                         {"units", "mm"},
                         {"cameras", camerasToJson(dataset.cameras)},
                         {"sequence", sequence.name},
                         {"joints", joints},
                         {"frames", frames}});
}

Edit autoLabelEdit(const AnnotationSet& set, const Dataset& dataset, const AutoLabels& labels,
                   const std::string& rater) {
    Edit all;
    for (const auto& [frame, hands] : labels) {
        for (const AutoHand& label : hands) {
            std::vector<JointPoint> points;
            for (std::size_t i = 0; i < kLandmarkCount; ++i)
                if (const auto& landmark = label.hand.hand.landmarks[i])
                    points.push_back(
                        {{label.hand.side, std::string(landmarkName(i))}, landmark->triangulated.pointInWorld});
            Edit edit = proposeEdit(set, dataset.cameras, frame, rater, points);
            all.description = edit.description;
            for (MarkChange& change : edit.marks) {
                change.after->likelihood = 1 - label.doubt;
                all.marks.push_back(std::move(change));
            }
        }
    }
    return all;
}

} // namespace core
