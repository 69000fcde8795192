// SPDX-License-Identifier: MIT
#include "widgets/jobs/quality_checks.h"

#include <utility>

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
    std::set<int> unseen; ///< frames to look at

    void look(const std::stop_token& stop) {
        while (!unseen.empty() && !stop.stop_requested())
            checker.check(set, unseen.extract(unseen.begin()).value());
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

void QualityChecks::setClickSigmas(const core::ClickSigmas& sigmas) {
    if (sigmas == m_sigmas)
        return;
    m_sigmas = sigmas;
    begin();
}

void QualityChecks::restart() {
    m_findings.clear();
    begin();
    emit changed();
}

void QualityChecks::begin() {
    m_job.stop();
    m_wait.stop();
    m_edits.clear();
    m_state.reset();
    if (!m_dataset)
        return;
    core::QualityOptions options;
    options.triangulation = m_sigmas.optionsFor(m_document.rater());
    m_state = std::make_shared<State>(
        State{m_document.annotations(),
              core::QualityChecker(m_dataset->cameras, m_dataset->hands, m_document.rater(), options),
              framesOf(m_document.annotations())});
    look();
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
            state->look(context.stop);
            return [this, found = state->checker.findings()] {
                m_findings = found;
                emit changed();
            };
        });
}

} // namespace widgets
