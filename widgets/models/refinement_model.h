// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "core/rig/rig_refinement.h"

namespace widgets {

/// What a refinement made of each camera, one a row: residuals before and after, and how far the camera moved.
class RefinementModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Camera, Clicks, BeforePx, AfterPx, TurnDeg, ShiftMm, Focal, ColumnCount };

    explicit RefinementModel(QObject* parent = nullptr);

    void setChanges(std::vector<core::CameraRefinement> changes);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString cell(const core::CameraRefinement& change, int column) const;

    std::vector<core::CameraRefinement> m_changes;
};

} // namespace widgets
