// SPDX-License-Identifier: MIT
#include "core/io/calibration/calibration.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/calibration/tzionas_cameras.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

const CalibrationKind& kindNamed(std::string_view name) {
    for (const CalibrationKind& kind : calibrationKinds())
        if (kind.name == name)
            return kind;
    throw Error(ErrorCode::Usage, "", "kind", "\"" + std::string(name) + "\" is not a known kind of calibration");
}

Error unknownKind(const fs::path& path) {
    return Error(ErrorCode::Unsupported, path.string(), "",
                 "is not a calibration of a known kind (if it is one, say which with --from)");
}

std::string sniffJson(const fs::path& file) {
    const nlohmann::json value = readJsonFile(file);
    if (value.is_object()) {
        const nlohmann::json& inner = !value.empty() && value.begin()->is_object() ? *value.begin() : value;
        if (value.contains("format"))
            return "handlens";
        if (value.contains("campos") || inner.contains("campos"))
            return "interhand";
        if (value.contains("K") && value.contains("M"))
            return "hanco";
        if (value.contains("camera_matrix") || value.contains("cameras"))
            return "opencv";
    }
    throw unknownKind(file);
}

std::string sniffYaml(const fs::path& file) {
    const std::string text = readTextFile(file);
    const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
    if (has("intrinsicMatrix"))
        return "jarvis";
    if (has("camera_matrix"))
        return "opencv";
    if (has("names:") && (has("K_") || has("R_")))
        return "easymocap";
    throw unknownKind(file);
}

std::string sniffFolder(const fs::path& folder) {
    if (fs::exists(folder / "intri.yml"))
        return "easymocap";
    if (!calibrationFiles(folder, {".mat"}).empty())
        return "dannce";
    if (isHandpose3d(folder))
        return "handpose3d";
    const std::vector<fs::path> files = calibrationFiles(folder, {".yml", ".yaml", ".xml"});
    if (files.empty())
        throw unknownKind(folder);
    return sniffYaml(files.front());
}

std::string lowerExtension(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::vector<Camera> readKind(const fs::path& path, const std::string& kind, const CalibrationOptions& options) {
    if (kind == "handlens")
        return readCameras(path);
    if (kind == "anipose")
        return readAnipose(path);
    if (kind == "opencv")
        return readOpenCv(path);
    if (kind == "easymocap")
        return readEasyMocap(path);
    if (kind == "jarvis")
        return readJarvis(path);
    if (kind == "dannce")
        return readDannce(path);
    if (kind == "interhand")
        return readInterHand(path, options.section);
    if (kind == "hanco")
        return readHanCo(path);
    if (kind == "handpose3d")
        return readHandpose3d(path);
    return readTzionasCameras(path, options.size);
}

/// Rotations that were written with few digits are made orthonormal; other matrices are left for checkCameras to
/// refuse.
void tidyRotation(Camera& camera) {
    const Eigen::Matrix3d& rotation = camera.cameraFromWorld.rotation;
    if (!isRotation(rotation, 1e-9))
        camera.cameraFromWorld.rotation = nearestRotation(rotation, 1e-2).value_or(rotation);
}

/// Trailing zeros of longer lens models, and lists of an unusual length that zeros complete, are brought to 0, 4, 5
/// or 8.
void tidyLens(Camera& camera) {
    std::vector<double>& lens = camera.distortion;
    const auto trimTo = [&](std::size_t count) {
        if (lens.size() > count &&
            std::all_of(lens.begin() + static_cast<std::ptrdiff_t>(count), lens.end(), [](double d) { return d == 0; }))
            lens.resize(count);
    };
    if (camera.fisheye) {
        trimTo(4);
        return;
    }
    trimTo(8);
    if (!lens.empty() && lens.size() < 4)
        lens.resize(4, 0);
    else if (lens.size() == 6 || lens.size() == 7)
        lens.resize(8, 0);
}

} // namespace

