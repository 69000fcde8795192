// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>

#include <QObject>

#include "core/annotation/click_sigmas.h"
#include "core/annotation/reconstruction.h"
#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// Per annotated frame and hand, how many joints are done, partial, bad, occluded. Frames without marks are not in it.
using FrameCoverage = std::map<int, std::map<core::Side, core::HandCoverage>>;

/// The coverage of the whole sequence for the document's rater: computed in the background when a sequence or rater is
/// opened, then kept up to date with every edit.
class AnnotationCoverage : public QObject {
    Q_OBJECT

public:
    AnnotationCoverage(const AnnotationDocument& document, JobPool& pool, QObject* parent = nullptr);

    /// Another dataset: every camera counts until setPictureGaps() says otherwise.
    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    /// Where the open sequence has no picture: views that need no mark.
    void setPictureGaps(core::PictureGaps gaps);
    /// What clicks are worth; assumed in a dataset until this says otherwise.
    void setClickSigmas(core::ClickSigmas sigmas);
    /// A joint is bad when its error is above this, px.
    void setBadRmsPx(double px);
    double badRmsPx() const { return m_badRmsPx; }

    const FrameCoverage& frames() const { return m_frames; }

signals:
    void changed();

private:
    void rebuild();
    void update(const core::Edit& edit);
    void updateFrame(int frame);

    const AnnotationDocument& m_document;
    Job m_job;
    std::shared_ptr<const core::Dataset> m_dataset;
    core::PictureGaps m_gaps;
    core::ClickSigmas m_sigmas;
    FrameCoverage m_frames;
    bool m_isStale = false; ///< a large edit is on its way
    double m_badRmsPx = 2.0;
};

} // namespace widgets
