// SPDX-License-Identifier: MIT
#include "core/io/formats/coco_annotations.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"
#include "core/io/formats/format_requests.h"

// COCO keypoints: one image per frame and camera, one annotation per hand in it; x, y, v with v = 0 not labelled, 1
// labelled but not visible (hidden, or outside the picture), 2 visible. Whole pixels are pixel centres, as here. Beyond
// the format, images say their frame and camera, and annotations the placement of each keypoint: other readers ignore
// that. An annotation with a score is a program's guess.
namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr int kLeftCategory = 1, kRightCategory = 2;

int categoryOf(Side hand) {
    return hand == Side::Left ? kLeftCategory : kRightCategory;
}

/// Joints that follow each other on a finger, and each finger's base on the wrist; counted from 1.
ordered_json skeletonOf(const std::vector<std::pair<std::string, JointId>>& joints) {
    ordered_json pairs = ordered_json::array();
    const auto fingerOf = [](const JointId& joint) { return joint.joint.substr(0, joint.joint.find('_')); };
    std::size_t wrist = 0;
    for (std::size_t i = 0; i < joints.size(); ++i)
        wrist = joints[i].second.joint == "wrist" ? i + 1 : wrist;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const bool isSame = i > 0 && fingerOf(joints[i].second) == fingerOf(joints[i - 1].second);
        if (isSame)
            pairs.push_back({i, i + 1});
        else if (wrist > 0 && wrist != i + 1)
            pairs.push_back({wrist, i + 1});
    }
    return pairs;
}

ordered_json categories(const JointMap& map) {
    ordered_json list = ordered_json::array();
    for (const Side hand : {Side::Left, Side::Right}) {
        const auto joints = map.handList(hand);
        ordered_json names = ordered_json::array();
        for (const auto& [name, joint] : joints)
            names.push_back(name);
        list.push_back({{"id", categoryOf(hand)},
                        {"name", std::string(sideName(hand)) + "_hand"},
                        {"supercategory", "hand"},
                        {"keypoints", names},
                        {"skeleton", skeletonOf(joints)}});
    }
    return list;
}

/// One hand in one image; empty if no joint of the list is placed there.
std::optional<ordered_json> handAnnotation(const ExportRequest& job, int frame, const Camera& camera, Side hand) {
    ordered_json keypoints = ordered_json::array(), placements = ordered_json::array();
    Eigen::Vector2d low(1e30, 1e30), high(-1e30, -1e30);
    int count = 0;
    for (const auto& [name, joint] : job.map.handList(hand)) {
        const auto mark = placedMark(job, frame, joint, camera.name);
        const Eigen::Vector2d px = mark ? mark->px : Eigen::Vector2d(0, 0);
        const int visibility = !mark ? 0 : isSeen(*mark, camera) ? 2 : 1;
        keypoints.insert(keypoints.end(), {px.x(), px.y(), visibility});
        placements.push_back(mark ? ordered_json(placementName(mark->placement)) : ordered_json());
        if (mark) {
            low = low.cwiseMin(px);
            high = high.cwiseMax(px);
            ++count;
        }
    }
    if (count == 0)
        return std::nullopt;
    const Eigen::Vector2d extent = high - low;
    return ordered_json{{"category_id", categoryOf(hand)}, {"keypoints", keypoints},
                        {"num_keypoints", count},          {"bbox", {low.x(), low.y(), extent.x(), extent.y()}},
                        {"area", extent.x() * extent.y()}, {"iscrowd", 0},
                        {"placement", placements}};
}

std::string imageName(const ExportRequest& job, int frame, const std::string& camera) {
    const std::string digits = std::to_string(frame);
    return job.sequence.name + "/" + camera + "/" + std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') +
           digits + ".png";
}

} // namespace

void writeCocoAnnotations(const ExportRequest& job) {
    ordered_json images = ordered_json::array(), annotations = ordered_json::array();
    for (const int frame : settledFrames(job.set, job.rater)) {
        for (const Camera& camera : job.dataset.cameras) {
            const std::size_t imageId = images.size() + 1;
            images.push_back({{"id", imageId},
                              {"width", camera.size.width},
                              {"height", camera.size.height},
                              {"file_name", imageName(job, frame, camera.name)},
                              {"frame", frame},
                              {"camera", camera.name}});
            for (const Side hand : {Side::Left, Side::Right}) {
                if (auto annotation = handAnnotation(job, frame, camera, hand)) {
                    ordered_json item{{"id", annotations.size() + 1}, {"image_id", imageId}};
                    item.update(*annotation);
                    annotations.push_back(item);
                }
            }
        }
    }
    const ordered_json document{
        {"info", {{"description", "Handlens, sequence " + job.sequence.name}, {"contributor", job.rater}}},
        {"images", images},
        {"annotations", annotations},
        {"categories", categories(job.map)}};
    writeJsonFile(job.path, document);
}

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& field, const std::string& detail) {
    throw Error(ErrorCode::BadInput, file, field, detail);
}

