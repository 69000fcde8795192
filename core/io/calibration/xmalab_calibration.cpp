// SPDX-License-Identifier: MIT
#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFirstSection = "image size";

/// The next `count` lines, each with numbers between commas.
std::vector<double> sectionNumbers(LineReader& lines, std::string_view title, int count) {
    if (lines.next(title) != title)
        throw lines.errorHere("\"" + std::string(title) + "\" is expected");
    std::vector<double> numbers;
    for (int i = 0; i < count; ++i) {
        for (const std::string_view word : splitWords(lines.next(title), true)) {
            numbers.emplace_back();
            if (!parseNumber(word, numbers.back()))
                throw lines.errorHere("'" + std::string(word.substr(0, 40)) + "' is not a finite number");
        }
    }
    return numbers;
}

Camera readMayaCam(const fs::path& path) {
    const std::string file = path.string();
    LineReader lines(path);
    const std::vector<double> size = sectionNumbers(lines, kFirstSection, 1);
    if (size.size() != 2 || size[0] < 1 || size[1] < 1 || size[0] > 1e5 || size[1] > 1e5)
        throw lines.errorHere("width and height are expected");
    Camera camera;
    camera.name = path.stem().string();
    camera.size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    camera.intrinsics = rowMajorMatrix(sectionNumbers(lines, "camera matrix", 3), file, "camera matrix");
    camera.cameraFromWorld.rotation = rowMajorMatrix(sectionNumbers(lines, "rotation", 3), file, "rotation");
    camera.cameraFromWorld.translation = vectorOf(sectionNumbers(lines, "translation", 3), file, "translation");
    if (!lines.atEnd()) {
        throw Error(ErrorCode::Unsupported, file, std::string(lines.next("a section").substr(0, 40)),
                    "is a section that is not read: export cameras of undistorted images");
    }
    return camera;
}

} // namespace

bool looksLikeXmaLab(const CalibrationSource& source) {
    if (!source.isFolder())
        return source.hasExtension({".txt"}) && source.text().starts_with(kFirstSection);
    const std::vector<fs::path> files = calibrationFiles(source.path(), {".txt"});
    return !files.empty() && readTextFile(files.front()).starts_with(kFirstSection);
}

std::vector<Camera> readXmaLab(const CalibrationSource& source, const CalibrationOptions&) {
    std::vector<Camera> cameras;
    for (const fs::path& file : calibrationFiles(source.path(), {".txt"}))
        cameras.push_back(readMayaCam(file));
    return cameras;
}

} // namespace core
