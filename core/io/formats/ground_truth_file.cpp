// SPDX-License-Identifier: MIT
#include "core/io/formats/ground_truth_file.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/sequence_pictures.h"
#include "core/io/files/json_file.h"
#include "core/io/formats/import_notes.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

ordered_json viewJson(const ViewReconstruction& view) {
    ordered_json json{
        {"camera", view.camera},
        {"px", {view.mark->px.x(), view.mark->px.y()}},
        {"state", stateName(view.outside ? MarkState::Occluded : view.mark->state)}, // outside the picture: not visible
        {"placement", placementName(view.mark->placement)},
        {"errorPx", view.errorPx ? ordered_json(*view.errorPx) : ordered_json()}};
    if (view.mark->isAcceptedGuess())
        json["likelihood"] = *view.mark->likelihood;
    return json;
}

/// Names of all joints: those of the hands, then others that are annotated.
std::vector<std::string> jointNamesOf(const Dataset& dataset, const AnnotationSet& set) {
    std::vector<std::string> names;
    std::set<std::string> known;
    for (const HandModel& hand : dataset.hands) {
        for (const Bone& bone : hand.skeleton.bones)
            if (known.insert(bone.name).second)
                names.push_back(bone.name);
    }
    for (const auto& [key, mark] : set.marks)
        if (known.insert(key.joint.joint).second)
            names.push_back(key.joint.joint);
    return names;
}

ordered_json handsJson(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                       const std::string& rater, const ReconstructionOptions& options) {
    ordered_json hands = ordered_json::object();
    for (const auto& [id, joint] : reconstructFrame(set, cameras, frame, rater, options)) {
        if (joint.status == JointStatus::None)
            continue; // proposals only
        hands[std::string(sideName(id.hand))]["joints"][id.joint] = groundTruthJoint(joint);
    }
    return hands;
}

} // namespace

ordered_json groundTruthJoint(const JointReconstruction& joint) {
    ordered_json views = ordered_json::array(), unplaceable = ordered_json::array();
    for (const ViewReconstruction& view : joint.views)
        if (view.mark && view.mark->isPlaced())
            views.push_back(viewJson(view));
        else if (view.mark && !view.mark->hasPlace())
            unplaceable.push_back(view.camera);
    const auto& point = joint.result.point;
    return {{"xyz", point ? jsonOf(point->pointInWorld) : ordered_json()},
            {"covariance", point ? jsonOf(point->covariance) : ordered_json()},
            {"rmsPx", point && !joint.isAccepted ? ordered_json(point->rmsPx) : ordered_json()},
            {"views", views},
            {"unplaceable", unplaceable},
            {"status", statusName(joint.status)}};
}

void writeGroundTruth(const std::filesystem::path& file, const Dataset& dataset, const Sequence& sequence,
                      const AnnotationSet& set, const AnnotationExportOptions& options) {
    std::set<int> framesToWrite;
    for (const int frame : annotatedFrames(set))
        framesToWrite.insert(frame);
    for (const auto& [frame, note] : set.notes)
        framesToWrite.insert(frame);
    const PictureGaps gaps = pictureGaps(dataset, sequence);
    ordered_json frames = ordered_json::array();
    for (const int frame : framesToWrite) {
        ordered_json raters = ordered_json::array();
        for (const std::string& rater : ratersOf(set, frame)) {
            if (!options.rater || *options.rater == rater) {
                const ReconstructionOptions reconstruction{options.triangulationOf(rater), false, std::nullopt,
                                                           gaps.at(frame)};
                if (auto hands = handsJson(set, dataset.cameras, frame, rater, reconstruction); !hands.empty())
                    raters.push_back({{"rater", rater}, {"hands", std::move(hands)}});
            }
        }
        const auto note = set.notes.find(frame);
        if (raters.empty() && note == set.notes.end())
            continue;
        ordered_json item{{"frame", frame}};
        if (note != set.notes.end())
            item["note"] = note->second;
        item["raters"] = raters;
        frames.push_back(item);
    }
    writeJsonFile(file, {{"format", "handlens-ground-truth"},
                         {"version", 1},
                         {"units", "mm"},
                         {"cameras", camerasToJson(dataset.cameras)},
                         {"sequence", sequence.name},
                         {"joints", jointNamesOf(dataset, set)},
                         {"frames", frames}});
}

namespace {

Mark markFromJson(const json& view, const std::string& file, const std::string& field) {
    const std::vector<double> px = jsonNumbers(view["px"], 2, file, field + ".px");
    Mark mark{{px[0], px[1]},
              *placementFromName(view["placement"].get<std::string>()),
              *stateFromName(view["state"].get<std::string>())};
    if (mark.placement == Placement::Auto && view.contains("likelihood"))
        mark.likelihood = view["likelihood"].get<double>();
    return mark;
}

/// Files of before do not say which marks are accepted guesses of a program: those of a joint that has a place, and
/// neither a click nor a residual.
bool isAcceptedUnsaid(const json& joint) {
    return !joint["xyz"].is_null() && joint["rmsPx"].is_null() &&
           std::all_of(
               joint["views"].begin(), joint["views"].end(),
               [](const json& view) { return view["placement"] == "auto" && !view.contains("likelihood"); });
}

/// `isProgram`: a program labelled the hand, and nobody has looked at it.
void readJoint(const json& joint, const MarkKey& where, bool isProgram, const std::string& file, ImportNotes& notes,
               AnnotationSet& set) {
    const auto add = [&](const std::string& camera, const Mark& mark) {
        MarkKey key = where;
        key.camera = camera;
        if (notes.accepts(key) && !set.marks.emplace(key, mark).second)
            throw Error(ErrorCode::BadInput, file, "frame " + std::to_string(key.frame) + ", " + jointLabel(key.joint),
                        "camera \"" + camera + "\" occurs twice");
    };
    constexpr double kUnknownLikelihood = 0.5;
    const bool isAccepted = isAcceptedUnsaid(joint) && !isProgram;
    for (const json& view : joint["views"]) {
        Mark mark = markFromJson(view, file, "frame " + std::to_string(where.frame) + ", " + jointLabel(where.joint));
        if (isAccepted)
            mark.likelihood = kUnknownLikelihood;
        add(view["camera"], mark);
    }
    for (const json& camera : joint["unplaceable"])
        add(camera, Mark{Eigen::Vector2d::Zero(), Placement::Manual, MarkState::Unplaceable});
}

} // namespace

ImportedAnnotations readGroundTruth(const std::filesystem::path& file, const Dataset& dataset,
                                    const Sequence& sequence) {
    const json value = readOwnFile(file, "ground-truth");
    ImportNotes notes(dataset, sequence);
    AnnotationSet set;
    if (const std::string name = value["sequence"]; name != sequence.name)
        notes.remark(ImportNoteKind::FileOfSequence, {name, sequence.name});
    for (const json& frame : value["frames"]) {
        const int number = frame["frame"];
        if (frame.contains("note") && notes.acceptsFrame(number))
            set.notes[number] = frame["note"];
        for (const json& rater : frame["raters"]) {
            for (const auto& [hand, joints] : rater["hands"].items()) {
                for (const auto& [name, joint] : joints["joints"].items()) {
                    readJoint(joint, {number, rater["rater"], {*sideFromName(hand), name}, {}},
                              joints.contains("doubt"), file.string(), notes, set);
                }
            }
        }
    }
    return {std::move(set), notes.all(), {}, {}};
}

} // namespace core
