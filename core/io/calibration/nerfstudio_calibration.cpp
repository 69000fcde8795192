// SPDX-License-Identifier: MIT
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;

namespace {

/// A frame of transforms.json: its own members come before those of the document.
struct NerfFrame {
    const json& document;
    const json& frame;
    const std::string& file;
    std::string field;

    const json* find(const char* key) const {
        return frame.contains(key) ? &frame[key] : document.contains(key) ? &document[key] : nullptr;
    }
    double number(const char* key) const {
        const json* value = find(key);
        if (value == nullptr || !value->is_number())
            throw Error(ErrorCode::BadInput, file, field + "." + key, "a number is expected");
        return value->get<double>();
    }
    double numberOr0(const char* key) const { return find(key) == nullptr ? 0 : number(key); }
};

void readLens(Camera& camera, const NerfFrame& frame) {
    const json* named = frame.find("camera_model");
    const std::string model = named != nullptr && named->is_string() ? named->get<std::string>() : "OPENCV";
    const double k1 = frame.numberOr0("k1"), k2 = frame.numberOr0("k2"), k3 = frame.numberOr0("k3");
    const double k4 = frame.numberOr0("k4");
    if (model == "OPENCV_FISHEYE") {
        camera.fisheye = true;
        camera.distortion = {k1, k2, k3, k4};
    } else if (model == "OPENCV" || model == "PINHOLE" || model == "SIMPLE_PINHOLE") {
        if (k4 != 0) {
            throw Error(ErrorCode::Unsupported, frame.file, frame.field + ".k4",
                        "is a coefficient of r^8, which OpenCV's lens model does not have");
        }
        camera.distortion = {k1, k2, frame.numberOr0("p1"), frame.numberOr0("p2"), k3};
    } else {
        throw Error(ErrorCode::Unsupported, frame.file, frame.field + ".camera_model", model + " is not known");
    }
}

Camera cameraOfFrame(const NerfFrame& frame) {
    Camera camera;
    if (frame.find("w") != nullptr && frame.find("h") != nullptr) {
        const double width = frame.number("w"), height = frame.number("h");
        if (!(width >= 1 && width <= 1e5 && height >= 1 && height <= 1e5))
            throw Error(ErrorCode::BadInput, frame.file, frame.field + ".w", "the image size is not sensible");
        camera.size = {static_cast<int>(width), static_cast<int>(height)};
    }
    // Pixels begin at 0, so that the centre of the first one is 0.5.
    camera.intrinsics << frame.number("fl_x"), 0, frame.number("cx") - 0.5, 0, frame.number("fl_y"),
        frame.number("cy") - 0.5, 0, 0, 1;
    readLens(camera, frame);
    const json& rows = frame.frame["transform_matrix"];
    const std::string field = frame.field + ".transform_matrix";
    if (!rows.is_array() || rows.size() < 3)
        throw Error(ErrorCode::BadInput, frame.file, field, "four rows of four numbers are expected");
    RigidMotion worldFromCamera;
    for (int row = 0; row < 3; ++row) {
        const std::vector<double> v = jsonNumbers(rows[static_cast<std::size_t>(row)], 4, frame.file, field);
        // OpenGL's camera looks along -z with y up.
        worldFromCamera.rotation.row(row) << v[0], -v[1], -v[2];
        worldFromCamera.translation[row] = v[3];
    }
    camera.cameraFromWorld.rotation = worldFromCamera.rotation.transpose();
    camera.cameraFromWorld.translation = -(camera.cameraFromWorld.rotation * worldFromCamera.translation);
    return camera;
}

} // namespace

bool looksLikeNerfstudio(const CalibrationSource& source) {
    if (!source.hasExtension({".json"}) || !source.json().is_object() || !source.json().contains("frames"))
        return false;
    const json& frames = source.json()["frames"];
    return frames.is_array() && !frames.empty() && frames[0].is_object() && frames[0].contains("transform_matrix");
}

std::vector<Camera> readNerfstudio(const CalibrationSource& source, const CalibrationOptions&) {
    const std::string file = source.path().string();
    if (!looksLikeNerfstudio(source))
        throw Error(ErrorCode::BadInput, file, "frames", "a list with a transform_matrix each is expected");
    const json& frames = source.json()["frames"];
    std::vector<Camera> cameras;
    std::vector<std::string> images;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::string field = "frames[" + std::to_string(i) + "]";
        for (const char* key : {"transform_matrix", "file_path"})
            if (!frames[i].is_object() || !frames[i].contains(key))
                throw Error(ErrorCode::BadInput, file, field + "." + key, "is missing");
        if (!frames[i]["file_path"].is_string())
            throw Error(ErrorCode::BadInput, file, field + ".file_path", "a text is expected");
        images.push_back(frames[i]["file_path"].get<std::string>());
        cameras.push_back(cameraOfFrame({source.json(), frames[i], file, field}));
    }
    const std::vector<std::string> names = cameraNamesOfImages(images, file);
    for (std::size_t i = 0; i < cameras.size(); ++i)
        cameras[i].name = names[i];
    return cameras;
}

} // namespace core
