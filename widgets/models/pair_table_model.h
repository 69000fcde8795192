// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QAbstractTableModel>

#include "core/benchmark/benchmark_results.h"

namespace widgets {

/// Every pair and method of a benchmark, one a row. It only shows; sort it by ValueRole.
class PairTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Method, Sequence, Start, Test, InitialErrorMm, ErrorMm, Iterations, Seconds, ColumnCount };
    enum Role { ValueRole = Qt::UserRole };

    explicit PairTableModel(QObject* parent = nullptr);

    /// Null for no results.
    void setResults(std::shared_ptr<const core::BenchmarkResults> results);
    const core::PairResult& pair(int row) const { return m_results->rows[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QVariant value(const core::PairResult& row, int column) const;

    std::shared_ptr<const core::BenchmarkResults> m_results;
};

} // namespace widgets