const std::vector<CalibrationKind>& calibrationKinds() {
    static const std::vector<CalibrationKind> kinds{
        {"handlens", "cameras.json of a dataset", 1, true},
        {"anipose", "calibration.toml of Anipose", 1, true},
        {"opencv", "OpenCV YAML, XML or JSON, all cameras in one file or a folder of files", 1, true},
        {"easymocap", "EasyMocap's intri.yml and extri.yml (usually in metres)", 1000, false},
        {"jarvis", "a folder of JARVIS YAML files", 1, false},
        {"dannce", "a folder of DANNCE's *_params.mat", 1, false},
        {"interhand", "InterHand2.6M camera JSON", 1, false},
        {"hanco", "HanCo calibration JSON (in metres)", 1000, false},
        {"handpose3d",
         "a folder of handpose3d's c0.dat and rot_trans_c0.dat (the unit is not said; usually centimetres)", 10, false},
        {"tzionas", "Cameras.txt of the method's authors", 1, false}};
    return kinds;
}

std::string sniffCalibration(const fs::path& path) {
    if (fs::is_directory(path))
        return sniffFolder(path);
    const std::string extension = lowerExtension(path);
    if (extension == ".toml")
        return "anipose";
    if (extension == ".json")
        return sniffJson(path);
    if (extension == ".yml" || extension == ".yaml" || extension == ".xml")
        return sniffYaml(path);
    if (extension == ".mat")
        return "dannce";
    if (extension == ".txt")
        return "tzionas";
    if (extension == ".dat" && isHandpose3d(path))
        return "handpose3d";
    throw unknownKind(path);
}

std::vector<Camera> readCalibration(const fs::path& path, const CalibrationOptions& options) {
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw Error(ErrorCode::NotFound, path.string(), "", "no such file or folder");
    const std::string kind = options.kind.empty() ? sniffCalibration(path) : options.kind;
    const double mmPerUnit = options.mmPerUnit.value_or(kindNamed(kind).mmPerUnit);
    std::vector<Camera> cameras = readKind(path, kind, options);
    if (cameras.empty())
        throw Error(ErrorCode::BadInput, path.string(), "", "holds no cameras");
    for (Camera& camera : cameras) {
        if (camera.size == ImageSize{}) {
            if (!options.size) {
                throw Error(ErrorCode::BadInput, path.string(), camera.name + ".size",
                            "such files hold no image size; give --size WxH");
            }
            camera.size = *options.size;
        }
        camera.cameraFromWorld.translation *= mmPerUnit;
        tidyRotation(camera);
        tidyLens(camera);
    }
    std::stable_sort(cameras.begin(), cameras.end(),
                     [](const Camera& a, const Camera& b) { return naturalLess(a.name, b.name); });
    checkCameras(cameras, path.string());
    return cameras;
}

void writeCalibration(const fs::path& file, std::string_view kind, const std::vector<Camera>& cameras) {
    checkCameras(cameras, file.string());
    if (kind == "handlens")
        writeCameras(file, cameras);
    else if (kind == "anipose")
        writeFileAtomically(file, formatAnipose(cameras));
    else if (kind == "opencv")
        writeFileAtomically(file, formatOpenCv(cameras, lowerExtension(file)));
    else
        throw Error(ErrorCode::Usage, "", "--to", "\"" + std::string(kind) + "\" cannot be written");
}

std::vector<fs::path> calibrationFiles(const fs::path& path, const std::vector<std::string>& extensions) {
    if (!fs::is_directory(path))
        return {path};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
        if (entry.is_regular_file() &&
            std::find(extensions.begin(), extensions.end(), lowerExtension(entry.path())) != extensions.end())
            files.push_back(entry.path());
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return naturalLess(a.filename().string(), b.filename().string());
    });
    return files;
}

bool naturalLess(std::string_view a, std::string_view b) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (isDigit(a[i]) && isDigit(b[j])) {
            const std::size_t endA = std::min(a.find_first_not_of("0123456789", i), a.size());
            const std::size_t endB = std::min(b.find_first_not_of("0123456789", j), b.size());
            std::string_view numberA = a.substr(i, endA - i), numberB = b.substr(j, endB - j);
            numberA.remove_prefix(std::min(numberA.find_first_not_of('0'), numberA.size()));
            numberB.remove_prefix(std::min(numberB.find_first_not_of('0'), numberB.size()));
            if (numberA != numberB)
                return numberA.size() != numberB.size() ? numberA.size() < numberB.size() : numberA < numberB;
            i = endA;
            j = endB;
        } else if (a[i] != b[j]) {
            return a[i] < b[j];
        } else {
            ++i;
            ++j;
        }
    }
    return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

} // namespace core
