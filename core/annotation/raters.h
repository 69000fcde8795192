// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/click_sigmas.h"
#include "core/annotation/sequence_points.h"

namespace core {

/// Numbers of Bland and Altman (1986) for one coordinate, mm: differences first - second.
struct BlandAltman {
    double biasMm = 0;
    double sdMm = 0;                                          ///< standard deviation of the differences
    double lowerMm() const { return biasMm - kLimit * sdMm; } ///< 95 % limits of agreement
    double upperMm() const { return biasMm + kLimit * sdMm; }
    static constexpr double kLimit = 1.959963984540054;
};

/// How far two sets of 3D joints lie apart.
struct Agreement {
    int count = 0;     ///< joints that both have
    double meanMm = 0; ///< distance
    double medianMm = 0;
    double maxMm = 0;
    BlandAltman axes[3]; ///< x, y, z of the world
};

/// Two raters compared: joints of the same frame, and clicks of the same joint in the same view.
struct RaterComparison {
    std::string first, second;
    Agreement all;
    std::map<JointId, Agreement> byJoint;
    int clicks = 0;        ///< marks that both placed by hand in the same view
    double clickRmsPx = 0; ///< root mean square distance between them
    /// Standard deviation of one rater's click per axis if both scatter alike, px: clickRmsPx / 2.
    double clickSigmaPx() const { return clickRmsPx / 2; }
};
/// Empty if the two share neither a joint nor a click.
std::optional<RaterComparison> compareRaters(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                             const std::string& first, const std::string& second,
                                             const TriangulationOptions& options = {});
/// Every pair of raters that share something, in order; each one's clicks count by their sigmas.
std::vector<RaterComparison> compareAllRaters(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                              const ClickSigmas& sigmas = {});
/// The same where the points of each rater are known already.
std::vector<RaterComparison> compareAllRaters(const AnnotationSet& set,
                                              const std::map<std::string, SequencePoints>& points);

/// One click that a consensus was made from.
struct ConsensusClick {
    std::string rater, camera;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    double errorPx = 0;
    bool outlier = false;
};
/// What all raters together say of a joint.
struct Consensus {
    TriangulationResult result;
    std::vector<ConsensusClick> clicks;
};
/// Triangulates all raters' manual marks of one joint at once, each weighed by its rater's sigma (raters whose sigma is
/// not known have that of the options). Marks of several raters in one view all count, but share the view's systematic
/// error: k of them count as k measurements of the hand and one of the calibration.
Consensus consensus(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const JointId& joint,
                    const ClickSigmas& sigmas = {}, const TriangulationOptions& options = {});

/// A joint of a frame that is to be annotated again.
struct RepeatTask {
    int frame = 0;
    JointId joint;
    auto operator<=>(const RepeatTask&) const = default;
};
/// A random subset of what a rater has finished (joints with a point from at least two manual views): `share` of it, at
/// least one if there is any, in random order; the same seed draws the same. The annotator must not see the first marks
/// while repeating them.
std::vector<RepeatTask> drawRepeatTasks(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                        const std::string& rater, double share, unsigned seed,
                                        const TriangulationOptions& options = {});
/// The name under which a rater's second marks are kept: "ann (again)". compareRaters of both is the intra-rater error.
std::string repeatRaterName(const std::string& rater);
/// True for such a name.
bool isRepeatRater(const std::string& rater);
/// The rater's name without the suffix of a repeat round.
std::string ownRaterName(const std::string& rater);

/// How much one rater has done.
struct RaterWork {
    std::string rater;
    int marks = 0;  ///< settled ones
    int frames = 0; ///< that hold them
    bool operator==(const RaterWork&) const = default;
};
/// All raters with a settled mark, ascending by name; repeat rounds count for themselves.
std::vector<RaterWork> raterWork(const AnnotationSet& set);

} // namespace core
