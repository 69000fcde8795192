// SPDX-License-Identifier: MIT
#include "widgets/views/camera/mesh_layer_painter.h"

#include <QSemaphore>
#include <QThreadPool>

namespace widgets {

namespace {

/// The threads that all views share. Not Qt's global ones, where a fit may keep every thread busy for seconds.
QThreadPool& drawingThreads() {
    static QThreadPool threads;
    return threads;
}

MeshPicture draw(const MeshLayerPainter::Request& r) {
    return drawMeshLayers(r.camera, r.layers, r.topLeftPx, r.size, r.scale);
}

} // namespace

/// One request being drawn; shared by the window's thread and the drawing one.
struct MeshLayerPainter::Drawing {
    Request request;
    MeshPicture picture; ///< the drawing thread's until `ended`
    QSemaphore ended;
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
    drawingThreads().start([drawing = m_running, this] {
        drawing->picture = draw(drawing->request);
        QMetaObject::invokeMethod(
            this, [drawing, this] { take(drawing); }, Qt::QueuedConnection);
        drawing->ended.release();
    });
}

void MeshLayerPainter::take(const std::shared_ptr<Drawing>& drawing) {
    if (drawing != m_running)
        return; // finish() was faster
    m_picture = std::move(drawing->picture);
    m_running.reset();
    if (m_next)
        start(*std::exchange(m_next, std::nullopt));
    emit pictureChanged();
}

void MeshLayerPainter::finish() {
    if (!m_running)
        return;
    m_running->ended.acquire();
    m_picture = m_next ? draw(*m_next) : std::move(m_running->picture);
    m_next.reset();
    m_running.reset();
    emit pictureChanged();
}

} // namespace widgets
