// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/annotation/annotation_set.h"
#include "core/geometry/triangulation.h"

namespace core {

/// What a check found.
enum class QualityKind {
    Disagreement,  ///< a click is an outlier, or two or more views give no point; value: px (without a point, off the
                   ///< other view's curve)
    BoneLength,    ///< value: percent away from the sequence's median
    JointAngle,    ///< the hand model would have to bend beyond its limits; value: degrees beyond
    FingerOrder,   ///< knuckles not in order, or two fingers exchanged; value: mm out of order
    HandMixUp,     ///< looks like the other hand; value: mm, or degrees of bending the wrong way
    SharedPixel,   ///< two joints on one pixel; value: px between them
    OutsidePicture ///< a mark outside its view's image, which does not count; value: px from the image
};

/// "disagreement", "bone length", "joint angle", ...
constexpr std::string_view qualityKindName(QualityKind kind) {
    switch (kind) {
    case QualityKind::Disagreement:
        return "disagreement";
    case QualityKind::BoneLength:
        return "bone length";
    case QualityKind::JointAngle:
        return "joint angle";
    case QualityKind::FingerOrder:
        return "finger order";
    case QualityKind::HandMixUp:
        return "hand mix-up";
    case QualityKind::SharedPixel:
        return "shared pixel";
    case QualityKind::OutsidePicture:
        break;
    }
    return "outside the picture";
}

/// One row of the list of findings: it says where to look.
struct QualityFinding {
    int frame = 0;
    JointId joint;
    QualityKind kind = QualityKind::Disagreement;
    double value = 0;
    std::string text;      ///< English, for people
    std::string camera;    ///< if it is about one view, else empty
    std::string curveOf{}; ///< camera on whose curve the click in `camera` should lie, where clicks give no point
    bool operator==(const QualityFinding&) const = default;
};

struct QualityOptions {
    TriangulationOptions triangulation;
    double boneLengthShare = 0.10; ///< flagged if |length / median - 1| is above it
    int leastFramesForMedian = 3;  ///< bones seen in fewer frames are not judged
    double angleToleranceDeg = 10; ///< flagged if an angle leaves its limits by more
    double knuckleToleranceMm = 2; ///< flagged if knuckles are out of order by more
    double wrongBendDeg = 15;      ///< fingers bent backwards by more on average belong to the other hand
    double sharedPixelPx =
        1; ///< marks of one view nearer than this, unless their 3D points lie behind each other there
};

} // namespace core
