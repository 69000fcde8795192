// SPDX-License-Identifier: MIT
#include "widgets/views/camera/camera_view_items.h"

#include <QGraphicsScene>

#include "widgets/views/camera/hand_label_item.h"
#include "widgets/views/camera/line_items.h"
#include "widgets/views/camera/mark_item.h"
#include "widgets/views/camera/other_marks_item.h"
#include "widgets/views/camera/overlay_shapes_item.h"

namespace widgets {

namespace {

/// Only holds the others, so that they can be hidden together.
class RootItem : public QGraphicsItem {
public:
    RootItem() { setFlag(ItemHasNoContents); }
    QRectF boundingRect() const override { return {}; }
    void paint(QPainter*, const QStyleOptionGraphicsItem*, QWidget*) override {}
};

} // namespace

CameraViewItems::CameraViewItems(QGraphicsScene& scene)
    : m_root(new RootItem)
    , m_shapes(new OverlayShapesItem(m_root))
    , m_skeleton(new SkeletonItem(m_root))
    , m_guides(new GuidesItem(m_root))
    , m_ellipse(new EllipseItem(m_root))
    , m_otherMarks(new OtherMarksItem(m_root))
    , m_reprojections(new ReprojectionItem(m_root))
    , m_arrows(new ArrowsItem(m_root)) {
    double level = -10;
    for (QGraphicsItem* item : std::initializer_list<QGraphicsItem*>{m_shapes, m_skeleton, m_guides, m_ellipse,
                                                                     m_otherMarks, m_reprojections, m_arrows})
        item->setZValue(level++);
    scene.addItem(m_root);
}

void CameraViewItems::setMarks(const std::vector<ViewMark>& marks) {
    while (m_markItems.size() > marks.size()) {
        delete m_markItems.back();
        m_markItems.pop_back();
    }
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (i == m_markItems.size()) {
            m_markItems.push_back(new MarkItem(m_root));
            m_markItems.back()->setLabelShown(m_labelsShown);
        } else if (marks[i] == m_marks[i]) {
            continue; // only what changed is painted again
        }
        m_markItems[i]->setMark(marks[i]);
    }
    m_marks = marks;
    m_reprojections->setMarks(marks);
}

void CameraViewItems::setOtherMarks(const std::vector<ViewMark>& marks) {
    m_otherMarks->setMarks(marks);
}
const std::vector<ViewMark>& CameraViewItems::otherMarks() const {
    return m_otherMarks->marks();
}
void CameraViewItems::setShapes(const OverlayShapes& shapes) {
    m_shapes->setShapes(shapes);
}
const OverlayShapes& CameraViewItems::shapes() const {
    return m_shapes->shapes();
}
void CameraViewItems::setSkeleton(const std::vector<SkeletonLine>& lines) {
    m_skeleton->setLines(lines);
}
void CameraViewItems::setHandLabels(const std::vector<HandLabel>& labels) {
    if (labels == m_handLabels)
        return;
    m_handLabels = labels;
    while (m_labelItems.size() > labels.size()) {
        delete m_labelItems.back();
        m_labelItems.pop_back();
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (i == m_labelItems.size())
            m_labelItems.push_back(new HandLabelItem(m_root));
        m_labelItems[i]->setLabel(labels[i]);
    }
}

void CameraViewItems::setGuides(const std::vector<EpipolarGuide>& guides) {
    m_guides->setGuides(guides);
}
void CameraViewItems::setGuideFocus(const std::optional<QPointF>& px) {
    m_guides->setFocus(px);
}
void CameraViewItems::setArrows(const std::vector<ResidualArrow>& arrows) {
    m_arrows->setArrows(arrows);
}
const std::vector<ResidualArrow>& CameraViewItems::arrows() const {
    return m_arrows->arrows();
}
void CameraViewItems::setEllipse(const std::optional<UncertaintyEllipse>& ellipse) {
    m_ellipse->setEllipse(ellipse);
}
void CameraViewItems::setReprojectionScale(double factor) {
    m_reprojections->setFactor(factor);
}
void CameraViewItems::setVisible(bool visible) {
    m_root->setVisible(visible);
}

void CameraViewItems::setLabelsShown(bool shown) {
    m_labelsShown = shown;
    for (MarkItem* item : m_markItems)
        item->setLabelShown(shown);
}

} // namespace widgets
