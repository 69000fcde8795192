// SPDX-License-Identifier: MIT
#include "core/subject/outline_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/fitting/match_rule.h"
#include "core/numeric/median.h"

namespace core {

namespace {

constexpr int kCoverVertices = 700;
constexpr double kOutlierSigmas = 4; ///< outlines between touching fingers lie outside: beyond, they have no weight

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

OutlineMatcher::OutlineMatcher(const std::vector<ShapeSpace>& spaces, const std::vector<HandModel>& hands) {
    for (std::size_t h = 0; h < hands.size(); ++h) {
        RimHand& rim = m_rims.emplace_back();
        rim.full = makeSkinnedSurface(hands[h], 0);
        rim.cover = makeSkinnedSurface(hands[h], kCoverVertices);
        rim.meshVertex = usedVertices(hands[h].mesh);
        rim.leftOut = beyondWrist(spaces[h].model());
        m_skeletons.push_back(hands[h].skeleton);
    }
}

OutlineMatch OutlineMatcher::outlineMatch(const RimPoint& rim, std::size_t hand, const CameraTarget& target,
                                          int contourPoint, int frame) const {
    const RimHand& source = m_rims[hand];
    OutlineMatch match;
    match.frame = frame;
    match.hand = static_cast<int>(hand);
    match.vertexA = source.meshVertex[static_cast<std::size_t>(rim.vertexA)];
    match.vertexB = source.meshVertex[static_cast<std::size_t>(rim.vertexB)];
    match.t = static_cast<double>(rim.t);
    const Eigen::Vector3f onEdge = (1 - rim.t) * source.fullPosed.positions[static_cast<std::size_t>(rim.vertexA)] +
                                   rim.t * source.fullPosed.positions[static_cast<std::size_t>(rim.vertexB)];
    match.offset = (rim.point - onEdge).cast<double>();
    match.centre = target.centre;
    const Eigen::Vector3d& ray = target.rayDirection[static_cast<std::size_t>(contourPoint)];
    const Eigen::Vector3d normal = rim.normal.cast<double>();
    match.across = (normal - normal.dot(ray) * ray).normalized();
    return match;
}

void OutlineMatcher::match(const HandPoses& poses, const std::vector<Camera>& cameras,
                           const std::vector<CameraTarget>& outlines, int frame, const OutlineMatching& matching,
                           std::vector<OutlineMatch>& matches) {
    std::vector<RimSource> sources;
    std::vector<std::size_t> handOf;
    for (std::size_t h = 0; h < m_rims.size(); ++h) {
        if (poses[h].size() == 0)
            continue;
        RimHand& rim = m_rims[h];
        const BoneMatrices bones = boneMatrices(m_skeletons[h], poses[h]);
        poseSurface(rim.full, bones, rim.fullPosed);
        poseSurface(rim.cover, bones, rim.coverPosed);
        sources.push_back({&rim.full, &rim.fullPosed, &rim.cover, &rim.coverPosed});
        handOf.push_back(h);
    }
    MatchRule rule;
    rule.tauRad = static_cast<float>(std::numbers::pi / 8);
    rule.gatePx = static_cast<float>(matching.gatePx);
    RimOptions options;
    options.maxPoints = matching.pointsPerCamera;
    std::vector<RimPoint> points;
    std::vector<WeightedMatch> found;
    for (const CameraTarget& target : outlines) {
        visibleRim(cameras[static_cast<std::size_t>(target.camera)], sources, options, m_scratch, points);
        for (const RimPoint& point : points) {
            const std::size_t hand = handOf[static_cast<std::size_t>(point.hand)];
            const RimHand& rim = m_rims[hand];
            const auto nearest = static_cast<std::size_t>(point.t < 0.5f ? point.vertexA : point.vertexB);
            if (rim.leftOut[static_cast<std::size_t>(rim.meshVertex[nearest])])
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
        const double relative = residualsMm[i] / (kOutlierSigmas * sigma);
        const double kept = std::max(0.0, 1 - relative * relative);
        matches[i].weight = share / (sigma * sigma) * kept * kept;
    }
    return sigma;
}

} // namespace core
