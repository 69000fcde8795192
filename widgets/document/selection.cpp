// SPDX-License-Identifier: MIT
#include "widgets/document/selection.h"

#include <algorithm>

namespace widgets {

Selection::Selection(QObject* parent)
    : QObject(parent) {}

void Selection::setFrame(int frame) {
    const int wanted = std::clamp(frame, 0, std::max(0, m_frameCount - 1));
    if (wanted == m_frame)
        return;
    m_frame = wanted;
    emit frameChanged(m_frame);
}

void Selection::setJoint(const core::JointId& joint) {
    if (joint == m_joint)
        return;
    m_joint = joint;
    emit jointChanged();
}

void Selection::setCamera(const std::string& camera) {
    if (camera == m_camera)
        return;
    m_camera = camera;
    emit cameraChanged();
}

void Selection::setFrameCount(int frameCount) {
    if (frameCount == m_frameCount)
        return;
    m_frameCount = std::max(0, frameCount);
    emit frameCountChanged(m_frameCount);
    setFrame(m_frame);
}

} // namespace widgets
