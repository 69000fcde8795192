// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace core {

/// A camera that moved once, between two annotated frames.
struct CameraStep {
    int lastFrameBefore = 0;                            ///< the last annotated frame before the move
    int frame = 0;                                      ///< the first one after it
    Eigen::Vector2d beforePx = Eigen::Vector2d::Zero(); ///< mean residual before
    Eigen::Vector2d afterPx = Eigen::Vector2d::Zero();  ///< and from `frame` on
    double sigmaPx = 0;                                 ///< standard deviation of each coordinate of the change
    double changePx() const { return (afterPx - beforePx).norm(); }
};

/// How one camera stands in one sequence, as its clicks show it.
struct SequenceHealth {
    int sequence = 0; ///< as the clicks number it
    int clicks = 0;
    int firstFrame = 0, lastFrame = 0;                ///< with clicks of it
    Eigen::Vector2d meanPx = Eigen::Vector2d::Zero(); ///< robust mean residual, its variation over the image taken off
    double meanSigmaPx = 0;                           ///< standard deviation of each coordinate
    /// Change of the mean over the frames, px per 100 frames, with its standard deviation; empty if all clicks are of
    /// few frames.
    std::optional<Eigen::Vector2d> driftPx;
    double driftSigmaPx = 0;
    std::optional<CameraStep> step; ///< significant, and explains the residuals better than a drift
    bool isDrifting = false;        ///< significant, and explains them better than a step
    bool isOff = false;             ///< from its first click to its last
};

/// A click's residual with what it may depend on.
struct CourseClick {
    int sequence = 0, frame = 0;
    Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< in the image, in halves of its larger side from its middle
    Eigen::Vector2d residualPx = Eigen::Vector2d::Zero();
};

struct CourseOptions {
    int leastClicks = 12;    ///< of a sequence; with fewer it is not judged
    double leastOffPx = 1;   ///< smaller changes do not matter
    double significance = 4; ///< in standard deviations
};

/// Looks for sudden and slow changes of a camera's residuals over the frames of each sequence. r = a_s + V place + what
/// changes: one step or one slope per sequence, whichever takes away more of the squares, if it is significant (a step
/// at 1.5 times the sigmas: its frame is chosen among all). The sequences in ascending order.
std::vector<SequenceHealth> judgeCourse(std::vector<CourseClick> clicks, const CourseOptions& options = {});

} // namespace core
