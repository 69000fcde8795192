// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxDepth = 32;

/// A file of cv::FileStorage, opened; errors carry its name.
class Storage {
public:
    explicit Storage(const fs::path& file)
        : m_file(file.string()) {
        const std::string text = readTextFile(file);
        if (text.find_first_not_of(" \t\r\n") == std::string::npos)
            throw bad("", "is empty");
        if (nestingDepth(text) > kMaxDepth) // the library's parser is recursive
            throw bad("", "is nested too deep");
        try {
            m_storage.open(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
        } catch (const cv::Exception& failure) {
            throw bad("", "is not YAML, XML or JSON as OpenCV writes it: " + failure.err);
        }
        if (!m_storage.isOpened())
            throw bad("", "is not YAML, XML or JSON as OpenCV writes it");
    }

    Error bad(const std::string& field, const std::string& detail) const {
        return Error(ErrorCode::BadInput, m_file, field, detail);
    }
    cv::FileNode root() const { return m_storage.root(); }
    const std::string& file() const { return m_file; }

    /// The numbers of a list, a list of lists, or a matrix, row by row. Empty if there is no such node.
    std::vector<double> numbers(const cv::FileNode& parent, const std::string& key) const {
        const cv::FileNode node = parent[key];
        std::vector<double> values;
        append(values, node.isMap() ? node["data"] : node, key, 0);
        return values;
    }
    std::vector<double> neededNumbers(const cv::FileNode& parent, const std::string& key) const {
        std::vector<double> values = numbers(parent, key);
        if (values.empty())
            throw bad(key, "is missing");
        return values;
    }

private:
    void append(std::vector<double>& values, const cv::FileNode& node, const std::string& key, int depth) const {
        if (node.isSeq() && depth < kMaxDepth) {
            for (const cv::FileNode item : node)
                append(values, item, key, depth + 1);
        } else if (node.isInt() || node.isReal()) {
            const double value = static_cast<double>(node);
            if (!std::isfinite(value))
                throw bad(key, "holds a number that is not finite");
            values.push_back(value);
        } else if (!node.empty() && !node.isNone()) {
            throw bad(key, "numbers are expected");
        }
    }

    std::string m_file;
    cv::FileStorage m_storage;
};

/// Runs a reader; what OpenCV throws on the way becomes an error of the file.
template <typename Reader>
auto guarded(const Storage& storage, Reader&& reader) {
    try {
        return reader();
    } catch (const cv::Exception& failure) {
        throw storage.bad("", "cannot be read: " + failure.err);
    }
}

ImageSize sizeOf(const Storage& storage, const cv::FileNode& node, const char* widthKey, const char* heightKey) {
    const cv::FileNode width = node[widthKey], height = node[heightKey];
    if (width.empty() || height.empty())
        return {};
    const double w = static_cast<double>(width), h = static_cast<double>(height);
    if (!(w >= 1 && w <= 1e5 && h >= 1 && h <= 1e5))
        throw storage.bad(widthKey, "the image size is not sensible");
    return {static_cast<int>(w), static_cast<int>(h)};
}

std::string textOf(const cv::FileNode& node) {
    return node.isString() ? static_cast<std::string>(node) : std::string();
}

/// The first of these keys that is there.
std::string firstKey(const Storage& storage, const cv::FileNode& node, const std::vector<std::string>& keys) {
    for (const std::string& key : keys)
        if (!node[key].empty())
            return key;
    throw storage.bad(keys.front(), "is missing");
}

Camera openCvCamera(const Storage& storage, const cv::FileNode& node, const std::string& fallbackName) {
    Camera camera;
    camera.name = textOf(node[node["name"].empty() ? "camera_name" : "name"]);
    if (camera.name.empty())
        camera.name = fallbackName;
    camera.size = sizeOf(storage, node, "image_width", "image_height");
    camera.intrinsics = rowMajorMatrix(storage.neededNumbers(node, "camera_matrix"), storage.file(), "camera_matrix");
    camera.distortion = storage.numbers(node, "distortion_coefficients");
    camera.fisheye = !node["fisheye"].empty() && static_cast<int>(node["fisheye"]) != 0;
    const std::string rotation = firstKey(storage, node, {"R", "rvec", "rotation", "rotation_matrix"});
    camera.cameraFromWorld.rotation = rotationOf(storage.neededNumbers(node, rotation), storage.file(), rotation);
    const std::string translation = firstKey(storage, node, {"tvec", "T", "t", "translation", "translation_vector"});
    camera.cameraFromWorld.translation =
        vectorOf(storage.neededNumbers(node, translation), storage.file(), translation);
    return camera;
}

cv::Mat toMat(const Eigen::MatrixXd& matrix) {
    cv::Mat result(static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), CV_64F);
    for (int i = 0; i < result.rows; ++i)
        for (int j = 0; j < result.cols; ++j)
            result.at<double>(i, j) = matrix(i, j);
    return result;
}

void writeCamera(cv::FileStorage& storage, const Camera& camera) {
    storage << "{"
            << "name" << camera.name << "image_width" << camera.size.width << "image_height" << camera.size.height;
    storage << "camera_matrix" << toMat(camera.intrinsics);
    Eigen::MatrixXd lens =
        Eigen::MatrixXd::Zero(1, static_cast<Eigen::Index>(std::max<std::size_t>(4, camera.distortion.size())));
    std::copy(camera.distortion.begin(), camera.distortion.end(), lens.data());
    storage << "distortion_coefficients" << toMat(lens) << "fisheye" << static_cast<int>(camera.fisheye);
    storage << "R" << toMat(camera.cameraFromWorld.rotation) << "tvec" << toMat(camera.cameraFromWorld.translation)
            << "}";
}

