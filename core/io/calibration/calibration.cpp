// SPDX-License-Identifier: MIT
#include "core/io/calibration/calibration.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/calibration/tzionas_cameras.h"
#include "core/io/files/atomic_file.h"
#include "core/text/number_text.h"

namespace core {

namespace fs = std::filesystem;

namespace {

using Cameras = std::vector<Camera>;
using Source = CalibrationSource;
using Options = CalibrationOptions;

/// How one kind is recognised, read and written.
struct Row {
    CalibrationKind kind;
    bool (*looksAlike)(const Source&); ///< what the extension and a look at the content tell
    Cameras (*read)(const Source&, const Options&);
    void (*write)(const fs::path&, const Cameras&); ///< nullptr: cannot be written
    const char* note = "";                          ///< what a reader of the cameras should know, if no unit was given
    std::vector<std::string> (*notesOf)(const Source&) = nullptr; ///< what the file itself gives reason to say
};

/// Programs of OpenCV's kind read fx, fy, cx and cy only: a skew would be lost in silence.
void refuseSkew(const fs::path& file, const Cameras& cameras) {
    constexpr double kTolerancePx = 0.01;
    for (const Camera& camera : cameras) {
        const double skew = camera.intrinsics(0, 1);
        if (std::abs(skew) * camera.size.height / (2 * camera.intrinsics(1, 1)) > kTolerancePx) {
            throw Error(ErrorCode::Unsupported, file.string(), camera.name + ".K",
                        "has a skew of " + fixedText(skew, 3) + " px, which programs that read this kind ignore");
        }
    }
}

void writeAnipose(const fs::path& file, const Cameras& cameras) {
    refuseSkew(file, cameras);
    writeFileAtomically(file, formatAnipose(cameras));
}

void writeOpenCv(const fs::path& file, const Cameras& cameras) {
    refuseSkew(file, cameras);
    writeFileAtomically(file, formatOpenCv(cameras, file.extension().string()));
}

constexpr const char* kNoScale =
    "such files have no scale of their own: give --mm-per-unit, from a length that you know";

/// All kinds, in the order in which they are tried: the first that looks alike is it, so a kind that takes every file
/// of an extension stands behind those that look closer.
constexpr Row kRows[] = {
    {{"handlens", "cameras.json of a dataset", 1, true, "json"}, looksLikeOwnCameras, readOwnCameras, writeCameras},
    {{"caliscope", "Caliscope's camera_array.toml (in metres)", 1000, false, "toml"},
     looksLikeCaliscope,
     readCaliscope,
     nullptr},
    {{"anipose", "calibration.toml of Anipose", 1, true, "toml"}, looksLikeAnipose, readAnipose, writeAnipose},
    {{"pose2sim", "Calib.toml of Pose2Sim (Anipose's, in metres)", 1000, false, "toml"},
     [](const Source&) { return false; }, // only the unit tells it from Anipose's
     readAnipose,
     nullptr},
    {{"easymocap", "EasyMocap's intri.yml and extri.yml (usually in metres)", 1000, false, "yml yaml"},
     looksLikeEasyMocap,
     readEasyMocap,
     nullptr},
    {{"dannce", "DANNCE's *_params.mat (a folder) or project file, Label3D's project file", 1, false, "mat"},
     looksLikeDannce,
     readDannce,
     nullptr},
    {{"handpose3d", "a folder of handpose3d's c0.dat and rot_trans_c0.dat (the unit is not said; usually centimetres)",
      10, false, "dat"},
     looksLikeHandpose3d,
     readHandpose3d,
     nullptr,
     "these files do not say their unit of length: centimetres are assumed (--mm-per-unit 10); compare a length "
     "that you know, such as a palm's width. (In handpose3d's own example a unit is about 45 mm.)"},
    {{"colmap", "COLMAP's text model: a folder with cameras.txt and images.txt", 1, false, "txt"},
     looksLikeColmap,
     readColmap,
     nullptr,
     kNoScale},
    {{"kalibr", "Kalibr's camchain.yaml (in metres)", 1000, false, "yaml yml"}, looksLikeKalibr, readKalibr, nullptr},
    {{"jarvis", "a folder of JARVIS YAML files", 1, false, "yaml yml"}, looksLikeJarvis, readJarvis, nullptr},
    {{"interhand", "InterHand2.6M camera JSON", 1, false, "json"}, looksLikeInterHand, readInterHand, nullptr},
    {{"hanco", "HanCo calibration JSON (in metres)", 1000, false, "json"}, looksLikeHanCo, readHanCo, nullptr},
    {{"nerfstudio", "transforms.json of nerfstudio", 1, false, "json"},
     looksLikeNerfstudio,
     readNerfstudio,
     nullptr,
     kNoScale},
    {{"dlt", "DLT coefficients, CSV with eleven rows and a column per camera", 1, false, "csv"},
     looksLikeDlt,
     readDlt,
     nullptr,
     "these files do not say their unit of length: millimetres are assumed; otherwise give --mm-per-unit"},
    {{"qualisys", "calibration .qca.txt of Qualisys", 1, false, "txt xml qca"},
     looksLikeQualisys,
     readQualisys,
     nullptr,
     "",
     qualisysNotes},
    {{"xmalab", "a folder of XMALab's MayaCam 2.0 files", 1, false, "txt"},
     looksLikeXmaLab,
     readXmaLab,
     nullptr,
     "these files do not say their unit of length: millimetres are assumed; otherwise give --mm-per-unit"},
    {{"opencv", "OpenCV YAML, XML or JSON, all cameras in one file or a folder of files", 1, true, "yml yaml xml json"},
     looksLikeOpenCv,
     readOpenCv,
     writeOpenCv},
    {{"tzionas", "Cameras.txt of the method's authors", 1, false, "txt"},
     [](const Source& source) { return source.hasExtension({".txt"}); },
     [](const Source& source, const Options& options) { return readTzionasCameras(source.path(), options.size); },
     nullptr}};

const Row& rowNamed(std::string_view name) {
    for (const Row& row : kRows)
        if (row.kind.name == name)
            return row;
    throw Error(ErrorCode::Usage, "", "kind", "\"" + std::string(name) + "\" is not a known kind of calibration");
}

const Row& rowThatLooksLike(const Source& source) {
    std::string tried;
    for (const Row& row : kRows) {
        if (row.looksAlike(source))
            return row;
        tried += (tried.empty() ? "" : ", ") + std::string(row.kind.name);
    }
    throw Error(ErrorCode::Unsupported, source.path().string(), "",
                "is not a calibration of a known kind: tried " + tried + " (if it is one, say which with --from)");
}

const Row& rowOf(const Source& source, const Options& options) {
    return options.kind.empty() ? rowThatLooksLike(source) : rowNamed(options.kind);
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

/// The size of cameras whose principal points lie in the middle of their images.
ImageSize assumedSize(const std::vector<Camera>& cameras) {
    Eigen::Vector2d sum(0, 0);
    for (const Camera& camera : cameras)
        sum += camera.intrinsics.topRightCorner<2, 1>();
    const Eigen::Vector2d size = 2 * sum / static_cast<double>(cameras.size()) + Eigen::Vector2d::Ones();
    constexpr double kMost = 1 << 20;
    if (!size.allFinite() || size.minCoeff() < 2 || size.maxCoeff() > kMost)
        return {};
    return {static_cast<int>(std::lround(size.x())), static_cast<int>(std::lround(size.y()))};
}

/// Cameras whose file holds no image size get that of the options. Throws Error if there is none.
void setSizes(std::vector<Camera>& cameras, const Options& options, const std::string& file) {
    const ImageSize size = options.size ? *options.size : options.assumeSize ? assumedSize(cameras) : ImageSize{};
    for (Camera& camera : cameras) {
        if (!(camera.size == ImageSize{}))
            continue;
        if (size == ImageSize{}) {
            throw Error(ErrorCode::BadInput, file, camera.name + ".size",
                        "such files hold no image size; give --size WxH");
        }
        camera.size = size;
    }
}

/// Says which size was assumed; empty if the file holds sizes, or one was given.
std::string sizeNote(const std::vector<Camera>& asStored, const Options& options, const std::vector<Camera>& cameras) {
    const bool isStored =
        std::all_of(asStored.begin(), asStored.end(), [](const Camera& c) { return !(c.size == ImageSize{}); });
    if (options.size || isStored || cameras.empty())
        return {};
    const ImageSize size = cameras.front().size;
    return "the file holds no image size: " + std::to_string(size.width) + " x " + std::to_string(size.height) +
           " is assumed, twice the mean principal point; give the right one with --size WxH";
}

} // namespace

bool mayBeCalibration(const fs::path& file) {
    std::string ending = file.extension().string();
    ending.erase(0, 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending.empty() || ending.find(' ') != std::string::npos)
        return false;
    return std::any_of(std::begin(kRows), std::end(kRows), [&ending](const Row& row) {
        return (" " + std::string(row.kind.endings) + " ").find(" " + ending + " ") != std::string::npos;
    });
}

const std::vector<CalibrationKind>& calibrationKinds() {
    static const std::vector<CalibrationKind> kinds = [] {
        std::vector<CalibrationKind> list;
        for (const Row& row : kRows)
            list.push_back(row.kind);
        return list;
    }();
    return kinds;
}

std::string sniffCalibration(const fs::path& path) {
    return std::string(rowThatLooksLike(Source(path)).kind.name);
}

std::vector<Camera> readCalibration(const fs::path& path, const CalibrationOptions& options) {
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw Error(ErrorCode::NotFound, path.string(), "", "no such file or folder");
    const Source source(path);
    const Row& row = rowOf(source, options);
    const double mmPerUnit = options.mmPerUnit.value_or(row.kind.mmPerUnit);
    std::vector<Camera> cameras = row.read(source, options);
    if (cameras.empty())
        throw Error(ErrorCode::BadInput, path.string(), "", "holds no cameras");
    setSizes(cameras, options, path.string());
    for (Camera& camera : cameras) {
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
    const auto writable = std::find_if(std::begin(kRows), std::end(kRows),
                                       [kind](const Row& row) { return row.kind.name == kind && row.write; });
    if (writable == std::end(kRows))
        throw Error(ErrorCode::Usage, "", "--to", "\"" + std::string(kind) + "\" cannot be written");
    writable->write(file, cameras);
}

std::vector<std::string> calibrationNotes(const fs::path& path, const CalibrationOptions& options,
                                          const std::vector<Camera>& cameras) {
    const Source source(path);
    const Row& row = rowOf(source, options);
    std::vector<std::string> notes;
    if (const std::string note = sizeNote(row.read(source, options), options, cameras); !note.empty())
        notes.push_back(note);
    if (*row.note != '\0' && !options.mmPerUnit)
        notes.emplace_back(row.note);
    const std::string unit = unitNote(cameras, options.mmPerUnit.value_or(row.kind.mmPerUnit));
    if (!unit.empty())
        notes.push_back(unit);
    for (const std::string& lens : lensNotes(cameras))
        notes.push_back(lens);
    if (row.notesOf)
        for (const std::string& note : row.notesOf(source))
            notes.push_back(note);
    return notes;
}

} // namespace core
