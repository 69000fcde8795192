// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/text/number_text.h"

namespace core {

namespace {

/// An XML element's attributes.
struct QcaTag {
    std::string name;
    std::map<std::string, std::string, std::less<>> attributes;
};

/// All opening tags in the order of the file. The format keeps everything in attributes.
std::vector<QcaTag> tagsOf(std::string_view text, const std::string& file) {
    constexpr std::string_view kBlank = " \t\r\n";
    std::vector<QcaTag> tags;
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos)
            throw Error(ErrorCode::BadInput, file, "", "ends within a tag");
        std::string_view inner = text.substr(at + 1, end - at - 1);
        at = end;
        if (inner.empty() || inner[0] == '/' || inner[0] == '?' || inner[0] == '!')
            continue;
        const std::size_t nameEnd = std::min(inner.find_first_of(" \t\r\n/"), inner.size());
        QcaTag tag{std::string(inner.substr(0, nameEnd)), {}};
        for (inner.remove_prefix(nameEnd);;) {
            const std::size_t equals = inner.find('='),
                              open = inner.find_first_of("\"'", std::min(equals, inner.size()));
            const std::size_t close = open == std::string_view::npos ? open : inner.find(inner[open], open + 1);
            if (close == std::string_view::npos)
                break;
            std::string_view key = inner.substr(0, equals);
            key.remove_prefix(std::min(key.find_first_not_of(kBlank), key.size()));
            key = key.substr(0, key.find_last_not_of(kBlank) + 1);
            tag.attributes[std::string(key)] = inner.substr(open + 1, close - open - 1);
            inner.remove_prefix(close + 1);
        }
        tags.push_back(tag);
    }
    return tags;
}

/// The tags of one camera, by name.
struct QcaCamera {
    std::map<std::string, QcaTag, std::less<>> tags;
    std::string name;
    std::string file;

    std::string text(std::string_view tag, std::string_view key) const {
        const auto found = tags.find(tag);
        if (found == tags.end())
            return "";
        const auto value = found->second.attributes.find(key);
        return value == found->second.attributes.end() ? "" : value->second;
    }
    double number(std::string_view tag, std::string_view key) const {
        double value = 0;
        if (!parseNumber(text(tag, key), value)) {
            throw Error(ErrorCode::BadInput, file, name + "." + std::string(tag) + "." + std::string(key),
                        "a finite number is expected");
        }
        return value;
    }
};

/// Cameras that record pictures for people; the others see markers only.
bool isVideo(const QcaCamera& camera) {
    const std::string model = camera.text("camera", "model");
    return model.find("Video") != std::string::npos || model == "none" || model.empty();
}

/// Cameras that were switched off or that the calibration did not find have no place.
bool isCalibrated(const QcaCamera& camera) {
    return camera.text("camera", "active") != "0" && camera.text("camera", "calibrated") != "false" &&
           camera.tags.contains("transform") && camera.tags.contains("intrinsic");
}

std::vector<QcaCamera> camerasOf(const std::vector<QcaTag>& tags, const std::string& file) {
    std::vector<QcaCamera> cameras;
    for (const QcaTag& tag : tags) {
        if (tag.name == "camera") {
            cameras.push_back({{}, "", file});
            const auto serial = tag.attributes.find("serial");
            cameras.back().name =
                serial == tag.attributes.end() ? "camera" + std::to_string(cameras.size()) : serial->second;
        }
        if (!cameras.empty())
            cameras.back().tags.emplace(tag.name, tag);
    }
    return cameras;
}