/// Items of a list by their id.
std::map<int, const json*> byId(const json& list, const std::string& file, const std::string& field) {
    std::map<int, const json*> items;
    for (const json& item : list)
        if (!items.emplace(item["id"].get<int>(), &item).second)
            refuse(file, field, "the id " + item["id"].dump() + " occurs twice");
    return items;
}

} // namespace

void checkCoco(const json& document, const std::string& file) {
    checkSchema(document, "coco", file);
    const auto images = byId(document["images"], file, "images");
    const auto kinds = byId(document["categories"], file, "categories");
    byId(document["annotations"], file, "annotations");
    for (const auto& [id, category] : kinds) {
        for (const json& pair : category->value("skeleton", json::array()))
            if (std::max(pair[0].get<std::size_t>(), pair[1].get<std::size_t>()) > (*category)["keypoints"].size())
                refuse(file, "categories", "a skeleton pair names a keypoint that is not there (they count from 1)");
    }
    for (const json& annotation : document["annotations"]) {
        const std::string field = "annotations, id " + annotation["id"].dump();
        const auto category = kinds.find(annotation["category_id"].get<int>());
        if (category == kinds.end() || !images.contains(annotation["image_id"].get<int>()))
            refuse(file, field, "names an image or a category that is not there");
        const json& keypoints = annotation["keypoints"];
        if (keypoints.size() != 3 * (*category->second)["keypoints"].size())
            refuse(file, field, "keypoints must be x, y, v for each of the category's");
        int labelled = 0;
        for (std::size_t i = 2; i < keypoints.size(); i += 3) {
            if (keypoints[i] != 0 && keypoints[i] != 1 && keypoints[i] != 2)
                refuse(file, field, "v must be 0, 1 or 2");
            labelled += keypoints[i] != 0;
        }
        if (annotation["num_keypoints"] != labelled)
            refuse(file, field, "num_keypoints is not the number of keypoints with v > 0");
    }
}

namespace {

std::optional<Side> handOfCategory(const json& category) {
    std::string name = category["name"];
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool isLeft = name.find("left") != std::string::npos, isRight = name.find("right") != std::string::npos;
    return isLeft == isRight ? std::nullopt : std::optional(isLeft ? Side::Left : Side::Right);
}

/// Frame and camera of an image: as it says, or from its file name.
std::pair<int, std::string> placeOf(const ImportRequest& job, const json& image) {
    const std::string name = image["file_name"];
    if (image.contains("frame") && image.contains("camera"))
        return {image["frame"].get<int>(), image["camera"].get<std::string>()};
    const auto frame = trailingNumber(name);
    if (!frame) {
        refuse(job.path.string(), "images, id " + image["id"].dump(),
               "\"" + name + "\" does not end in the number of its frame");
    }
    return {*frame, cameraOfFile(job, name)};
}

void readHand(ImportRequest& job, const json& annotation, const json& category, Side hand, int frame,
              const std::string& camera) {
    const json& keypoints = annotation["keypoints"];
    const json placements = annotation.value("placement", json::array());
    std::optional<double> score; // only a program gives one
    if (annotation.contains("score") && annotation["score"].is_number())
        score = annotation["score"].get<double>();
    for (std::size_t i = 0; i < category["keypoints"].size(); ++i) {
        const int visibility = keypoints[3 * i + 2];
        const std::string name = category["keypoints"][i];
        if (visibility == 0)
            continue;
        const auto joint = job.map.jointOf(name, hand);
        if (!joint) {
            job.notes.leaveOut(ImportNoteKind::UnmappedKeypoint, name);
            continue;
        }
        const bool isAuto = i < placements.size() && placements[i] == "auto";
        addMark(job, frame, *joint, camera,
                Mark{Eigen::Vector2d(keypoints[3 * i].get<double>(), keypoints[3 * i + 1].get<double>()),
                     score    ? Placement::Proposed
                     : isAuto ? Placement::Auto
                              : Placement::Manual,
                     visibility == 2 ? MarkState::Visible : MarkState::Occluded, score});
    }
}

} // namespace

void readCocoAnnotations(ImportRequest& job) {
    const std::string file = job.path.string();
    const json document = readJsonFile(job.path);
    checkCoco(document, file);
    const auto images = byId(document["images"], file, "images"),
               kinds = byId(document["categories"], file, "categories");
    for (const json& annotation : document["annotations"]) {
        const json& category = *kinds.at(annotation["category_id"].get<int>());
        const auto hand = handOfCategory(category);
        if (!hand) {
            job.notes.leaveOut(ImportNoteKind::CategoryWithoutSide, category["name"].dump());
            continue;
        }
        const auto [frame, camera] = placeOf(job, *images.at(annotation["image_id"].get<int>()));
        readHand(job, annotation, category, *hand, frame, camera);
    }
}

} // namespace core
