// SPDX-License-Identifier: MIT
#include "core/labelling/frame_fitter.h"

#include <algorithm>
#include <cmath>

#include "core/fitting/method_name.h"
#include "core/labelling/fit_doubt.h"
#include "core/segmentation/silhouette.h"

namespace core {

namespace {

/// What silhouettes that are made of pictures and a measured hand leave per axis, whatever their normal equations say:
/// on rendered hands with known joints.
constexpr double kModelSigmaMm = 0.25;

double worstSigmaMm(const std::vector<Eigen::Matrix3d>& covariances) {
    double most = 0;
    for (const Eigen::Matrix3d& covariance : covariances)
        most = std::max(most, covariance.trace());
    return std::sqrt(most);
}

const SpatialHand* detectedHand(const FrameEvidence& evidence, std::size_t hand) {
    return hand < evidence.detected.size() && evidence.detected[hand] ? &*evidence.detected[hand] : nullptr;
}

/// The hands that are there: their models, and their poses one after another.
std::vector<std::size_t> presentHands(const HandPoses& poses) {
    std::vector<std::size_t> present;
    for (std::size_t h = 0; h < poses.size(); ++h)
        if (poses[h].size() > 0)
            present.push_back(h);
    return present;
}

} // namespace

bool FrameEvidence::showsPoses() const {
    const auto hasPixels = [](const cv::Mat& picture) { return !picture.empty(); };
    return std::max(std::count_if(pictures.begin(), pictures.end(), hasPixels),
                    std::count_if(masks.begin(), masks.end(), hasPixels)) >= kFewestSilhouetteViews;
}

HandPoses FrameFit::poses() const {
    HandPoses list;
    for (const FittedHand& hand : hands)
        list.push_back(hand.pose);
    return list;
}

bool FrameFit::isEmpty() const {
    return std::all_of(
        hands.begin(), hands.end(), [](const FittedHand& hand) { return hand.pose.size() == 0; });
}

double FrameFit::doubt() const {
    double most = isEmpty() ? 1 : 0;
    for (const FittedHand& hand : hands)
        if (hand.pose.size() > 0)
            most = std::max(most, hand.doubt);
    return most;
}

FrameFitter::FrameFitter(std::vector<HandModel> hands, std::vector<Camera> cameras, int threads,
                         LandmarkFitOptions landmarks)
    : m_hands(std::move(hands))
    , m_cameras(std::move(cameras))
    , m_threads(threads)
    , m_landmarks(landmarks) {
    m_estimators.emplace_back(m_hands, m_cameras);
    for (std::size_t h = 0; m_hands.size() == 2 && h < 2; ++h)
        m_estimators.emplace_back(std::vector{m_hands[h]}, m_cameras);
}

const PoseEstimator& FrameFitter::estimatorOf(const HandPoses& poses) const {
    const auto present = presentHands(poses);
    return m_estimators[present.size() == m_hands.size() ? 0 : 1 + present.front()];
}

FrameFit FrameFitter::fromLandmarks(const FrameEvidence& evidence, const HandPoses& near) const {
    FrameFit result;
    result.hands.resize(m_hands.size());
    for (std::size_t h = 0; h < m_hands.size(); ++h) {
        const SpatialHand* detected = detectedHand(evidence, h);
        if (!detected)
            continue;
        std::vector<Pose> starts = usualStarts(m_hands[h].skeleton);
        if (h < near.size() && near[h].size() > 0)
            starts.insert(starts.begin(), near[h]);
        auto fit = fitToLandmarks(m_hands[h], *detected, starts, m_landmarks);
        if (!fit)
            continue;
        FitSigns signs;
        signs.misfit = fit->misfit;
        signs.raySine = widestRaySine(m_cameras, *detected);
        signs.landmarkMm = landmarkDistanceMm(m_hands[h], fit->pose, *detected, m_landmarks.areJoints);
        result.hands[h] = {std::move(fit->pose), std::move(fit->jointCovarianceMm2), doubtOf(signs)};
    }
    return result;
}

std::vector<cv::Mat> FrameFitter::silhouettes(const FrameEvidence& evidence, const HandPoses& poses) const {
    if (!evidence.masks.empty())
        return evidence.masks;
    return silhouettesByModel(m_cameras, evidence.pictures, m_hands, poses);
}

FrameFit FrameFitter::bySilhouettes(const FrameEvidence& evidence, const HandPoses& start, int rounds, FitSource source,
                                    std::stop_token stop, const KnownJoints& known) const {
    FrameFit result;
    result.source = source;
    result.hands.resize(m_hands.size());
    const auto present = presentHands(start);
    if (present.empty())
        return result;
    static const Method method = parseMethod("best");
    HandPoses poses;
    KnownJoints knownOfPresent;
    for (const std::size_t h : present) {
        poses.push_back(start[h]);
        knownOfPresent.push_back(h < known.size() ? known[h] : std::vector<JointTarget>());
    }
    HandPoses all = start;
    FitResult fit;
    for (int round = 0; round < (evidence.masks.empty() ? rounds : 1) && !stop.stop_requested(); ++round) {
        fit = estimatorOf(start).fit(silhouettes(evidence, all), poses, method, stop, {}, m_threads,
                                     {.confidence = true}, knownOfPresent);
        poses = fit.poses;
        for (std::size_t i = 0; i < present.size(); ++i)
            all[present[i]] = poses[i];
    }
    for (std::size_t i = 0; i < present.size(); ++i) {
        FittedHand& hand = result.hands[present[i]];
        hand.pose = poses[i];
        if (!fit.confidence)
            continue;
        hand.jointCovarianceMm2 = fit.confidence->jointCovarianceMm2[i];
        for (Eigen::Matrix3d& covariance : hand.jointCovarianceMm2)
            covariance += kModelSigmaMm * kModelSigmaMm * Eigen::Matrix3d::Identity();
        FitSigns signs;
        signs.deepPx = result.deepPx = fit.confidence->deepPx;
        signs.overlap = result.overlap = fit.confidence->overlap;
        signs.worstSigmaMm = worstSigmaMm(hand.jointCovarianceMm2);
        if (const SpatialHand* detected = detectedHand(evidence, present[i]))
            signs.landmarkMm = landmarkDistanceMm(m_hands[present[i]], hand.pose, *detected, m_landmarks.areJoints);
        hand.doubt = doubtOf(signs);
    }
    if (!fit.confidence)
        for (FittedHand& hand : result.hands)
            hand.jointCovarianceMm2.assign(
                m_hands[static_cast<std::size_t>(&hand - result.hands.data())].skeleton.bones.size(),
                Eigen::Matrix3d::Identity() * 1e4);
    return result;
}

} // namespace core
