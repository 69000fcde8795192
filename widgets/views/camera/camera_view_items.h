// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QPointF>

#include "widgets/views/camera/view_mark.h"

class QGraphicsItem;
class QGraphicsScene;

namespace widgets {

class ArrowsItem;
class EllipseItem;
class GuidesItem;
class HandLabelItem;
class MarkItem;
class OtherMarksItem;
class OverlayShapesItem;
class ReprojectionItem;
class SkeletonItem;

/// The vector items that lie over a view's image. Bottom to top: an inspected method's shapes, skeleton, guides,
/// ellipse, other people's marks, reprojection lines, residual arrows, hand labels, marks. The scene's coordinates are
/// image pixels + 0.5, so that pixel (0, 0) covers (0, 0) .. (1, 1).
class CameraViewItems {
public:
    explicit CameraViewItems(QGraphicsScene& scene);

    void setMarks(const std::vector<ViewMark>& marks);
    void setOtherMarks(const std::vector<ViewMark>& marks);
    void setShapes(const OverlayShapes& shapes);
    const OverlayShapes& shapes() const;
    void setSkeleton(const std::vector<SkeletonLine>& lines);
    void setGuides(const std::vector<EpipolarGuide>& guides);
    void setGuideFocus(const std::optional<QPointF>& px);
    void setHandLabels(const std::vector<HandLabel>& labels);
    void setArrows(const std::vector<ResidualArrow>& arrows);
    const std::vector<ResidualArrow>& arrows() const;
    void setEllipse(const std::optional<UncertaintyEllipse>& ellipse);
    void setReprojectionScale(double factor);
    void setLabelsShown(bool shown);
    void setVisible(bool visible);

    const std::vector<HandLabel>& handLabels() const { return m_handLabels; }
    const std::vector<ViewMark>& marks() const { return m_marks; }
    const std::vector<ViewMark>& otherMarks() const;

private:
    QGraphicsItem* m_root; ///< the items belong to the scene
    OverlayShapesItem* m_shapes;
    SkeletonItem* m_skeleton;
    GuidesItem* m_guides;
    EllipseItem* m_ellipse;
    OtherMarksItem* m_otherMarks;
    ReprojectionItem* m_reprojections;
    ArrowsItem* m_arrows;
    std::vector<HandLabelItem*> m_labelItems;
    std::vector<HandLabel> m_handLabels;
    std::vector<MarkItem*> m_markItems;
    std::vector<ViewMark> m_marks;
    bool m_labelsShown = false;
};

} // namespace widgets
