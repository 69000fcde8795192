// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QComboBox>
#include <QSpinBox>
#include <QToolButton>
#include <QWidget>

#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/document/joint_list.h"
#include "widgets/document/selection.h"
#include "widgets/panels/timeline.h"
#include "widgets/session/annotation_coverage.h"

class QAction;

namespace widgets {

/// The strip above the views: sequence, previous, frame number, next, play, timeline.
class FramesBar : public QWidget {
    Q_OBJECT

public:
    FramesBar(Selection& selection, const AnnotationDocument& document, const AnnotationCoverage& coverage,
              const JointList& joints, QWidget* parent = nullptr);

    /// The actions behind the buttons.
    void setActions(QAction* previous, QAction* next, QAction* play);
    void setDataset(const core::Dataset& dataset);
    /// Shows which sequence is open.
    void setSequence(const QString& name);
    /// Frames that the benchmark draws, marked below the timeline.
    void setTestFrames(const std::set<int>& frames) { m_timeline->setTestFrames(frames); }
    /// Hands that wait for a look, with their doubts.
    void setProposedHands(const std::map<int, std::map<core::Side, double>>& frames) {
        m_timeline->setProposedHands(frames);
    }
    /// The keyboard goes to the frame number.
    void askForFrame();

signals:
    void sequenceRequested(const QString& name);

private:
    void refreshFrame();
    void refreshCoverage();
    void refreshNotes();
    void showLegend();
    void refreshOthers();

    Selection& m_selection;
    const AnnotationDocument& m_document;
    const AnnotationCoverage& m_coverage;
    const JointList& m_joints;
    QComboBox* m_sequences;
    QToolButton* m_previous;
    QSpinBox* m_frame;
    QToolButton* m_next;
    QToolButton* m_play;
    Timeline* m_timeline;
    QToolButton* m_legend;
};

} // namespace widgets
