// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

#include "widgets/presenters/inspect/inspect_overlays.h"
#include "widgets/presenters/inspect/inspect_probe.h"
#include "widgets/views/legend_strip.h"

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
    /// What the tip of the choice of matches says, beside its key.
    void setMatchTip(const QString& tip) { m_matches->setToolTip(tip); }
    /// Whether the views show the silhouette that is to be met, as a white line, and whether that is one with noise.
    void setSilhouetteShown(bool shown, bool isNoisy = false);
    const LegendStrip& legend() const { return *m_legend; }
    /// What is said of the place under the pointer.
    QString probeText() const { return m_probe->text(); }

private:
    void addBox(InspectLayer layer);
    void makeMatchChoice();
    void showState();
    void showLegend();

    InspectOverlays& m_overlays;
    std::map<InspectLayer, QCheckBox*> m_boxes;
    QComboBox* m_matches; ///< which of them are drawn
    LegendStrip* m_legend;
    QSlider* m_direction;
    QLabel* m_directionText;
    QLabel* m_probe;
    bool m_silhouetteShown = false;
    bool m_isNoisy = false; ///< the silhouette is
};

} // namespace widgets
