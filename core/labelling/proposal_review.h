// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/annotation/edit.h"
#include "core/annotation/sequence_points.h"
#include "core/geometry/camera.h"
#include "core/labelling/review_order.h"

namespace core {

/// Why a frame that a program labelled deserves a look.
enum class DoubtReason {
    Unsure,        ///< the program itself says so
    HandMissing,   ///< a hand that most frames have was not found
    JointsMissing, ///< joints that most frames have were not found
    BoneLength,    ///< a bone is longer or shorter than usual
    Jump           ///< the hand is not where the frames around have it
};

/// A frame that a program labelled for one rater.
struct ProposedFrame {
    int frame = 0;
    double doubt = 0;                 ///< of its most doubtful hand, 0 (sure) .. 1 (lost)
    std::map<Side, double> openHands; ///< the doubt of each hand with joints that wait for a look
    DoubtReason reason = DoubtReason::Unsure;
    /// What the reason is about: its hand; for Unsure and BoneLength the joint that deserves a look first.
    JointId joint = {};
    /// BoneLength: change of the bone that ends in the joint, share of its usual length. JointsMissing: how many. Jump:
    /// mm. Else 0.
    double value = 0;
    bool isReviewed = false;                      ///< no joint waits for a look
    std::optional<double> movedMm = std::nullopt; ///< mean over its joints of what a person moved them by
};

/// The frames that programs labelled for a rater, as a review sees them, kept up to date frame by frame.
class ProposalReview {
public:
    ProposalReview(std::vector<Camera> cameras, std::string rater);

    /// Looks at a frame anew. `set`: the annotations as they are. `proposed`: what programs proposed last, whatever
    /// became of it.
    void look(const AnnotationSet& set, const AnnotationSet& proposed, int frame);
    /// All frames with proposals, ascending.
    std::vector<ProposedFrame> frames() const;

private:
    struct SeenFrame {
        JointPoints points;                         ///< as a person put them, else as proposed
        std::map<JointId, double> openJoints;       ///< those that wait, by the doubt of the program
        double doubt = 0;                           ///< of the program: the greatest of its joints
        std::vector<double> movedMm;                ///< of the joints that a person has looked at
        std::map<Side, Eigen::Vector3d> handCentre; ///< mm
    };
    /// What the frames have in common.
    struct Usual;

    Usual usual() const;
    ProposedFrame judged(std::map<int, SeenFrame>::const_iterator at, const Usual& usual) const;
    double jumpMm(std::map<int, SeenFrame>::const_iterator at, Side hand, double& travelMm) const;

    std::vector<Camera> m_cameras;
    std::string m_rater;
    std::map<int, SeenFrame> m_seen;
};

/// As reviewOrder and reviewProgress take them.
std::vector<ReviewFrame> reviewFrames(const std::vector<ProposedFrame>& frames);

/// Follows an edit in what programs proposed: new proposals come, marks that were taken away go, and marks that a
/// person placed or accepted in their stead leave what was proposed as it is.
void followProposals(AnnotationSet& proposed, const Edit& edit);

} // namespace core
