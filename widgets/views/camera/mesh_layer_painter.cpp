// SPDX-License-Identifier: MIT
#include "widgets/views/camera/mesh_layer_painter.h"

#include <algorithm>

#include <QPainter>
#include <QSemaphore>
#include <QThreadPool>

namespace widgets {

namespace {

/// The threads that all views share. Not Qt's global ones, where a fit may keep every thread busy for seconds.
QThreadPool& drawingThreads() {
    static QThreadPool threads;
    return threads;
}

bool isSameView(const core::Camera& a, const core::Camera& b) {
    return a.size == b.size && a.intrinsics == b.intrinsics && a.distortion == b.distortion && a.fisheye == b.fisheye &&
           a.cameraFromWorld.rotation == b.cameraFromWorld.rotation &&
           a.cameraFromWorld.translation == b.cameraFromWorld.translation;
}

bool isSameCrop(const MeshLayerPainter::Request& a, const MeshLayerPainter::Request& b) {
    return a.topLeftPx == b.topLeftPx && a.size == b.size && a.scale == b.scale && isSameView(a.camera, b.camera);
}

} // namespace

/// One request being drawn; shared by the window's thread and the drawing one.
struct MeshLayerPainter::Drawing {
    Request request;
    MeshPicture picture;        ///< the drawing thread's until `ended`, as the next one
    std::vector<QImage> layers; ///< one picture per layer of the request
    QSemaphore ended;

    /// What drawMeshLayers makes of the request. last: an ended drawing, or none.
    void draw(const Drawing* last) {
        picture = {{}, request.topLeftPx, request.scale};
        for (const MeshLayer& layer : request.layers) {
            layers.push_back(layerPicture(layer, last));
            if (picture.picture.isNull())
                picture.picture = layers.back();
            else if (!layers.back().isNull())
                QPainter(&picture.picture).drawImage(0, 0, layers.back());
        }
    }

private:
    QImage layerPicture(const MeshLayer& layer, const Drawing* last) const {
        if (last && isSameCrop(last->request, request)) {
            const auto found = std::find(last->request.layers.begin(), last->request.layers.end(), layer);
            if (found != last->request.layers.end())
                return last->layers[static_cast<std::size_t>(found - last->request.layers.begin())];
        }
        return drawMeshLayers(request.camera, {layer}, request.topLeftPx, request.size, request.scale).picture;
    }
};

MeshLayerPainter::MeshLayerPainter(QObject* parent)
    : QObject(parent) {}

MeshLayerPainter::~MeshLayerPainter() {
    if (m_running)
        m_running->ended.acquire(); // the drawing thread still refers to this object: a few milliseconds
}

void MeshLayerPainter::request(const Request& request) {
    if (m_running)
        m_next = request;
    else
        start(request);
}

void MeshLayerPainter::start(const Request& request) {
    m_running = std::make_shared<Drawing>();
    m_running->request = request;
    drawingThreads().start([drawing = m_running, last = m_last, this] {
        drawing->draw(last.get());
        QMetaObject::invokeMethod(
            this, [drawing, this] { take(drawing); }, Qt::QueuedConnection);
        drawing->ended.release();
    });
}

void MeshLayerPainter::take(const std::shared_ptr<Drawing>& drawing) {
    if (drawing != m_running)
        return; // finish() was faster
    m_picture = drawing->picture;
    m_last = std::move(m_running);
    m_running.reset();
    if (m_next)
        start(*std::exchange(m_next, std::nullopt));
    emit pictureChanged();
}

void MeshLayerPainter::finish() {
    if (!m_running)
        return;
    m_running->ended.acquire();
    if (m_next) {
        auto drawing = std::make_shared<Drawing>();
        drawing->request = *std::exchange(m_next, std::nullopt);
        drawing->draw(m_running.get());
        m_running = std::move(drawing);
    }
    m_picture = m_running->picture;
    m_last = std::move(m_running);
    m_running.reset();
    emit pictureChanged();
}

} // namespace widgets
