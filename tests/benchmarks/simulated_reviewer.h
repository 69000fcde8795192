// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/labelling/auto_labels.h"
#include "core/labelling/proposal_review.h"
#include "core/labelling/retracking.h"
#include "tests/benchmarks/simulated_recording.h"

namespace trial {

struct ReviewerOptions {
    double clickPx = 1.5;     ///< standard deviation of a click per axis
    double seenPx = 5;        ///< a joint that is drawn so far off in some view is seen to be wrong
    double surenessMm = 1.25; ///< a corrected joint gets clicks in further views until it is as certain
    int looksPerFrame = 1; ///< joints of a frame that are corrected one after the other, as long as one is seen wrong
    bool refits = true;    ///< the frame's other joints follow a corrected one, as in the window
    std::uint64_t seed = 14;
};

/// A person who goes through the queue of a first pass: looks at the frame that comes first, corrects the joint that
/// deserves the first look (or one that is plainly wrong), accepts, and the hands are followed from there.
class SimulatedReviewer {
public:
    SimulatedReviewer(Recording& recording, core::PassResult pass, const core::PassOptions& passOptions,
                      const ReviewerOptions& options = {});

    /// Looks at the next frame. False if none is left.
    bool reviewOne();

    double errorMm() const;          ///< mean over all joints of all frames, as they are now
    double errorMm(int frame) const; ///< of one frame
    int clicks() const { return m_clicks; }
    int reviewed() const { return m_reviewed; }
    int lastFrame() const { return m_last; }
    const std::string& lastAct() const { return m_act; }

private:
    using Points = std::map<core::JointId, Eigen::Vector3d>;

    void apply(const core::Edit& edit);
    void look(int frame);
    void takeLabels(const core::AutoLabels& labels);
    std::vector<core::JointId> jointsToCorrect(const core::ProposedFrame& why) const;
    double offPx(int frame, const core::JointId& joint) const;
    void correct(int frame, const core::JointId& joint);
    void click(int frame, const core::JointId& joint, const std::string& camera);
    void follow(int frame);
    void refit(int frame);
    std::optional<Eigen::Vector3d> pointOf(int frame, const core::JointId& joint) const;

    Recording& m_recording;
    core::PassResult m_pass;
    core::PassOptions m_passOptions;
    ReviewerOptions m_options;
    std::mt19937_64 m_random;
    core::AnnotationSet m_set, m_proposed;
    core::ProposalReview m_review;
    std::map<int, Points> m_points; ///< as they are now
    std::set<int> m_done;           ///< accepted frames
    int m_clicks = 0, m_reviewed = 0, m_last = 0;
    std::string m_act;
};

} // namespace trial