Camera jarvisCamera(const Storage& storage, const std::string& name) {
    const cv::FileNode root = storage.root();
    Camera camera;
    camera.name = name;
    camera.size = sizeOf(storage, root, "image_width", "image_height");
    // Both matrices are stored transposed: the principal point stands in the last row.
    camera.intrinsics =
        rowMajorMatrix(storage.neededNumbers(root, "intrinsicMatrix"), storage.file(), "intrinsicMatrix")
            .transpose()
            .eval();
    camera.distortion = storage.numbers(root, "distortionCoefficients");
    camera.cameraFromWorld.rotation =
        rowMajorMatrix(storage.neededNumbers(root, "R"), storage.file(), "R").transpose().eval();
    camera.cameraFromWorld.translation = vectorOf(storage.neededNumbers(root, "T"), storage.file(), "T");
    return camera;
}

Camera easyMocapCamera(const Storage& intrinsics, const Storage& extrinsics, const std::string& name) {
    const cv::FileNode in = intrinsics.root(), ex = extrinsics.root();
    Camera camera;
    camera.name = name;
    camera.size = sizeOf(intrinsics, in, ("W_" + name).c_str(), ("H_" + name).c_str());
    camera.intrinsics = rowMajorMatrix(intrinsics.neededNumbers(in, "K_" + name), intrinsics.file(), "K_" + name);
    camera.distortion = intrinsics.numbers(in, "dist_" + name);
    const std::string rotation = firstKey(extrinsics, ex, {"Rot_" + name, "R_" + name});
    camera.cameraFromWorld.rotation = rotationOf(extrinsics.neededNumbers(ex, rotation), extrinsics.file(), rotation);
    camera.cameraFromWorld.translation =
        vectorOf(extrinsics.neededNumbers(ex, "T_" + name), extrinsics.file(), "T_" + name);
    return camera;
}

} // namespace

bool looksLikeOpenCv(const CalibrationSource& source) {
    if (source.hasExtension({".json"}))
        return source.json().is_object() &&
               (source.json().contains("camera_matrix") || source.json().contains("cameras"));
    return source.isMarkup() && source.holds("camera_matrix");
}

std::vector<Camera> readOpenCv(const CalibrationSource& source, const CalibrationOptions&) {
    std::vector<Camera> cameras;
    for (const fs::path& file : calibrationFiles(source.path(), {".yml", ".yaml", ".xml", ".json"})) {
        const Storage storage(file);
        guarded(storage, [&] {
            const cv::FileNode list = storage.root()["cameras"];
            if (!list.isSeq()) {
                cameras.push_back(openCvCamera(storage, storage.root(), file.stem().string()));
                return;
            }
            for (const cv::FileNode node : list)
                cameras.push_back(openCvCamera(storage, node, "cam" + std::to_string(cameras.size())));
        });
    }
    return cameras;
}

std::string formatOpenCv(const std::vector<Camera>& cameras, std::string extension) {
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool isKnown = extension == ".xml" || extension == ".json";
    cv::FileStorage storage(isKnown ? extension : ".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
    storage << "cameras"
            << "[";
    for (const Camera& camera : cameras)
        writeCamera(storage, camera);
    storage << "]";
    return storage.releaseAndGetString();
}

bool looksLikeJarvis(const CalibrationSource& source) {
    return source.isMarkup() && source.holds("intrinsicMatrix");
}

std::vector<Camera> readJarvis(const CalibrationSource& source, const CalibrationOptions&) {
    std::vector<Camera> cameras;
    for (const fs::path& file : calibrationFiles(source.path(), {".yml", ".yaml"})) {
        const Storage storage(file);
        cameras.push_back(guarded(storage, [&] { return jarvisCamera(storage, file.stem().string()); }));
    }
    return cameras;
}

bool looksLikeEasyMocap(const CalibrationSource& source) {
    if (source.isFolder())
        return fs::exists(source.path() / "intri.yml");
    return source.isMarkup() && !source.holds("intrinsicMatrix") && !source.holds("camera_matrix") &&
           source.holds("names:") && (source.holds("K_") || source.holds("R_"));
}

std::vector<Camera> readEasyMocap(const CalibrationSource& source, const CalibrationOptions&) {
    const fs::path folder = source.isFolder() ? source.path() : source.path().parent_path();
    const Storage intrinsics(folder / "intri.yml"), extrinsics(folder / "extri.yml");
    return guarded(intrinsics, [&] {
        const cv::FileNode names = intrinsics.root()["names"];
        if (!names.isSeq())
            throw intrinsics.bad("names", "a list of camera names is expected");
        std::vector<Camera> cameras;
        for (const cv::FileNode node : names) {
            // Names that look like numbers are read as such.
            cameras.push_back(easyMocapCamera(intrinsics, extrinsics,
                                              node.isInt() ? std::to_string(static_cast<int>(node)) : textOf(node)));
        }
        return cameras;
    });
}

} // namespace core
