// SPDX-License-Identifier: MIT
#include "core/io/derived/calibration_files.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/dataset_paths.h"

namespace core {

namespace fs = std::filesystem;

namespace {

const std::string kRefined = "-refined-";

/// Refinements of refinements are counted on: "cameras" of "cameras-refined-3.json".
std::string plainStem(const fs::path& file) {
    const std::string stem = file.stem().string();
    const std::size_t at = stem.rfind(kRefined);
    const bool isNumbered = at != std::string::npos && at + kRefined.size() < stem.size() &&
                            stem.find_first_not_of("0123456789", at + kRefined.size()) == std::string::npos;
    return isNumbered ? stem.substr(0, at) : stem;
}

bool areSameCameras(const std::vector<Camera>& a, const std::vector<Camera>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const Camera& one, const Camera& other) {
            return one.name == other.name && one.size.width == other.size.width && one.size.height == other.size.height;
        });
}

bool isCalibrationOf(const Dataset& dataset, const fs::path& file) {
    try {
        return areSameCameras(readCameras(file), dataset.cameras);
    } catch (const Error&) { // another JSON file, or one of a newer version
        return false;
    }
}

void checkSameCameras(const Dataset& dataset, const std::vector<Camera>& cameras, const std::string& file) {
    if (!areSameCameras(cameras, dataset.cameras))
        throw Error(ErrorCode::BadInput, file, "cameras",
                    "must be the dataset's cameras: the same names in the same order, and the same picture sizes");
}

} // namespace

std::vector<std::string> calibrationFiles(const Dataset& dataset) {
    const fs::path parent = fs::path(dataset.camerasFile).parent_path();
    std::set<std::string> files{dataset.camerasFile};
    std::error_code failure;
    for (fs::directory_iterator at(dataset.folder / parent, failure), end; !failure && at != end;
         at.increment(failure)) {
        const std::string file = (parent / at->path().filename()).string();
        if (at->path().extension() == ".json" && at->path().filename() != "dataset.json" &&
            isCalibrationOf(dataset, at->path()))
            files.insert(file);
    }
    return {files.begin(), files.end()};
}

Dataset addCalibration(const fs::path& folder, const std::vector<Camera>& cameras) {
    Dataset dataset = readDataset(folder);
    const fs::path inUse = dataset.camerasFile;
    checkSameCameras(dataset, cameras, dataset.camerasFile);
    int number = 1;
    fs::path file;
    do {
        file = inUse.parent_path() / (plainStem(inUse) + kRefined + std::to_string(number++) + ".json");
    } while (fs::exists(folder / file));
    writeCameras(folder / file, cameras);
    try {
        dataset.camerasFile = file.string();
        rewriteDatasetFile(dataset);
    } catch (...) {
        std::error_code ignored;
        fs::remove(folder / file, ignored);
        throw;
    }
    return readDataset(folder);
}

Dataset useCalibration(const fs::path& folder, const std::string& file) {
    Dataset dataset = readDataset(folder);
    const std::vector<Camera> cameras = readCameras(pathInside(folder, file, "cameras"));
    checkSameCameras(dataset, cameras, file);
    dataset.cameras = cameras;
    dataset.camerasFile = file;
    rewriteDatasetFile(dataset);
    return dataset;
}

} // namespace core
