// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "core/annotation/sequence_points.h"
#include "core/io/dataset/dataset.h"
#include "core/segmentation/silhouette.h"

namespace core {

/// Where it is known from how hands are posed.
enum class EvidenceOrigin { None, RecordedMotion, Labels, Annotations, Detector };
/// "none", "motion", "labels", "annotations", "detector": as segmentation.json holds it.
std::string_view originName(EvidenceOrigin origin);

/// What a sequence's silhouettes are looked for by, frame by frame. May be asked from several threads at once.
class SequenceEvidence {
public:
    SequenceEvidence() = default;
    /// Recorded poses.
    SequenceEvidence(std::vector<HandModel> hands, Motion motion);
    /// Joints in space; poses are fitted to them where they are asked for.
    SequenceEvidence(std::vector<HandModel> hands, SequencePoints points, EvidenceOrigin origin);

    EvidenceOrigin origin() const { return m_origin; }
    /// How many of these frames something is known of.
    int countKnown(const std::vector<int>& frames) const;
    /// What the method can use; empty parts where it is not known.
    HandEvidence at(int frame, SegmentationMethod method) const;

private:
    std::vector<HandModel> m_hands;
    Motion m_motion;
    SequencePoints m_points;
    EvidenceOrigin m_origin = EvidenceOrigin::None;
};

/// The joints of a ground truth file (as autolabel writes it) that have a point; of several raters the first one with
/// that joint. Throws Error: BadInput if it is not such a file or is of another sequence.
SequencePoints readLabelPoints(const std::filesystem::path& file, const Sequence& sequence);

/// The joints that a sequence's annotations give, of all raters: of several the first one with that joint.
SequencePoints readAnnotationPoints(const Dataset& dataset, const Sequence& sequence);

} // namespace core
