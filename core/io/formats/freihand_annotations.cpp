// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"
#include "core/io/formats/format_requests.h"

// Files in the style of HanCo, in FreiHAND's joint order: xyz/<sequence>_<hand>/<frame>.json with 21 joints in the
// world, and calib/<sequence>_<hand>/<frame>.json with K and the world-to-camera matrix of every camera. Metres, as in
// the originals; a joint without a point is null.
namespace core {

using nlohmann::ordered_json;

namespace {

constexpr double kMetresPerMm = 1e-3;

std::string jsonFileName(int frame) {
    const std::string digits = std::to_string(frame);
    return std::string(digits.size() < 8 ? 8 - digits.size() : 0, '0') + digits + ".json";
}

ordered_json calibration(const std::vector<Camera>& cameras) {
    ordered_json intrinsics = ordered_json::array(), motions = ordered_json::array();
    for (const Camera& camera : cameras) {
        intrinsics.push_back(jsonOf(camera.intrinsics));
        ordered_json matrix = jsonOf(camera.cameraFromWorld.rotation);
        for (std::size_t row = 0; row < 3; ++row)
            matrix[row].push_back(camera.cameraFromWorld.translation[static_cast<Eigen::Index>(row)] * kMetresPerMm);
        matrix.push_back({0.0, 0.0, 0.0, 1.0});
        motions.push_back(matrix);
    }
    return {{"K", intrinsics}, {"M", motions}};
}

/// The joints of one hand; empty if none has a point.
std::optional<ordered_json> handJson(const std::map<JointId, JointReconstruction>& points, const JointMap& map,
                                     Side hand) {
    ordered_json joints = ordered_json::array();
    bool isEmpty = true;
    for (const auto& [name, joint] : map.handList(hand)) {
        const auto found = points.find(joint);
        isEmpty = isEmpty && found == points.end();
        joints.push_back(found == points.end()
                             ? ordered_json()
                             : jsonOf(Eigen::Vector3d(found->second.result.point->pointInWorld * kMetresPerMm)));
    }
    return isEmpty ? std::nullopt : std::optional(joints);
}

} // namespace

void writeFreiHand(const ExportRequest& job) {
    PendingFolder folder(job.path);
    const ordered_json calib = calibration(job.dataset.cameras);
    for (const int frame : settledFrames(job.set, job.rater)) {
        const auto points = pointsOf(job, frame);
        for (const Side hand : {Side::Left, Side::Right}) {
            if (const auto joints = handJson(points, job.map, hand)) {
                const std::string sequence = job.sequence.name + "_" + std::string(sideName(hand));
                for (const char* kind : {"xyz", "calib"})
                    ensureFolder(folder.path() / kind / sequence);
                writeJsonFile(folder.path() / "xyz" / sequence / jsonFileName(frame), *joints);
                writeJsonFile(folder.path() / "calib" / sequence / jsonFileName(frame), calib);
            }
        }
    }
    folder.commit();
}

} // namespace core
