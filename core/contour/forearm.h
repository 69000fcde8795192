// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"
#include "core/geometry/rigid_motion.h"
#include "core/hand/hand_model.h"

namespace core {

/// A convex polygon of a picture, px. Empty: it holds no point.
class ConvexRegion {
public:
    ConvexRegion() = default;
    /// The convex hull of the points; empty if they span no area.
    explicit ConvexRegion(const std::vector<Eigen::Vector2f>& points);

    bool contains(const Eigen::Vector2f& px) const;
    /// The first and the last x of the row y that are inside; no value where the row is outside.
    std::optional<std::pair<float, float>> span(float y) const;
    bool empty() const { return m_corners.empty(); }
    bool operator==(const ConvexRegion&) const = default;

private:
    std::vector<Eigen::Vector2f> m_corners; ///< one after another around the polygon
    Eigen::Vector2f m_low = Eigen::Vector2f::Zero(), m_high = Eigen::Vector2f::Zero();
};

/// Where a hand model ends towards the forearm: the part of a hand's silhouette that the model cannot explain lies
/// beyond the cut, a plane a little on the hand's side of the model's end. In the rest pose's frame, mm.
struct ForearmCut {
    Eigen::Vector3d centre;    ///< of the model's section with the plane
    Eigen::Vector3d direction; ///< unit, from the hand towards the elbow
    double radiusMm = 0;       ///< of the section
    double endMm = 0;          ///< how far beyond the plane the model ends
};
ForearmCut forearmCut(const HandModel& hand);

/// The cut where a sleeve, which is wider than the wrist, begins `mm` before it.
ForearmCut movedTowardsHand(ForearmCut cut, double mm);

/// Where a forearm beyond the cut may be seen: the hull of a cone that opens with 0.2 mm per mm over 300 mm and goes on
/// as wide for another 200 mm. Parts near or behind the camera, or an image beside the picture, are left out.
/// worldFromRest: the motion of the hand's root bone.
ConvexRegion forearmRegion(const Camera& camera, const ForearmCut& cut, const RigidMotion& worldFromRest);

/// Points on the forearm's axis that the model does not reach, 25 to 120 mm beyond its end, in the world.
std::vector<Eigen::Vector3d> forearmAxis(const ForearmCut& cut, const RigidMotion& worldFromRest);

} // namespace core
