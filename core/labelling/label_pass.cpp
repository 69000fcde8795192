// SPDX-License-Identifier: MIT
#include "core/labelling/label_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/labelling/landmark_fit.h"
#include "core/labelling/outline_rig.h"
#include "core/labelling/pass_hands.h"
#include "core/labelling/pass_plan.h"
#include "core/subject/calibration_unit.h"
#include "core/subject/hand_tips.h"

namespace core {

namespace {

constexpr std::size_t kFewestPilots = 3;    ///< frames that a person's hands can be measured from
constexpr std::size_t kLandmarkPilots = 30; ///< the same from landmarks alone, which takes little time
constexpr double kPilotDoubt = 0.3;         ///< frames with more are not measured from
/// Silhouettes of a model do not find the size of a hand that is so much larger or smaller, as landmarks show it.
constexpr double kOtherScale = 0.06;
constexpr double kSurer = 0.1; ///< so much less doubt must models leave as they were given

std::vector<HandModel> withAllTips(const std::vector<HandModel>& hands) {
    std::vector<HandModel> result;
    for (const HandModel& hand : hands)
        result.push_back(withTips(hand));
    return result;
}

long countHands(const FrameFit& fit) {
    return std::count_if(
        fit.hands.begin(), fit.hands.end(), [](const FittedHand& hand) { return hand.pose.size() > 0; });
}

/// Of hands that nothing says the models are like, half are off by more than 5 mm, whatever silhouettes say.
void halveTrust(std::map<int, FrameFit>& fits) {
    for (auto& [frame, fit] : fits)
        for (FittedHand& hand : fit.hands)
            hand.doubt = 1 - (1 - hand.doubt) / 2;
}

/// One run of the pass.
class Run {
public:
    Run(const std::vector<HandModel>& hands, std::vector<Camera> cameras, const std::vector<int>& frames,
        PassSource& source, const PassOptions& options, std::stop_token stop, const PassProgress& progress,
        const PassSink& sink)
        : m_cameras(std::move(cameras))
        , m_frames(frames)
        , m_source(source)
        , m_options(options)
        , m_stop(std::move(stop))
        , m_progress(progress)
        , m_sink(sink) {
        m_options.withSilhouettes = options.withSilhouettes && source.viewCount() >= kFewestSilhouetteViews;
        m_keys = m_options.withSilhouettes ? keyFrames(frames, options.keyEveryFrames) : frames;
        m_result.hands = withAllTips(hands);
    }

    PassResult run() {
        m_total = static_cast<int>(m_keys.size() + m_frames.size());
        m_result.cameras = m_cameras;
        m_result.isFinished = detectKeys() && measure() && fitKeys() && track();
        if (m_isPersonUnknown)
            halveTrust(m_result.fits);
        return std::move(m_result);
    }

private:
    bool detectKeys();
    void findUnit(const std::map<int, ViewDetections>& views);
    bool measure();
    bool measureSilhouettes();
    bool chooseScale(const std::vector<int>& complete);
    double meanDoubt(const std::vector<int>& frames, const std::string& step);
    void takeHands(std::vector<SubjectHand> measured);
    bool fitKeys();
    bool track();
    double doubtAt(int frame) const;
    void trackTo(const TrackStep& step);
    FrameFit tracked(const TrackStep& step);
    FrameFit freshFit(const FrameFitter& fitter, int frame, const std::string& step, int rounds);
    const HandDetections& detect(int frame, const HandPoses& near);
    FrameFit look(int frame, FrameEvidence evidence, const HandPoses& near);
    std::map<int, std::vector<SpatialHand>> grouped(const std::map<int, ViewDetections>& views) const;

    void makeFitter() { m_fitter.emplace(m_result.hands, m_cameras, m_options.threads, landmarkOptions()); }
    LandmarkFitOptions landmarkOptions() const {
        if (m_options.landmarksAreJoints)
            return {.areJoints = true, .modelSigmaMm = 0.5, .priorSigmaRad = 2};
        return {};
    }
    bool isStopped() const { return m_stop.stop_requested(); }
    bool say(PassStage stage) {
        ++m_done;
        m_total = std::max(m_total, m_done);
        if (m_progress)
            m_progress(stage, m_done, m_total);
        return !isStopped();
    }
    void keep(int frame, FrameFit fit) {
        m_result.fits[frame] = std::move(fit);
        if (m_sink)
            m_sink(m_result, frame);
    }

