// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"
#include "core/io/formats/format_requests.h"

// Files in the style of InterHand2.6M: joint_3d.json with 21 joints of the right and 21 of the left hand (tips first,
// wrist last, mm) and camera.json with positions instead of translations: x_cam = R (X - campos).
namespace core {

using nlohmann::ordered_json;

namespace {

std::vector<JointId> jointsInOrder(const JointMap& map) {
    std::vector<JointId> joints;
    for (const Side hand : {Side::Right, Side::Left})
        for (const auto& [name, joint] : map.handList(hand))
            joints.push_back(joint);
    return joints;
}

ordered_json frameJson(const ExportRequest& job, int frame) {
    const auto points = pointsOf(job, frame);
    ordered_json coordinates = ordered_json::array(), valid = ordered_json::array();
    bool hasHand[2] = {false, false};
    for (const JointId& joint : jointsInOrder(job.map)) {
        const auto found = points.find(joint);
        const bool isThere = found != points.end();
        coordinates.push_back(jsonOf(isThere ? found->second.result.point->pointInWorld : Eigen::Vector3d(0, 0, 0)));
        valid.push_back({isThere ? 1 : 0});
        hasHand[joint.hand == Side::Left ? 0 : 1] |= isThere;
    }
    const bool isTwoHanded = hasHand[0] && hasHand[1];
    return {{"world_coord", coordinates},
            {"joint_valid", valid},
            {"hand_type", isTwoHanded  ? "interacting"
                          : hasHand[0] ? "left"
                                       : "right"},
            {"hand_type_valid", hasHand[0] || hasHand[1]}};
}

ordered_json camerasJson(const std::vector<Camera>& cameras) {
    ordered_json json;
    for (const Camera& camera : cameras) {
        json["campos"][camera.name] = jsonOf(camera.centreInWorld());
        json["camrot"][camera.name] = jsonOf(camera.cameraFromWorld.rotation);
        json["focal"][camera.name] = {camera.intrinsics(0, 0), camera.intrinsics(1, 1)};
        json["princpt"][camera.name] = {camera.intrinsics(0, 2), camera.intrinsics(1, 2)};
        if (camera.intrinsics(0, 1) != 0) // not in the original either
            json["skew"][camera.name] = camera.intrinsics(0, 1);
        if (camera.hasLens()) { // not in the original, whose images have no distortion left
            json["distortion"][camera.name] = camera.distortion;
            json["fisheye"][camera.name] = camera.fisheye;
        }
    }
    return json;
}

} // namespace

void writeInterHand(const ExportRequest& job) {
    PendingFolder folder(job.path);
    ordered_json frames = ordered_json::object();
    for (const int frame : settledFrames(job.set, job.rater))
        frames[std::to_string(frame)] = frameJson(job, frame);
    writeJsonFile(folder.path() / "joint_3d.json", {{job.sequence.name, frames}});
    writeJsonFile(folder.path() / "camera.json", {{job.sequence.name, camerasJson(job.dataset.cameras)}});
    folder.commit();
}

} // namespace core
