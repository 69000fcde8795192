// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/geometry/camera_target.h"
#include "core/geometry/lens_coverage.h"
#include "core/io/calibration/calibration_notes.h"

namespace core {

namespace {

constexpr double kNearMm = 20;   ///< nearer than any rig around a hand
constexpr double kFarMm = 200e3; ///< farther than any room is wide
constexpr double kCentimetresBelowMm = 100;
constexpr double kSideBySideMm = 5; ///< no two cameras with parallel axes stand closer

/// The middle one of the cameras' distances from where they look or, if they look past each other, from each other; 0
/// for a single camera.
double usualDistanceMm(const std::vector<Camera>& cameras) {
    const std::optional<Eigen::Vector3d> target = commonTarget(cameras);
    std::vector<double> distances;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const Eigen::Vector3d other = target ? *target : cameras[i == 0 ? cameras.size() - 1 : i - 1].centreInWorld();
        distances.push_back((cameras[i].centreInWorld() - other).norm());
    }
    std::sort(distances.begin(), distances.end());
    return distances.empty() ? 0 : distances[distances.size() / 2];
}

std::string number(double value, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

} // namespace

std::string unitNote(const std::vector<Camera>& cameras, double mmPerUnit) {
    const double distance = usualDistanceMm(cameras);
    if (cameras.size() < 2 || distance == 0)
        return "";
    const std::string where = "the cameras are " + number(distance, "%.3g") + " mm from " +
                              (commonTarget(cameras) ? "where they look" : "each other");
    const bool hasTarget = commonTarget(cameras).has_value();
    if (distance < (hasTarget ? kNearMm : kSideBySideMm))
        return where + ": is the calibration in metres? Then give --mm-per-unit " + number(mmPerUnit * 1000, "%g");
    if (hasTarget && distance < kCentimetresBelowMm)
        return where + ": is the calibration in centimetres? Then give --mm-per-unit " + number(mmPerUnit * 10, "%g");
    if (distance > kFarMm)
        return where + ": is the calibration in millimetres? Then give --mm-per-unit " + number(mmPerUnit / 1000, "%g");
    return "";
}

std::vector<std::string> lensNotes(const std::vector<Camera>& cameras) {
    std::vector<std::string> notes;
    for (const Camera& camera : cameras) {
        const double coverage = lensCoverage(camera);
        if (coverage < 1)
            notes.push_back(camera.name + ": the lens model holds in " + number(std::floor(100 * coverage), "%.0f") +
                            " % of the image");
    }
    return notes;
}

} // namespace core
