// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <QAbstractTableModel>

#include "core/benchmark/comparison/benchmark_digest.h"

namespace widgets {

/// A benchmark in the paper's layout: a row per method (the start poses first), mean and standard deviation in mm per
/// frame difference and over all, how many pairs there are of it yet, and seconds per pair.
class SummaryModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role { ValueRole = Qt::UserRole }; ///< of the first column: the method's name; "start" for the start poses

    explicit SummaryModel(QObject* parent = nullptr);

    /// Null for no results.
    void setDigest(std::shared_ptr<const core::BenchmarkDigest> digest);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString cell(int row, int column) const;

    std::shared_ptr<const core::BenchmarkDigest> m_digest;
};

} // namespace widgets
