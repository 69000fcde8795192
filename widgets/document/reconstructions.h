// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>

#include <QObject>

#include "core/annotation/click_sigmas.h"
#include "core/annotation/reconstruction.h"
#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/document/selection.h"

namespace widgets {

/// The 3D joints of the current frame and rater, kept up to date with every edit. The selected joint is looked at in
/// detail (ellipses, leave-one-out, next view) and is always there, also without marks.
class Reconstructions : public QObject {
    Q_OBJECT

public:
    Reconstructions(const AnnotationDocument& document, const Selection& selection, QObject* parent = nullptr);

    /// Another dataset: every camera counts until setPictureGaps() says otherwise.
    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    /// Where the open sequence has no picture: views that need no mark.
    void setPictureGaps(core::PictureGaps gaps);
    /// What clicks are worth; assumed in a dataset until this says otherwise.
    void setClickSigmas(core::ClickSigmas sigmas);
    const core::ClickSigmas& clickSigmas() const { return m_sigmas; }

    /// Every joint with at least one mark in the frame.
    const std::map<core::JointId, core::JointReconstruction>& joints() const { return m_joints; }
    /// That joint, or null if it has no mark.
    const core::JointReconstruction* find(const core::JointId& joint) const;
    const core::JointReconstruction& selected() const { return m_selected; }
    /// With the sigmas of the document's rater.
    const core::TriangulationOptions& options() const { return m_options; }

    /// Any joint of any frame for the document's rater, with all details.
    core::JointReconstruction compute(int frame, const core::JointId& joint) const;

signals:
    void changed();

private:
    void rebuild();
    void update(const core::Edit& edit);
    void selectJoint();
    void refreshSelected();
    core::ReconstructionOptions optionsAt(int frame, bool details) const;
    std::optional<Eigen::Vector3d> nearPoint(core::Side hand) const;

    const AnnotationDocument& m_document;
    const Selection& m_selection;
    std::shared_ptr<const core::Dataset> m_dataset;
    core::PictureGaps m_gaps;
    core::ClickSigmas m_sigmas;
    core::TriangulationOptions m_options;
    std::map<core::JointId, core::JointReconstruction> m_joints;
    core::JointReconstruction m_selected;
};

} // namespace widgets
