// SPDX-License-Identifier: MIT
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QWidget>

#include "widgets/document/selection.h"
#include "widgets/jobs/silhouette_study.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// How silhouettes are found, the brush that touches them up, and the run over a range of frames. While it is open the
/// camera views show the current frame's silhouettes.
class SilhouettePage : public QWidget {
    Q_OBJECT

public:
    SilhouettePage(SilhouetteStudy& study, const Selection& selection, QWidget* parent = nullptr);
    ~SilhouettePage() override;

    /// Makes the silhouettes of the chosen frames, or asks first whether those of the sequence are to be replaced.
    void run();
    /// The brush as it is elsewhere, too.
    void showBrush(bool on, double radiusPx);

signals:
    void brushRequested(bool on);
    void brushRadiusRequested(double radiusPx);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    QLayout* makeMethod();
    QLayout* makeBrush();
    QLayout* makeFrames();
    QLayout* makeButtons();
    void connectStudy();
    void applyMethod();
    void showMethod();
    void showFound();
    void showRunning();
    void showUndo();
    void start(bool attach);

    SilhouetteStudy& m_study;
    const Selection& m_selection;
    MessageBar* m_message;
    QComboBox* m_method;
    QDoubleSpinBox* m_band;
    QDoubleSpinBox* m_forearm;
    QLabel* m_found;
    QToolButton* m_brush;
    QDoubleSpinBox* m_radius;
    QToolButton* m_undo;
    QToolButton* m_redo;
    QSpinBox* m_from;
    QSpinBox* m_to;
    QSpinBox* m_step;
    QCheckBox* m_attach;
    QPushButton* m_make;
    QProgressBar* m_progress;
    QPushButton* m_stop;
};

} // namespace widgets
