// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/matlab/mat_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// Looks up a variable of a file or a member of a structure.
using MatLookup = std::function<MatValue(const char*)>;

/// All numbers of a matrix, column by column, as MATLAB keeps them.
std::vector<double> columnNumbers(const MatValue& value) {
    std::vector<double> numbers = value.numbers().values;
    if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
        value.refuse("holds a number that is not finite");
    return numbers;
}

/// `place` stands before the members' names in errors.
Camera matlabCamera(const MatLookup& find, const std::string& name, const std::string& place) {
    const auto read = [&](const char* member) { return columnNumbers(find(member)); };
    Camera camera;
    // MATLAB multiplies from the left (x K, X r + t), so both are stored transposed; kept column by column, they read
    // as wanted row by row. K(0, 1) is the skew.
    camera.intrinsics = rowMajorMatrix(read("K"), name, place + "K");
    camera.intrinsics(0, 2) -= 1; // its first pixel is 1
    camera.intrinsics(1, 2) -= 1;
    camera.cameraFromWorld.rotation = rowMajorMatrix(read("r"), name, place + "r");
    camera.cameraFromWorld.translation = vectorOf(read("t"), name, place + "t");
    const std::vector<double> radial = read("RDistort"), tangential = read("TDistort");
    if ((radial.size() != 2 && radial.size() != 3) || tangential.size() != 2) {
        throw Error(ErrorCode::BadInput, name, place + "RDistort",
                    "two or three radial and two tangential coefficients are expected");
    }
    camera.distortion = {radial[0], radial[1], tangential[0], tangential[1], radial.size() == 3 ? radial[2] : 0};
    return camera;
}

/// Names of the cameras, if the file has as many as it has cameras; empty if it has none.
std::vector<std::string> namesIn(const MatFile& file, std::size_t count) {
    for (const char* variable : {"camnames", "camNames"}) {
        const MatValue names = file.read(variable);
        if (names.isMissing() || names.count() == 0)
            continue;
        std::vector<std::string> list = names.texts();
        if (list.size() != count)
            names.refuse("as many names as cameras are expected");
        return list;
    }
    return {};
}

/// Image sizes, one per camera: `imageSize` (rows, columns) of some versions of Label3D, or those of the pictures that
/// it keeps in `videos` (rows x columns x colours x frames). Empty if the file holds neither.
std::vector<ImageSize> sizesIn(const MatFile& file, std::size_t count) {
    constexpr double kMost = 1 << 20;
    const auto sizeOf = [&](double rows, double columns) {
        const bool isSize = rows >= 1 && columns >= 1 && rows < kMost && columns < kMost;
        return isSize ? ImageSize{static_cast<int>(columns), static_cast<int>(rows)} : ImageSize{};
    };
    std::vector<ImageSize> sizes;
    if (const MatValue stored = file.read("imageSize"); !stored.isMissing()) {
        const MatNumbers numbers = stored.numbers();
        const std::size_t rows = numbers.values.size() == 2 ? 1 : numbers.size(0);
        if (numbers.values.size() != 2 * rows || (rows != 1 && rows != count))
            stored.refuse("rows and columns of the images are expected, once or for every camera");
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t row = rows == 1 ? 0 : i;
            sizes.push_back(sizeOf(numbers.values[row], numbers.values[row + rows]));
        }
        return sizes;
    }
    const MatValue videos = file.readShape("videos");
    if (!videos.isCell() || videos.count() != count)
        return {};
    for (std::size_t i = 0; i < count; ++i) {
        const MatValue video = videos.element(i);
        sizes.push_back(video.count() > 0
                            ? sizeOf(static_cast<double>(video.size(0)), static_cast<double>(video.size(1)))
                            : ImageSize{});
    }
    return sizes;
}

/// `list`: a structure per camera, in a cell or an array of structures, that DANNCE calls params and Label3D camParams.
std::vector<Camera> camerasOfProject(const MatFile& file, const MatValue& list, const std::string& listName) {
    if (!list.isCell() && !list.isStructure())
        list.refuse("a cell with a struct per camera is expected");
    const std::vector<std::string> names = namesIn(file, list.count());
    const std::vector<ImageSize> sizes = sizesIn(file, list.count());
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < list.count(); ++i) {
        const MatValue camera = list.element(i);
        const std::string number = std::to_string(i + 1);
        const std::string place = listName + (list.isCell() ? "{" + number + "}" : "(" + number + ")") + ".";
        cameras.push_back(matlabCamera([&](const char* member) { return camera.member(member); }, file.name(), place));
        cameras.back().name = names.empty() || names[i].empty() ? "Camera" + number : names[i];
        if (!sizes.empty())
            cameras.back().size = sizes[i];
    }
    return cameras;
}

Camera cameraOfFile(const MatFile& file, const fs::path& path) {
    Camera camera = matlabCamera([&](const char* variable) { return file.read(variable); }, path.string(), "");
    camera.name = path.stem().string();
    if (camera.name.ends_with("_params"))
        camera.name.resize(camera.name.size() - 7);
    return camera;
}

std::vector<Camera> camerasOfMat(const fs::path& path) {
    const MatFile file(path);
    for (const char* listName : {"params", "camParams"}) {
        const MatValue list = file.read(listName);
        if (!list.isMissing())
            return camerasOfProject(file, list, listName);
    }
    if (file.read("K").isMissing() && file.read("r").isMissing())
        file.refuse("params",
                    "is missing: cameras are expected in params (DANNCE), camParams (Label3D), or K, r and t");
    return {cameraOfFile(file, path)};
}

} // namespace

bool looksLikeDannce(const CalibrationSource& source) {
    return source.hasExtension({".mat"}) || (source.isFolder() && !calibrationFiles(source.path(), {".mat"}).empty());
}

std::vector<Camera> readDannce(const CalibrationSource& source, const CalibrationOptions&) {
    std::vector<Camera> cameras;
    for (const fs::path& file : calibrationFiles(source.path(), {".mat"})) {
        const std::vector<Camera> some = camerasOfMat(file);
        cameras.insert(cameras.end(), some.begin(), some.end());
    }
    return cameras;
}

} // namespace core
