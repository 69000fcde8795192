// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "widgets/presenters/inspect_columns.h"
#include "widgets/views/camera/camera_grid.h"
#include "widgets/views/camera/wipe_cover.h"

namespace widgets {

/// Lays the column beside the current one over it, in every row: behind a line that can be dragged, or by turns.
class ColumnWipe : public QObject {
    Q_OBJECT

public:
    enum class Kind { None, Wipe, Blink };

    ColumnWipe(CameraGrid& grid, InspectColumns& columns, QObject* parent = nullptr);

    void setKind(Kind kind);
    Kind kind() const { return m_kind; }
    /// Where the line of the wipe is, as a share of the views' width.
    void setPlace(double share);
    double place() const { return m_place; }
    /// The views or the current column are others.
    void refresh();
    /// The column that lies over the current one.
    std::size_t other() const;

signals:
    void changed();

private:
    void place(double share);

    CameraGrid& m_grid;
    InspectColumns& m_columns;
    QTimer m_timer;
    Kind m_kind = Kind::None;
    double m_place = 0.5;
    bool m_isOver = false; ///< of a blink: the other column is seen
    std::vector<QPointer<WipeCover>> m_covers;
};

} // namespace widgets
