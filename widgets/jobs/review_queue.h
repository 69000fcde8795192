// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "core/io/dataset/dataset.h"
#include "core/labelling/proposal_review.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// A frame that waits for a look: where it stands in the order, and why.
struct ReviewRow {
    core::ReviewItem item;
    core::ProposedFrame why;
};

/// The frames whose proposals nobody has looked at, those first whose look teaches most; for the document's rater, kept
/// up to date in the background.
class ReviewQueue : public QObject {
    Q_OBJECT

public:
    ReviewQueue(const AnnotationDocument& document, JobPool& pool, QObject* parent = nullptr);
    ~ReviewQueue() override;

    void setDataset(std::shared_ptr<const core::Dataset> dataset);

    const std::vector<ReviewRow>& rows() const { return m_rows; }
    /// The row of a frame, or null if it does not wait.
    const ReviewRow* find(int frame) const;
    /// The frame that comes after `frame` in the order, from the last one on to the first; the first one if `frame`
    /// does not wait. No value if none is left but `frame`.
    std::optional<int> next(int frame) const;
    const core::ReviewProgress& progress() const { return m_progress; }
    int reviewed() const { return m_reviewed; }
    /// The doubts of hands that wait, by frame.
    const std::map<int, std::map<core::Side, double>>& openHands() const { return m_openHands; }
    /// True when everything that was done has been looked at.
    bool isUpToDate() const { return !m_job.isRunning() && !m_wait.isActive(); }

    /// The frame was accepted: it leaves the queue at once.
    void dropFrame(int frame);

signals:
    void changed();

private:
    struct State;
    void restart();
    void queue(const core::Edit& edit);
    void look();
    core::AnnotationSet proposedSoFar() const;

    const AnnotationDocument& m_document;
    Job m_job;
    QTimer m_wait;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<State> m_state;  ///< the worker's while it runs
    std::vector<core::Edit> m_edits; ///< that the state does not know yet
    std::vector<ReviewRow> m_rows;
    std::map<int, std::map<core::Side, double>> m_openHands;
    core::ReviewProgress m_progress;
    int m_reviewed = 0;
};

} // namespace widgets
