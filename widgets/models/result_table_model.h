// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QAbstractTableModel>

#include "widgets/jobs/fit_runner.h"

namespace widgets {

/// What each method made of the fitted pair: initial error, error, iterations, seconds. It only shows.
class ResultTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Method, InitialErrorMm, ErrorMm, Iterations, Seconds, ColumnCount };
    enum Role { ValueRole = Qt::UserRole };

    explicit ResultTableModel(QObject* parent = nullptr);

    /// Null for no results.
    void setOutcome(std::shared_ptr<const FitOutcome> outcome);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QVariant value(const MethodOutcome& method, int column) const;

    std::shared_ptr<const FitOutcome> m_outcome;
};

} // namespace widgets
