// SPDX-License-Identifier: MIT
#include "core/io/dataset/picture_setup.h"

#include <cmath>
#include <cstdio>

#include "core/error.h"
#include "core/io/footage/grey_levels.h"
#include "core/io/footage/image_file.h"
#include "core/io/footage/image_orientation.h"

namespace core {

namespace {

std::string scaleText(double scale) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", scale);
    return text;
}

/// Cameras halve an odd size down or up.
bool isScaled(ImageSize calibrated, double scale, ImageSize size) {
    return std::abs(calibrated.width * scale - size.width) < 1 && std::abs(calibrated.height * scale - size.height) < 1;
}

/// The scale that makes `size` of the calibrated one: exactly, or as cameras bin (1/2, 1/3, ...) with the remainder
/// dropped.
std::optional<double> scaleBetween(ImageSize calibrated, ImageSize size) {
    for (int divisor = 2; divisor <= 8; ++divisor)
        if (isScaled(calibrated, 1.0 / divisor, size))
            return 1.0 / divisor;
    const bool isExact = static_cast<long long>(size.width) * calibrated.height ==
                         static_cast<long long>(size.height) * calibrated.width;
    return isExact && size != calibrated ? std::optional(static_cast<double>(size.width) / calibrated.width)
                                         : std::nullopt;
}

/// The option that would make footage of `size` fit, as the end of a message.
std::string adviceFor(const Camera& camera, ImageSize size, int rotateDegrees) {
    const ImageSize across = turnedSize(size, 90);
    if (const std::optional<double> scale = scaleBetween(camera.size, size)) {
        return "; if the footage is the whole image at another size, use --scale " + camera.name + "=" +
               scaleText(*scale);
    }
    if (across == camera.size) {
        return "; if the pictures lie on their side, use --rotate " + camera.name + "=" +
               std::to_string((rotateDegrees + 90) % 360) + " (or " + std::to_string((rotateDegrees + 270) % 360) + ")";
    }
    if (const std::optional<double> scale = scaleBetween(camera.size, across)) {
        return "; if the footage lies on its side at another size, use --rotate " + camera.name +
               "=90 (or 270) with --scale " + camera.name + "=" + scaleText(*scale);
    }
    if (size.width <= camera.size.width && size.height <= camera.size.height) {
        return "; if the footage is a part of the calibrated image, use --crop " + camera.name +
               "=x,y with where its top left pixel lies";
    }
    return "";
}

/// The camera of pictures of that size; empty if they are not what the options say.
std::optional<Camera> cameraFor(const Camera& camera, ImageSize size, const PictureOptions& options) {
    const double scale = options.scale.value_or(1);
    if (options.cropPx) {
        const Eigen::Vector2d end = *options.cropPx + Eigen::Vector2d(size.width, size.height) / scale;
        const bool fits = options.cropPx->minCoeff() >= 0 && end.x() < camera.size.width + 1 / scale &&
                          end.y() < camera.size.height + 1 / scale;
        return fits ? std::optional(cropped(camera, *options.cropPx, size, scale)) : std::nullopt;
    }
    if (options.scale)
        return isScaled(camera.size, scale, size) ? std::optional(cropped(camera, {0, 0}, size, scale)) : std::nullopt;
    return size == camera.size ? std::optional(camera) : std::nullopt;
}

std::string optionText(const Camera& camera, const PictureOptions& options) {
    std::string text;
    if (options.scale)
        text += " with --scale " + camera.name + "=" + scaleText(*options.scale);
    if (options.cropPx) {
        text +=
            " with --crop " + camera.name + "=" + scaleText(options.cropPx->x()) + "," + scaleText(options.cropPx->y());
    }
    return text;
}

} // namespace

std::optional<GreyLevels> measureFileLevels(const std::vector<std::filesystem::path>& files) {
    std::vector<cv::Mat> pictures;
    std::error_code ignored;
    for (const std::filesystem::path& file : files) {
        if (!std::filesystem::exists(file, ignored))
            continue;
        pictures.push_back(readRawImage(file));
        if (pictures.front().depth() == CV_8U)
            return std::nullopt;
    }
    return measureLevels(pictures);
}

std::optional<FootageNote> orientationNote(const std::string& camera, const Orientation& tag, int rotateDegrees) {
    const double asked = tag.rotateDegrees, turned = rotateDegrees;
    if (tag.isMirrored)
        return FootageNote{FootageNoteKind::Mirrored, {camera}, {}, {turned}};
    if (tag.rotateDegrees == 0)
        return std::nullopt;
    return rotateDegrees == tag.rotateDegrees
               ? FootageNote{FootageNoteKind::TagFollowed, {camera}, {}, {asked}}
               : FootageNote{FootageNoteKind::TagNotFollowed, {camera}, {}, {asked, turned}};
}

PictureSetup setUpPictures(const Camera& camera, const std::string& file, ImageSize recorded, const Orientation& tag,
                           const PictureOptions& options) {
    // A mirrored picture is never right, so its tag is not followed.
    std::vector<int> turns{options.rotateDegrees.value_or(tag.isMirrored ? 0 : tag.rotateDegrees)};
    if (!options.rotateDegrees && turns.front() != 0)
        turns.push_back(0);
    for (const int turn : turns) {
        if (const std::optional<Camera> fitting = cameraFor(camera, turnedSize(recorded, turn), options)) {
            PictureSetup setup{*fitting, turn, {}};
            if (const std::optional<FootageNote> note = orientationNote(camera.name, tag, turn))
                setup.notes.push_back(*note);
            return setup;
        }
    }
    const ImageSize size = turnedSize(recorded, turns.front());
    throw Error(ErrorCode::BadInput, file, "size",
                sizeText(size) + ", but " + camera.name + " is calibrated for " + sizeText(camera.size) +
                    (options.scale || options.cropPx ? ", which does not fit" + optionText(camera, options)
                                                     : adviceFor(camera, size, turns.front())));
}

} // namespace core
