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

/// The part of the sensor that pictures show, px, along one axis.
struct PicturePart {
    double first = 0, length = 0;
};

/// One axis of a sensor as `intrinsic` counts along it.
struct SensorAxis {
    double unit = 1;    ///< counts per pixel
    double firstPx = 0; ///< where the first pixel's centre is, in pixels from the count 0
};

/// Where coordinates begin follows from the range that the file states. QTM counts sub-pixels, 0 to 64 W - 1, so that
/// the first pixel's centre is 31.5; programs that write its format state 64 (W - 1), from centre to centre, or W, from
/// edge to edge and perhaps in whole pixels. `last` is the last pixel that pictures may show.
SensorAxis sensorAxis(const QcaCamera& qca, const std::string& axis, double last) {
    const double from = qca.number("intrinsic", "sensorMin" + axis), to = qca.number("intrinsic", "sensorMax" + axis);
    constexpr double kSubPixels = 64, kTolerance = 0.004;
    SensorAxis sensor;
    sensor.unit = to - from > 20 * (last + 1) ? kSubPixels : 1;
    const double span = (to - from) / sensor.unit;
    const double whole = std::round(span);
    const auto begin = [&](double firstCentre) {
        sensor.firstPx = from / sensor.unit + firstCentre;
        return sensor;
    };
    if (sensor.unit == kSubPixels && std::abs(span + 1 / kSubPixels - whole) < kTolerance)
        return begin(0.5 - 0.5 / kSubPixels);
    if (std::abs(span - (last + 1)) < kTolerance)
        return begin(0.5);
    if (std::abs(span - last) < kTolerance)
        return begin(0);
    throw Error(ErrorCode::Unsupported, qca.file, qca.name + ".intrinsic.sensorMax" + axis,
                "the range does not fit the pictures: 64 W - 1, 64 (W - 1) or W is expected for W pixels");
}

PicturePart picturePart(const QcaCamera& qca, const char* first, const char* last) {
    const char* view = qca.tags.contains("fov_video") ? "fov_video" : "fov_video_max";
    if (!qca.tags.contains(view)) { // such as Theia's own files
        throw Error(ErrorCode::Unsupported, qca.file, qca.name + ".fov_video",
                    "is missing: files of programs that write QTM's names with another meaning are not read");
    }
    const PicturePart part{qca.number(view, first), qca.number(view, last) - qca.number(view, first) + 1};
    if (!(part.length >= 1 && part.length < 1e5)) {
        throw Error(ErrorCode::BadInput, qca.file, qca.name + "." + view,
                    "right and bottom must lie beyond left and top");
    }
    return part;
}

/// The last pixel of the whole sensor along an axis, as far as the file says.
double lastPixel(const QcaCamera& qca, const char* last) {
    return qca.number(qca.tags.contains("fov_video_max") ? "fov_video_max" : "fov_video", last);
}

/// Size and intrinsic matrix.
void setIntrinsics(Camera& camera, const QcaCamera& qca) {
    const PicturePart across = picturePart(qca, "left", "right"), down = picturePart(qca, "top", "bottom");
    const SensorAxis u = sensorAxis(qca, "U", lastPixel(qca, "right"));
    const SensorAxis v = sensorAxis(qca, "V", lastPixel(qca, "bottom"));
    const double scale = pictureScale(qca);
    camera.size = {static_cast<int>(std::lround(across.length * scale)),
                   static_cast<int>(std::lround(down.length * scale))};
    const auto number = [&](const char* key) { return qca.number("intrinsic", key); };
    const auto place = [scale](double count, const SensorAxis& axis, const PicturePart& part) {
        return (count / axis.unit - axis.firstPx - part.first + 0.5) * scale - 0.5;
    };
    camera.intrinsics << number("focalLengthU") / u.unit * scale, number("skew") / u.unit * scale,
        place(number("centerPointU"), u, across), 0, number("focalLengthV") / v.unit * scale,
        place(number("centerPointV"), v, down), 0, 0, 1;
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

std::vector<std::string> qualisysNotes(const CalibrationSource& source) {
    const std::string file = source.path().string();
    std::vector<std::string> notes;
    for (const QcaCamera& camera : camerasOf(tagsOf(source.text(), file), file)) {
        const std::string turn = camera.text("camera", "viewrotation");
        if (isVideo(camera) && isCalibrated(camera) && !turn.empty() && turn != "0")
            notes.push_back(camera.name + ": QTM shows it turned by " + turn +
                            " degrees; the calibration is of the picture as the sensor records it: a video that was "
                            "saved turned needs \"rotate\" in the dataset");
    }
    return notes;
}

} // namespace core
