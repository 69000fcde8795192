// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/annotation/sequence_points.h"
#include "core/hand/hand_model.h"

namespace core {

/// What a check found.
enum class QualityKind {
    Disagreement, ///< a click is an outlier, or two or more views give no point; value: px (without a point, off the other view's curve)
    BoneLength,   ///< value: percent away from the sequence's median
    JointAngle,   ///< the hand model would have to bend beyond its limits; value: degrees beyond
    FingerOrder,  ///< knuckles not in order, or two fingers exchanged; value: mm out of order
    HandMixUp,    ///< looks like the other hand; value: mm, or degrees of bending the wrong way
    SharedPixel   ///< two joints on one pixel; value: px between them
};
std::string_view qualityKindName(QualityKind kind); ///< "disagreement", "bone length", "joint angle", ...

/// One row of the list of doubts: it says where to look.
struct QualityFinding {
    int frame = 0;
    JointId joint;
    QualityKind kind = QualityKind::Disagreement;
    double value = 0;
    std::string text;   ///< English, for people
    std::string camera; ///< if it is about one view, else empty
    std::string curveOf{}; ///< camera on whose curve the click in `camera` should lie, where clicks give no point
    bool operator==(const QualityFinding&) const = default;
};

struct QualityOptions {
    TriangulationOptions triangulation;
    double boneLengthShare = 0.10;   ///< flagged if |length / median - 1| is above it
    int leastFramesForMedian = 3;    ///< bones seen in fewer frames are not judged
    double angleToleranceDeg = 10;   ///< flagged if an angle leaves its limits by more
    double knuckleToleranceMm = 2;   ///< flagged if knuckles are out of order by more
    double wrongBendDeg = 15;        ///< fingers bent backwards by more on average belong to the other hand
    double sharedPixelPx = 1;        ///< marks of one view nearer than this, unless their 3D points lie behind each other there
};

/// Length of each bone (by its far joint) in the median over a sequence, mm.
using BoneLengths = std::map<JointId, double>;
BoneLengths medianBoneLengths(const SequencePoints& points, int leastFrames);

/// The doubts about one rater's annotations of a sequence, kept up to date frame by frame: a frame is looked at again when its marks
/// have changed, and everything that depends on other frames (bone lengths, exchanged hands) is asked anew of the points that are
/// known. A value: copy it to look at a state from another thread.
class QualityChecker {
public:
    /// Angles are checked only with `hands`.
    QualityChecker(std::vector<Camera> cameras, std::vector<HandModel> hands, std::string rater, QualityOptions options = {});

    /// Looks at the marks of one frame.
    void check(const AnnotationSet& set, int frame);
    /// The doubts about all frames looked at, by frame.
    std::vector<QualityFinding> findings() const;
    const SequencePoints& points() const { return m_points; }

private:
    std::vector<Camera> m_cameras;
    std::vector<HandModel> m_hands;
    std::string m_rater;
    QualityOptions m_options;
    SequencePoints m_points;
    std::map<int, std::vector<QualityFinding>> m_markFindings; ///< what a frame's own marks say
};

/// The doubts about all frames of a sequence, by frame.
std::vector<QualityFinding> checkSequence(const AnnotationSet& set, const std::vector<Camera>& cameras, const std::string& rater,
                                          const std::vector<HandModel>& hands, const QualityOptions& options = {});

} // namespace core
