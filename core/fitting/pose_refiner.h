// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/contour/forearm_cuts.h"
#include "core/contour/visible_rim.h"
#include "core/fitting/fit_result.h"
#include "core/fitting/fit_target.h"
#include "core/fitting/joint_problem.h"
#include "core/fitting/rim_matches.h"
#include "core/hand/finger_overlap.h"
#include "core/hand/skinned_surface.h"

namespace core {

/// The hands as the estimator sees them.
struct FittingHands {
    std::vector<HandModel> models;
    std::vector<std::array<SkinnedSurface, kSurfaceLevels>> levels; ///< per hand
    std::vector<ForearmCut> cuts;                                   ///< per hand
    std::vector<Eigen::MatrixXd> changePrecision;                   ///< per hand, see fingerChangePrecision
    /// Per level and hand: of every vertex, the bone that moves it most.
    std::array<std::vector<std::vector<std::uint8_t>>, kSurfaceLevels> boneOfVertex;
    HandCapsules capsules;
};
FittingHands makeFittingHands(std::vector<HandModel> models);

/// A rim point at the final pose and the contour point that it is matched with, and what moves the rim across its
/// outline: the derivatives of `mm`.
struct OutlineResidual {
    int view = 0; ///< index into the targets
    int hand = 0;
    int contourPoint = 0;
    double px = 0;              ///< signed, across the outline: from the rim outward to the contour
    double mm = 0;              ///< signed: from the contour's ray outward to the rim
    double mmPerPx = 0;         ///< at the rim point's depth
    Eigen::Vector2d normalPx;   ///< outward image normal, unit
    double perGirthMm = 0;      ///< by 1 mm of girth
    double perLogScale = 0;     ///< by the logarithm of the hand's size about its root joint, mm
    Eigen::RowVectorXd perPose; ///< by a tangent step of its hand's pose
};

/// How far from an observed outline, px, a difference of silhouettes is no longer its noise of that standard deviation:
/// 3.5 of them, from 4 to 12 px.
int beyondNoisePx(double noisePx);

/// Extracts correspondences and solves for one step, again and again. One object per fit; not for several threads at
/// once, though it may use several itself.
class PoseRefiner {
public:
    PoseRefiner(const FittingHands& hands, const std::vector<Camera>& cameras, const std::vector<CameraTarget>& targets,
                const HandPoses& start, int threads, FitProfile& profile);

    /// One iteration; `poses` moves. The record's number and poses are left to the caller.
    FitIteration iterate(HandPoses& poses, const IterationSettings& settings);

    /// From now on, iterations record their matches, or no longer.
    void recordMatches(bool on);
    /// The matches that another iteration with the last one's settings would step from; none before the first.
    IterationMatches matchesAt(const HandPoses& poses);

    const FittingHands& hands() const { return m_hands; }
    /// Whether the masks hold specks, as a threshold in noisy pictures makes them.
    bool isNoisy() const { return !m_targets.empty() && m_targets.front().isSpeckled; }

    /// From now on, iterations pull the hands to these joints as well, and a pose that misses them counts as one that
    /// explains the masks worse.
    void pullTo(KnownJoints known) { m_known = std::move(known); }
    const KnownJoints& knownJoints() const { return m_known; }

    /// From now on, leaves out what lies beyond the cut of each hand whose silhouettes go on there: rim, contour and
    /// area. That a hand has a forearm is decided from the pixels beyond the model's end in `poses` that no hand
    /// covers; silhouettes that end with the hands leave everything as it was.
    void cutForearms(const HandPoses& poses);
    const ForearmCuts& forearms() const { return m_forearms; }
    /// Moves the cuts towards the fingers, to where silhouettes get wider than the hands in `poses`: a sleeve begins
    /// there. True if one was moved. Hands without a forearm are left as they are.
    bool cutSleeves(const HandPoses& poses);
    /// The same after looking for forearms that the start was too far off to show, if forearms are to be cut at all.
    /// True if anything changed.
    bool updateForearms(const HandPoses& poses);

    /// How far the contours lie from the rim where they are matched, across the outline: 1.4826 times the median of the
    /// distances, px, per camera, and the cameras' median. 0 where there is no match. Not much disturbed by the parts
    /// of the hands that are wrong.
    struct Noise {
        double px = 0;
        std::vector<double> perCameraPx;
    };
    Noise contourNoise(const HandPoses& poses);

