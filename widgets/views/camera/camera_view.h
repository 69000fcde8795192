// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QGraphicsView>

#include "core/geometry/camera.h"
#include "widgets/jobs/image_pyramid.h"
#include "widgets/views/camera/mesh_layer_painter.h"
#include "widgets/views/camera/view_mark.h"
#include "widgets/views/camera/view_title_bar.h"

class QMenu;

namespace widgets {

class CameraViewItems;
class CameraViewMouse;
class Loupe;
class MessageBar;
struct MessageAction;

/// One camera's image with everything that lies on it. It only shows and reports: it never changes an annotation. All
/// positions, in setters and signals, are recorded image pixels with centres at integers, in double precision.
///
/// Pointer: a left press and release within 3 screen pixels places; a left drag that starts on a mark (the selected one
/// first) drags it, on the background it pans, as the middle button does anywhere; the wheel zooms at the pointer;
/// Alt+click selects a mark; double click asks to be maximised (and takes back the click that began it).
class CameraView : public QGraphicsView {
    Q_OBJECT
public:
    explicit CameraView(QWidget* parent = nullptr);
    ~CameraView() override;

    /// The camera whose size and lens everything refers to. The zoom is kept if the size stays.
    void setCamera(const core::Camera& camera);
    const core::Camera& camera() const { return m_camera; }

    /// The image; a null one shows the backdrop. Zoom and pan are kept.
    void setImage(const QImage& image);
    void setImage(const ImagePyramid& pyramid);
    /// While true, the picture is one of another instant that is shown until the wanted one comes: it lies under a veil
    /// and nothing can be placed on it.
    void setAwaiting(bool awaiting);
    bool isAwaiting() const { return m_awaiting; }
    void setAdjustment(const ImageAdjustment& adjustment);
    const ImageAdjustment& adjustment() const { return m_adjustment; }

    void setMeshLayers(const std::vector<MeshLayer>& layers);
    void setMarks(const std::vector<ViewMark>& marks);
    const std::vector<ViewMark>& marks() const;
    /// Marks of other people: drawn muted under the others, out of the pointer's reach.
    void setOtherMarks(const std::vector<ViewMark>& marks);
    const std::vector<ViewMark>& otherMarks() const;
    void setSkeleton(const std::vector<SkeletonLine>& lines);
    /// What an inspected method did: contour, rim, matches.
    void setShapes(const OverlayShapes& shapes);
    const OverlayShapes& shapes() const;
    void setEpipolarGuides(const std::vector<EpipolarGuide>& guides);
    /// Which hand is which; hidden with the other overlays.
    void setHandLabels(const std::vector<HandLabel>& labels);
    const std::vector<HandLabel>& handLabels() const;
    /// How far clicks are off, place by place; hidden with the other overlays.
    void setResidualArrows(const std::vector<ResidualArrow>& arrows);
    const std::vector<ResidualArrow>& residualArrows() const;
    void setEllipse(const std::optional<UncertaintyEllipse>& ellipse);
    /// Where the guides fade from: usually the selected joint's reprojection or the pointer.
    void setGuideFocus(const std::optional<QPointF>& px);
    /// A picture over the whole image, such as a distance field (premultiplied ARGB, size of the image or a fraction of
    /// it); null for none.
    /// `overMeshes`: above the mesh layers instead of below them.
    void setFieldImage(const QImage& field, double opacity = 0.6, bool overMeshes = false);

    void setTitle(const ViewTitle& title);
    const ViewTitle& title() const;
    /// A bar at the top of the picture that says what is wrong and what to do; empty hides it.
    void setMessage(const QString& text);
    /// The same with buttons that do something about it.
    void setMessage(const QString& text, const std::vector<MessageAction>& actions);
    QString message() const;

    /// While true, nothing but the image is shown (a key is held).
    void setOverlaysHidden(bool hidden);
    void setLabelsShown(bool shown);
    void setLoupeShown(bool shown);
    /// How many times longer than true the lines from clicks to reprojections are drawn.
    void setReprojectionScale(double factor);
    /// False where nothing can be placed or dragged (inspection): a left drag then always pans.
    void setPlacingEnabled(bool enabled);
    /// True if the view has the keyboard actions' attention (the "current" view): its frame is drawn in the accent
    /// colour.
    void setCurrent(bool current);

