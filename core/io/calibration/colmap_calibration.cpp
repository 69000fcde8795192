// SPDX-License-Identifier: MIT
#include <map>
#include <set>
#include <sstream>

#include <Eigen/Geometry>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// Which parameters a camera model has: f or fx fy, cx cy, and then lens coefficients at these places of ours.
struct ColmapModel {
    std::size_t focalLengths;
    std::vector<std::size_t> lens;
    bool fisheye = false;
};

const std::map<std::string, ColmapModel, std::less<>>& colmapModels() {
    static const std::map<std::string, ColmapModel, std::less<>> models{
        {"SIMPLE_PINHOLE", {1, {}}},
        {"PINHOLE", {2, {}}},
        {"SIMPLE_RADIAL", {1, {0}}},
        {"RADIAL", {1, {0, 1}}},
        {"OPENCV", {2, {0, 1, 2, 3}}},
        {"FULL_OPENCV", {2, {0, 1, 2, 3, 4, 5, 6, 7}}},
        {"SIMPLE_RADIAL_FISHEYE", {1, {0}, true}},
        {"RADIAL_FISHEYE", {1, {0, 1}, true}},
        {"OPENCV_FISHEYE", {2, {0, 1, 2, 3}, true}},
    };
    return models;
}

/// Lines of a model's text file; comments are left out, empty lines stay (a picture without points has one).
std::vector<std::string> dataLines(const fs::path& file) {
    std::istringstream text(readTextFile(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        if (!line.starts_with('#'))
            lines.push_back(line);
    return lines;
}

std::vector<double> numbersIn(const std::vector<std::string_view>& words, std::size_t from, std::size_t to,
                              const fs::path& file, const std::string& field) {
    std::vector<double> numbers;
    for (std::size_t i = from; i < to; ++i) {
        numbers.emplace_back();
        if (i >= words.size() || !parseNumber(words[i], numbers.back()))
            throw Error(ErrorCode::BadInput, file.string(), field, "finite numbers are expected");
    }
    return numbers;
}

/// CAMERA_ID MODEL WIDTH HEIGHT PARAMS...
Camera lensOf(const std::vector<std::string_view>& words, const fs::path& file) {
    const std::string field = "camera " + std::string(words[0]);
    const auto model = words.size() > 1 ? colmapModels().find(words[1]) : colmapModels().end();
    if (model == colmapModels().end()) {
        throw Error(ErrorCode::Unsupported, file.string(), field,
                    "its model " + std::string(words.size() > 1 ? words[1] : "") + " is not known");
    }
    const auto& [focalLengths, lens, fisheye] = model->second;
    const std::vector<double> size = numbersIn(words, 2, 4, file, field);
    const std::vector<double> numbers = numbersIn(words, 4, 4 + focalLengths + 2 + lens.size(), file, field);
    Camera camera;
    camera.size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    // Its pixels begin at 0, so that the centre of the first one is 0.5.
    camera.intrinsics << numbers[0], 0, numbers[focalLengths] - 0.5, 0, numbers[focalLengths - 1],
        numbers[focalLengths + 1] - 0.5, 0, 0, 1;
    camera.fisheye = fisheye;
    if (!lens.empty())
        camera.distortion.resize(lens.size() > 4 ? 8 : 4, 0);
    for (std::size_t i = 0; i < lens.size(); ++i)
        camera.distortion[lens[i]] = numbers[focalLengths + 2 + i];
    return camera;
}

} // namespace

std::vector<std::string> cameraNamesOfImages(const std::vector<std::string>& images, const std::string& file) {
    std::vector<std::string> stems, folders;
    for (const std::string& image : images) {
        stems.push_back(fs::path(image).stem().string());
        folders.push_back(fs::path(image).parent_path().filename().string());
    }
    const auto areDistinct = [](const std::vector<std::string>& names) {
        return std::set<std::string>(names.begin(), names.end()).size() == names.size();
    };
    if (areDistinct(stems))
        return stems;
    if (!areDistinct(folders)) {
        throw Error(ErrorCode::Unsupported, file, "",
                    "holds several images of a camera; one image per camera, in a folder of its own or with a name "
                    "of its own, is expected");
    }
    return folders;
}

bool looksLikeColmap(const CalibrationSource& source) {
    const fs::path folder = source.isFolder() ? source.path() : source.path().parent_path();
    return (source.isFolder() || source.hasExtension({".txt"})) && fs::exists(folder / "cameras.txt") &&
           fs::exists(folder / "images.txt");
}

std::vector<Camera> readColmap(const CalibrationSource& source, const CalibrationOptions&) {
    const fs::path folder = source.isFolder() ? source.path() : source.path().parent_path();
    const fs::path cameraFile = folder / "cameras.txt", imageFile = folder / "images.txt";
    std::map<std::string, Camera, std::less<>> lenses;
    for (const std::string& line : dataLines(cameraFile))
        if (const auto words = splitWords(line); !words.empty())
            lenses.emplace(words[0], lensOf(words, cameraFile));
    std::vector<Camera> cameras;
    std::vector<std::string> images;
    const std::vector<std::string> lines = dataLines(imageFile);
    // IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then a line of points that is not needed.
    for (std::size_t i = 0; i < lines.size(); i += 2) {
        const auto words = splitWords(lines[i]);
        if (words.empty())
            continue;
        const std::string field = "image " + std::string(words[0]);
        const std::vector<double> pose = numbersIn(words, 1, 8, imageFile, field);
        const auto lens = words.size() >= 10 ? lenses.find(words[8]) : lenses.end();
        if (lens == lenses.end())
            throw Error(ErrorCode::BadInput, imageFile.string(), field, "its camera or its name is missing");
        const Eigen::Quaterniond rotation(pose[0], pose[1], pose[2], pose[3]);
        if (!(rotation.norm() > 0.5))
            throw Error(ErrorCode::BadInput, imageFile.string(), field, "its quaternion is not a rotation");
        Camera camera = lens->second;
        camera.cameraFromWorld = {rotation.normalized().toRotationMatrix(), {pose[4], pose[5], pose[6]}};
        cameras.push_back(camera);
        images.emplace_back(words[9]);
    }
    const std::vector<std::string> names = cameraNamesOfImages(images, imageFile.string());
    for (std::size_t i = 0; i < cameras.size(); ++i)
        cameras[i].name = names[i];
    return cameras;
}

} // namespace core
