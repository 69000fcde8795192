// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

#include "widgets/presenters/inspect/inspect_probe.h"
#include "widgets/presenters/inspect_overlays.h"

namespace widgets {

/// Which layers lie over the inspected views, their scale, and what the methods would match at the pointer.
class InspectLayerBar : public QWidget {
    Q_OBJECT

public:
    explicit InspectLayerBar(InspectOverlays& overlays, QWidget* parent = nullptr);

    /// What a layer is called, and what its tip says. Until then it has its id.
    void setLayerTexts(InspectLayer layer, const QString& text, const QString& tip);
    /// What is matched at the pointer; none shows how to ask.
    void showProbe(const std::optional<InspectProbe>& probe);
    void clearProbe();

private:
    void addBox(InspectLayer layer);
    void showState();
    void showLegend();

    InspectOverlays& m_overlays;
    std::map<InspectLayer, QCheckBox*> m_boxes;
    QLabel* m_scale;
    QLabel* m_legend;
    QSlider* m_direction;
    QLabel* m_directionText;
    QLabel* m_probe;
};

} // namespace widgets
