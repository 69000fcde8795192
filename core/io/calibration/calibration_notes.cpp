// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include "core/geometry/camera_faults.h"
#include "core/geometry/lens_coverage.h"
#include "core/io/calibration/calibration_notes.h"

namespace core {

namespace {

std::string number(double value, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

} // namespace

std::string unitNote(const std::vector<Camera>& cameras, double mmPerUnit) {
    const RigScale scale = rigScale(cameras);
    if (scale.likelyFactor == 1)
        return "";
    const std::string unit = scale.likelyFactor == 1000 ? "metres"
                             : scale.likelyFactor == 10 ? "centimetres"
                                                        : "millimetres";
    return "the cameras are " + number(scale.distanceMm, "%.3g") + " mm from " +
           (scale.hasTarget ? "where they look" : "each other") + ": is the calibration in " + unit +
           "? Then give --mm-per-unit " + number(mmPerUnit * scale.likelyFactor, "%g");
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
