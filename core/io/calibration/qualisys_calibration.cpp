// SPDX-License-Identifier: MIT
#include <algorithm>
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
            const std::size_t equals = inner.find('='), open = inner.find('"', std::min(equals, inner.size()));
            const std::size_t close = open == std::string_view::npos ? open : inner.find('"', open + 1);
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

bool isVideo(const QcaCamera& camera) {
    const std::string model = camera.text("camera", "model");
    return model.find("Video") != std::string::npos || model == "none";
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

Camera toCamera(const QcaCamera& qca) {
    const std::string resolution = qca.text("camera", "video_resolution");
    if (!resolution.empty() && resolution != "N/A" && resolution != "1080p") {
        throw Error(ErrorCode::Unsupported, qca.file, qca.name + ".video_resolution",
                    resolution + " is not read: it is not established how such files are scaled");
    }
    const double left = qca.number("fov_video", "left"), top = qca.number("fov_video", "top");
    Camera camera;
    camera.name = qca.name;
    camera.size = {static_cast<int>(qca.number("fov_video", "right") - left) + 1,
                   static_cast<int>(qca.number("fov_video", "bottom") - top) + 1};
    // QTM counts in 1/64 px; files that other programs write in its format may count in whole ones.
    const bool isFine = qca.number("intrinsic", "sensorMaxU") > 20 * (left + camera.size.width);
    const double unit = isFine ? 64 : 1;
    const auto px = [&](const char* key) { return qca.number("intrinsic", key) / unit; };
    camera.intrinsics << px("focalLengthU"), px("skew"), px("centerPointU") - left, 0, px("focalLengthV"),
        px("centerPointV") - top, 0, 0, 1;
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
    for (const QcaCamera& camera : camerasOf(tagsOf(source.text(), file), file))
        if (isVideo(camera))
            cameras.push_back(toCamera(camera));
    if (cameras.empty())
        throw Error(ErrorCode::BadInput, file, "cameras", "holds no video cameras");
    return cameras;
}

} // namespace core
