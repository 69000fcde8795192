// SPDX-License-Identifier: MIT
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;

namespace {

const json& member(const json& value, const std::string& key, const std::string& file, const std::string& where) {
    if (!value.is_object() || !value.contains(key))
        throw Error(ErrorCode::BadInput, file, where + key, "is missing");
    return value[key];
}

/// The capture that is asked for, or the only one.
const json& capture(const json& document, const std::string& section, const std::string& file) {
    if (document.is_object() && document.contains("campos"))
        return document;
    if (!section.empty())
        return member(document, section, file, "");
    if (!document.is_object() || document.size() != 1)
        throw Error(ErrorCode::BadInput, file, "", "holds several captures; say which with --section");
    return document.front();
}

} // namespace

bool looksLikeOwnCameras(const CalibrationSource& source) {
    return source.hasExtension({".json"}) && source.json().is_object() && source.json().contains("format");
}

std::vector<Camera> readOwnCameras(const CalibrationSource& source, const CalibrationOptions&) {
    return camerasFromJson(source.json(), source.path().string());
}

bool looksLikeInterHand(const CalibrationSource& source) {
    if (!source.hasExtension({".json"}) || !source.json().is_object())
        return false;
    const json& value = source.json();
    const json& inner = !value.empty() && value.begin()->is_object() ? *value.begin() : value;
    return value.contains("campos") || inner.contains("campos");
}

std::vector<Camera> readInterHand(const CalibrationSource& source, const CalibrationOptions& options) {
    const std::string file = source.path().string();
    const json& cameras = capture(source.json(), options.section, file);
    std::vector<Camera> result;
    for (const auto& [name, position] : member(cameras, "campos", file, "").items()) {
        Camera camera;
        camera.name = name;
        const auto entry = [&](const char* key) -> const json& {
            return member(member(cameras, key, file, ""), name, file, std::string(key) + ".");
        };
        const std::vector<double> focal = jsonNumbers(entry("focal"), 2, file, "focal." + name);
        const std::vector<double> principal = jsonNumbers(entry("princpt"), 2, file, "princpt." + name);
        camera.intrinsics << focal[0], 0, principal[0], 0, focal[1], principal[1], 0, 0, 1;
        camera.cameraFromWorld.rotation = jsonMatrix(entry("camrot"), file, "camrot." + name);
        // x_cam = R (X - position)
        camera.cameraFromWorld.translation =
            -(camera.cameraFromWorld.rotation * jsonVector(position, file, "campos." + name));
        result.push_back(camera);
    }
    return result;
}

bool looksLikeHanCo(const CalibrationSource& source) {
    return source.hasExtension({".json"}) && source.json().is_object() && source.json().contains("K") &&
           source.json().contains("M");
}

std::vector<Camera> readHanCo(const CalibrationSource& source, const CalibrationOptions&) {
    const std::string file = source.path().string();
    const json& document = source.json();
    const json& intrinsics = member(document, "K", file, "");
    const json& poses = member(document, "M", file, "");
    if (!intrinsics.is_array() || !poses.is_array() || intrinsics.size() != poses.size())
        throw Error(ErrorCode::BadInput, file, "M", "as many poses as intrinsic matrices are expected");
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < intrinsics.size(); ++i) {
        const std::string index = "[" + std::to_string(i) + "]";
        Camera camera;
        camera.name = "cam" + std::to_string(i);
        camera.intrinsics = jsonMatrix(intrinsics[i], file, "K" + index);
        if (!poses[i].is_array() || poses[i].size() < 3)
            throw Error(ErrorCode::BadInput, file, "M" + index, "four rows of four numbers are expected");
        for (int row = 0; row < 3; ++row) {
            const std::vector<double> values =
                jsonNumbers(poses[i][static_cast<std::size_t>(row)], 4, file, "M" + index);
            camera.cameraFromWorld.rotation.row(row) << values[0], values[1], values[2];
            camera.cameraFromWorld.translation[row] = values[3];
        }
        cameras.push_back(camera);
    }
    return cameras;
}

Eigen::Matrix3d rowMajorMatrix(const std::vector<double>& numbers, const std::string& file, const std::string& field) {
    if (numbers.size() != 9) {
        throw Error(ErrorCode::BadInput, file, field,
                    "nine numbers are expected, not " + std::to_string(numbers.size()));
    }
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
}

Eigen::Vector3d vectorOf(const std::vector<double>& numbers, const std::string& file, const std::string& field) {
    if (numbers.size() != 3) {
        throw Error(ErrorCode::BadInput, file, field,
                    "three numbers are expected, not " + std::to_string(numbers.size()));
    }
    return {numbers[0], numbers[1], numbers[2]};
}

Eigen::Matrix3d rotationOf(const std::vector<double>& numbers, const std::string& file, const std::string& field) {
    return numbers.size() == 3 ? rotationExp(vectorOf(numbers, file, field)) : rowMajorMatrix(numbers, file, field);
}

} // namespace core
