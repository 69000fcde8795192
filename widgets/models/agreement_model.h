// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QAbstractTableModel>

#include "core/annotation/raters.h"

namespace widgets {

/// How far two raters agree: all joints in the first row, then joint by joint; distances in mm, and Bland and Altman's
/// bias per axis of the world with its 95 % limits in the tooltip.
class AgreementModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Joint, Count, MeanMm, MaxMm, BiasX, BiasY, BiasZ, ColumnCount };

    explicit AgreementModel(QObject* parent = nullptr);

    void setComparison(const std::optional<core::RaterComparison>& comparison);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString cell(int row, int column) const;

    std::vector<std::pair<QString, core::Agreement>> m_rows;
};

} // namespace widgets
