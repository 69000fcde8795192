// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QObject>

#include "core/annotation/annotation_set.h"

namespace widgets {

/// What the person is working on: frame (from 0), joint and camera. It holds no data and never writes any.
/// Setting a value that is already there emits nothing.
class Selection : public QObject {
    Q_OBJECT

public:
    explicit Selection(QObject* parent = nullptr);

    int frame() const { return m_frame; }
    const core::JointId& joint() const { return m_joint; }
    /// Name of the active camera; empty if none is.
    const std::string& camera() const { return m_camera; }

    /// Clamped into [0, frameCount).
    void setFrame(int frame);
    void setJoint(const core::JointId& joint);
    void setCamera(const std::string& camera);
    /// How many frames there are; the current one is clamped. 0 while nothing is open (the frame is then 0).
    void setFrameCount(int frameCount);
    int frameCount() const { return m_frameCount; }

signals:
    void frameChanged(int frame);
    void jointChanged();
    void cameraChanged();
    void frameCountChanged(int frameCount);

private:
    int m_frame = 0;
    int m_frameCount = 0;
    core::JointId m_joint;
    std::string m_camera;
};

} // namespace widgets
