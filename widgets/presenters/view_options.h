// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <QObject>

#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// How all camera views are looked at: loupe, names, hidden overlays, brightness. Views that come later follow too.
class ViewOptions : public QObject {
    Q_OBJECT

public:
    ViewOptions(CameraGrid& grid, const Selection& selection, const Reconstructions& reconstructions,
                QObject* parent = nullptr);

    void setOverlaysHidden(bool hidden);
    void setLongErrors(bool on);
    void setLoupeShown(bool shown);
    void setLabelsShown(bool shown);
    /// While on, every zoomed view keeps the selected joint in its middle.
    void setFollowingJoint(bool on);
    /// Zooms all views in on the selected joint, where it is known.
    void zoomToJoint();
    void showWholeImages();

    ImageAdjustment adjustment(const std::string& camera) const;
    /// Of one camera, or of all with an empty name.
    void setAdjustment(const std::string& camera, const ImageAdjustment& adjustment);

    /// All adjustments as text, a camera a line, and back; lines that make no sense are left out.
    std::string adjustmentsText() const;
    void setAdjustmentsFromText(const std::string& text);

signals:
    void adjustmentsChanged(); ///< by a person
    void adjustmentsLoaded();

private:
    void apply(CameraView& view) const;
    void applyToAll() const;
    void follow();
    std::optional<QPointF> jointIn(int camera) const;

    CameraGrid& m_grid;
    const Selection& m_selection;
    const Reconstructions& m_reconstructions;
    std::map<std::string, ImageAdjustment> m_adjustments;
    bool m_overlaysHidden = false;
    bool m_longErrors = false;
    bool m_loupeShown = false;
    bool m_labelsShown = false;
    bool m_following = false;
};

} // namespace widgets
