// SPDX-License-Identifier: MIT
#include "core/io/detector/detector_files.h"

#include <cstdlib>
#include <map>

#include "core/error.h"
#include "core/io/detector/package_archive.h"
#include "core/io/detector/package_text.h"
#include "core/io/detector/tflite_file.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

const std::string kPalmFile = "palm_detection_full.tflite";
const std::string kLandmarkFile = "hand_landmark_full.tflite";
const std::string kAssets = "hands_solution_packed_assets.data";
const std::string kAssetsLoader = "hands_solution_packed_assets_loader.js";
const std::string kManifest = "package.json";
const std::string kSource = "source.txt"; ///< what they were installed from

bool isDetectorFile(const std::string& name) {
    return name == kLandmarkFile || name == kAssets || name == kAssetsLoader || name == kManifest;
}

/// A file of the package, as messages name it.
std::string within(const fs::path& package, const std::string& name) {
    return (package / name).string();
}

const std::string& packageFile(const std::map<std::string, std::string>& files, const fs::path& package,
                               const std::string& name) {
    const auto found = files.find(name);
    if (found == files.end())
        throw Error(ErrorCode::NotFound, within(package, name), "", "is not in the package: " + howToGetDetector());
    return found->second;
}

/// One of the files that are packed into another one, at the offsets that the loader says.
std::string packedFile(const std::map<std::string, std::string>& files, const fs::path& package,
                       const std::string& wanted) {
    const std::string& assets = packageFile(files, package, kAssets);
    const PackedRange range = packedRange(packageFile(files, package, kAssetsLoader), within(package, kAssetsLoader),
                                          wanted, assets.size(), kAssets);
    return assets.substr(range.begin, range.end - range.begin);
}

std::string titleOf(const std::map<std::string, std::string>& files, const fs::path& package) {
    const auto found = files.find(kManifest);
    return found == files.end() ? "a package without " + kManifest
                                : packageTitle(found->second, within(package, kManifest));
}

DetectorNetworks parseNetworks(std::string_view palms, const std::string& palmFile, std::string_view landmarks,
                               const std::string& landmarkFile) {
    DetectorNetworks networks{parseTflite(palms, palmFile), parseTflite(landmarks, landmarkFile)};
    checkPalmNetwork(networks.palms, palmFile);
    checkLandmarkNetwork(networks.landmarks, landmarkFile);
    return networks;
}

} // namespace

std::string howToGetDetector() {
    return "get the hand detector with \"npm pack @mediapipe/hands\" (11 MB, Apache-2.0) and run \"handlens-batch "
           "detector install FILE.tgz\"";
}

fs::path detectorFolder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value ? value : "");
    };
    const fs::path data = variable("XDG_DATA_HOME"); // ignored unless it is absolute, as its specification says
    return (data.is_absolute() ? data : variable("HOME") / ".local/share") / "handlens/detector";
}

bool isDetectorInstalled(const fs::path& folder) {
    std::error_code error;
    return fs::exists(folder / kPalmFile, error) && fs::exists(folder / kLandmarkFile, error);
}

std::string installDetector(const fs::path& package, const fs::path& folder) {
    const std::map<std::string, std::string> files = readPackage(package, isDetectorFile);
    const std::string& landmarks = packageFile(files, package, kLandmarkFile);
    const std::string palms = packedFile(files, package, kPalmFile);
    const DetectorNetworks networks =
        parseNetworks(palms, within(package, kAssets), landmarks, within(package, kLandmarkFile));
    Network(networks.palms, within(package, kAssets)); // throws if it cannot run
    Network(networks.landmarks, within(package, kLandmarkFile));
    std::string title = titleOf(files, package);

    ensureFolder(folder);
    writeFileAtomically(folder / kPalmFile, palms); // either network works with any other version of the other one
    writeFileAtomically(folder / kLandmarkFile, landmarks);
    writeFileAtomically(folder / kSource, title + "\n");
    return title;
}

DetectorNetworks readDetector(const fs::path& folder) {
    if (!isDetectorInstalled(folder))
        throw Error(ErrorCode::NotFound, folder.string(), "",
                    "the hand detector is not installed: " + howToGetDetector());
    const fs::path palms = folder / kPalmFile, landmarks = folder / kLandmarkFile;
    return parseNetworks(readTextFile(palms), palms.string(), readTextFile(landmarks), landmarks.string());
}

} // namespace core
