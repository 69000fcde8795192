// SPDX-License-Identifier: MIT
#include "core/subject/outline_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/contour/visible_rim.h"
#include "core/fitting/match_rule.h"
#include "core/numeric/median.h"

namespace core {

namespace {

constexpr int kCoverVertices = 700;

/// A hand as rims see it, and which vertex of the mesh each vertex of the full level is.
struct RimHand {
    SkinnedSurface full, cover;
    PosedPoints fullPosed, coverPosed;
    std::vector<int> meshVertex;
    std::vector<bool> left; ///< per mesh vertex: left out
};

std::vector<int> usedVertices(const TriangleMesh& mesh) {
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle)
            used[static_cast<std::size_t>(corner)] = true;
    std::vector<int> list;
    for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v])
            list.push_back(static_cast<int>(v));
    return list;
}

RimHand rimHand(const HandModel& model, const HandModel& hand, const Pose& pose) {
    RimHand rim;
    rim.full = makeSkinnedSurface(hand, 0);
    rim.cover = makeSkinnedSurface(hand, kCoverVertices);
    const BoneMatrices bones = boneMatrices(hand.skeleton, pose);
    poseSurface(rim.full, bones, rim.fullPosed);
    poseSurface(rim.cover, bones, rim.coverPosed);
    rim.meshVertex = usedVertices(hand.mesh);
    rim.left = beyondWrist(model);
    return rim;
}

OutlineMatch outlineMatch(const RimPoint& rim, const RimHand& hand, const CameraTarget& target, int contourPoint,
                          int frame) {
    OutlineMatch match;
    match.frame = frame;
    match.hand = rim.hand;
    match.vertexA = hand.meshVertex[static_cast<std::size_t>(rim.vertexA)];
    match.vertexB = hand.meshVertex[static_cast<std::size_t>(rim.vertexB)];
    match.t = static_cast<double>(rim.t);
    const Eigen::Vector3f onEdge = (1 - rim.t) * hand.fullPosed.positions[static_cast<std::size_t>(rim.vertexA)] +
                                   rim.t * hand.fullPosed.positions[static_cast<std::size_t>(rim.vertexB)];
    match.offset = (rim.point - onEdge).cast<double>();
    match.centre = target.centre;
    const Eigen::Vector3d& ray = target.rayDirection[static_cast<std::size_t>(contourPoint)];
    const Eigen::Vector3d normal = rim.normal.cast<double>();
    match.across = (normal - normal.dot(ray) * ray).normalized();
    return match;
}

} // namespace

std::vector<bool> beyondWrist(const HandModel& model) {
    const std::vector<Bone>& bones = model.skeleton.bones;
    const Eigen::Vector3d& wrist = bones[0].worldFromBoneAtRest.translation;
    Eigen::Vector3d knuckles = Eigen::Vector3d::Zero();
    int count = 0;
    for (const Bone& bone : bones) {
        if (bone.name.ends_with("_mcp")) {
            knuckles += bone.worldFromBoneAtRest.translation;
            ++count;
        }
    }
    std::vector<bool> beyond(model.mesh.vertices.size(), false);
    if (count == 0)
        return beyond;
    const Eigen::Vector3d axis = knuckles / count - wrist;
    constexpr double kMargin = 0.1; // of the way from wrist to knuckles
    for (std::size_t v = 0; v < beyond.size(); ++v) {
        beyond[v] = (model.mesh.vertices[v] - wrist).dot(axis) < kMargin * axis.squaredNorm();
        for (int e = model.weights.firstEntry[v]; bones[0].name == "forearm" && e < model.weights.firstEntry[v + 1];
             ++e) {
            const SkinWeight& w = model.weights.entries[static_cast<std::size_t>(e)];
            beyond[v] = beyond[v] || (w.bone == 0 && w.weight > 0.5);
        }
    }
    return beyond;
}

void matchOutlines(const std::vector<ShapeSpace>& spaces, const std::vector<HandModel>& hands, const HandPoses& poses,
                   const std::vector<Camera>& cameras, const std::vector<CameraTarget>& outlines, int frame,
                   const OutlineMatching& matching, std::vector<OutlineMatch>& matches) {
    std::vector<RimHand> rims;
    for (std::size_t h = 0; h < hands.size(); ++h)
        rims.push_back(rimHand(spaces[h].model(), hands[h], poses[h]));
    std::vector<RimSource> sources;
    for (const RimHand& rim : rims)
        sources.push_back({&rim.full, &rim.fullPosed, &rim.cover, &rim.coverPosed});
    MatchRule rule;
    rule.tauRad = static_cast<float>(std::numbers::pi / 8);
    rule.gatePx = static_cast<float>(matching.gatePx);
    RimOptions options;
    options.maxPoints = matching.pointsPerCamera;
    RimScratch scratch;
    std::vector<RimPoint> points;
    std::vector<WeightedMatch> found;
    for (const CameraTarget& target : outlines) {
        visibleRim(cameras[static_cast<std::size_t>(target.camera)], sources, options, scratch, points);
        for (const RimPoint& point : points) {
            const RimHand& hand = rims[static_cast<std::size_t>(point.hand)];
            const auto nearest = point.t < 0.5f ? point.vertexA : point.vertexB;
            if (hand.left[static_cast<std::size_t>(hand.meshVertex[static_cast<std::size_t>(nearest)])])
                continue;
            found.clear();
            findMatches(target, rule, point, found);
            for (const WeightedMatch& match : found)
                matches.push_back(outlineMatch(point, hand, target, match.index, frame));
        }
    }
}

double weighOutline(const std::vector<double>& residualsMm, double share, std::vector<OutlineMatch>& matches) {
    if (matches.empty())
        return 0;
    std::vector<double> sizes;
    for (const double residual : residualsMm)
        sizes.push_back(std::abs(residual));
    constexpr double kLeastMm = 0.05;
    const double sigma = std::max(kLeastMm, kSigmaPerMedian * medianOf(sizes));
    for (std::size_t i = 0; i < matches.size(); ++i) {
        const double relative = residualsMm[i] / (2 * sigma);
        matches[i].weight = share / (sigma * sigma) / (1 + relative * relative);
    }
    return sigma;
}

} // namespace core