    /// Shows the home (the whole image, unless another one was set), and keeps doing so when the widget is resized.
    void fitImage();
    /// What fitImage() shows, image px; an empty rectangle is the whole image.
    void setHome(const QRectF& homePx);
    const QRectF& home() const { return m_home; }
    bool isFitted() const { return m_fitted; }
    /// Puts image pixel `centrePx` into the middle, at `scale` screen pixels per image pixel (0: keeps the scale).
    void lookAt(QPointF centrePx, double scale = 0);
    /// Zooms by `factor` about a point of the viewport, which stays over the same image pixel.
    void zoomAt(QPointF viewportPoint, double factor);
    /// Moves the image by logical pixels of the viewport.
    void panBy(QPointF viewportDelta);
    /// Screen (logical) pixels per image pixel.
    double scale() const;

    /// Exact maps between image pixels and logical pixels of the viewport.
    QPointF imageToViewport(QPointF px) const;
    QPointF viewportToImage(QPointF viewportPoint) const;
    /// Where that joint's mark is; (0, 0) if it has none.
    QPointF markPosition(const core::JointId& joint) const;
    /// The mark that a pointer there would grab: the selected one first, then the nearest; within 9 screen pixels.
    std::optional<core::JointId> markAt(QPointF viewportPoint) const;

    /// Draws the image and all overlays as they are now: a picture of the visible part, `scale` times the size on
    /// screen.
    QImage grabPicture(double scale = 1) const;
    /// The same on any paint device whose logical size is the view's picture; `pictureScale` pixels of embedded
    /// pictures per logical one.
    void paintPicture(QPainter& painter, double pictureScale) const { paintAll(painter, pictureScale); }
    /// The same as SVG: the image embedded, the overlays as vectors. False if the file cannot be written.
    bool saveSvg(const QString& path) const;
    bool savePdf(const QString& path) const;
    /// Appends "Copy picture", "Save picture..." to a context menu of the window's.
    void addPictureActions(QMenu& menu);

    /// Finishes the mesh layer that is being drawn on other threads, so that the next paint is complete.
    void finishDrawing();

    QSize sizeHint() const override;

signals:
    /// The selected joint was placed here.
    void pointPlaced(QPointF px);
    /// A click where placing is not enabled.
    void pointClicked(QPointF px);
    /// The pointPlaced before was only the first half of a double click: take it back without a trace.
    void pointWithdrawn();
    void markDragStarted(const core::JointId& joint, QPointF px);
    void markDragged(const core::JointId& joint, QPointF px);
    void markDropped(const core::JointId& joint, QPointF px);
    /// Escape was pressed, or the drag was lost: the mark goes back to where it was.
    void markDragCancelled(const core::JointId& joint);
    void markSelected(const core::JointId& joint);
    /// Right click. `joint` is empty (joint name "") if there is no mark.
    void contextMenuRequested(QPointF px, const core::JointId& joint, QPoint globalPosition);
    void maximiseRequested();
    void pointerMoved(QPointF px);
    void pointerLeft();
    /// Zoom or pan changed.
    void viewChanged();

protected:
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool event(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    std::unique_ptr<CameraViewMouse> makeMouse();
    QSizeF imageSize() const;
    double fittingScale(const QSizeF& size) const;
    void showWholeImage();
    void setViewTransform(double scale, QPointF translation);
    void requestMeshPicture();
    MeshLayerPainter::Request meshRequest(double pictureScale) const;
    void paintImage(QPainter& painter, double pixelsPerImagePixel) const;
    void paintField(QPainter& painter) const;
    void paintMeshes(QPainter& painter, const MeshPicture& picture) const;
    void paintAll(QPainter& painter, double pictureScale) const;
    const QImage& level(int index) const;
    void moveLoupe(QPointF viewportPoint);
    void updateCursor();
    void layOut();

    core::Camera m_camera;
    ImagePyramid m_pyramid;
    ImageAdjustment m_adjustment;
    mutable std::vector<QImage> m_adjustedLevels; ///< of m_pyramid with m_adjustment, made when first drawn
    QImage m_field;
    double m_fieldOpacity = 0.6;
    bool m_fieldOverMeshes = false;
    std::vector<MeshLayer> m_meshLayers;
    bool m_fitted = true;
    QRectF m_home; ///< image px; empty: the whole image
    bool m_overlaysHidden = false;
    bool m_placingEnabled = true;
    bool m_awaiting = false;
    bool m_loupeShown = false;
    std::unique_ptr<QGraphicsScene> m_scene;
    std::unique_ptr<CameraViewItems> m_items;
    std::unique_ptr<CameraViewMouse> m_mouse;
    std::unique_ptr<MeshLayerPainter> m_meshPainter;
    ViewTitleBar* m_titleBar;
    MessageBar* m_messageBar;
    Loupe* m_loupe;
};

} // namespace widgets
