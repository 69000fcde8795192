// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace core {

/// A frame that was labelled without a click, as the review sees it.
struct ReviewFrame {
    int frame = 0;
    double doubt = 1;                             ///< of its most doubtful hand, 0 (sure) .. 1 (lost)
    bool isReviewed = false;                      ///< a person has accepted or corrected it
    std::optional<double> movedMm = std::nullopt; ///< mean distance that the person moved its joints; 0 if accepted
};

struct ReviewOptions {
    /// Tracking from a corrected frame ends at the first frame with less doubt: there is nothing to mend.
    double sureDoubt = 0.2;
    int reachFrames = 60;   ///< what tracking from a corrected frame mends halves over so many frames
    int mostGapFrames = 30; ///< frames that lie farther apart are not tracked into each other
};

/// A frame that waits for a look.
struct ReviewItem {
    int frame = 0;
    double doubt = 0;
    int neighbours = 0; ///< frames that tracking from this one would mend, to both sides
    double teach = 0;   ///< doubt x (1 + the doubts of the neighbours, halved every reachFrames)
};

/// The frames that nobody has looked at, in the order in which a look teaches most; equal ones by their numbers.
/// A look at a frame mends its unsure neighbours on both sides, up to the first that is sure or reviewed, or a gap.
/// `frames` in any order.
std::vector<ReviewItem> reviewOrder(std::vector<ReviewFrame> frames, const ReviewOptions& options = {});

/// How far a review has come.
struct ReviewProgress {
    int left = 0;     ///< frames that nobody has looked at
    int doubtful = 0; ///< of these, with a doubt of options.sureDoubt or more
    /// Mean error to be expected of the frames that are left, mm: what reviewed frames with about their doubts were
    /// moved by. None while fewer than three frames say how far they were moved, and while nothing was moved at all: a
    /// look alone finds no error of a few mm.
    std::optional<double> expectedErrorMm;
    bool isCorrected = false; ///< something was moved in a reviewed frame
};
ReviewProgress reviewProgress(const std::vector<ReviewFrame>& frames, const ReviewOptions& options = {});

} // namespace core
