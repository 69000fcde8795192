// SPDX-License-Identifier: MIT
#include "widgets/views/camera/camera_view.h"

#include <algorithm>
#include <cmath>

#include <QMenu>
#include <QScrollBar>
#include <QSvgGenerator>

#include "widgets/views/camera/camera_view_items.h"
#include "widgets/views/camera/camera_view_mouse.h"
#include "widgets/views/camera/loupe.h"
#include "widgets/views/camera/view_cursor.h"
#include "widgets/views/message_bar.h"
#include "widgets/views/picture_export.h"

namespace widgets {

namespace {

constexpr double kHalfWorld = 1e6;    // the scene reaches this far, so that the scroll bars never interfere
constexpr double kGreatestScale = 64; // screen px per image px
constexpr double kHitScreenPx = 9;
constexpr double kKeptInSightScreenPx = 40;
const QPointF kHalfPixel(0.5, 0.5); // from image pixels to the scene

} // namespace

CameraView::CameraView(QWidget* parent)
    : QGraphicsView(parent)
    , m_scene(std::make_unique<QGraphicsScene>())
    , m_items(std::make_unique<CameraViewItems>(*m_scene))
    , m_mouse(makeMouse())
    , m_meshPainter(std::make_unique<MeshLayerPainter>())
    , m_titleBar(new ViewTitleBar(this))
    , m_messageBar(new MessageBar(this))
    , m_loupe(new Loupe(viewport())) {
    m_scene->setItemIndexMethod(QGraphicsScene::NoIndex);
    m_scene->setSceneRect(-kHalfWorld, -kHalfWorld, 2 * kHalfWorld, 2 * kHalfWorld);
    setScene(m_scene.get());
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTransformationAnchor(NoAnchor);
    setResizeAnchor(NoAnchor);
    setViewportUpdateMode(MinimalViewportUpdate);
    setOptimizationFlags(DontSavePainterState);
    setFocusPolicy(Qt::ClickFocus);
    setMinimumSize(60, 30); // eight rows of a small window
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    updateCursor();
    connect(m_meshPainter.get(), &MeshLayerPainter::pictureChanged, viewport(), qOverload<>(&QWidget::update));
    connect(m_titleBar, &ViewTitleBar::doubleClicked, this, &CameraView::maximiseRequested);
}

CameraView::~CameraView() = default;

QSizeF CameraView::imageSize() const {
    const core::ImageSize& size = m_camera.size;
    return size.width > 0 && size.height > 0 ? QSizeF(size.width, size.height) : QSizeF(m_pyramid.size());
}

void CameraView::setCamera(const core::Camera& camera) {
    const bool sameSize = camera.size == m_camera.size;
    m_camera = camera;
    if (sameSize)
        requestMeshPicture();
    else
        fitImage();
}

void CameraView::setImage(const QImage& image) {
    setImage(ImagePyramid(image));
}

void CameraView::setImage(const ImagePyramid& pyramid) {
    const QSizeF before = imageSize();
    m_pyramid = pyramid;
    m_adjustedLevels.clear();
    if (imageSize() != before)
        fitImage();
    viewport()->update();
}

void CameraView::setAdjustment(const ImageAdjustment& adjustment) {
    m_adjustment = adjustment;
    m_adjustedLevels.clear();
    viewport()->update();
}

void CameraView::setMeshLayers(const std::vector<MeshLayer>& layers) {
    if (layers == m_meshLayers)
        return;
    m_meshLayers = layers;
    requestMeshPicture();
}

void CameraView::setOtherMarks(const std::vector<ViewMark>& marks) {
    m_items->setOtherMarks(marks);
}

const std::vector<ViewMark>& CameraView::otherMarks() const {
    return m_items->otherMarks();
}

void CameraView::setMarks(const std::vector<ViewMark>& marks) {
    m_items->setMarks(marks);
}

const std::vector<ViewMark>& CameraView::marks() const {
    return m_items->marks();
}

void CameraView::setSkeleton(const std::vector<SkeletonLine>& lines) {
    m_items->setSkeleton(lines);
}
void CameraView::setShapes(const OverlayShapes& shapes) {
    m_items->setShapes(shapes);
}
const OverlayShapes& CameraView::shapes() const {
    return m_items->shapes();
}
void CameraView::setEpipolarGuides(const std::vector<EpipolarGuide>& guides) {
    m_items->setGuides(guides);
}
void CameraView::setHandLabels(const std::vector<HandLabel>& labels) {
    m_items->setHandLabels(labels);
}
const std::vector<HandLabel>& CameraView::handLabels() const {
    return m_items->handLabels();
}
void CameraView::setResidualArrows(const std::vector<ResidualArrow>& arrows) {
    m_items->setArrows(arrows);
}
const std::vector<ResidualArrow>& CameraView::residualArrows() const {
    return m_items->arrows();
}
void CameraView::setEllipse(const std::optional<UncertaintyEllipse>& ellipse) {
    m_items->setEllipse(ellipse);
}
void CameraView::setGuideFocus(const std::optional<QPointF>& px) {
    m_items->setGuideFocus(px);
}
void CameraView::setReprojectionScale(double factor) {
    m_items->setReprojectionScale(factor);
}
void CameraView::setLabelsShown(bool shown) {
    m_items->setLabelsShown(shown);
}

void CameraView::setFieldImage(const QImage& field, double opacity, bool overMeshes) {
    m_field = field;
    m_fieldOpacity = opacity;
    m_fieldOverMeshes = overMeshes;
    viewport()->update();
}

void CameraView::setMessage(const QString& text) {
    setMessage(text, {});
}

void CameraView::setMessage(const QString& text, const std::vector<MessageAction>& actions) {
    m_messageBar->offer(text, actions, MessageBar::Tone::Warning);
    layOut();
}

QString CameraView::message() const {
    return m_messageBar->message();
}

void CameraView::setOverlaysHidden(bool hidden) {
    m_overlaysHidden = hidden;
    m_items->setVisible(!hidden);
    viewport()->update();
}

void CameraView::setLoupeShown(bool shown) {
    m_loupeShown = shown;
    if (shown && viewport()->underMouse())
        moveLoupe(viewport()->mapFromGlobal(QCursor::pos()));
    else if (!shown)
        m_loupe->hide();
}

void CameraView::setPlacingEnabled(bool enabled) {
    m_placingEnabled = enabled;
    m_mouse->setPlacingEnabled(enabled && !m_awaiting);
    updateCursor();
}

void CameraView::setAwaiting(bool awaiting) {
    if (awaiting == m_awaiting)
        return;
    m_awaiting = awaiting;
    setPlacingEnabled(m_placingEnabled);
    viewport()->update();
}

void CameraView::setCurrent(bool current) {
    m_titleBar->setCurrent(current);
}

double CameraView::scale() const {
    return transform().m11();
}

double CameraView::fittingScale(const QSizeF& size) const {
    if (size.isEmpty())
        return 1;
    return std::min(viewport()->width() / size.width(), viewport()->height() / size.height());
}

void CameraView::setHome(const QRectF& homePx) {
    if (homePx == m_home)
        return;
    m_home = homePx;
    if (m_fitted)
        fitImage();
}

void CameraView::fitImage() {
    m_fitted = true;
    const QRectF home = m_home.isEmpty() ? QRectF(-kHalfPixel, imageSize()) : m_home;
    const double scale = std::clamp(fittingScale(home.size()), 1e-6, kGreatestScale);
    const QPointF middle(viewport()->width() / 2.0, viewport()->height() / 2.0);
    setViewTransform(scale, middle - (home.center() + kHalfPixel) * scale);
}

void CameraView::showWholeImage() {
    if (m_home.isEmpty()) {
        fitImage();
        return;
    }
    const QSizeF image = imageSize();
    lookAt(QPointF(image.width() / 2, image.height() / 2) - kHalfPixel, fittingScale(image));
}

void CameraView::lookAt(QPointF centrePx, double newScale) {
    m_fitted = false;
    const double wanted = newScale > 0 ? std::min(newScale, kGreatestScale) : scale();
    const QPointF middle(viewport()->width() / 2.0, viewport()->height() / 2.0);
    setViewTransform(wanted, middle - (centrePx + kHalfPixel) * wanted);
}

void CameraView::zoomAt(QPointF viewportPoint, double factor) {
    const double wanted = std::min(scale() * factor, kGreatestScale);
    if (wanted <= fittingScale(imageSize())) {
        showWholeImage();
        return;
    }
    m_fitted = false;
    const QPointF scenePoint = viewportToImage(viewportPoint) + kHalfPixel;
    setViewTransform(wanted, viewportPoint - scenePoint * wanted);
}

void CameraView::panBy(QPointF viewportDelta) {
    m_fitted = false;
    setViewTransform(scale(), QPointF(transform().dx(), transform().dy()) + viewportDelta);
}

/// The whole mapping lies in the transform, in double precision; the scroll bars, which only know integers, stay at 0.
void CameraView::setViewTransform(double newScale, QPointF translation) {
    const QSizeF image = imageSize() * newScale;
    const auto keep = [](double offset, double length, double room) {
        const double least = std::min(kKeptInSightScreenPx, std::min(length, room));
        return std::clamp(offset, least - length, room - least);
    };
    translation.setX(keep(translation.x(), image.width(), viewport()->width()));
    translation.setY(keep(translation.y(), image.height(), viewport()->height()));
    const QTransform wanted(newScale, 0, 0, newScale, translation.x(), translation.y());
    const bool changed = wanted != transform();
    setTransform(wanted);
    horizontalScrollBar()->setValue(0);
    verticalScrollBar()->setValue(0);
    if (changed) {
        requestMeshPicture();
        emit viewChanged();
    }
}

QPointF CameraView::imageToViewport(QPointF px) const {
    return viewportTransform().map(px + kHalfPixel);
}

QPointF CameraView::viewportToImage(QPointF viewportPoint) const {
    return viewportTransform().inverted().map(viewportPoint) - kHalfPixel;
}

QPointF CameraView::markPosition(const core::JointId& joint) const {
    const std::vector<ViewMark>& marks = m_items->marks();
    const auto found = std::find_if(marks.begin(), marks.end(), [&](const ViewMark& m) { return m.joint == joint; });
    return found == marks.end() ? QPointF() : found->px;
}

std::optional<core::JointId> CameraView::markAt(QPointF viewportPoint) const {
    const ViewMark* nearest = nullptr;
    double nearestDistance = kHitScreenPx;
    for (const ViewMark& mark : m_items->marks()) {
        const QPointF away = imageToViewport(mark.px) - viewportPoint;
        const double distance = std::hypot(away.x(), away.y());
        if (distance <= kHitScreenPx && mark.selected)
            return mark.joint;
        if (distance <= nearestDistance) {
            nearest = &mark;
            nearestDistance = distance;
        }
    }
    return nearest ? std::optional(nearest->joint) : std::nullopt;
}

QSize CameraView::sizeHint() const {
    return {270, 480};
}

void CameraView::resizeEvent(QResizeEvent* event) {
    const QPointF oldMiddle(event->oldSize().width() / 2.0, event->oldSize().height() / 2.0);
    const QPointF centrePx = viewportToImage(oldMiddle);
    QGraphicsView::resizeEvent(event);
    layOut();
    if (m_fitted || !event->oldSize().isValid())
        fitImage();
    else
        lookAt(centrePx);
    requestMeshPicture();
}

void CameraView::showEvent(QShowEvent* event) {
    QGraphicsView::showEvent(event);
    layOut();
    requestMeshPicture();
}

void CameraView::changeEvent(QEvent* event) {
    QGraphicsView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        layOut();
}

bool CameraView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        m_loupe->hide();
        emit pointerLeft();
    }
    return QGraphicsView::viewportEvent(event);
}

void CameraView::moveLoupe(QPointF viewportPoint) {
    m_loupe->show(m_pyramid, m_adjustment, viewportToImage(viewportPoint), viewportPoint, scale());
}

void CameraView::updateCursor() {
    viewport()->setCursor(m_awaiting         ? QCursor(Qt::BusyCursor)
                          : m_placingEnabled ? placingCursor()
                                             : QCursor(Qt::OpenHandCursor));
}

} // namespace widgets
