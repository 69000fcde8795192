// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractTableModel>

#include "core/rig/rig_health.h"

namespace widgets {

/// What the clicks say of each camera, one a row; px, y down. Empty cells where there are too few clicks to know.
class RigHealthModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Camera, State, Clicks, Rms, MeanX, MeanY, Spread, ColumnCount };

    explicit RigHealthModel(QObject* parent = nullptr);

    void setHealth(const core::RigHealth& health);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString cell(const core::CameraHealth& camera, int column) const;
    QString tip(const core::CameraHealth& camera) const;

    core::RigHealth m_health;
};

} // namespace widgets
