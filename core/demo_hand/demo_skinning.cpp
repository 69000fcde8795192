// SPDX-License-Identifier: MIT
#include "core/demo_hand/demo_skinning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

constexpr double kShareInPalmMm = 14;  ///< how much farther than the nearest ray another ray still has a share
constexpr double kShareInFingerMm = 2; ///< the same beyond the webs
constexpr int kSmoothings = 4;
constexpr int kMaxBones = 5;
constexpr double kLeastWeight = 0.01;

double smoothStep(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// How far beyond joint `j` of the ray the point lies, mm along the ray; negative before it.
double beyondJointMm(const RayShape& ray, int j, double at, const Eigen::Vector3d& point) {
    if (j == 0) // the path starts here: what lies before it is measured straight
        return (point - ray.joints[0]).dot((ray.joints[1] - ray.joints[0]).normalized());
    double sum = 0;
    const int last = static_cast<int>(ray.joints.size()) - 1;
    for (int s = std::min(j, static_cast<int>(at)); s <= std::max(j, std::min(static_cast<int>(at), last - 1)); ++s) {
        const double from = std::clamp(std::min(at, double(j)), double(s), s + 1.0);
        const double to = std::clamp(std::max(at, double(j)), double(s), s + 1.0);
        if (s < last)
            sum += (to - from) * (ray.joints[s + 1] - ray.joints[s]).norm();
    }
    return at < j ? -sum : sum;
}

/// Share of each ray in a vertex, summing to 1.
std::vector<double> rayShares(const DemoHandShape& shape, const std::vector<SweepPosition>& positions) {
    std::size_t nearest = 0;
    for (std::size_t r = 1; r < positions.size(); ++r)
        if (positions[r].distanceMm < positions[nearest].distanceMm)
            nearest = r;
    const double pastMcpMm = beyondJointMm(shape.rays[nearest], 1, positions[nearest].at, {});
    const double inFinger = smoothStep((pastMcpMm + 6) / 22);
    const double reach = kShareInPalmMm + inFinger * (kShareInFingerMm - kShareInPalmMm);
    std::vector<double> shares(positions.size());
    double sum = 0;
    for (std::size_t r = 0; r < positions.size(); ++r) {
        const double excess = positions[r].distanceMm - positions[nearest].distanceMm;
        shares[r] = std::pow(std::max(0.0, 1 - excess / reach), 2);
        sum += shares[r];
    }
    for (double& share : shares)
        share /= sum;
    return shares;
}

/// Dense row of weights, one per bone.
using WeightRow = Eigen::VectorXd;

WeightRow vertexWeights(const DemoHandShape& shape, const DemoHandSolid& solid,
                        const std::vector<std::vector<int>>& boneOfJoint, int boneCount,
                        const Eigen::Vector3d& vertex) {
    WeightRow row = WeightRow::Zero(boneCount);
    const std::vector<SweepPosition> positions = solid.alongRays(vertex);
    const std::vector<double> shares = rayShares(shape, positions);
    for (std::size_t r = 0; r < shape.rays.size(); ++r) {
        const RayShape& ray = shape.rays[r];
        double left = shares[r];
        int bone = 0;
        for (std::size_t j = 0; j < ray.bendMm.size(); ++j) {
            const double bend = ray.bendMm[j];
            const double beyond = beyondJointMm(ray, static_cast<int>(j), positions[r].at, vertex);
            const double passed = left * smoothStep((beyond + bend) / (2 * bend));
            row[bone] += left - passed;
            left = passed;
            bone = boneOfJoint[r][j];
        }
        row[bone] += left;
    }
    return row;
}

void smoothAlong(const TriangleMesh& mesh, std::vector<WeightRow>& rows) {
    const std::vector<MeshEdge> edges = meshEdges(mesh.triangles);
    for (int pass = 0; pass < kSmoothings; ++pass) {
        std::vector<WeightRow> sum(rows.size(), WeightRow::Zero(rows.front().size()));
        std::vector<double> count(rows.size(), 0);
        for (const MeshEdge& edge : edges) {
            sum[edge.vertexA] += rows[edge.vertexB];
            sum[edge.vertexB] += rows[edge.vertexA];
            ++count[edge.vertexA];
            ++count[edge.vertexB];
        }
        for (std::size_t v = 0; v < rows.size(); ++v)
            rows[v] = 0.5 * rows[v] + 0.5 * sum[v] / count[v];
    }
}

} // namespace

SkinWeights demoSkinWeights(const DemoHandShape& shape, const DemoHandSolid& solid, const Skeleton& skeleton,
                            const TriangleMesh& mesh) {
    std::vector<std::vector<int>> boneOfJoint;
    for (const RayShape& ray : shape.rays) {
        boneOfJoint.emplace_back();
        for (const std::string& name : rayJointNames(ray))
            boneOfJoint.back().push_back(skeleton.boneIndex(name));
    }
    const int boneCount = static_cast<int>(skeleton.bones.size());
    std::vector<WeightRow> rows;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        rows.push_back(vertexWeights(shape, solid, boneOfJoint, boneCount, vertex));
    smoothAlong(mesh, rows);
    SkinWeights weights{{0}, {}};
    for (const WeightRow& row : rows) {
        for (int b = 0; b < boneCount; ++b)
            if (row[b] > 0)
                weights.entries.push_back({b, row[b]});
        weights.firstEntry.push_back(static_cast<int>(weights.entries.size()));
    }
    return compressedWeights(weights, kMaxBones, kLeastWeight);
}

} // namespace core
