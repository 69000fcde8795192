// SPDX-License-Identifier: MIT
#include "core/io/detector/auto_label_file.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "core/annotation/edits.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/sequence_pictures.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::ordered_json;

namespace {

ordered_json orNull(const std::optional<double>& number) {
    return number ? ordered_json(*number) : ordered_json(nullptr);
}

/// `gaps`: cameras without a picture, which show no joint.
ordered_json jointJson(const Dataset& dataset, const AutoJoint& joint, const std::set<std::string>& gaps) {
    ordered_json views = ordered_json::array();
    for (const AutoView& view : joint.views) {
        const std::string& camera = dataset.cameras[static_cast<std::size_t>(view.camera)].name;
        if (gaps.count(camera) > 0)
            continue;
        views.push_back({{"camera", camera},
                         {"px", {view.px.x(), view.px.y()}},
                         {"state", stateName(MarkState::Visible)},
                         {"placement", placementName(Placement::Auto)},
                         {"errorPx", orNull(view.errorPx)}});
    }
    const bool isDone = views.size() + gaps.size() >= dataset.cameras.size();
    return {{"xyz", jsonOf(joint.pointInWorld)},
            {"covariance", jsonOf(joint.covariance)},
            {"rmsPx", orNull(joint.rmsPx())},
            {"views", views},
            {"unplaceable", ordered_json::array()},
            {"status", statusName(isDone ? JointStatus::Done : JointStatus::Partial)}};
}

ordered_json handsOfFrame(const Dataset& dataset, const std::vector<AutoHand>& hands,
                          const std::set<std::string>& gaps) {
    ordered_json result = ordered_json::object();
    for (const AutoHand& label : hands) {
        ordered_json joints = ordered_json::object();
        for (const AutoJoint& joint : label.joints)
            joints[joint.name] = jointJson(dataset, joint, gaps);
        result[std::string(sideName(label.side))] = {{"doubt", label.doubt}, {"joints", joints}};
    }
    return result;
}

/// The names of all joints that are labelled, in the order of their hands.
std::vector<std::string> namesOf(const AutoLabels& labels) {
    std::vector<std::string> names;
    for (const auto& [frame, hands] : labels)
        for (const AutoHand& hand : hands)
            for (const AutoJoint& joint : hand.joints)
                if (std::find(names.begin(), names.end(), joint.name) == names.end())
                    names.push_back(joint.name);
    return names;
}

} // namespace

void writeAutoLabels(const std::filesystem::path& file, const Dataset& dataset, const Sequence& sequence,
                     const AutoLabels& labels) {
    const PictureGaps gaps = pictureGaps(dataset, sequence);
    ordered_json frames = ordered_json::array();
    for (const auto& [frame, hands] : labels)
        frames.push_back({{"frame", frame},
                          {"raters", {{{"rater", "auto"}, {"hands", handsOfFrame(dataset, hands, gaps.at(frame))}}}}});
    writeJsonFile(file, {{"format", "handlens-ground-truth"},
                         {"version", 1},
                         {"units", "mm"},
                         {"cameras", camerasToJson(dataset.cameras)},
                         {"sequence", sequence.name},
                         {"joints", namesOf(labels)},
                         {"frames", frames}});
}

Edit autoLabelEdit(const AnnotationSet& set, const Dataset& dataset, const AutoLabels& labels, const std::string& rater,
                   const std::vector<JointId>& joints) {
    Edit all;
    for (const auto& [frame, hands] : labels) {
        for (const AutoHand& label : hands) {
            std::vector<JointPoint> points;
            for (const AutoJoint& joint : label.joints) {
                const JointId id{label.side, joint.name};
                if (joints.empty() || std::find(joints.begin(), joints.end(), id) != joints.end())
                    points.push_back({id, joint.pointInWorld});
            }
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
