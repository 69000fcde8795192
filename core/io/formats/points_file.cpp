// SPDX-License-Identifier: MIT
#include "core/io/formats/points_file.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

Observation observationFromJson(const json& view, const std::vector<Camera>& cameras, const std::string& file,
                                const std::string& field) {
    const std::string name = view["camera"];
    const auto camera = std::find_if(cameras.begin(), cameras.end(),
                                     [&name](const Camera& candidate) { return candidate.name == name; });
    if (camera == cameras.end())
        throw Error(ErrorCode::BadInput, file, field + ".camera", "unknown camera \"" + name + "\"");
    const std::vector<double> px = jsonNumbers(view["px"], 2, file, field + ".px");
    return {static_cast<int>(camera - cameras.begin()), {px[0], px[1]}};
}

} // namespace

std::vector<PointClicks> readPointClicks(const std::filesystem::path& file, const std::vector<Camera>& cameras) {
    const json value = readJsonFile(file);
    checkSchema(value, "points", file.string());
    std::vector<PointClicks> points;
    for (const json& item : value["points"]) {
        PointClicks point{item["id"], {}};
        const std::string field = "points[" + std::to_string(points.size()) + "].views";
        for (const json& view : item["views"]) {
            const std::string viewField = field + "[" + std::to_string(point.observations.size()) + "]";
            const Observation click = observationFromJson(view, cameras, file.string(), viewField);
            for (const Observation& other : point.observations) {
                if (other.camera == click.camera) {
                    throw Error(ErrorCode::BadInput, file.string(), viewField + ".camera",
                                "occurs twice in this point");
                }
            }
            point.observations.push_back(click);
        }
        points.push_back(std::move(point));
    }
    return points;
}

void writeTriangulatedPoints(const std::filesystem::path& file, const std::vector<Camera>& cameras,
                             const std::vector<PointClicks>& points, const std::vector<TriangulationResult>& results) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        ordered_json inliers = ordered_json::array(), outliers = ordered_json::array();
        const auto& point = results[i].point;
        for (std::size_t k = 0; point && k < points[i].observations.size(); ++k) {
            (point->inlier[k] ? inliers : outliers)
                .push_back(cameras[static_cast<std::size_t>(points[i].observations[k].camera)].name);
        }
        list.push_back({{"id", points[i].id},
                        {"xyz", point ? jsonOf(point->pointInWorld) : ordered_json()},
                        {"covariance", point ? jsonOf(point->covariance) : ordered_json()},
                        {"rmsPx", point ? ordered_json(point->rmsPx) : ordered_json()},
                        {"inliers", inliers},
                        {"outliers", outliers},
                        {"reason", failureText(results[i].failure)}});
    }
    writeJsonFile(file, {{"points", list}});
}

} // namespace core
