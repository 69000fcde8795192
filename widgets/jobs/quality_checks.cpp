// SPDX-License-Identifier: MIT
#include "widgets/jobs/quality_checks.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/rig/click_sigma_estimate.h"

namespace widgets {

namespace {

constexpr int kPauseMs = 300; ///< after an edit: a drag is many

/// All frames of the set.
std::set<int> framesOf(const core::AnnotationSet& set) {
    const std::vector<int> frames = core::annotatedFrames(set);
    return {frames.begin(), frames.end()};
}

std::set<int> framesOf(const std::vector<core::Edit>& edits) {
    std::set<int> frames;
    for (const core::Edit& edit : edits)
        for (const core::MarkChange& change : edit.marks)
            frames.insert(change.key.frame);
    return frames;
}

} // namespace

/// What the worker knows: a copy of the annotations, which follows by edits, and what was found in them.
struct QualityChecks::State {
    core::AnnotationSet set;
    core::QualityChecker checker;
    std::shared_ptr<const core::Dataset> dataset;
    std::string rater;
    std::set<int> unseen; ///< frames to look at
    core::ClickSigmas sigmas;
    int clicks = -1; ///< that the sigmas were estimated from; none yet

    core::QualityChecker newChecker() const {
        core::QualityOptions options;
        options.triangulation = sigmas.optionsFor(rater);
        return {dataset->cameras, dataset->hands, rater, options};
    }
    void look(const std::stop_token& stop) {
        while (!unseen.empty() && !stop.stop_requested())
            checker.check(set, unseen.extract(unseen.begin()).value());
    }
    /// Estimates the sigmas again if many clicks are new. If they differ, every frame is to be looked at again.
    void estimateSigmas() {
        const auto now = static_cast<int>(std::count_if(set.marks.begin(), set.marks.end(),
                                                        [](const auto& item) { return item.second.isEvidence(); }));
        constexpr int kManyClicks = 16;
        if (clicks >= 0 && std::abs(now - clicks) < std::max(kManyClicks, clicks / 10))
            return;
        clicks = now;
        std::vector<core::RigJoint> joints;
        core::addRigJoints(joints, set, dataset->cameras, 0);
        core::ClickSigmas found = core::estimateClickSigmas(dataset->cameras, joints);
        if (core::areAlike(found, sigmas))
            return;
        sigmas = std::move(found);
        checker = newChecker();
        unseen = framesOf(set);
    }
};

QualityChecks::QualityChecks(const AnnotationDocument& document, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_job(pool, Job::Kind::Background) {
    m_wait.setSingleShot(true);
    m_wait.setInterval(kPauseMs);
    connect(&m_wait, &QTimer::timeout, this, &QualityChecks::look);
    connect(&document, &AnnotationDocument::opened, this, &QualityChecks::restart);
    connect(&document, &AnnotationDocument::raterChanged, this, &QualityChecks::restart);
    connect(&document, &AnnotationDocument::changed, this, &QualityChecks::queue);
    connect(&m_job, &Job::finished, this, [this] {
        if (!m_edits.empty())
            m_wait.start();
    });
}

QualityChecks::~QualityChecks() = default;

void QualityChecks::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_dataset = std::move(dataset);
    m_sigmas = {};
    restart();
}

void QualityChecks::restart() {
    m_job.stop();
    m_wait.stop();
    m_edits.clear();
    m_state.reset();
    m_findings.clear();
    m_noise.reset();
    if (m_dataset) {
        m_state = std::make_shared<State>(
            State{m_document.annotations(), core::QualityChecker(m_dataset->cameras, m_dataset->hands, {}), m_dataset,
                  m_document.rater(), framesOf(m_document.annotations()), m_sigmas});
        m_state->checker = m_state->newChecker();
        look();
    }
    emit changed();
}

void QualityChecks::queue(const core::Edit& edit) {
    if (!m_state || edit.marks.empty())
        return;
    m_edits.push_back(edit);
    m_wait.start();
}

void QualityChecks::look() {
    if (!m_state)
        return;
    if (m_job.isRunning()) {
        m_wait.start();
        return;
    }
    if (m_edits.empty() && m_state->unseen.empty())
        return;
    m_job.start(
        [this, state = m_state, edits = std::exchange(m_edits, {})](const JobContext& context) -> Job::Delivery {
            for (const core::Edit& edit : edits)
                core::apply(state->set, edit);
            state->unseen.merge(framesOf(edits));
            state->estimateSigmas();
            state->look(context.stop);
            auto noise = core::estimateClickNoise(state->set, state->dataset->cameras, state->rater);
            return [this, found = state->checker.findings(), noise = std::move(noise), sigmas = state->sigmas] {
                m_findings = found;
                m_noise = noise;
                if (sigmas != m_sigmas) {
                    m_sigmas = sigmas;
                    emit clickSigmasChanged();
                }
                emit changed();
            };
        });
}

} // namespace widgets
