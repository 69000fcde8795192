// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// A camera's two files.
struct FilePair {
    std::string camera;
    fs::path intrinsics, pose;
};

/// c0.dat with rot_trans_c0.dat, or camera0_intrinsics.dat with camera0_rot_trans.dat.
std::vector<FilePair> pairsOf(const fs::path& folder) {
    constexpr std::string_view kIntrinsics = "_intrinsics";
    std::vector<FilePair> pairs;
    for (const fs::path& file : calibrationFiles(folder, {".dat"})) {
        std::string camera = file.stem().string();
        fs::path pose = folder / ("rot_trans_" + file.filename().string());
        if (camera.ends_with(kIntrinsics)) {
            camera.resize(camera.size() - kIntrinsics.size());
            pose = folder / (camera + "_rot_trans.dat");
        }
        std::error_code ignored;
        if (fs::is_regular_file(pose, ignored))
            pairs.push_back({camera, file, pose});
    }
    return pairs;
}

fs::path folderOf(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) ? path : path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The first block of numbers after a line that reads `title`; what follows (another block of the same title, comments)
/// is not looked at.
std::vector<std::vector<double>> block(const fs::path& file, std::string_view title, std::size_t rows) {
    LineReader reader(file);
    while (true) {
        if (reader.atEnd())
            throw Error(ErrorCode::BadInput, file.string(), std::string(title), "is missing");
        if (reader.next(title) == std::string(title) + ":")
            break;
    }
    std::vector<std::vector<double>> values;
    while (values.size() < rows) {
        const std::string_view line = reader.next(title);
        std::vector<double> row;
        for (const std::string_view word : splitWords(line)) {
            row.emplace_back();
            if (!parseNumber(word, row.back()))
                throw reader.errorHere("'" + std::string(word.substr(0, 40)) + "' is not a finite number");
        }
        values.push_back(row);
    }
    return values;
}

Eigen::Matrix3d matrixOf(const fs::path& file, const std::string& title) {
    std::vector<double> all;
    for (const std::vector<double>& row : block(file, title, 3))
        all.insert(all.end(), row.begin(), row.end());
    return rowMajorMatrix(all, file.string(), title);
}

} // namespace

bool looksLikeHandpose3d(const CalibrationSource& source) {
    return (source.isFolder() || source.hasExtension({".dat"})) && !pairsOf(folderOf(source.path())).empty();
}

std::vector<Camera> readHandpose3d(const CalibrationSource& source, const CalibrationOptions&) {
    const fs::path& path = source.path();
    const std::vector<FilePair> pairs = pairsOf(folderOf(path));
    if (pairs.empty()) {
        throw Error(ErrorCode::NotFound, path.string(), "",
                    "no pair of files such as c0.dat and rot_trans_c0.dat is there");
    }
    std::vector<Camera> cameras;
    for (const FilePair& pair : pairs) {
        Camera camera;
        camera.name = pair.camera;
        camera.intrinsics = matrixOf(pair.intrinsics, "intrinsic");
        camera.distortion = block(pair.intrinsics, "distortion", 1).front();
        camera.cameraFromWorld.rotation = matrixOf(pair.pose, "R");
        std::vector<double> translation;
        for (const std::vector<double>& row : block(pair.pose, "T", 3))
            translation.insert(translation.end(), row.begin(), row.end());
        camera.cameraFromWorld.translation = vectorOf(translation, pair.pose.string(), "T");
        cameras.push_back(camera);
    }
    return cameras;
}

} // namespace core
