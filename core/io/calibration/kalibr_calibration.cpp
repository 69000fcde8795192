// SPDX-License-Identifier: MIT
#include <map>
#include <sstream>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace {

/// The text behind each key of a camera; lists over several lines are one text.
using KalibrFields = std::map<std::string, std::string, std::less<>>;

std::string_view trimmed(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    return begin == std::string_view::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

/// The part of YAML that a camchain has: `camN:` at the margin, below it `key: value`, values that go on in lines
/// beginning with "-" or inside brackets.
std::map<std::string, KalibrFields> camchainFields(const std::string& text) {
    std::map<std::string, KalibrFields> cameras;
    std::string camera, key;
    std::istringstream lines(text);
    for (std::string whole; std::getline(lines, whole);) {
        const std::string_view line = trimmed(whole);
        if (line.empty() || line[0] == '#' || line[0] == '%' || line == "---")
            continue;
        const std::size_t colon = line.find(':');
        if (whole[0] != ' ' && line.ends_with(':')) {
            camera = line.substr(0, colon);
            key.clear();
        } else if (line[0] == '-' || line[0] == '[' || colon == std::string_view::npos) {
            cameras[camera][key] +=
                " " + std::string(line[0] == '-' && line.substr(1, 1) == " " ? line.substr(1) : line);
        } else {
            key = line.substr(0, colon);
            cameras[camera][key] = trimmed(line.substr(colon + 1));
        }
    }
    return cameras;
}

/// A camera of the chain, with its name for errors.
struct KalibrCamera {
    const KalibrFields& fields;
    std::string name;
    std::string file;

    const std::string& text(std::string_view key) const {
        const auto found = fields.find(key);
        if (found == fields.end())
            throw Error(ErrorCode::BadInput, file, name + "." + std::string(key), "is missing");
        return found->second;
    }
    std::vector<double> numbers(std::string_view key, std::size_t count) const {
        std::string plain = text(key);
        for (char& c : plain)
            c = c == '[' || c == ']' || c == ',' ? ' ' : c;
        std::vector<double> values;
        for (const std::string_view word : splitWords(plain)) {
            values.emplace_back();
            if (!parseNumber(word, values.back()))
                throw Error(ErrorCode::BadInput, file, name + "." + std::string(key), "numbers are expected");
        }
        if (values.size() != count) {
            throw Error(ErrorCode::BadInput, file, name + "." + std::string(key),
                        std::to_string(count) + " numbers are expected, not " + std::to_string(values.size()));
        }
        return values;
    }
};

Camera cameraOfChain(const KalibrCamera& chain) {
    Camera camera;
    camera.name = chain.name;
    if (chain.text("camera_model") != "pinhole") {
        throw Error(ErrorCode::Unsupported, chain.file, chain.name + ".camera_model",
                    chain.text("camera_model") + " is not read, only pinhole");
    }
    const std::vector<double> size = chain.numbers("resolution", 2), k = chain.numbers("intrinsics", 4);
    camera.size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    camera.intrinsics << k[0], 0, k[2], 0, k[1], k[3], 0, 0, 1;
    const std::string& lens = chain.text("distortion_model");
    if (lens != "radtan" && lens != "equidistant" && lens != "none") {
        throw Error(ErrorCode::Unsupported, chain.file, chain.name + ".distortion_model",
                    lens + " is not read, only radtan, equidistant and none");
    }
    camera.fisheye = lens == "equidistant";
    if (lens != "none")
        camera.distortion = chain.numbers("distortion_coeffs", 4);
    return camera;
}

} // namespace

bool looksLikeKalibr(const CalibrationSource& source) {
    return source.hasExtension({".yaml", ".yml"}) && source.holds("camera_model:") &&
           source.holds("distortion_model:") && source.holds("intrinsics:");
}

std::vector<Camera> readKalibr(const CalibrationSource& source, const CalibrationOptions&) {
    const std::string file = source.path().string();
    const std::map<std::string, KalibrFields> chain = camchainFields(source.text());
    std::vector<Camera> cameras;
    for (std::size_t i = 0;; ++i) {
        const std::string name = "cam" + std::to_string(i);
        const auto found = chain.find(name);
        if (found == chain.end())
            return cameras;
        const KalibrCamera fields{found->second, name, file};
        Camera camera = cameraOfChain(fields);
        if (i > 0) { // the world is that of cam0
            const std::vector<double> m = fields.numbers("T_cn_cnm1", 16);
            RigidMotion fromPrevious;
            fromPrevious.rotation << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
            fromPrevious.translation << m[3], m[7], m[11];
            camera.cameraFromWorld = fromPrevious * cameras.back().cameraFromWorld;
        }
        cameras.push_back(camera);
    }
}

} // namespace core
