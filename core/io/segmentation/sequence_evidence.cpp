// SPDX-License-Identifier: MIT
#include "core/io/segmentation/sequence_evidence.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "core/annotation/hand_fit.h"
#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;

namespace {

HandPoses fittedPoses(const std::vector<HandModel>& hands, const JointPoints& points) {
    HandPoses poses;
    for (const HandModel& hand : hands) {
        const auto fit = fitHandToPoints(hand, points);
        poses.push_back(fit ? fit->pose : Pose());
    }
    return poses;
}

bool isWhole(const LandmarkPoints& landmarks) {
    return std::all_of(
        landmarks.begin(), landmarks.end(), [](const auto& point) { return point.has_value(); });
}

/// The landmarks of every hand that has a joint; what is not annotated comes from the fitted model.
std::vector<LandmarkPoints> landmarksOf(const std::vector<HandModel>& hands, const JointPoints& points) {
    std::vector<LandmarkPoints> result;
    for (const Side side : {Side::Left, Side::Right}) {
        std::map<std::string, Eigen::Vector3d> named;
        for (const auto& [joint, point] : points)
            if (joint.hand == side)
                named.emplace(joint.joint, point.pointInWorld);
        if (named.empty())
            continue;
        LandmarkPoints landmarks = landmarkPoints(named);
        for (const HandModel& hand : hands)
            if (hand.side == side && !isWhole(landmarks))
                if (const auto fit = fitHandToPoints(hand, points))
                    fillFromModel(landmarks, hand.skeleton, fit->pose);
        result.push_back(landmarks);
    }
    return result;
}

TriangulatedPoint pointFromJson(const json& joint, const std::string& file, const std::string& field) {
    TriangulatedPoint point;
    point.pointInWorld = jsonVector(joint["xyz"], file, field + ".xyz");
    if (joint.contains("covariance") && !joint["covariance"].is_null())
        point.covariance = jsonMatrix(joint["covariance"], file, field + ".covariance");
    return point;
}

} // namespace

std::string_view originName(EvidenceOrigin origin) {
    constexpr std::array<std::string_view, 5> kNames{"none", "motion", "labels", "annotations", "detector"};
    return kNames.at(static_cast<std::size_t>(origin));
}

SequenceEvidence::SequenceEvidence(std::vector<HandModel> hands, Motion motion)
    : m_hands(std::move(hands))
    , m_motion(std::move(motion))
    , m_origin(EvidenceOrigin::RecordedMotion) {}

SequenceEvidence::SequenceEvidence(std::vector<HandModel> hands, SequencePoints points, EvidenceOrigin origin)
    : m_hands(std::move(hands))
    , m_points(std::move(points))
    , m_origin(origin) {}

int SequenceEvidence::countKnown(const std::vector<int>& frames) const {
    return static_cast<int>(std::count_if(
        frames.begin(), frames.end(),
        [&](int frame) {
            return m_origin == EvidenceOrigin::RecordedMotion ? frame < static_cast<int>(m_motion.size())
                                                              : m_points.count(frame) > 0;
        }));
}

HandEvidence SequenceEvidence::at(int frame, SegmentationMethod method) const {
    HandEvidence evidence;
    if (m_origin == EvidenceOrigin::RecordedMotion) {
        if (frame < 0 || frame >= static_cast<int>(m_motion.size()))
            return evidence;
        evidence.poses = m_motion[static_cast<std::size_t>(frame)];
        for (std::size_t h = 0; h < m_hands.size() && method != SegmentationMethod::Model; ++h)
            fillFromModel(evidence.landmarks.emplace_back(), m_hands[h].skeleton, evidence.poses[h]);
        return evidence;
    }
    const auto points = m_points.find(frame);
    if (points == m_points.end())
        return evidence;
    if (method == SegmentationMethod::Model)
        evidence.poses = fittedPoses(m_hands, points->second);
    else
        evidence.landmarks = landmarksOf(m_hands, points->second);
    return evidence;
}

SequencePoints readLabelPoints(const std::filesystem::path& file, const Sequence& sequence) {
    const json value = readOwnFile(file, "ground-truth");
    if (const std::string name = value["sequence"]; name != sequence.name)
        throw Error(ErrorCode::BadInput, file.string(), "sequence",
                    "the labels are of \"" + name + "\", not of \"" + sequence.name + "\"");
    SequencePoints points;
    for (const json& frame : value["frames"]) {
        const int number = frame["frame"];
        for (const json& rater : frame["raters"]) {
            for (const auto& [hand, joints] : rater["hands"].items()) {
                for (const auto& [name, joint] : joints["joints"].items()) {
                    if (joint["xyz"].is_null())
                        continue;
                    const std::string field = "frame " + std::to_string(number) + "." + hand + "." + name;
                    points[number].emplace(JointId{*sideFromName(hand), name},
                                           pointFromJson(joint, file.string(), field));
                }
            }
        }
    }
    return points;
}

SequencePoints readAnnotationPoints(const Dataset& dataset, const Sequence& sequence) {
    const AnnotationSet set = readAnnotations(dataset, sequence);
    SequencePoints points;
    for (const std::string& rater : ratersOf(set))
        for (auto& [frame, ofFrame] : sequencePoints(set, dataset.cameras, rater))
            points[frame].merge(JointPoints(ofFrame));
    return points;
}

} // namespace core
