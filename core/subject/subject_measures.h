// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/subject/hand_shape.h"

namespace core {

/// A length of the hand: that of the model and the measured one.
struct SubjectBone {
    std::string from, to; ///< joints; `to` is "tip" behind the last joint
    double modelMm = 0;
    double lengthMm = 0;
    double sigmaMm = 0;    ///< standard deviation of lengthMm
    double share = 0;      ///< how much longer it is than the hand's scale alone says: 0.05 = 5 %
    double shareSigma = 0; ///< standard deviation of share
    /// The proportions of this hand are not the model's here: |share| > 3 shareSigma, and more than 2 %.
    bool isUnlikeModel() const;
};

/// A number and its standard deviation.
struct Measured {
    double value = 0;
    double sigma = 0;
};

struct SubjectHand {
    HandModel hand;
    HandShape shape;
    Measured scale;   ///< mean length of the bones, tips aside, over the model's
    Measured girthMm; ///< mean offset of the surface along its normals; before the scale
    std::vector<SubjectBone> bones;
    int frames = 0;        ///< in which it is annotated; 0: everything follows from the other hand
    double jointRmsMm = 0; ///< of the annotated joints to those of the hand
};

/// A shape in numbers for people, with their deviations. `covariance`: of the shape. `outlineBiasMm`: by which all
/// outlines may lie outside or inside, added to the girth's deviation. `frames` and `jointRmsMm` stay 0.
SubjectHand measuredHand(const ShapeSpace& space, const HandShape& shape, const Eigen::MatrixXd& covariance,
                         double outlineBiasMm);

} // namespace core
