// SPDX-License-Identifier: MIT
#include "core/geometry/epipolar_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

/// Axis-aligned box of normalised coordinates.
struct Box {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d high = -low;
};

/// Normalised coordinates that the image of a camera can show: the box around its border, unbent.
Box visibleBox(const Camera& camera) {
    constexpr int kPerSide = 8;
    Box box;
    const Eigen::Vector2d corner(-0.5, -0.5), extent(camera.size.width, camera.size.height);
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < kPerSide; ++i) {
            const double along = static_cast<double>(i) / kPerSide;
            const Eigen::Vector2d unit = side == 0   ? Eigen::Vector2d(along, 0)
                                         : side == 1 ? Eigen::Vector2d(1, along)
                                         : side == 2 ? Eigen::Vector2d(1 - along, 1)
                                                     : Eigen::Vector2d(0, 1 - along);
            if (const auto n = undistort(camera, corner + extent.cwiseProduct(unit))) {
                box.low = box.low.cwiseMin(*n);
                box.high = box.high.cwiseMax(*n);
            }
        }
    }
    const Eigen::Vector2d margin = 0.05 * (box.high - box.low); // the border bulges between the samples
    box.low -= margin;
    box.high += margin;
    return box;
}

/// A stretch of the ray, in mm from its camera.
struct Stretch {
    double nearMm, farMm;
};

/// Keeps the part of the stretch where a + s b >= 0.
bool clip(Stretch& stretch, double a, double b) {
    if (b > 0)
        stretch.nearMm = std::max(stretch.nearMm, -a / b);
    else if (b < 0)
        stretch.farMm = std::min(stretch.farMm, -a / b);
    else if (a < 0)
        return false;
    return stretch.nearMm < stretch.farMm;
}

/// Clips origin + s direction (in the camera's frame) to the front of the camera and to the box; x/z >= low is linear
/// in s.
bool clipToView(Stretch& stretch, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, const Box& box) {
    constexpr double kNearestMm = 1e-3;
    if (!clip(stretch, origin.z() - kNearestMm, direction.z()))
        return false;
    for (int axis = 0; axis < 2; ++axis)
        if (!clip(stretch, origin[axis] - box.low[axis] * origin.z(),
                  direction[axis] - box.low[axis] * direction.z()) ||
            !clip(stretch, box.high[axis] * origin.z() - origin[axis],
                  box.high[axis] * direction.z() - direction[axis]))
            return false;
    return true;
}

/// Distance along the ray at which its image has gone the share t of the way between two distances: even steps in the
/// image.
double distanceAt(const Stretch& stretch, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double t) {
    const double depthNear = origin.z() + stretch.nearMm * direction.z();
    const double depthFar = origin.z() + stretch.farMm * direction.z();
    const double weightNear = (1 - t) * depthFar, weightFar = t * depthNear;
    return (weightNear * stretch.nearMm + weightFar * stretch.farMm) / (weightNear + weightFar);
}

/// Where the segment from an inner to an outer point leaves the image.
Eigen::Vector2d borderCrossing(const ImageSize& size, const Eigen::Vector2d& inner, const Eigen::Vector2d& outer) {
    const Eigen::Vector2d low(-0.5, -0.5), high(size.width - 0.5, size.height - 0.5);
    const Eigen::Vector2d way = outer - inner;
    double t = 1;
    for (int axis = 0; axis < 2; ++axis)
        if (way[axis] > 0)
            t = std::min(t, (high[axis] - inner[axis]) / way[axis]);
        else if (way[axis] < 0)
            t = std::min(t, (low[axis] - inner[axis]) / way[axis]);
    return inner + std::max(0.0, t) * way;
}

/// The first run of points inside the image, cut exactly at its border.
Polyline cutAtBorder(const Polyline& line, const ImageSize& size) {
    Polyline cut;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (isInside(size, line[i])) {
            if (cut.empty() && i > 0)
                cut.push_back(borderCrossing(size, line[i], line[i - 1]));
            cut.push_back(line[i]);
        } else if (!cut.empty()) {
            cut.push_back(borderCrossing(size, line[i - 1], line[i]));
            break;
        }
    }
    return cut;
}

/// Samples of the stretch, with the lens of the camera, evenly spaced before the lens.
Polyline sample(const Camera& camera, const Stretch& stretch, const Eigen::Vector3d& origin,
                const Eigen::Vector3d& direction, int segments) {
    Polyline line;
    for (int i = 0; i <= segments; ++i) {
        const double s = distanceAt(stretch, origin, direction, static_cast<double>(i) / segments);
        const Eigen::Vector3d p = origin + s * direction;
        const Eigen::Vector2d undistorted = p.head<2>() / p.z();
        if (!lensHolds(camera, undistorted)) {
            if (line.empty())
                continue; // it may come back into the image
            break;
        }
        const Eigen::Vector2d n = distort(camera, undistorted);
        line.push_back(camera.intrinsics.topLeftCorner<2, 2>() * n + camera.intrinsics.topRightCorner<2, 1>());
    }
    return line;
}

} // namespace

Polyline epipolarCurve(const Camera& from, const Eigen::Vector2d& px, const Camera& to, const RayRange& range) {
    const auto ray = viewingRay(from, px);
    const Eigen::Vector3d origin = to.cameraFromWorld * from.centreInWorld();
    constexpr double kSameCentreMm = 1e-6;
    if (!ray || origin.norm() < kSameCentreMm)
        return {};
    const Eigen::Vector3d direction = to.cameraFromWorld.rotation * ray->direction;
    Stretch stretch{range.nearMm, range.farMm};
    if (!clipToView(stretch, origin, direction, visibleBox(to)))
        return {};
    constexpr int kSegments = 64;
    return cutAtBorder(sample(to, stretch, origin, direction, kSegments), to.size);
}

std::optional<Eigen::Vector2d> nearestOnPolyline(const Polyline& polyline, const Eigen::Vector2d& px) {
    std::optional<Eigen::Vector2d> nearest;
    for (std::size_t i = 1; i < polyline.size(); ++i) {
        const Eigen::Vector2d way = polyline[i] - polyline[i - 1];
        const double length2 = way.squaredNorm();
        const double t = length2 > 0 ? std::clamp(way.dot(px - polyline[i - 1]) / length2, 0.0, 1.0) : 0.0;
        const Eigen::Vector2d candidate = polyline[i - 1] + t * way;
        if (!nearest || (candidate - px).squaredNorm() < (*nearest - px).squaredNorm())
            nearest = candidate;
    }
    return nearest;
}

} // namespace core
