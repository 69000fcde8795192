// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <QObject>

#include "widgets/document/annotation_document.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/hand_model_fit.h"
#include "widgets/jobs/hand_places.h"
#include "widgets/jobs/job.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// What tells where the hands are.
struct HandSources {
    const AnnotationDocument& document;
    const Reconstructions& reconstructions;
    const Selection& selection;
    const DatasetSession& datasets;
    const HandModelFit& model;
};

/// Zooms the views to the hands and writes beside each hand which one it is. Where the hands are comes from the
/// recorded motion, the hand model of the marks, the marks of all raters in this or the nearest annotated frame, or the
/// masks; a view in which nothing is known shows its whole image. Zoom and pan then stay when the frame changes.
class HandFraming : public QObject {
    Q_OBJECT

public:
    HandFraming(const HandSources& sources, CameraGrid& grid, JobPool& pool, QObject* parent = nullptr);

    /// Frames the hands of the current frame in every view; those of masks follow in the background. False if nothing
    /// is known and there are no masks.
    bool frameHands();
    /// Views that nobody has zoomed by hand show the hands of the current frame, if they are known in it and the views
    /// do not show them well already: a first pass has found them, or the review went to another frame.
    void showHands();
    void setLabelsShown(bool shown);
    bool labelsShown() const { return m_labelsShown; }
    /// The label of a hand that is not shown goes, too.
    void setHandShown(core::Side hand, bool shown);

private:
    std::vector<HandPlace> knownHands() const;
    std::vector<HandPlace> handsOfThisFrame() const;
    std::optional<QRectF> boxIn(int camera, const std::vector<HandPlace>& hands) const;
    void frameByMasks(const std::vector<int>& cameras);
    void frameMaximised(int camera);
    void refreshLabels();

    HandSources m_sources;
    CameraGrid& m_grid;
    Job m_maskJob;
    std::array<bool, 2> m_handShown{true, true}; ///< left, right
    bool m_labelsShown = true;
};

} // namespace widgets
