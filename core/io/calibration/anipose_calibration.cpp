// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <sstream>

#include <toml++/toml.h>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/text/number_text.h"

namespace core {

namespace {

toml::table parseToml(const CalibrationSource& source) {
    try {
        return toml::parse(source.text());
    } catch (const toml::parse_error& failure) {
        throw Error(ErrorCode::BadInput, source.path().string(), "line " + std::to_string(failure.source().begin.line),
                    "not TOML: " + std::string(failure.description()));
    }
}

/// A section of the file, with its name for errors.
struct Section {
    const toml::table& table;
    std::string name;
    std::string file;

    Error bad(const std::string& key, const std::string& detail) const {
        return Error(ErrorCode::BadInput, file, name + "." + key, detail);
    }
    const toml::array& array(const std::string& key) const {
        const toml::array* found = table[key].as_array();
        if (found == nullptr)
            throw bad(key, "a list is expected");
        return *found;
    }
};

void appendNumbers(std::vector<double>& numbers, const toml::array& list, const Section& section,
                   const std::string& key) {
    for (const toml::node& node : list) {
        if (const toml::array* inner = node.as_array()) {
            appendNumbers(numbers, *inner, section, key);
            continue;
        }
        const std::optional<double> value = node.value<double>();
        if (!value || !std::isfinite(*value))
            throw section.bad(key, "holds a value that is not a finite number");
        numbers.push_back(*value);
    }
}

std::vector<double> numbersOf(const Section& section, const std::string& key) {
    std::vector<double> numbers;
    appendNumbers(numbers, section.array(key), section, key);
    return numbers;
}

Camera cameraOf(const Section& section) {
    const auto field = [&](const char* key) { return section.name + "." + key; };
    Camera camera;
    camera.name = section.table["name"].value<std::string>().value_or(section.name);
    const std::vector<double> size = numbersOf(section, "size");
    if (size.size() != 2 || size[0] < 1 || size[1] < 1 || size[0] > 1e5 || size[1] > 1e5)
        throw section.bad("size", "width and height are expected");
    camera.size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    camera.intrinsics = rowMajorMatrix(numbersOf(section, "matrix"), section.file, field("matrix"));
    camera.distortion = numbersOf(section, "distortions");
    camera.fisheye = section.table["fisheye"].value<bool>().value_or(false);
    camera.cameraFromWorld.rotation = rotationOf(numbersOf(section, "rotation"), section.file, field("rotation"));
    camera.cameraFromWorld.translation =
        vectorOf(numbersOf(section, "translation"), section.file, field("translation"));
    return camera;
}

std::string tomlFloat(double value) {
    const std::string text = exactText(value);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text; // a TOML float needs a point
}

template <typename List>
std::string numberList(const List& values) {
    std::string text = "[ ";
    for (const double value : values)
        text += tomlFloat(value) + ", ";
    return text + "]";
}

std::string tomlString(const std::string& text) {
    std::ostringstream out;
    out << toml::value<std::string>(text);
    return out.str();
}

std::string formatCamera(const Camera& camera, std::size_t index) {
    std::vector<double> lens = camera.distortion;
    lens.resize(camera.fisheye ? 4 : std::max<std::size_t>(5, lens.size()), 0); // Anipose writes five, zeros too
    std::string rows;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d row = camera.intrinsics.row(i).transpose();
        rows += numberList(row) + ", ";
    }
    const Eigen::Vector3d rotation = rotationLog(camera.cameraFromWorld.rotation);
    return "[cam_" + std::to_string(index) + "]\nname = " + tomlString(camera.name) + "\nsize = [ " +
           std::to_string(camera.size.width) + ", " + std::to_string(camera.size.height) + ",]\nmatrix = [ " + rows +
           "]\ndistortions = " + numberList(lens) + "\nrotation = " + numberList(rotation) +
           "\ntranslation = " + numberList(Eigen::Vector3d(camera.cameraFromWorld.translation)) +
           "\nfisheye = " + (camera.fisheye ? "true" : "false") + "\n\n";
}

} // namespace

bool looksLikeAnipose(const CalibrationSource& source) {
    return source.hasExtension({".toml"});
}

std::vector<Camera> readAnipose(const CalibrationSource& source, const CalibrationOptions&) {
    const std::string file = source.path().string();
    const toml::table document = parseToml(source);
    std::vector<Camera> cameras;
    for (const auto& [key, node] : document) {
        const std::string name(key.str());
        if (const toml::table* table = node.as_table(); table != nullptr && name != "metadata")
            cameras.push_back(cameraOf({*table, name, file}));
    }
    return cameras;
}

bool looksLikeCaliscope(const CalibrationSource& source) {
    return source.hasExtension({".toml"}) && source.holds("rotation_count");
}

std::vector<Camera> readCaliscope(const CalibrationSource& source, const CalibrationOptions&) {
    const std::string file = source.path().string();
    const toml::table document = parseToml(source);
    const toml::table* list = document["cameras"].as_table(); // newer files; older ones have [cam_N] at the top
    std::vector<Camera> cameras;
    for (const auto& [key, node] : list != nullptr ? *list : document) {
        const std::string number(key.str());
        const toml::table* table = node.as_table();
        if (table == nullptr || (list == nullptr && !number.starts_with("cam_")))
            continue;
        // Cameras without a place in the world stay out.
        if ((*table)["ignore"].value<bool>().value_or(false) || !(*table)["translation"].is_array())
            continue;
        const std::string name = list == nullptr ? number : "cam_" + number;
        cameras.push_back(cameraOf({*table, name, file}));
    }
    return cameras;
}

std::string formatAnipose(const std::vector<Camera>& cameras) {
    std::string text;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        text += formatCamera(cameras[i], i);
    return text + "[metadata]\nadjusted = false\nerror = 0.0\n";
}

} // namespace core
