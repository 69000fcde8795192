// SPDX-License-Identifier: MIT
#include "core/io/calibration/cameras_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

Camera cameraFromJson(const json& value, const std::string& file, const std::string& field) {
    Camera camera;
    camera.name = value["name"].get<std::string>();
    camera.size = {value["size"][0].get<int>(), value["size"][1].get<int>()};
    camera.intrinsics = jsonMatrix(value["K"], file, field + ".K");
    if (value.contains("distortion"))
        camera.distortion = jsonNumbers(value["distortion"], value["distortion"].size(), file, field + ".distortion");
    camera.fisheye = value.value("fisheye", false);
    camera.cameraFromWorld.rotation = jsonMatrix(value["R"], file, field + ".R");
    camera.cameraFromWorld.translation = jsonVector(value["t"], file, field + ".t");
    return camera;
}

/// What is wrong with K, or nothing.
std::string intrinsicsProblem(const Eigen::Matrix3d& k) {
    if (!k.allFinite() || k(0, 0) <= 0 || k(1, 1) <= 0)
        return "focal lengths must be positive";
    if (std::abs(k(2, 0)) > 1e-9 || std::abs(k(2, 1)) > 1e-9 || std::abs(k(2, 2) - 1) > 1e-9)
        return "the last row must be 0 0 1 (is the matrix transposed?)";
    if (std::abs(k(1, 0)) > 1e-9)
        return "must be upper triangular";
    return "";
}

std::string lensProblem(const Camera& camera) {
    const std::size_t n = camera.distortion.size();
    if (!std::all_of(camera.distortion.begin(), camera.distortion.end(), [](double d) { return std::isfinite(d); }))
        return "is not finite";
    if (camera.fisheye)
        return n == 4 ? "" : "a fisheye camera has 4 coefficients, not " + std::to_string(n);
    return n == 0 || n == 4 || n == 5 || n == 8 ? ""
                                                : "0, 4, 5 or 8 coefficients are expected, not " + std::to_string(n);
}

std::string rotationProblem(const Eigen::Matrix3d& rotation) {
    if (rotation.allFinite() && isRotation(-rotation))
        return "is a reflection (determinant -1), not a rotation";
    return isRotation(rotation) ? "" : "is not a rotation (orthonormal rows, determinant +1)";
}

} // namespace

void checkCameras(const std::vector<Camera>& cameras, const std::string& file) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const Camera& camera = cameras[i];
        const std::string field = "cameras[" + std::to_string(i) + "]";
        const auto demand = [&](const std::string& member, const std::string& problem) {
            if (!problem.empty())
                throw Error(ErrorCode::BadInput, file, field + "." + member, problem);
        };
        demand("name", isFileName(camera.name) ? "" : "must be usable as a file name");
        demand("name", names.insert(camera.name).second ? "" : "the name \"" + camera.name + "\" is used twice");
        demand("size", camera.size.width > 0 && camera.size.height > 0 ? "" : "must be positive");
        demand("K", intrinsicsProblem(camera.intrinsics));
        demand("distortion", lensProblem(camera));
        demand("R", rotationProblem(camera.cameraFromWorld.rotation));
        demand("t", camera.cameraFromWorld.translation.allFinite() ? "" : "is not finite");
    }
}

std::vector<Camera> camerasFromJson(const json& document, const std::string& file) {
    checkOwnDocument(document, "cameras", file);
    std::vector<Camera> cameras;
    for (const json& item : document["cameras"])
        cameras.push_back(cameraFromJson(item, file, "cameras[" + std::to_string(cameras.size()) + "]"));
    checkCameras(cameras, file);
    return cameras;
}

std::vector<Camera> readCameras(const std::filesystem::path& file) {
    return camerasFromJson(readJsonFile(file), file.string());
}

ordered_json camerasToJson(const std::vector<Camera>& cameras) {
    ordered_json list = ordered_json::array();
    for (const Camera& camera : cameras) {
        list.push_back({{"name", camera.name},
                        {"size", {camera.size.width, camera.size.height}},
                        {"K", jsonOf(camera.intrinsics)},
                        {"distortion", camera.distortion},
                        {"fisheye", camera.fisheye},
                        {"R", jsonOf(camera.cameraFromWorld.rotation)},
                        {"t", jsonOf(camera.cameraFromWorld.translation)}});
    }
    return list;
}

ordered_json camerasDocument(const std::vector<Camera>& cameras) {
    return {{"format", "handlens-cameras"}, {"version", 1}, {"units", "mm"}, {"cameras", camerasToJson(cameras)}};
}

void writeCameras(const std::filesystem::path& file, const std::vector<Camera>& cameras) {
    checkCameras(cameras, file.string());
    writeJsonFile(file, camerasDocument(cameras));
}

} // namespace core
