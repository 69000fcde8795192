// SPDX-License-Identifier: MIT
#include "core/contour/forearm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace core {

namespace {

constexpr double kMarginMm = 25;   ///< of the model's end, where it is a rounded cap
constexpr double kSectionMm = 8;   ///< vertices so near to the plane belong to the section
constexpr double kOpening = 0.2;   ///< mm per mm: a forearm widens, and may be bent against the hand
constexpr double kOpeningMm = 300; ///< beyond, it keeps its width
constexpr double kLengthMm = 500;
constexpr double kStepMm = 50;
constexpr double kSleeveMm = 10;  ///< by which a sleeve is wider than the wrist
constexpr int kCorners = 12;      ///< of the cone's circles
constexpr double kNearestMm = 50; ///< of what is projected to the camera

/// Twice the signed area of the triangle.
float turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Appends the circle's pixels. False if any of it cannot be seen in or around the picture.
bool appendCircle(const Camera& camera, const Eigen::Vector3d& centre, const Eigen::Vector3d& direction,
                  double radiusMm, std::vector<Eigen::Vector2f>& points) {
    const Eigen::Vector3d u = direction.unitOrthogonal(), v = direction.cross(u);
    std::vector<Eigen::Vector2f> circle;
    for (int k = 0; k < kCorners; ++k) {
        const double angle = 2 * std::numbers::pi * k / kCorners;
        const Eigen::Vector3d point = centre + radiusMm * (std::cos(angle) * u + std::sin(angle) * v);
        const Eigen::Vector3d pointInCamera = camera.cameraFromWorld * point;
        const auto px = pointInCamera.z() > kNearestMm ? project(camera, point) : std::nullopt;
        if (!px || px->x() < -camera.size.width || px->y() < -camera.size.height || px->x() > 2 * camera.size.width ||
            px->y() > 2 * camera.size.height)
            return false;
        circle.push_back(px->cast<float>());
    }
    points.insert(points.end(), circle.begin(), circle.end());
    return true;
}

} // namespace

ConvexRegion::ConvexRegion(const std::vector<Eigen::Vector2f>& points) {
    std::vector<cv::Point2f> all, hull;
    for (const Eigen::Vector2f& p : points)
        all.emplace_back(p.x(), p.y());
    if (all.size() >= 3)
        cv::convexHull(all, hull);
    if (hull.size() < 3)
        return;
    m_low = m_high = {hull.front().x, hull.front().y};
    for (const cv::Point2f& p : hull) {
        m_corners.emplace_back(p.x, p.y);
        m_low = m_low.cwiseMin(m_corners.back());
        m_high = m_high.cwiseMax(m_corners.back());
    }
    float area = 0;
    for (std::size_t k = 1; k + 1 < m_corners.size(); ++k)
        area += turn(m_corners[0], m_corners[k], m_corners[k + 1]);
    if (area < 0)
        std::reverse(m_corners.begin(), m_corners.end());
}

bool ConvexRegion::contains(const Eigen::Vector2f& px) const {
    if (empty() || (px.array() < m_low.array()).any() || (px.array() > m_high.array()).any())
        return false;
    for (std::size_t k = 0; k < m_corners.size(); ++k)
        if (turn(m_corners[k], m_corners[(k + 1) % m_corners.size()], px) < 0)
            return false;
    return true;
}

std::optional<std::pair<float, float>> ConvexRegion::span(float y) const {
    if (empty() || y < m_low.y() || y > m_high.y())
        return std::nullopt;
    float left = std::numeric_limits<float>::infinity(), right = -left;
    for (std::size_t k = 0; k < m_corners.size(); ++k) {
        const Eigen::Vector2f &a = m_corners[k], &b = m_corners[(k + 1) % m_corners.size()];
        if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y)
            continue;
        const float x = a.y() == b.y() ? b.x() : a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
        left = std::min({left, x, a.y() == b.y() ? a.x() : x});
        right = std::max({right, x, a.y() == b.y() ? a.x() : x});
    }
    return std::pair(left, right);
}

ForearmCut forearmCut(const HandModel& hand) {
    const std::vector<Bone>& bones = hand.skeleton.bones;
    const Eigen::Vector3d root = bones.front().worldFromBoneAtRest.translation;
    Eigen::Vector3d fingers = Eigen::Vector3d::Zero();
    for (std::size_t b = 1; b < bones.size(); ++b)
        fingers += bones[b].worldFromBoneAtRest.translation / static_cast<double>(bones.size() - 1);
    ForearmCut cut;
    cut.direction = (root - fingers).norm() > 1e-6 ? (root - fingers).normalized() : Eigen::Vector3d(0, 0, -1);
    double end = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& v : hand.mesh.vertices)
        end = std::max(end, cut.direction.dot(v - root));
    const double plane = end - kMarginMm;
    std::vector<Eigen::Vector3d> section;
    cut.centre = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& v : hand.mesh.vertices) {
        const double along = cut.direction.dot(v - root);
        if (std::abs(along - plane) < kSectionMm)
            section.push_back(v - (along - plane) * cut.direction);
    }
    if (section.empty())
        section.push_back(root + plane * cut.direction);
    for (const Eigen::Vector3d& v : section)
        cut.centre += v / static_cast<double>(section.size());
    for (const Eigen::Vector3d& v : section)
        cut.radiusMm = std::max(cut.radiusMm, (v - cut.centre).norm());
    cut.endMm = end - plane;
    return cut;
}

ConvexRegion forearmRegion(const Camera& camera, const ForearmCut& cut, const RigidMotion& worldFromRest) {
    std::vector<Eigen::Vector2f> points;
    const Eigen::Vector3d direction = worldFromRest.rotation * cut.direction;
    for (double along = 0; along <= kLengthMm; along += kStepMm) {
        const Eigen::Vector3d centre = worldFromRest * (cut.centre + along * cut.direction);
        if (!appendCircle(camera, centre, direction, cut.radiusMm + kOpening * std::min(along, kOpeningMm), points))
            break;
    }
    return ConvexRegion(points);
}

std::vector<Eigen::Vector3d> forearmAxis(const ForearmCut& cut, const RigidMotion& worldFromRest) {
    std::vector<Eigen::Vector3d> axis;
    for (double beyond = 25; beyond <= 120; beyond += 5)
        axis.push_back(worldFromRest * (cut.centre + (cut.endMm + beyond) * cut.direction));
    return axis;
}

ForearmCut movedTowardsHand(ForearmCut cut, double mm) {
    cut.centre -= mm * cut.direction;
    cut.radiusMm += kSleeveMm;
    cut.endMm += mm;
    return cut;
}

} // namespace core