    /// How badly the poses explain the masks: area of the symmetric difference over length of the outlines, that is the
    /// mean distance between both outlines in px, over all cameras. Of the coarse level: about half a pixel where all
    /// is well.
    double silhouetteDifferencePx(const HandPoses& poses) { return silhouetteDifferencePx(poses, kScoreCellPx); }
    /// The same, sampled every cellPx pixels.
    double silhouetteDifferencePx(const HandPoses& poses, float cellPx);
    static constexpr float kScoreCellPx = 4, kRoughScoreCellPx = 8;
    /// The same of the part that lies farther than depthPx from the observed outlines: almost 0 where only the
    /// contour is noisy, much where a finger is in a wrong place.
    double deepDifferencePx(const HandPoses& poses, int depthPx);

    /// What a pose leaves of the outlines, for its uncertainty and for the doubt about it (core/fitting/confidence.h).
    struct Evidence {
        std::vector<NormalEquations> equations; ///< per hand, at the pose, matches within 22.5 degrees and 4 sigma
        double sigmaMm = 0;                     ///< robust scale of the distances across the outlines
        double sigmaPx = 0;                     ///< the same in the pictures
        double pointsPerSample = 1;             ///< N / N_eff: matches that count as one independent measurement
        double unmatchedShare = 0;              ///< of the rim points, those without a match
        SilhouetteComparison silhouettes;       ///< over all cameras; deep: beyondNoisePx
        double outlinePx = 0;                   ///< length of the outlines that were compared
        std::vector<OutlineResidual> residuals; ///< of all views
    };
    Evidence evidence(const HandPoses& poses);

private:
    struct View {
        RimScratch scratch;
        std::vector<RimPoint> rim;
        RimMatches matched;
        std::vector<NormalEquations> equations; ///< per hand
        std::vector<ConvexRegion> forearms;     ///< of the hands that have one
        double differencePx2 = 0;
        std::size_t contourPoints = 0; ///< outside the forearms
        bool isCounted = false;        ///< contourPoints is of these forearms
        double noisePx = 0;
        cv::Mat unsure; ///< not 0 within unsureDepthPx of the observed outline
        int unsureDepthPx = 0;
        SilhouetteComparison silhouettes;
        std::vector<OutlineResidual> residuals;
        double secondsRim = 0, secondsMatch = 0, secondsSolve = 0, secondsScore = 0;
    };

    void poseSurfaces(const HandPoses& poses, Detail detail);
    void extractRim(View& view, const CameraTarget& target, Detail detail, int points);
    std::shared_ptr<const IterationMatches> takeRecords();
    std::vector<RimSource> rimSources(Detail detail) const;
    void placeForearms(const HandPoses& poses);
    template <typename Search>
    std::vector<Search> lookBeyondHands(const HandPoses& poses); ///< one per hand
    void measureNoise(View& view, const CameraTarget& target) const;
    Eigen::VectorXd solveHand(std::size_t hand, const HandPoses& poses, const NormalEquations& equations,
                              const std::vector<CapsuleOverlap>& overlaps, const IterationSettings& settings) const;
    void compareView(View& view, const CameraTarget& target, const std::vector<RimSource>& sources,
                     const cv::Mat& unsure, float cellPx = kScoreCellPx);
    const cv::Mat& unsureMask(View& view, const CameraTarget& target, int depthPx) const;
    double outlineLengthPx() const;
    void collectEvidence(View& view, const CameraTarget& target, const std::vector<HandLinearisation>& hands,
                         const std::vector<Eigen::Vector3d>& roots) const;
    void forEachView(const std::function<void(View&, const CameraTarget&)>& work);

    const FittingHands& m_hands;
    const std::vector<Camera>& m_cameras;
    const std::vector<CameraTarget>& m_targets;
    HandPoses m_start;
    int m_threads;
    FitProfile& m_profile;
    std::optional<IterationSettings> m_lastSettings;
    KnownJoints m_known;
    std::vector<View> m_views;
    ForearmCuts m_forearms;
    bool m_cutsForearms = false;
    std::vector<std::array<PosedPoints, kSurfaceLevels>> m_posed; ///< per hand
};

} // namespace core
