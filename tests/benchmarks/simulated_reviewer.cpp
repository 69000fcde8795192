// SPDX-License-Identifier: MIT
#include "tests/benchmarks/simulated_reviewer.h"

#include <algorithm>

#include "core/annotation/edits.h"
#include "core/annotation/reconstruction.h"
#include "core/io/detector/auto_label_file.h"

namespace trial {

namespace {

constexpr const char* kRater = "sim";
constexpr double kMissingMm = 100; ///< the error of a joint that nobody has placed
const core::ReconstructionOptions kQuick{{}, false, std::nullopt, {}};

std::set<int> framesOf(const core::Edit& edit) {
    std::set<int> frames;
    for (const core::MarkChange& change : edit.marks)
        frames.insert(change.key.frame);
    return frames;
}

} // namespace

SimulatedReviewer::SimulatedReviewer(Recording& recording, core::PassResult pass, const core::PassOptions& passOptions,
                                     const ReviewerOptions& options)
    : m_recording(recording)
    , m_pass(std::move(pass))
    , m_passOptions(passOptions)
    , m_options(options)
    , m_random(options.seed)
    , m_review(recording.dataset().cameras, kRater) {
    takeLabels(core::autoLabels(m_pass, recording.dataset().cameras));
}

/// As the window and the command line make proposals of labels.
void SimulatedReviewer::takeLabels(const core::AutoLabels& labels) {
    const core::Edit edit = core::autoLabelEdit(m_set, m_recording.dataset(), labels, kRater, m_recording.joints());
    core::followProposals(m_proposed, edit);
    for (const auto& [frame, hands] : labels)
        for (const core::AutoHand& hand : hands)
            for (const core::AutoJoint& joint : hand.joints)
                if (!m_done.contains(frame))
                    m_points[frame][{hand.side, joint.name}] = joint.pointInWorld;
    apply(edit);
}

void SimulatedReviewer::apply(const core::Edit& edit) {
    core::apply(m_set, edit);
    for (const int frame : framesOf(edit))
        look(frame);
}

void SimulatedReviewer::look(int frame) {
    m_review.look(m_set, m_proposed, frame);
    for (const core::JointId& joint : m_recording.joints()) {
        const auto found = core::reconstruct(m_set, m_recording.dataset().cameras, frame, kRater, joint, kQuick);
        if (found.hasPoint())
            m_points[frame][joint] = found.result.point->pointInWorld;
    }
}

std::optional<Eigen::Vector3d> SimulatedReviewer::pointOf(int frame, const core::JointId& joint) const {
    const auto points = m_points.find(frame);
    if (points == m_points.end())
        return std::nullopt;
    const auto point = points->second.find(joint);
    return point == points->second.end() ? std::nullopt : std::optional(point->second);
}

double SimulatedReviewer::errorMm(int frame) const {
    double sum = 0;
    for (const core::JointId& joint : m_recording.joints()) {
        const auto point = pointOf(frame, joint);
        sum += point ? (*point - m_recording.truth(frame, joint)).norm() : kMissingMm;
    }
    return sum / static_cast<double>(m_recording.joints().size());
}

double SimulatedReviewer::errorMm() const {
    double sum = 0;
    for (const int frame : m_recording.frames())
        sum += errorMm(frame);
    return sum / static_cast<double>(m_recording.frames().size());
}

/// How far off a joint is drawn where it is drawn farthest off; far if it is nowhere.
double SimulatedReviewer::offPx(int frame, const core::JointId& joint) const {
    const auto point = pointOf(frame, joint);
    if (!point)
        return 1e9;
    double most = 0;
    const auto& cameras = m_recording.dataset().cameras;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        const auto drawn = core::project(cameras[c], *point), seen = m_recording.truePx(frame, joint, c);
        if (drawn && seen)
            most = std::max(most, (*drawn - *seen).norm());
    }
    return most;
}

/// The joint that the queue asks for, unless another one is plainly wrong and this one is not; all of a hand that is
/// not there.
std::vector<core::JointId> SimulatedReviewer::jointsToCorrect(const core::ProposedFrame& why) const {
    std::vector<core::JointId> missing;
    core::JointId worst = why.joint;
    double worstPx = offPx(why.frame, why.joint);
    const bool isListed =
        std::find(m_recording.joints().begin(), m_recording.joints().end(), why.joint) != m_recording.joints().end();
    if (isListed && worstPx >= m_options.seenPx && pointOf(why.frame, why.joint))
        return {why.joint};
    for (const core::JointId& joint : m_recording.joints())
        if (!pointOf(why.frame, joint))
            missing.push_back(joint);
        else if (const double px = offPx(why.frame, joint); px > worstPx || !isListed)
            worst = joint, worstPx = px;
    if (!missing.empty())
        return missing;
    return worstPx >= m_options.seenPx ? std::vector{worst} : std::vector<core::JointId>{};
}

