// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "core/annotation/click_sigmas.h"
#include "core/annotation/raters.h"
#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// The rater's name without the suffix of a repeat round.
std::string ownName(const std::string& rater);

/// How far the raters of the open sequence agree, and the repeat rounds in which a rater marks a random part of the own
/// work again without seeing the first marks.
class RaterStudy : public QObject {
    Q_OBJECT

public:
    RaterStudy(AnnotationDocument& document, Selection& selection, JobPool& pool, QObject* parent = nullptr);

    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    /// What every rater's clicks are worth from now on; what was compared is compared again.
    void setClickSigmas(const core::ClickSigmas& sigmas);

    /// Compares all raters as they stand now; compared() follows.
    void compare();
    const std::vector<core::RaterComparison>& comparisons() const { return m_comparisons; }
    const core::ClickSigmas& clickSigmas() const { return m_sigmas; }
    /// All raters' clicks of the selected joint in the current frame together, each weighed by its rater's scatter.
    core::Consensus consensus() const;

    /// True while the rater is in a repeat round.
    bool isRepeating() const;
    /// Goes on with an unfinished round or draws a new one in the background, `share` of what the rater has finished
    /// and never repeated; then marks are kept under repeatRaterName, or nothingToRepeat() says that there is nothing.
    void beginRepeating(double share, unsigned seed);
    /// Goes to the next joint of the round that is not marked in two views yet; false if all are.
    bool goToNextTask();
    /// Back to the rater's own name.
    void endRepeating();
    int tasks() const { return static_cast<int>(m_tasks.size()); }
    int openTasks() const;

signals:
    void compared();
    /// A round began, went on or ended.
    void roundChanged();
    void nothingToRepeat();
    /// The comparison was not possible, and why.
    void failed(const QString& message);

private:
    void takeSequence();
    void takeRater();
    void begin(const std::string& rater, std::vector<core::RepeatTask> tasks);
    bool isOpen(const core::RepeatTask& task) const;

    AnnotationDocument& m_document;
    Selection& m_selection;
    Job m_job;
    Job m_drawJob;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::vector<core::RaterComparison> m_comparisons;
    core::ClickSigmas m_sigmas;
    std::vector<core::RepeatTask> m_tasks;
};

} // namespace widgets
