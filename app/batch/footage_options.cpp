// SPDX-License-Identifier: MIT
#include "app/batch/footage_options.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace app {

namespace {

core::Error badValue(const std::string& option, const std::string& text, const std::string& expected) {
    return {core::ErrorCode::Usage, "", option, "\"" + text + "\": " + expected};
}

/// "cam0=path" in two.
std::pair<std::string, std::string> splitAssignment(const std::string& text, const std::string& option) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw core::Error(core::ErrorCode::Usage, "", option, "CAMERA=VALUE is expected, not \"" + text + "\"");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

/// Numbers between commas; `count` of them.
std::optional<std::vector<double>> numbersOf(const std::string& text, std::size_t count) {
    std::vector<double> values;
    for (const std::string_view word : core::splitWords(text, true)) {
        values.emplace_back();
        if (!core::parseNumber(word, values.back()))
            return std::nullopt;
    }
    return values.size() == count ? std::optional(values) : std::nullopt;
}

using Setter = std::function<bool(core::Footage&, const std::string&)>;

/// Applies "CAMERA=VALUE" texts to the footage of those cameras; `set` says whether a value makes sense.
void apply(std::vector<core::Footage>& footage, const std::vector<std::string>& texts, const std::string& option,
           const std::string& expected, const Setter& set) {
    for (const std::string& text : texts) {
        const auto [camera, value] = splitAssignment(text, option);
        const auto found = std::find_if(footage.begin(), footage.end(),
                                        [&, name = camera](const core::Footage& one) { return one.camera == name; });
        if (found == footage.end() || !set(*found, value))
            throw badValue(option, text, "a camera with footage and " + expected + " are expected");
    }
}

bool setOffset(core::Footage& footage, const std::string& value) {
    const auto frames = numbersOf(value, 1);
    if (!frames || frames->front() < 0 || frames->front() > 10'000'000 ||
        frames->front() != std::floor(frames->front()))
        return false;
    footage.offsetFrames = static_cast<int>(frames->front());
    return true;
}

bool setRotation(core::Footage& footage, const std::string& value) {
    static const std::string kTurns[] = {"0", "90", "180", "270"};
    const auto turn = std::find(std::begin(kTurns), std::end(kTurns), value);
    footage.pictures.rotateDegrees =
        turn == std::end(kTurns) ? std::nullopt : std::optional(static_cast<int>(turn - std::begin(kTurns)) * 90);
    return value == "auto" || footage.pictures.rotateDegrees.has_value();
}

bool setLevels(core::Footage& footage, const std::string& value) {
    const auto levels = numbersOf(value, 2);
    if (!levels || (*levels)[0] < 0 || (*levels)[1] > 65535 || (*levels)[0] >= (*levels)[1])
        return false;
    footage.pictures.levels = core::GreyLevels{static_cast<int>((*levels)[0]), static_cast<int>((*levels)[1])};
    return true;
}

bool setScale(core::Footage& footage, const std::string& value) {
    const auto scale = numbersOf(value, 1);
    if (!scale || scale->front() <= 0 || scale->front() > 100)
        return false;
    footage.pictures.scale = scale->front();
    return true;
}

bool setCrop(core::Footage& footage, const std::string& value) {
    const auto corner = numbersOf(value, 2);
    if (!corner || (*corner)[0] < 0 || (*corner)[1] < 0)
        return false;
    footage.pictures.cropPx = Eigen::Vector2d((*corner)[0], (*corner)[1]);
    return true;
}

} // namespace

void addFootageOptions(CLI::App& verb, FootageArguments& arguments) {
    verb.add_option("--video", arguments.videos, "CAMERA=FILE; can be repeated");
    verb.add_option("--images", arguments.images,
                    "CAMERA=FOLDER of numbered images, or a pattern such as cam0/{frame:06}.png; can be repeated");
    verb.add_option("--offset", arguments.offsets,
                    "CAMERA=FRAMES: the footage's frame at the sequence's first instant");
    verb.add_option("--rotate", arguments.rotations,
                    "CAMERA=auto|0|90|180|270: degrees clockwise that the pictures are turned; auto follows the file's "
                    "orientation tag where the result fits");
    verb.add_option("--levels", arguments.levels,
                    "CAMERA=BLACK,WHITE: levels of pictures of more than 8 bits that are shown black and white");
    verb.add_option("--scale", arguments.scales,
                    "CAMERA=FACTOR: the footage is the calibrated image at another size, such as 0.5");
    verb.add_option("--crop", arguments.crops,
                    "CAMERA=X,Y: the footage is a part of the calibrated image, with its top left pixel there");
}

std::vector<core::Footage> footageOf(const FootageArguments& arguments) {
    std::vector<core::Footage> footage;
    for (const auto& [list, option] :
         {std::pair(&arguments.videos, "--video"), std::pair(&arguments.images, "--images")}) {
        for (const std::string& text : *list) {
            const auto [camera, path] = splitAssignment(text, option);
            footage.push_back({camera, path});
        }
    }
    apply(footage, arguments.offsets, "--offset", "a number of frames from 0 on", setOffset);
    apply(footage, arguments.rotations, "--rotate", "auto, 0, 90, 180 or 270", setRotation);
    apply(footage, arguments.levels, "--levels", "two levels BLACK,WHITE between 0 and 65535", setLevels);
    apply(footage, arguments.scales, "--scale", "a factor above 0", setScale);
    apply(footage, arguments.crops, "--crop", "X,Y of the top left pixel from 0 on", setCrop);
    return footage;
}

} // namespace app