void SimulatedReviewer::click(int frame, const core::JointId& joint, const std::string& camera) {
    const auto index = static_cast<std::size_t>(m_recording.dataset().cameraIndex(camera));
    std::normal_distribution<double> noise(0, m_options.clickPx);
    const double x = noise(m_random), y = noise(m_random);
    core::apply(m_set, core::placeEdit(m_set, {frame, kRater, joint, camera},
                                       *m_recording.truePx(frame, joint, index) + Eigen::Vector2d(x, y)));
    ++m_clicks;
}

/// Clicks in the view that sees it and lies first, then in the most useful ones, until the joint is certain.
void SimulatedReviewer::correct(int frame, const core::JointId& joint) {
    const auto& cameras = m_recording.dataset().cameras;
    core::ReconstructionOptions options;
    options.triangulation.sigmaPx = m_options.clickPx;
    options.nearInWorld = pointOf(frame, joint);
    for (std::size_t c = 0; c < cameras.size(); ++c)
        if (m_recording.truePx(frame, joint, c)) {
            click(frame, joint, cameras[c].name);
            break;
        }
    for (std::size_t i = 1; i < cameras.size(); ++i) {
        const auto found = core::reconstruct(m_set, cameras, frame, kRater, joint, options);
        if (found.hasPoint() && core::sigmaMm(found.result.point->covariance) <= m_options.surenessMm)
            break;
        const auto next = std::find_if(found.nextViews.begin(), found.nextViews.end(), [&](const core::NextView& view) {
            return m_recording
                .truePx(frame, joint, static_cast<std::size_t>(m_recording.dataset().cameraIndex(view.camera)))
                .has_value();
        });
        if (next == found.nextViews.end())
            break;
        click(frame, joint, next->camera);
    }
    look(frame);
}

/// As the window does while a person corrects a frame: what is not placed follows what is.
void SimulatedReviewer::refit(int frame) {
    const auto& cameras = m_recording.dataset().cameras;
    const core::PassResult result =
        core::retrack(m_pass.hands, m_pass.cameras, core::correctedFrame(m_set, cameras, frame, kRater, m_pass.cameras),
                      {frame}, {}, m_recording, m_passOptions);
    takeLabels(core::autoLabels(result, cameras));
    look(frame);
}

void SimulatedReviewer::follow(int frame) {
    std::vector<int> waiting{frame}, reviewed;
    for (const int other : m_recording.frames())
        if (m_done.contains(other))
            reviewed.push_back(other);
        else if (other != frame)
            waiting.push_back(other);
    std::sort(waiting.begin(), waiting.end());
    const auto& cameras = m_recording.dataset().cameras;
    core::PassResult result =
        core::retrack(m_pass.hands, m_pass.cameras, core::correctedFrame(m_set, cameras, frame, kRater, m_pass.cameras),
                      waiting, reviewed, m_recording, m_passOptions);
    core::AutoLabels labels = core::autoLabels(result, cameras);
    labels.erase(frame); // it is the person's
    takeLabels(labels);
}

bool SimulatedReviewer::reviewOne() {
    const auto frames = m_review.frames();
    const auto order = core::reviewOrder(core::reviewFrames(frames));
    if (order.empty())
        return false;
    m_last = order.front().frame;
    const auto why = std::find_if(frames.begin(), frames.end(),
                                  [this](const core::ProposedFrame& frame) { return frame.frame == m_last; });
    core::ProposedFrame doubtful = *why;
    m_act = "accepted";
    bool isCorrected = false;
    for (int look = 0; look < m_options.looksPerFrame; ++look) {
        const auto joints = jointsToCorrect(doubtful);
        if (joints.empty())
            break;
        m_act = (isCorrected ? m_act + " + " : "") + core::jointLabel(joints.front());
        isCorrected = true;
        for (const core::JointId& joint : joints)
            correct(m_last, joint);
        if (m_options.refits)
            refit(m_last);
        doubtful.joint = joints.front(); // it is right now: another one if it is plainly wrong
    }
    m_done.insert(m_last);
    apply(core::acceptProposalsEdit(m_set, m_recording.dataset().cameras, m_last, kRater));
    ++m_reviewed;
    if (isCorrected)
        follow(m_last);
    return true;
}

} // namespace trial
