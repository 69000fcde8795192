// SPDX-License-Identifier: MIT
#include "core/subject/subject_measures.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

using Eigen::VectorXd;

/// Mean of each bone's weight over the surface.
VectorXd meanWeights(const HandModel& model) {
    VectorXd mean = VectorXd::Zero(static_cast<Eigen::Index>(model.skeleton.bones.size()));
    for (const SkinWeight& w : model.weights.entries)
        mean[w.bone] += w.weight / static_cast<double>(model.mesh.vertices.size());
    return mean;
}

Measured linearised(double value, const VectorXd& slope, const Eigen::MatrixXd& covariance) {
    return {value, std::sqrt(std::max(0.0, slope.dot(covariance * slope)))};
}

/// d length / d shape of a segment.
VectorXd lengthSlope(const ShapeSpace& space, int segment, const HandShape& shape) {
    VectorXd slope = VectorXd::Zero(space.size());
    slope[0] = space.lengthMm(segment, shape);
    slope[space.lengthIndex(segment)] = slope[0] / (1 + shape[space.lengthIndex(segment)]);
    return slope;
}

SubjectBone measuredBone(const ShapeSpace& space, int index, const HandShape& shape,
                         const Eigen::MatrixXd& covariance) {
    const auto& bones = space.model().skeleton.bones;
    const ShapeSegment& segment = space.segments()[static_cast<std::size_t>(index)];
    const Measured length = linearised(space.lengthMm(index, shape), lengthSlope(space, index, shape), covariance);
    SubjectBone bone;
    bone.from = bones[static_cast<std::size_t>(segment.bone)].name;
    bone.to = segment.end < 0 ? "tip" : bones[static_cast<std::size_t>(segment.end)].name;
    bone.modelMm = segment.alongAtRest.norm();
    bone.lengthMm = length.value;
    bone.sigmaMm = length.sigma;
    const int at = space.lengthIndex(index);
    bone.share = shape[at];
    bone.shareSigma = std::sqrt(std::max(0.0, covariance(at, at)));
    return bone;
}

} // namespace

bool SubjectBone::isUnlikeModel() const {
    constexpr double kLeastShare = 0.02, kSigmas = 3;
    return std::abs(share) > std::max(kLeastShare, kSigmas * shareSigma);
}

SubjectHand measuredHand(const ShapeSpace& space, const HandShape& shape, const Eigen::MatrixXd& covariance,
                         double outlineBiasMm) {
    SubjectHand result;
    result.shape = shape;
    result.hand = space.shaped(shape);
    VectorXd sumSlope = VectorXd::Zero(space.size());
    double sum = 0, modelSum = 0;
    for (int a = 0; a < space.segmentCount(); ++a) {
        result.bones.push_back(measuredBone(space, a, shape, covariance));
        const SubjectBone& bone = result.bones.back();
        if (bone.to.ends_with("tip"))
            continue;
        sumSlope += lengthSlope(space, a, shape);
        sum += bone.lengthMm;
        modelSum += bone.modelMm;
    }
    if (modelSum > 0)
        result.scale = linearised(sum / modelSum, sumSlope / modelSum, covariance);
    VectorXd slope = VectorXd::Zero(space.size());
    slope[1] = 1;
    slope.segment(space.girthIndex(0), space.boneCount()) = meanWeights(space.model());
    result.girthMm = linearised(slope.dot(shape), slope, covariance);
    result.girthMm.sigma = std::hypot(result.girthMm.sigma, outlineBiasMm);
    return result;
}

} // namespace core
