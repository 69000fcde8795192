// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <QObject>

#include "widgets/workspaces/inspect_grid.h"
#include "widgets/workspaces/inspect_probe_card.h"

namespace widgets {

/// A point of a view that stays probed: its card, and in every column the way to the contour point that its own method
/// matches there. Follows iterations, settings and poses; goes when its column or camera goes.
class InspectProbePin : public QObject {
    Q_OBJECT

public:
    InspectProbePin(InspectColumns& columns, InspectGrid& views, ProbeTargets& targets, QObject* parent = nullptr);

    /// The same point once more takes the pin away.
    void pin(int view, QPointF px);
    void unpin();
    bool isPinned() const { return m_pin.has_value(); }
    struct Pin {
        InspectColumn column;
        int camera = 0; ///< index into the dataset's
        QPointF px;     ///< of the camera's image
    };
    const std::optional<Pin>& pinned() const { return m_pin; }
    /// For the page to place.
    InspectProbeCard* card() const { return m_card; }

signals:
    /// The card is shown, has other contents, or is gone.
    void changed();

private:
    void refresh();
    void showCard(std::optional<std::size_t> pinned);

    InspectColumns& m_columns;
    InspectGrid& m_views;
    ProbeTargets& m_targets;
    InspectProbeCard* m_card;
    std::optional<Pin> m_pin;
};

} // namespace widgets
