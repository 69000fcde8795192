// SPDX-License-Identifier: MIT
#include "core/hand/finger_overlap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/numeric/median.h"

namespace core {

namespace {

constexpr std::size_t kFewestVertices = 8; ///< that give a bone a capsule
constexpr double kShortestMm = 1;

std::vector<std::vector<Eigen::Vector3d>> verticesPerBone(const HandModel& hand) {
    std::vector<std::vector<Eigen::Vector3d>> owned(hand.skeleton.bones.size());
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v) {
        const auto first = hand.weights.entries.begin() + hand.weights.firstEntry[v];
        const auto last = hand.weights.entries.begin() + hand.weights.firstEntry[v + 1];
        const auto most =
            std::max_element(first, last, [](const SkinWeight& a, const SkinWeight& b) { return a.weight < b.weight; });
        if (most != last)
            owned[static_cast<std::size_t>(most->bone)].push_back(hand.mesh.vertices[v]);
    }
    return owned;
}

/// The next joint of a chain, if its bone owns skin.
std::optional<Eigen::Vector3d> nextJoint(const Skeleton& skeleton, int bone,
                                         const std::vector<std::vector<Eigen::Vector3d>>& owned) {
    for (std::size_t b = 0; b < owned.size(); ++b)
        if (skeleton.bones[b].parent == bone && owned[b].size() >= kFewestVertices)
            return skeleton.bones[b].worldFromBoneAtRest.translation;
    return std::nullopt;
}

/// Where the skin of a last bone ends.
Eigen::Vector3d skinEnd(const Eigen::Vector3d& joint, const std::vector<Eigen::Vector3d>& skin) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& v : skin)
        mean += v / static_cast<double>(skin.size());
    const Eigen::Vector3d direction = (mean - joint).normalized();
    double length = 0;
    for (const Eigen::Vector3d& v : skin)
        length = std::max(length, direction.dot(v - joint));
    return joint + length * direction;
}

std::optional<BoneCapsule> boneCapsule(const Skeleton& skeleton, int bone,
                                       const std::vector<std::vector<Eigen::Vector3d>>& owned) {
    const std::vector<Eigen::Vector3d>& skin = owned[static_cast<std::size_t>(bone)];
    const std::optional<Eigen::Vector3d> next = nextJoint(skeleton, bone, owned);
    const auto parentOf = [&](int b) { return skeleton.bones[static_cast<std::size_t>(b)].parent; };
    BoneCapsule capsule;
    capsule.bone = capsule.finger = bone;
    while (parentOf(capsule.finger) > 0)
        capsule.finger = parentOf(capsule.finger);
    capsule.startAtRest = skeleton.bones[static_cast<std::size_t>(bone)].worldFromBoneAtRest.translation;
    capsule.endAtRest = next ? *next : skinEnd(capsule.startAtRest, skin);
    const double length = (capsule.endAtRest - capsule.startAtRest).norm();
    if (length < kShortestMm)
        return std::nullopt;
    const Eigen::Vector3d direction = (capsule.endAtRest - capsule.startAtRest) / length;
    std::vector<double> distances;
    for (const Eigen::Vector3d& v : skin) {
        const Eigen::Vector3d offset = v - capsule.startAtRest;
        const double along = direction.dot(offset);
        if (along > 0 && along < length)
            distances.push_back((offset - along * direction).norm());
    }
    if (distances.size() < kFewestVertices)
        return std::nullopt;
    capsule.radiusMm = medianOf(std::move(distances));
    capsule.isPalm = skeleton.bones[static_cast<std::size_t>(bone)].name.ends_with("_cmc");
    if (!next)
        capsule.endAtRest = capsule.startAtRest + std::max(kShortestMm, length - capsule.radiusMm) * direction;
    return capsule;
}

/// Where the closest points of the segments p + s u and q + t v lie, s and t in [0, 1].
std::pair<double, double> closestPoints(const Eigen::Vector3d& p, const Eigen::Vector3d& u, const Eigen::Vector3d& q,
                                        const Eigen::Vector3d& v) {
    const auto within = [](double x) { return std::clamp(x, 0.0, 1.0); };
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
    const double alongU = u.dot(p - q), alongV = v.dot(p - q);
    const double area = uu * vv - uv * uv; // of the parallelogram, squared
    double s = area > 1e-9 * uu * vv ? within((uv * alongV - vv * alongU) / area) : 0;
    double t = (uv * s + alongV) / vv;
    if (t < 0 || t > 1) {
        t = within(t);
        s = within((uv * t - alongU) / uu);
    }
    return {s, t};
}

/// Segments of a hand's capsules in the world: from start to start + along, mm.
struct PosedCapsules {
    std::vector<Eigen::Vector3d> start, along;
};

std::vector<PosedCapsules> posed(const HandCapsules& capsules, const std::vector<HandModel>& hands,
                                 const HandPoses& poses) {
    std::vector<PosedCapsules> all(hands.size());
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const Skeleton& skeleton = hands[h].skeleton;
        const std::vector<RigidMotion> worldFromBone = boneTransforms(skeleton, poses[h]);
        for (const BoneCapsule& capsule : capsules.capsules[h]) {
            const auto bone = static_cast<std::size_t>(capsule.bone);
            const RigidMotion worldFromRest = worldFromBone[bone] * inverse(skeleton.bones[bone].worldFromBoneAtRest);
            all[h].start.push_back(worldFromRest * capsule.startAtRest);
            all[h].along.push_back(worldFromRest.rotation * (capsule.endAtRest - capsule.startAtRest));
        }
    }
    return all;
}

