// SPDX-License-Identifier: MIT
#include "core/labelling/review_order.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr int kFewestMoved = 3;        ///< reviewed frames that an expectation is made from
constexpr double kSimilarDoubt = 0.15; ///< doubts this far apart still say something of each other
constexpr double kLeastWeight = 1e-3;  ///< of a reviewed frame with quite another doubt

/// Adds what tracking from frames[at] in one direction would mend.
void addNeighbours(const std::vector<ReviewFrame>& frames, std::size_t at, int direction, const ReviewOptions& options,
                   ReviewItem& item, double& mended) {
    std::size_t last = at;
    while (direction > 0 ? last + 1 < frames.size() : last > 0) {
        const std::size_t next = direction > 0 ? last + 1 : last - 1;
        const ReviewFrame& neighbour = frames[next];
        if (std::abs(neighbour.frame - frames[last].frame) > options.mostGapFrames || neighbour.isReviewed ||
            neighbour.doubt < options.sureDoubt)
            return;
        const double away = std::abs(neighbour.frame - frames[at].frame);
        mended += neighbour.doubt * std::exp2(-away / options.reachFrames);
        ++item.neighbours;
        last = next;
    }
}

/// What frames of that doubt were moved by: mean over the reviewed ones, those of similar doubt first of all.
double expectedMm(double doubt, const std::vector<ReviewFrame>& reviewed) {
    double sum = 0, weights = 0;
    for (const ReviewFrame& frame : reviewed) {
        const double apart = (frame.doubt - doubt) / kSimilarDoubt;
        const double weight = kLeastWeight + std::exp(-0.5 * apart * apart);
        sum += weight * *frame.movedMm;
        weights += weight;
    }
    return sum / weights;
}

} // namespace

std::vector<ReviewItem> reviewOrder(std::vector<ReviewFrame> frames, const ReviewOptions& options) {
    std::sort(frames.begin(), frames.end(),
              [](const ReviewFrame& a, const ReviewFrame& b) { return a.frame < b.frame; });
    std::vector<ReviewItem> items;
    for (std::size_t at = 0; at < frames.size(); ++at) {
        if (frames[at].isReviewed)
            continue;
        ReviewItem item{frames[at].frame, frames[at].doubt, 0, 0};
        double mended = 0;
        for (const int direction : {-1, 1})
            addNeighbours(frames, at, direction, options, item, mended);
        item.teach = item.doubt * (1 + mended);
        items.push_back(item);
    }
    std::stable_sort(items.begin(), items.end(),
                     [](const ReviewItem& a, const ReviewItem& b) { return a.teach > b.teach; });
    return items;
}

ReviewProgress reviewProgress(const std::vector<ReviewFrame>& frames, const ReviewOptions& options) {
    std::vector<ReviewFrame> moved;
    for (const ReviewFrame& frame : frames)
        if (frame.isReviewed && frame.movedMm)
            moved.push_back(frame);
    ReviewProgress progress;
    progress.isCorrected = std::any_of(moved.begin(), moved.end(), [](const ReviewFrame& f) { return *f.movedMm > 0; });
    double sum = 0;
    for (const ReviewFrame& frame : frames) {
        if (frame.isReviewed)
            continue;
        ++progress.left;
        progress.doubtful += frame.doubt >= options.sureDoubt ? 1 : 0;
        sum += moved.empty() ? 0 : expectedMm(frame.doubt, moved);
    }
    if (progress.left > 0 && progress.isCorrected && static_cast<int>(moved.size()) >= kFewestMoved)
        progress.expectedErrorMm = sum / progress.left;
    return progress;
}

} // namespace core
