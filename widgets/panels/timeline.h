// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>

#include <QWidget>

#include "widgets/session/annotation_coverage.h"

namespace widgets {

/// All frames in one line, a lane per hand: done, partial, bad, occluded; a click or drag goes there. Frames with notes
/// have a tick above, test frames one below; stripes stand for proposals that wait for a look.
class Timeline : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(QWidget* parent = nullptr);

    void setFrameCount(int frames);
    void setFrame(int frame);
    /// `joints` per hand is what "done" is measured against.
    void setCoverage(const FrameCoverage& frames, int leftJoints, int rightJoints);
    /// Hands that a program has placed and nobody has looked at, with their doubts, 0 .. 1.
    void setProposedHands(const std::map<int, std::map<core::Side, double>>& frames);
    void setNotedFrames(const std::set<int>& frames);
    void setTestFrames(const std::set<int>& frames);
    /// Frames in which other people have marks, and whose: a muted line between the lanes.
    void setOthersFrames(const std::map<int, QString>& frames);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// What the tool tip says over a frame: its state and what the colours mean.
    QString toolTipOf(int frame) const;

signals:
    void frameRequested(int frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF track() const;
    double xOf(int frame) const;
    int frameAt(double x) const;
    void paintLane(QPainter& painter, core::Side hand, const QRectF& lane) const;
    void paintProposals(QPainter& painter, core::Side hand, const QRectF& lane) const;
    void paintTicks(QPainter& painter) const;
    QString describe(int frame) const;

    FrameCoverage m_coverage;
    std::map<int, std::map<core::Side, double>> m_proposed;
    std::set<int> m_noted;
    std::set<int> m_tests;
    std::map<int, QString> m_others;
    int m_frames = 0;
    int m_frame = 0;
    int m_leftJoints = 0;
    int m_rightJoints = 0;
};

} // namespace widgets
