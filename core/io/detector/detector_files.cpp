// SPDX-License-Identifier: MIT
#include "core/io/detector/detector_files.h"

#include <cstdlib>
#include <map>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/detector/package_archive.h"
#include "core/io/detector/tflite_file.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"
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

/// The list of packed files that the loader's last line hands to loadPackage(...).
nlohmann::json packedFiles(const std::string& script, const std::string& name) {
    const std::string call = "loadPackage({";
    const std::size_t begin = script.rfind(call), end = script.find("})", begin);
    if (begin == std::string::npos || end == std::string::npos)
        throw Error(ErrorCode::BadInput, name, "loadPackage", "the list of packed files is missing");
    const nlohmann::json list = parseJson(script.substr(begin + call.size() - 1, end + 2 - begin - call.size()), name);
    if (!list.contains("files") || !list["files"].is_array())
        throw Error(ErrorCode::BadInput, name, "files", "the list of packed files is missing");
    return list["files"];
}

/// One of the files that are packed into another one, at the offsets that the loader says.
std::string packedFile(const std::map<std::string, std::string>& files, const fs::path& package,
                       const std::string& wanted) {
    const std::string name = within(package, kAssetsLoader);
    const std::string& assets = packageFile(files, package, kAssets);
    for (const nlohmann::json& entry : packedFiles(packageFile(files, package, kAssetsLoader), name)) {
        if (!entry.is_object() || !entry.contains("filename") || !entry["filename"].is_string() ||
            fs::path(entry["filename"].get<std::string>()).filename() != wanted)
            continue;
        const auto offset = [&](const char* field) {
            if (!entry.contains(field) || !entry[field].is_number_unsigned())
                throw Error(ErrorCode::BadInput, name, std::string("files.") + field, "an offset is expected");
            return entry[field].get<std::size_t>();
        };
        const std::size_t begin = offset("start"), end = offset("end");
        if (begin > end || end > assets.size())
            throw Error(ErrorCode::BadInput, name, "files.end",
                        wanted + " lies outside " + kAssets + " (bytes " + std::to_string(begin) + " to " +
                            std::to_string(end) + " of " + std::to_string(assets.size()) + ")");
        return assets.substr(begin, end - begin);
    }
    throw Error(ErrorCode::NotFound, name, "files", wanted + " is not among the packed files");
}

std::string packageTitle(const std::map<std::string, std::string>& files, const fs::path& package) {
    const auto found = files.find(kManifest);
    if (found == files.end())
        return "a package without " + kManifest;
    const nlohmann::json manifest = parseJson(found->second, within(package, kManifest));
    const auto text = [&](const char* field) {
        return manifest.is_object() && manifest.contains(field) && manifest[field].is_string()
                   ? manifest[field].get<std::string>()
                   : std::string("?");
    };
    return text("name") + " " + text("version");
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
    std::string title = packageTitle(files, package);

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
