// SPDX-License-Identifier: MIT
#include "widgets/jobs/review_queue.h"

#include <algorithm>
#include <set>
#include <utility>

#include "widgets/document/edit_command.h"

namespace widgets {

namespace {

constexpr int kReviewPauseMs = 150; ///< after an edit: a drag is many

bool concernsProposals(const core::MarkChange& change) {
    return (change.before && change.before->isProposal()) || (change.after && change.after->isProposal());
}

} // namespace

/// What the worker knows: a copy of the annotations and of what was proposed, which follow by edits.
struct ReviewQueue::State {
    core::AnnotationSet set;
    core::AnnotationSet proposed;
    core::ProposalReview review;
    std::set<int> unseen; ///< frames to look at

    void follow(const core::Edit& edit) {
        core::apply(set, edit);
        core::followProposals(proposed, edit);
        for (const core::MarkChange& change : edit.marks)
            unseen.insert(change.key.frame);
    }
    void look(const std::stop_token& stop) {
        while (!unseen.empty() && !stop.stop_requested())
            review.look(set, proposed, unseen.extract(unseen.begin()).value());
    }
};

ReviewQueue::ReviewQueue(const AnnotationDocument& document, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_job(pool, Job::Kind::Background) {
    m_wait.setSingleShot(true);
    m_wait.setInterval(kReviewPauseMs);
    connect(&m_wait, &QTimer::timeout, this, &ReviewQueue::look);
    connect(&document, &AnnotationDocument::opened, this, &ReviewQueue::restart);
    connect(&document, &AnnotationDocument::raterChanged, this, &ReviewQueue::restart);
    connect(&document, &AnnotationDocument::changed, this, &ReviewQueue::queue);
    connect(&m_job, &Job::finished, this, [this] {
        if (!m_edits.empty())
            m_wait.start();
    });
}

ReviewQueue::~ReviewQueue() = default;

void ReviewQueue::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_dataset = std::move(dataset);
    restart();
}

/// What programs have proposed and was not taken away, whatever became of it: marks that are proposals or were accepted
/// as they were, and the undo steps.
core::AnnotationSet ReviewQueue::proposedSoFar() const {
    core::AnnotationSet proposed;
    for (const auto& [key, mark] : m_document.annotations().marks)
        if (mark.isProposal() || mark.isAcceptedGuess())
            proposed.marks[key] = mark;
    const QUndoStack* stack = m_document.undoStack();
    core::AnnotationSet history;
    for (int step = 0; step < stack->index(); ++step)
        if (const auto* command = dynamic_cast<const EditCommand*>(stack->command(step)))
            core::followProposals(history, command->edit());
    proposed.marks.merge(history.marks);
    return proposed;
}

void ReviewQueue::restart() {
    m_job.stop();
    m_wait.stop();
    m_edits.clear();
    m_state.reset();
    m_rows.clear();
    m_openHands.clear();
    m_progress = {};
    m_reviewed = 0;
    if (m_dataset && m_document.isOpen()) {
        m_state = std::make_shared<State>(State{m_document.annotations(),
                                                proposedSoFar(),
                                                core::ProposalReview(m_dataset->cameras, m_document.rater()),
                                                {}});
        for (const int frame : core::annotatedFrames(m_state->proposed))
            m_state->unseen.insert(frame);
        if (!m_state->unseen.empty())
            look();
    }
    emit changed();
}

/// Edits without proposals matter in frames that have some.
void ReviewQueue::queue(const core::Edit& edit) {
    if (!m_state || edit.marks.empty())
        return;
    m_edits.push_back(edit);
    if (m_progress.left + m_reviewed > 0 || m_job.isRunning() ||
        std::any_of(edit.marks.begin(), edit.marks.end(), concernsProposals))
        m_wait.start();
}

void ReviewQueue::look() {
    if (!m_state)
        return;
    if (m_job.isRunning()) {
        m_wait.start();
        return;
    }
    m_job.start(
        [this, state = m_state, edits = std::exchange(m_edits, {})](const JobContext& context) -> Job::Delivery {
            for (const core::Edit& edit : edits)
                state->follow(edit);
            state->look(context.stop);
            if (context.stop.stop_requested())
                return {};
            const std::vector<core::ProposedFrame> frames = state->review.frames();
            const std::vector<core::ReviewFrame> seen = core::reviewFrames(frames);
            std::map<int, core::ProposedFrame> byFrame;
            std::map<int, std::map<core::Side, double>> openHands;
            int reviewed = 0;
            for (const core::ProposedFrame& frame : frames) {
                byFrame[frame.frame] = frame;
                reviewed += frame.isReviewed ? 1 : 0;
                if (!frame.openHands.empty())
                    openHands[frame.frame] = frame.openHands;
            }
            std::vector<ReviewRow> rows;
            for (const core::ReviewItem& item : core::reviewOrder(seen))
                rows.push_back({item, byFrame.at(item.frame)});
            return [this, rows = std::move(rows), openHands = std::move(openHands), reviewed,
                    progress = core::reviewProgress(seen)] {
                m_rows = rows;
                m_openHands = openHands;
                m_progress = progress;
                m_reviewed = reviewed;
                emit changed();
            };
        });
}

const ReviewRow* ReviewQueue::find(int frame) const {
    const auto row =
        std::find_if(m_rows.begin(), m_rows.end(), [frame](const ReviewRow& one) { return one.item.frame == frame; });
    return row == m_rows.end() ? nullptr : &*row;
}

std::optional<int> ReviewQueue::next(int frame) const {
    const ReviewRow* current = find(frame);
    const std::size_t at = current ? static_cast<std::size_t>(current - m_rows.data()) + 1 : 0;
    if (m_rows.empty() || (current && m_rows.size() == 1))
        return std::nullopt;
    return m_rows[at % m_rows.size()].item.frame;
}

void ReviewQueue::dropFrame(int frame) {
    const ReviewRow* row = find(frame);
    if (!row)
        return;
    m_rows.erase(m_rows.begin() + (row - m_rows.data()));
    m_openHands.erase(frame);
    m_progress.left = std::max(0, m_progress.left - 1);
    ++m_reviewed;
    emit changed();
}

} // namespace widgets