    std::vector<Camera> m_cameras; ///< in mm once the unit is known
    std::vector<int> m_frames, m_keys;
    PassSource& m_source;
    PassOptions m_options;
    std::stop_token m_stop;
    const PassProgress& m_progress;
    const PassSink& m_sink;
    PassResult m_result;
    std::optional<FrameFitter> m_fitter;
    std::map<int, FrameFit> m_pilots; ///< fits of the models before they were measured
    long m_mostHands = 0;             ///< in one frame
    bool m_isPersonUnknown = false;   ///< too many pilots were in doubt to measure the hands
    double m_scale = 1;               ///< of the models, as landmarks show them, over those that were given
    std::vector<HandModel> m_given;   ///< not scaled; empty if no other scale was seen
    std::string m_pilotStep = "pilot";
    int m_done = 0, m_total = 1;
};

std::map<int, std::vector<SpatialHand>> Run::grouped(const std::map<int, ViewDetections>& views) const {
    std::map<int, std::vector<SpatialHand>> frames;
    for (const auto& [frame, detections] : views)
        frames[frame] = groupDetections(m_cameras, detections);
    return frames;
}

/// The calibration's unit as the hands tell it: cameras are in mm from then on.
void Run::findUnit(const std::map<int, ViewDetections>& views) {
    std::map<int, HandDetections> all;
    for (const auto& [frame, hands] : grouped(views)) {
        // whatever side it is: lengths are the same
        int number = 2 * frame;
        for (const SpatialHand& hand : hands) {
            HandDetections& list = all[number++];
            list.resize(m_result.hands.size());
            list.front() = hand;
        }
    }
    const double ratio = landmarksOverModelLength(m_result.hands, all);
    m_result.unitMm = unitMmOf(ratio);
    const double scale = ratio * m_result.unitMm;
    if (m_options.measureHands && std::abs(scale - 1) > kOtherScale && scale > 0) {
        m_given = m_result.hands;
        m_result.hands = scaledHands(m_result.hands, scale);
        m_scale = scale;
    }
    for (Camera& camera : m_cameras)
        camera.cameraFromWorld.translation *= m_result.unitMm;
}

bool Run::detectKeys() {
    const auto views = detectFrames(m_cameras, m_keys, m_source, m_options.mostGapFrames, m_stop,
                                    [this] { say(PassStage::Detecting); });
    if (isStopped())
        return false;
    findUnit(views);
    m_result.detected = assignHands(m_result.hands, grouped(views));
    makeFitter();
    return true;
}

/// From what the detector saw, by silhouettes if there are enough views.
FrameFit Run::freshFit(const FrameFitter& fitter, int frame, const std::string& step, int rounds) {
    if (auto known = m_source.recall(step, frame))
        return *known;
    FrameEvidence evidence = m_options.withSilhouettes ? m_source.evidence(frame) : FrameEvidence{};
    evidence.detected = m_result.detected.at(frame);
    const auto pilot = m_pilots.find(frame);
    FrameFit fit = fitter.fromLandmarks(evidence);
    const HandPoses start = pilot != m_pilots.end() && !pilot->second.isEmpty() ? pilot->second.poses() : fit.poses();
    if (m_options.withSilhouettes && !fit.isEmpty() && evidence.showsPoses())
        fit = fitter.bySilhouettes(evidence, start, rounds, FitSource::Silhouettes, m_stop);
    if (!isStopped())
        m_source.remember(step, frame, fit);
    return fit;
}

/// The person's hands from the surest key frames.
bool Run::measure() {
    if (!m_options.measureHands)
        return true;
    if (m_options.landmarksAreJoints) {
        takeHands(
            measureLandmarks(m_result.hands, m_cameras, m_result.detected, kLandmarkPilots, landmarkOptions(), m_stop));
        return !isStopped();
    }
    return !m_options.withSilhouettes || measureSilhouettes();
}

/// Of fits of the present models; NaN if it was stopped.
double Run::meanDoubt(const std::vector<int>& frames, const std::string& step) {
    double sum = 0;
    for (const int frame : frames) {
        sum += freshFit(*m_fitter, frame, step, 2).doubt();
        if (isStopped())
            return std::nan("");
    }
    return sum / static_cast<double>(frames.size());
}

/// The detector may be off by as much as another hand: silhouettes of a few frames say whether the models fit better as
/// they were given. False if it was stopped.
bool Run::chooseScale(const std::vector<int>& complete) {
    const std::vector<int> frames = evenlyDrawn(complete, kFewestPilots);
    if (frames.empty())
        return true;
    const double scaledDoubt = meanDoubt(frames, "pilot");
    std::swap(m_result.hands, m_given);
    makeFitter();
    if (const double givenDoubt = isStopped() ? 0 : meanDoubt(frames, "given"); givenDoubt + kSurer < scaledDoubt) {
        m_scale = 1;
        m_pilotStep = "given";
        return !isStopped();
    }
    std::swap(m_result.hands, m_given);
    makeFitter();
    return !isStopped();
}

/// From silhouettes that pilot fits of the models explain.
bool Run::measureSilhouettes() {
    std::vector<int> complete;
    for (const auto& [frame, hands] : m_result.detected)
        if (std::all_of(hands.begin(), hands.end(), [](const auto& hand) { return hand.has_value(); }))
            complete.push_back(frame);
    if (m_scale != 1 && !chooseScale(complete))
        return false;
    std::vector<MeasuredFrame> measured;
    for (const int frame : evenlyDrawn(complete, m_options.mostPilots)) {
        if (isStopped())
            return false;
        FrameFit fit = freshFit(*m_fitter, frame, m_pilotStep, 2);
        if (fit.source == FitSource::Silhouettes && fit.doubt() < kPilotDoubt)
            measured.push_back({fit.poses(), m_fitter->silhouettes(m_source.evidence(frame), fit.poses())});
        m_pilots[frame] = std::move(fit);
        if (!say(PassStage::Measuring))
            return false;
    }
    m_isPersonUnknown = m_pilots.size() >= kFewestPilots && measured.size() < kFewestPilots;
    if (measured.size() < kFewestPilots)
        return true;
    if (auto adjusted = camerasByOutlines(m_cameras, m_result.hands, measured, m_stop)) {
        m_result.camerasOffPx = adjusted->shiftPx;
        m_cameras = adjusted->cameras;
        for (Camera& camera : adjusted->cameras)
            camera.cameraFromWorld.translation /= m_result.unitMm;
        m_result.cameras = std::move(adjusted->cameras);
    }
    takeHands(measureHands(m_result.hands, m_cameras, measured, m_stop));
    return !isStopped();
}

void Run::takeHands(std::vector<SubjectHand> measured) {
    m_result.measured = std::move(measured);
    for (std::size_t h = 0; h < m_result.measured.size(); ++h) {
        m_result.hands[h] = m_result.measured[h].hand;
        m_result.measured[h].scale.value *= m_scale; // over the model as it was given
    }
    makeFitter();
}

bool Run::fitKeys() {
    for (const int frame : m_keys) {
        if (isStopped())
            return false;
        FrameFit fit = freshFit(*m_fitter, frame, "key", m_pilots.count(frame) > 0 ? 1 : 2);
        if (isStopped())
            return false;
        keep(frame, std::move(fit));
        if (!say(PassStage::Fitting))
            return false;
    }
    return true;
}

const HandDetections& Run::detect(int frame, const HandPoses& near) {
    if (m_result.detected.count(frame) == 0) {
        KnownHands known;
        for (std::size_t h = 0; h < near.size(); ++h)
            if (near[h].size() > 0)
                known.hands.push_back(landmarksOf(m_result.hands[h], near[h], m_result.unitMm));
        m_result.detected[frame] =
            assignHands(m_result.hands, grouped({{frame, m_source.detect(frame, known)}})).at(frame);
    }
    return m_result.detected.at(frame);
}

/// The detector looks at a frame that tracking is unsure of.
FrameFit Run::look(int frame, FrameEvidence evidence, const HandPoses& near) {
    evidence.detected = detect(frame, near);
    const FrameFit fit = m_fitter->fromLandmarks(evidence, near);
    return fit.isEmpty() ? fit : m_fitter->bySilhouettes(evidence, fit.poses(), 2, FitSource::Silhouettes, m_stop);
}

/// A frame from its neighbour; where that is in doubt, from what the detector sees in it.
FrameFit Run::tracked(const TrackStep& step) {
    const FrameFit& from = m_result.fits.at(step.from);
    const int before = 2 * step.from - step.to;
    const auto earlier = m_result.fits.find(before);
    const HandPoses start =
        predictedPoses(from.poses(), earlier != m_result.fits.end() ? earlier->second.poses() : HandPoses{}, 0.8);
    FrameEvidence evidence = m_source.evidence(step.to);
    if (const auto seen = m_result.detected.find(step.to); seen != m_result.detected.end())
        evidence.detected = seen->second;
    FrameFit fit = m_fitter->bySilhouettes(evidence, start, 1, FitSource::Tracking, m_stop);
    if (fit.doubt() < m_options.leastDoubt || isStopped() || m_result.fits.count(step.to) > 0)
        return fit;
    FrameFit fresh = look(step.to, std::move(evidence), start);
    return fresh.doubt() < fit.doubt() ? fresh : fit;
}

void Run::trackTo(const TrackStep& step) {
    const std::string name = step.direction > 0 ? "forward" : "backward";
    FrameFit fit;
    if (auto known = m_source.recall(name, step.to)) {
        fit = *known;
        if (fit.source == FitSource::Silhouettes)
            detect(step.to, {});
    } else {
        fit = tracked(step);
        if (isStopped())
            return;
        m_source.remember(name, step.to, fit);
    }
    const auto kept = m_result.fits.find(step.to);
    if (kept == m_result.fits.end() || countHands(fit) > countHands(kept->second) ||
        (countHands(fit) == countHands(kept->second) && fit.doubt() < kept->second.doubt()))
        keep(step.to, std::move(fit));
}

/// The doubt of a frame, great where it lacks a hand that others have.
double Run::doubtAt(int frame) const {
    constexpr double kLacksHand = 0.9;
    const auto fit = m_result.fits.find(frame);
    if (fit == m_result.fits.end())
        return 2; // not fitted at all
    return countHands(fit->second) < m_mostHands ? std::max(kLacksHand, fit->second.doubt()) : fit->second.doubt();
}

/// Frames that are not fitted yet, and those in doubt, from their surest neighbours.
bool Run::track() {
    if (!m_options.withSilhouettes)
        return true;
    TrackQueue queue(m_frames, m_options.mostGapFrames);
    for (const auto& [frame, fit] : m_result.fits)
        m_mostHands = std::max(m_mostHands, countHands(fit));
    for (const auto& [frame, fit] : m_result.fits)
        if (fit.source == FitSource::Silhouettes)
            queue.add(frame, doubtAt(frame));
    while (const auto step = queue.next()) {
        const double before = doubtAt(step->to);
        if (before < m_options.leastDoubt || step->doubt >= before)
            continue;
        const bool isNew = m_result.fits.count(step->to) == 0;
        trackTo(*step);
        if (isStopped() || (isNew && !say(PassStage::Tracking)))
            return false;
        if (const double after = doubtAt(step->to); after < before)
            queue.add(step->to, after, step->direction);
    }
    return true;
}

} // namespace

std::map<int, ViewDetections> detectFrames(const std::vector<Camera>& cameras, const std::vector<int>& frames,
                                           PassSource& source, int mostGapFrames, const std::stop_token& stop,
                                           const std::function<void()>& done) {
    std::map<int, ViewDetections> views;
    KnownHands known;
    std::optional<int> last;
    for (const int frame : frames) {
        if (stop.stop_requested())
            break;
        known.isRecent = last && frame - *last <= mostGapFrames;
        views[frame] = source.detect(frame, known);
        if (auto found = groupDetections(cameras, views[frame]); !found.empty()) {
            known.hands = std::move(found);
            last = frame;
        }
        done();
    }
    return views;
}

PassResult runLabelPass(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                        const std::vector<int>& frames, PassSource& source, const PassOptions& options,
                        std::stop_token stop, const PassProgress& progress, const PassSink& sink) {
    return Run(hands, cameras, frames, source, options, std::move(stop), progress, sink).run();
}

} // namespace core
