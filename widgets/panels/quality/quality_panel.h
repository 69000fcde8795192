// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableView>
#include <QWidget>

#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/quality_checks.h"
#include "widgets/jobs/rater_study.h"
#include "widgets/models/finding_model.h"
#include "widgets/panels/quality/rig_health_view.h"
#include "widgets/session/annotation_coverage.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// What the quality panel looks at.
struct QualitySources {
    const AnnotationDocument& document;
    Selection& selection;
    const Reconstructions& reconstructions;
    const JointList& joints;
    AnnotationCoverage& coverage;
    const QualityChecks& checks;
    const RaterStudy& raters;
    const RigStudy& rig;
};

/// What deserves a look in the current frame or the whole sequence, how the sequence stands, and what the clicks say of
/// the cameras. A row jumps to its joint and view.
class QualityPanel : public QWidget {
    Q_OBJECT

public:
    explicit QualityPanel(const QualitySources& sources, QWidget* parent = nullptr);

    /// The keyboard goes to the error threshold.
    void askForThreshold();
    /// What the clicks say of the cameras comes to the front.
    void showCameras();
    RigHealthView* cameras() const { return m_cameras; }

signals:
    void badRmsPxChanged(double px);
    /// The person wants to refine the calibration.
    void refineRequested();

private:
    void build();
    void refresh();
    void refreshSummary();
    void refreshRig();
    QString nothingText() const;
    std::vector<Finding> frameFindings() const;
    std::vector<Finding> sequenceFindings() const;
    void jump(const QModelIndex& index);

    enum Scope { ThisFrame, WholeSequence, Cameras };

    QualitySources m_from;
    MessageBar* m_rigMessage;
    QDoubleSpinBox* m_threshold;
    QComboBox* m_scope;
    QLabel* m_summary;
    QLabel* m_nothing;
    QTableView* m_table;
    FindingModel* m_model;
    RigHealthView* m_cameras;
    QString m_rigText; ///< that was offered last
};

} // namespace widgets