CapsuleOverlap overlapOf(const HandCapsules& capsules, const CapsulePair& pair, const std::vector<PosedCapsules>& all) {
    const auto handA = static_cast<std::size_t>(pair.handA), handB = static_cast<std::size_t>(pair.handB);
    const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
    const BoneCapsule &one = capsules.capsules[handA][a], &other = capsules.capsules[handB][b];
    const Eigen::Vector3d &u = all[handA].along[a], &v = all[handB].along[b];
    const auto [s, t] = closestPoints(all[handA].start[a], u, all[handB].start[b], v);
    CapsuleOverlap overlap{pair.handA,
                           one.bone,
                           pair.handB,
                           other.bone,
                           0,
                           all[handA].start[a] + s * u,
                           all[handB].start[b] + t * v,
                           Eigen::Vector3d::UnitX()};
    const Eigen::Vector3d between = overlap.pointA - overlap.pointB;
    const double distance = between.norm();
    overlap.depthMm = one.radiusMm + other.radiusMm - pair.allowedMm - distance;
    if (distance > 1e-6)
        overlap.apart = between / distance;
    else if (u.cross(v).norm() > 1e-6 * u.norm() * v.norm())
        overlap.apart = u.cross(v).normalized(); // the axes cross: either side is as good
    return overlap;
}

bool mayOverlap(const BoneCapsule& a, const BoneCapsule& b) {
    return a.finger == b.finger || (a.isPalm && b.isPalm);
}

} // namespace

std::vector<BoneCapsule> boneCapsules(const HandModel& hand) {
    const std::vector<std::vector<Eigen::Vector3d>> owned = verticesPerBone(hand);
    std::vector<BoneCapsule> capsules;
    for (std::size_t b = 1; b < owned.size(); ++b)
        if (owned[b].size() >= kFewestVertices)
            if (const auto capsule = boneCapsule(hand.skeleton, static_cast<int>(b), owned))
                capsules.push_back(*capsule);
    return capsules;
}

HandCapsules handCapsules(const std::vector<HandModel>& hands) {
    HandCapsules made;
    HandPoses rest;
    for (const HandModel& hand : hands) {
        made.capsules.push_back(boneCapsules(hand));
        rest.push_back(hand.skeleton.restPose());
    }
    const std::vector<PosedCapsules> atRest = posed(made, hands, rest);
    const auto countOf = [&](int hand) {
        return static_cast<int>(made.capsules[static_cast<std::size_t>(hand)].size());
    };
    const auto capsule = [&](int hand, int c) -> const BoneCapsule& {
        return made.capsules[static_cast<std::size_t>(hand)][static_cast<std::size_t>(c)];
    };
    const int count = static_cast<int>(hands.size());
    for (int g = 0; g < count; ++g) {
        for (int h = g; h < count; ++h) {
            for (int a = 0; a < countOf(g); ++a) {
                for (int b = g == h ? a + 1 : 0; b < countOf(h); ++b) {
                    if (g == h && mayOverlap(capsule(g, a), capsule(h, b)))
                        continue;
                    CapsulePair pair{g, a, h, b, 0};
                    pair.allowedMm = g == h ? std::max(0.0, overlapOf(made, pair, atRest).depthMm) : 0;
                    made.pairs.push_back(pair);
                }
            }
        }
    }
    return made;
}

std::vector<CapsuleOverlap> capsuleOverlaps(const HandCapsules& capsules, const std::vector<HandModel>& hands,
                                            const HandPoses& poses) {
    const std::vector<PosedCapsules> all = posed(capsules, hands, poses);
    std::vector<CapsuleOverlap> found;
    for (const CapsulePair& pair : capsules.pairs) {
        const CapsuleOverlap overlap = overlapOf(capsules, pair, all);
        if (overlap.depthMm > 0)
            found.push_back(overlap);
    }
    return found;
}

Eigen::RowVectorXd overlapJacobian(const CapsuleOverlap& overlap, int hand, const Skeleton& skeleton,
                                   const DofAxes& axes) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(skeleton.poseSize());
    const auto addPoint = [&](int bone, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
        const auto isMovedBy = [&](int turned) {
            int b = bone;
            while (b > turned)
                b = skeleton.bones[static_cast<std::size_t>(b)].parent;
            return b == turned;
        };
        for (Eigen::Index k = 0; k < row.size(); ++k) {
            const auto i = static_cast<std::size_t>(k);
            if (k < 3)
                row[k] += direction.dot(axes.axisInWorld[i]);
            else if (k < kRigidDofs || isMovedBy(skeleton.dofs[i - kRigidDofs].bone))
                row[k] += direction.dot(axes.axisInWorld[i].cross(point - axes.pointInWorld[i]));
        }
    };
    if (overlap.handA == hand)
        addPoint(overlap.boneA, overlap.pointA, -overlap.apart);
    if (overlap.handB == hand)
        addPoint(overlap.boneB, overlap.pointB, overlap.apart);
    return row;
}

void addOverlaps(const std::vector<CapsuleOverlap>& overlaps, int hand, const Skeleton& skeleton, const Pose& pose,
                 double weight, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) {
    if (overlaps.empty())
        return;
    const DofAxes axes = dofAxes(skeleton, pose);
    for (const CapsuleOverlap& overlap : overlaps) {
        if (overlap.handA != hand && overlap.handB != hand)
            continue;
        const Eigen::VectorXd row = overlapJacobian(overlap, hand, skeleton, axes).head(gradient.size()).transpose();
        hessian.noalias() += weight * row * row.transpose();
        gradient += weight * overlap.depthMm * row;
    }
}

} // namespace core
