// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <vector>

#include <QObject>
#include <QTimer>

#include "core/annotation/click_sigmas.h"
#include "core/annotation/quality.h"
#include "core/annotation/quality_checker.h"
#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// The findings of the whole sequence for the document's rater. Found in the background: all frames when a sequence or
/// rater is opened or clicks count otherwise, then those that an edit touched, a moment after the edit.
class QualityChecks : public QObject {
    Q_OBJECT

public:
    QualityChecks(const AnnotationDocument& document, JobPool& pool, QObject* parent = nullptr);
    ~QualityChecks() override;

    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    /// What clicks are worth from now on: every frame is looked at again, the findings stay until then.
    void setClickSigmas(const core::ClickSigmas& sigmas);

    /// By frame.
    const std::vector<core::QualityFinding>& findings() const { return m_findings; }
    /// True when everything that was done has been looked at.
    bool isUpToDate() const { return !m_job.isRunning() && !m_wait.isActive(); }

signals:
    void changed();

private:
    struct State;
    void restart();
    void begin();
    void queue(const core::Edit& edit);
    void look();

    const AnnotationDocument& m_document;
    Job m_job;
    QTimer m_wait;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<State> m_state;  ///< the worker's while it runs
    std::vector<core::Edit> m_edits; ///< that the state does not know yet
    std::vector<core::QualityFinding> m_findings;
    core::ClickSigmas m_sigmas;
};

} // namespace widgets
