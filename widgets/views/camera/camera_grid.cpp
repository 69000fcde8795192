// SPDX-License-Identifier: MIT
#include "widgets/views/camera/camera_grid.h"

#include <algorithm>
#include <numeric>

#include <QEvent>
#include <QPainter>

#include "core/numeric/median.h"
#include "widgets/views/camera/grid_packing.h"

namespace widgets {

namespace {

constexpr int kGap = 2; // between views; the current one's frame is drawn in it

/// The views' typical width / height, by which the grid is chosen.
double medianAspect(const std::vector<CameraView*>& views) {
    std::vector<double> aspects;
    for (const CameraView* view : views) {
        const core::ImageSize& size = view->camera().size;
        aspects.push_back(size.height > 0 ? static_cast<double>(size.width) / size.height : 1);
    }
    return core::medianOf(std::move(aspects));
}

} // namespace

CameraGrid::CameraGrid(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

CameraGrid::~CameraGrid() = default;

void CameraGrid::setCameras(const std::vector<core::Camera>& cameras) {
    while (m_views.size() > cameras.size()) {
        delete m_views.back();
        m_views.pop_back();
    }
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const bool isNew = i == m_views.size();
        if (isNew) {
            auto* view = new CameraView(this);
            m_views.push_back(view);
            view->installEventFilter(this);
            view->viewport()->installEventFilter(this);
            connect(view, &CameraView::maximiseRequested, this,
                    [this, index = static_cast<int>(i)] { setMaximised(index); });
        }
        m_views[i]->setCamera(cameras[i]);
        m_views[i]->setTitle({QString::fromStdString(cameras[i].name), {}, {}, false});
        if (isNew)
            emit viewAdded(static_cast<int>(i), m_views[i]);
    }
    m_order.resize(m_views.size());
    std::iota(m_order.begin(), m_order.end(), 0);
    m_maximised = m_maximised < count() ? m_maximised : -1;
    m_current = m_current < count() ? m_current : -1;
    layOut();
}

CameraView* CameraGrid::view(const QString& cameraName) const {
    const auto found = std::find_if(m_views.begin(), m_views.end(),
                                    [&](const CameraView* v) { return v->camera().name == cameraName.toStdString(); });
    return found == m_views.end() ? nullptr : *found;
}

void CameraGrid::setOrder(const std::vector<int>& order) {
    m_order.clear();
    std::copy_if(order.begin(), order.end(), std::back_inserter(m_order),
                 [this](int i) { return i >= 0 && i < count(); });
    layOut();
}

void CameraGrid::setFixedColumns(int columns) {
    m_fixedColumns = std::max(0, columns);
    layOut();
}

void CameraGrid::setMaximised(int index) {
    const int wanted = index >= 0 && index < count() && index != m_maximised ? index : -1;
    if (wanted == m_maximised)
        return;
    m_maximised = wanted;
    layOut();
    emit maximisedChanged(m_maximised);
}

void CameraGrid::setCurrent(int index) {
    if (index == m_current || index >= count())
        return;
    m_current = std::max(-1, index);
    for (int i = 0; i < count(); ++i)
        view(i)->setCurrent(i == m_current);
    update();
    emit currentChanged(m_current);
}

void CameraGrid::setEmptyText(const QString& text) {
    m_emptyText = text;
    update();
}

void CameraGrid::finishDrawing() {
    for (CameraView* view : m_views)
        view->finishDrawing();
}

std::vector<CameraView*> CameraGrid::shownViews() const {
    if (m_maximised >= 0)
        return {view(m_maximised)};
    std::vector<CameraView*> shown;
    for (const int index : m_order)
        shown.push_back(view(index));
    return shown;
}

void CameraGrid::layOut() {
    const std::vector<CameraView*> shown = shownViews();
    for (CameraView* view : m_views)
        if (std::find(shown.begin(), shown.end(), view) == shown.end())
            view->hide();
    if (shown.empty()) {
        update();
        return;
    }
    const int number = static_cast<int>(shown.size());
    GridShape shape = packGrid(number, medianAspect(shown), size(), fontMetrics().height() + 2 + kGap);
    if (m_fixedColumns > 0 && m_maximised < 0)
        shape = {(number + m_fixedColumns - 1) / m_fixedColumns, m_fixedColumns};
    const auto edge = [](int index, int cells, int length) { return kGap + index * (length - kGap) / cells; };
    for (int i = 0; i < number; ++i) {
        const int row = i / shape.columns, column = i % shape.columns;
        const QPoint from(edge(column, shape.columns, width()), edge(row, shape.rows, height()));
        const QPoint to(edge(column + 1, shape.columns, width()), edge(row + 1, shape.rows, height()));
        CameraView* view = shown[static_cast<std::size_t>(i)];
        view->setGeometry(QRect(from, to - QPoint(kGap + 1, kGap + 1)));
        view->show();
    }
    update();
}

QImage CameraGrid::grabPicture(double scale) const {
    QImage picture((QSizeF(size()) * scale).toSize(), QImage::Format_RGB32);
    picture.setDevicePixelRatio(scale);
    picture.fill(palette().color(QPalette::Window));
    QPainter painter(&picture);
    for (const CameraView* view : shownViews()) {
        const QPoint corner = view->viewport()->mapTo(this, QPoint(0, 0));
        const QImage one = view->grabPicture(scale);
        painter.drawImage(QRectF(corner, QSizeF(view->viewport()->size())), one);
    }
    return picture;
}

QSize CameraGrid::minimumSizeHint() const {
    return {320, 240};
}

void CameraGrid::resizeEvent(QResizeEvent*) {
    layOut();
}

void CameraGrid::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_views.empty() && !m_emptyText.isEmpty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    }
    if (m_current >= 0 && view(m_current)->isVisible()) {
        painter.fillRect(view(m_current)->geometry().adjusted(-kGap, -kGap, kGap, kGap),
                         palette().color(QPalette::Highlight));
    }
}

/// A view becomes the current one when it is clicked anywhere.
bool CameraGrid::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        const auto found = std::find_if(m_views.begin(), m_views.end(),
                                        [&](const CameraView* v) { return watched == v || watched == v->viewport(); });
        if (found != m_views.end())
            setCurrent(static_cast<int>(found - m_views.begin()));
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace widgets
