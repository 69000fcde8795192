// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/detection/hand_views.h"
#include "core/fitting/pose_estimator.h"
#include "core/labelling/landmark_fit.h"

namespace core {

inline constexpr int kFewestSilhouetteViews = 3; ///< silhouettes of fewer views do not tell where a hand is

/// What is known of an instant before hands are fitted to it.
struct FrameEvidence {
    std::vector<cv::Mat> pictures; ///< BGR, per camera; empty where there is none
    std::vector<cv::Mat> masks; ///< silhouettes that are given, per camera; no entries: they are made of the pictures
    std::vector<std::optional<SpatialHand>> detected; ///< per hand; no entries: nobody looked

    /// kFewestSilhouetteViews views or more.
    bool showsPoses() const;
};

/// What the pose of a hand rests on.
enum class FitSource {
    Landmarks,   ///< what the detector saw, alone
    Silhouettes, ///< silhouettes, from the pose that the detector's landmarks ask for
    Tracking,    ///< silhouettes, from the pose of a neighbouring frame
    Correction   ///< joints that a person placed
};

/// A hand of a frame as its model in a pose.
struct FittedHand {
    Pose pose;                                       ///< empty: the hand is not there
    std::vector<Eigen::Matrix3d> jointCovarianceMm2; ///< per bone, of its origin in the world
    double doubt = 1;                                ///< 0 sure .. 1 lost
};

/// All hands of a frame, parallel to the models.
struct FrameFit {
    std::vector<FittedHand> hands;
    FitSource source = FitSource::Landmarks;
    double overlap = 0; ///< intersection over union of drawn and observed silhouettes; 0 without
    double deepPx = 0;  ///< their difference beyond the noise, per length of the outlines

    HandPoses poses() const;
    bool isEmpty() const;
    double doubt() const; ///< of the most doubtful hand that is there; 1 if there is none
};

/// Fits hand models to single instants. All members may be called from several threads at once.
class FrameFitter {
public:
    /// `hands` as withTips gives them. `threads` never change a result.
    FrameFitter(std::vector<HandModel> hands, std::vector<Camera> cameras, int threads = 1,
                LandmarkFitOptions landmarks = {});

    const std::vector<HandModel>& hands() const { return m_hands; }
    const std::vector<Camera>& cameras() const { return m_cameras; }

    /// The poses that the landmarks ask for, hand by hand; `near`: where the hands were a moment ago, tried as a start,
    /// too. A hand that was not detected is not there.
    FrameFit fromLandmarks(const FrameEvidence& evidence, const HandPoses& near = {}) const;

    /// The poses that explain the silhouettes by `best`, from `start` (empty poses: hands that are not there).
    /// `rounds`: how often silhouettes are made, each time from the poses of the round before; 1 where they are given.
    /// `known`: joints that are known beside them, per hand, mm.
    FrameFit bySilhouettes(const FrameEvidence& evidence, const HandPoses& start, int rounds, FitSource source,
                           std::stop_token stop = {}, const KnownJoints& known = {}) const;

    /// The silhouettes of hands in these poses: those that are given, else made of the pictures (silhouettesByModel).
    std::vector<cv::Mat> silhouettes(const FrameEvidence& evidence, const HandPoses& poses) const;

private:
    const PoseEstimator& estimatorOf(const HandPoses& poses) const;

    std::vector<HandModel> m_hands;
    std::vector<Camera> m_cameras;
    int m_threads;
    LandmarkFitOptions m_landmarks;
    std::vector<PoseEstimator> m_estimators; ///< of all hands, then (of two) of each alone
};

} // namespace core
