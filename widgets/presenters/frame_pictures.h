// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include "widgets/jobs/frame_loader.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// Brings the pictures of the current frame into the camera views, and says there why one is missing.
class FramePictures : public QObject {
    Q_OBJECT

public:
    FramePictures(FrameLoader& frames, DatasetSession& opened, CameraGrid& grid, QObject* parent = nullptr);

    void show(int camera, const ImagePyramid& picture);
    /// While frames are played, pictures are as sharp as the largest view shows them.
    void chooseDrafts();

signals:
    void shown(int camera, const widgets::ImagePyramid& picture);
    /// Footage is missing, and a person wants to say where it is.
    void footageWanted();

private:
    void showStandIn(int camera, const ImagePyramid& picture);
    void showFailure(int camera, const QString& message);

    FrameLoader& m_frames;
    DatasetSession& m_opened;
    CameraGrid& m_grid;
};

} // namespace widgets
