// SPDX-License-Identifier: MIT
#include "widgets/jobs/rig_study.h"

#include <utility>

#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_rig.h"
#include "widgets/text/error_text.h"
#include "widgets/text/rig_text.h"

namespace widgets {

namespace {

constexpr int kSettledMs = 1000; ///< after the last edit

} // namespace

/// What the worker knows: the clicks of the other sequences, and a copy of the open one's annotations.
struct RigStudy::Evidence {
    std::shared_ptr<const core::Dataset> dataset;
    int sequence = 0; ///< index of the open one
    core::AnnotationSet set;
    std::vector<core::RigJoint> others;
    QStringList unread;
    bool isRead = false; ///< the others

    void readOthers(const std::stop_token& stop) {
        for (std::size_t s = 0; s < dataset->sequences.size() && !isRead; ++s) {
            if (stop.stop_requested())
                return;
            if (static_cast<int>(s) == sequence)
                continue;
            try {
                core::addRigJoints(others, core::readAnnotations(*dataset, dataset->sequences[s]), dataset->cameras,
                                   static_cast<int>(s));
            } catch (const core::Error& error) {
                unread << withoutDetail(errorInWords(error));
            }
        }
        isRead = true;
    }
    std::shared_ptr<const RigState> judged() const {
        auto state = std::make_shared<RigState>();
        state->joints = others;
        core::addRigJoints(state->joints, set, dataset->cameras, sequence);
        state->residuals = core::computeRigResiduals(dataset->cameras, state->joints);
        state->health = core::judgeRig(dataset->cameras, state->joints, state->residuals);
        state->needs = core::adviseRefinement(state->health, state->joints);
        state->sigmas = core::estimateClickSigmas(dataset->cameras, state->joints, state->residuals);
        state->sequences = core::sequenceNames(*dataset);
        state->unread = unread;
        return state;
    }
};

RigStudy::RigStudy(const AnnotationDocument& document, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_job(pool, Job::Kind::Background)
    , m_refinement(pool) {
    m_wait.setSingleShot(true);
    m_wait.setInterval(kSettledMs);
    connect(&m_wait, &QTimer::timeout, this, &RigStudy::look);
    connect(&document, &AnnotationDocument::aboutToClose, this, &RigStudy::forget);
    connect(&document, &AnnotationDocument::changed, this, &RigStudy::queue);
    connect(&m_job, &Job::finished, this, [this] {
        if (!m_edits.empty())
            m_wait.start();
        else if (m_refiningWanted)
            startRefinement();
    });
    for (const Job* job : {&m_job, &m_refinement})
        connect(job, &Job::failed, this, &RigStudy::failed);
    for (const auto end : {&Job::started, &Job::finished, &Job::stopped})
        connect(&m_refinement, end, this, &RigStudy::refiningChanged);
    connect(&m_refinement, &Job::failed, this, &RigStudy::refiningChanged);
}

RigStudy::~RigStudy() = default;

void RigStudy::forget() {
    m_job.stop();
    m_refinement.stop();
    m_wait.stop();
    m_edits.clear();
    m_evidence.reset();
    m_state.reset();
    m_refiningWanted = false;
    discardProposal();
    emit changed();
}

void RigStudy::setSequence(std::shared_ptr<const core::Dataset> dataset, const std::string& sequence) {
    forget();
    if (dataset != m_dataset) // of another calibration
        setClickSigmas({});
    m_dataset = std::move(dataset);
    m_evidence = std::make_shared<Evidence>();
    m_evidence->dataset = m_dataset;
    while (m_dataset->sequences[static_cast<std::size_t>(m_evidence->sequence)].name != sequence)
        ++m_evidence->sequence;
    m_evidence->set = m_document.annotations();
    look();
}

void RigStudy::queue(const core::Edit& edit) {
    if (!m_evidence || edit.marks.empty())
        return;
    m_edits.push_back(edit);
    m_wait.start();
}

void RigStudy::look() {
    if (!m_evidence)
        return;
    m_wait.stop();
    if (m_job.isRunning()) {
        m_wait.start();
        return;
    }
    m_job.start(
        [this, evidence = m_evidence, edits = std::exchange(m_edits, {})](const JobContext& context) -> Job::Delivery {
            for (const core::Edit& edit : edits)
                core::apply(evidence->set, edit);
            evidence->readOthers(context.stop);
            if (context.stop.stop_requested())
                return {};
            return [this, state = evidence->judged()] { take(state); };
        });
}

void RigStudy::lookNow() {
    if (m_wait.isActive() && !m_job.isRunning())
        look();
}

void RigStudy::take(const std::shared_ptr<const RigState>& state) {
    m_state = state;
    if (!core::areAlike(state->sigmas, m_sigmas))
        setClickSigmas(state->sigmas);
    emit changed();
}

void RigStudy::setClickSigmas(const core::ClickSigmas& sigmas) {
    if (sigmas == m_sigmas)
        return;
    m_sigmas = sigmas;
    emit clickSigmasChanged();
}

void RigStudy::refine() {
    if (!m_evidence || isRefining())
        return;
    discardProposal();
    if (isUpToDate()) {
        startRefinement();
        return;
    }
    m_refiningWanted = true;
    lookNow();
    emit refiningChanged();
}

void RigStudy::stop() {
    const bool wasWaiting = std::exchange(m_refiningWanted, false);
    m_refinement.stop();
    if (wasWaiting)
        emit refiningChanged();
}

void RigStudy::startRefinement() {
    m_refiningWanted = false;
    m_refinement.start([this, dataset = m_dataset, state = m_state](const JobContext& context) -> Job::Delivery {
        auto refinement = core::refineRig(dataset->cameras, state->joints, state->residuals, {}, context.stop);
        if (context.stop.stop_requested())
            return {};
        if (!refinement)
            return [this, state] {
                core::RefinementNeeds needs = state->needs;
                needs.advice = core::RefinementAdvice::NeedsMoreJoints;
                emit failed(refinementNeedsText(state->health, needs));
            };
        auto proposal = std::make_shared<RigProposal>();
        proposal->residuals = core::computeRigResiduals(refinement->cameras, state->joints);
        proposal->refinement = *std::move(refinement);
        if (const auto world =
                core::worldCovariance(dataset->cameras, state->sigmas, proposal->refinement.middleInWorld))
            proposal->worldSigmaMm = core::sigmaMm(*world);
        return [this, proposal] {
            m_proposal = proposal;
            emit proposalChanged();
        };
    });
}

void RigStudy::discardProposal() {
    if (!m_proposal)
        return;
    m_proposal.reset();
    emit proposalChanged();
}

} // namespace widgets
