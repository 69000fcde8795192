// SPDX-License-Identifier: MIT
#include "widgets/session/annotation_coverage.h"

#include <set>

namespace widgets {

namespace {

/// Edits of more frames than this are counted again in the background.
constexpr std::size_t kFramesAtOnce = 4;

FrameCoverage coverageOfAll(const core::AnnotationSet& set, const core::Dataset& dataset, const std::string& rater,
                            double badRmsPx, const core::PictureGaps& gaps, const core::TriangulationOptions& options,
                            const std::stop_token& stop) {
    FrameCoverage frames;
    for (const int frame : core::annotatedFrames(set)) {
        if (stop.stop_requested())
            break;
        frames[frame] = core::coverageOf(set, dataset.cameras, frame, rater, badRmsPx, options, gaps);
    }
    return frames;
}

} // namespace

AnnotationCoverage::AnnotationCoverage(const AnnotationDocument& document, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_job(pool) {
    connect(&document, &AnnotationDocument::opened, this, &AnnotationCoverage::rebuild);
    connect(&document, &AnnotationDocument::raterChanged, this, &AnnotationCoverage::rebuild);
    connect(&document, &AnnotationDocument::changed, this, &AnnotationCoverage::update);
    connect(&document, &AnnotationDocument::busyChanged, this, [this] {
        if (m_isStale && !m_document.isApplying())
            rebuild();
    });
}

void AnnotationCoverage::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_dataset = std::move(dataset);
    m_gaps = {};
    m_sigmas = {};
    rebuild();
}

void AnnotationCoverage::setPictureGaps(core::PictureGaps gaps) {
    if (gaps == m_gaps)
        return;
    m_gaps = std::move(gaps);
    rebuild();
}

void AnnotationCoverage::setClickSigmas(core::ClickSigmas sigmas) {
    m_sigmas = std::move(sigmas);
    rebuild();
}

void AnnotationCoverage::setBadRmsPx(double px) {
    m_badRmsPx = px;
    rebuild();
}

void AnnotationCoverage::rebuild() {
    m_job.stop();
    m_isStale = false;
    m_frames.clear();
    emit changed();
    if (!m_dataset || m_document.annotations().marks.empty())
        return;
    m_job.start([this, set = m_document.annotations(), dataset = m_dataset, rater = m_document.rater(),
                 bad = m_badRmsPx, gaps = m_gaps,
                 options = m_sigmas.optionsFor(m_document.rater())](const JobContext& context) -> Job::Delivery {
        return [this, frames = coverageOfAll(set, *dataset, rater, bad, gaps, options, context.stop)] {
            m_frames = frames;
            emit changed();
        };
    });
}

void AnnotationCoverage::update(const core::Edit& edit) {
    if (!m_dataset)
        return;
    std::set<int> touched;
    for (const core::MarkChange& change : edit.marks)
        touched.insert(change.key.frame);
    if (touched.empty())
        return;
    if (m_document.isApplying()) { // a slice of a large edit: counted when all has come
        m_isStale = true;
        return;
    }
    if (m_job.isRunning() || touched.size() > kFramesAtOnce) {
        rebuild();
        return;
    }
    for (const int frame : touched)
        updateFrame(frame);
    emit changed();
}

void AnnotationCoverage::updateFrame(int frame) {
    const auto hands = core::coverageOf(m_document.annotations(), m_dataset->cameras, frame, m_document.rater(),
                                        m_badRmsPx, m_sigmas.optionsFor(m_document.rater()), m_gaps);
    const auto first = m_document.annotations().marks.lower_bound({frame, {}, {}, {}});
    if (first != m_document.annotations().marks.end() && first->first.frame == frame)
        m_frames[frame] = hands;
    else
        m_frames.erase(frame);
}

} // namespace widgets
