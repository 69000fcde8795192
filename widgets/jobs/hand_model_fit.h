// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "core/annotation/edits.h"
#include "core/annotation/hand_fit.h"
#include "core/annotation/sequence_points.h"
#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/document/reconstructions.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// Hand models fitted to the 3D joints of one frame.
struct ModelFit {
    int frame = 0;
    core::HandPoses poses;                   ///< per hand of the dataset; an empty pose where joints are missing
    int joints = 0;                          ///< that the models were fitted to
    double rmsMm = 0;                        ///< their distance from the models' joints
    std::vector<core::JointPoint> proposals; ///< the models' places of joints without a 3D point
};

/// Fits the hand models to the joints of a frame that have a point: three or more per hand. Empty if no hand has them.
std::optional<ModelFit> fitModelToPoints(const core::Dataset& dataset, int frame, const core::JointPoints& points);

/// Keeps the hand models on the annotated joints of the current frame while it is on; in the background.
class HandModelFit : public QObject {
    Q_OBJECT

public:
    HandModelFit(const AnnotationDocument& document, const Selection& selection, const Reconstructions& reconstructions,
                 JobPool& pool, QObject* parent = nullptr);

    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    void setOn(bool on);
    bool isOn() const { return m_on; }
    /// Fits once, on or off; fitted() or impossible() follows.
    void fitOnce();

    /// The fit of the current frame while it is on.
    const std::optional<ModelFit>& fit() const { return m_fit; }

signals:
    /// The fit of the current frame is another, or gone.
    void changed();
    /// What fitOnce() asked for.
    void fitted(const widgets::ModelFit& fit);
    void impossible(const QString& reason);

private:
    void refresh();
    core::JointPoints points() const;

    const Selection& m_selection;
    const Reconstructions& m_reconstructions;
    Job m_job;
    Job m_onceJob;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::optional<ModelFit> m_fit;
    bool m_on = false;
};

} // namespace widgets