/// Pixels of the pictures per pixel of the sensor: QTM calibrates the whole sensor and names the height of smaller
/// pictures, such as 540p, beside 1080 lines.
double pictureScale(const QcaCamera& qca) {
    const std::string resolution = qca.text("camera", "video_resolution");
    if (resolution.empty() || resolution == "N/A" || resolution == "none")
        return 1;
    double lines = 0;
    constexpr double kSensorLines = 1080;
    if (!resolution.ends_with('p') ||
        !parseNumber(std::string_view(resolution).substr(0, resolution.size() - 1), lines) || lines < 16 ||
        lines > kSensorLines) {
        throw Error(ErrorCode::Unsupported, qca.file, qca.name + ".video_resolution",
                    resolution + " is not read: a number of lines up to 1080p is expected");
    }
    return lines / kSensorLines;
}

/// Size and intrinsic matrix. The sensor's coordinates are taken to be 0 at the first pixel's centre, as in files whose
/// sensorMaxU is 64 (width - 1).
void setIntrinsics(Camera& camera, const QcaCamera& qca) {
    const char* view = qca.tags.contains("fov_video") ? "fov_video" : "fov_video_max";
    const double left = qca.number(view, "left"), top = qca.number(view, "top");
    const double width = qca.number(view, "right") - left + 1, height = qca.number(view, "bottom") - top + 1;
    if (!(width >= 1 && height >= 1 && width < 1e5 && height < 1e5)) {
        throw Error(ErrorCode::BadInput, qca.file, qca.name + "." + view,
                    "right and bottom must lie beyond left and top");
    }
    const double scale = pictureScale(qca);
    camera.size = {static_cast<int>(std::lround(width * scale)), static_cast<int>(std::lround(height * scale))};
    // QTM counts in 1/64 px; files that other programs write in its format may count in whole ones.
    const bool isFine = qca.number("intrinsic", "sensorMaxU") > 20 * (left + width);
    const double unit = isFine ? 64 : 1;
    const auto px = [&](const char* key) { return qca.number("intrinsic", key) / unit; };
    const auto place = [scale](double sensor, double first) { return (sensor - first + 0.5) * scale - 0.5; };
    camera.intrinsics << px("focalLengthU") * scale, px("skew") * scale, place(px("centerPointU"), left), 0,
        px("focalLengthV") * scale, place(px("centerPointV"), top), 0, 0, 1;
}

Camera toCamera(const QcaCamera& qca) {
    Camera camera;
    camera.name = qca.name;
    setIntrinsics(camera, qca);
    camera.distortion = {qca.number("intrinsic", "radialDistortion1"), qca.number("intrinsic", "radialDistortion2"),
                         qca.number("intrinsic", "tangentalDistortion1"),
                         qca.number("intrinsic", "tangentalDistortion2"), qca.number("intrinsic", "radialDistortion3")};
    Eigen::Matrix3d rows;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            rows(i, j) = qca.number("transform", "r" + std::to_string(i + 1) + std::to_string(j + 1));
    const Eigen::Vector3d centre(qca.number("transform", "x"), qca.number("transform", "y"),
                                 qca.number("transform", "z"));
    // Its camera looks along -z with y up.
    rows.bottomRows<2>() *= -1;
    camera.cameraFromWorld = {rows, -(rows * centre)};
    return camera;
}

} // namespace

bool looksLikeQualisys(const CalibrationSource& source) {
    return source.hasExtension({".txt", ".xml", ".qca"}) && source.holds("<calibration") &&
           source.holds("<intrinsic") && source.holds("sensorMaxU");
}

std::vector<Camera> readQualisys(const CalibrationSource& source, const CalibrationOptions&) {
    const std::string file = source.path().string();
    std::vector<Camera> cameras;
    int videos = 0;
    for (const QcaCamera& camera : camerasOf(tagsOf(source.text(), file), file)) {
        videos += isVideo(camera) ? 1 : 0;
        if (isVideo(camera) && isCalibrated(camera))
            cameras.push_back(toCamera(camera));
    }
    if (cameras.empty()) {
        throw Error(ErrorCode::BadInput, file, "cameras",
                    videos == 0 ? "holds no video cameras" : "none of its video cameras is calibrated");
    }
    return cameras;
}

} // namespace core
