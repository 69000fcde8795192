// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "core/geometry/camera.h"
#include "widgets/views/camera/mesh_layer.h"

namespace widgets {

/// Draws one view's mesh layers off the window's thread. Of the requests that come while it draws, only the last one
/// counts. Layers that are the same as in the picture before, seen alike, are not drawn again.
class MeshLayerPainter : public QObject {
    Q_OBJECT
public:
    /// What is to be drawn: the arguments of drawMeshLayers.
    struct Request {
        core::Camera camera;
        std::vector<MeshLayer> layers;
        QPointF topLeftPx;
        QSize size;
        double scale = 1;
    };

    explicit MeshLayerPainter(QObject* parent = nullptr);
    ~MeshLayerPainter() override;

    void request(const Request& request);
    /// Draws what is still asked for on this thread, so that picture() is up to date.
    void finish();
    const MeshPicture& picture() const { return m_picture; }

signals:
    void pictureChanged();

private:
    struct Drawing;
    void start(const Request& request);
    void take(const std::shared_ptr<Drawing>& drawing);

    std::shared_ptr<Drawing> m_running;
    std::shared_ptr<const Drawing> m_last; ///< whose picture is shown
    std::optional<Request> m_next;
    MeshPicture m_picture;
};

} // namespace widgets
