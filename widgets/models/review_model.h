// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "widgets/jobs/review_queue.h"

namespace widgets {

/// The frames that wait for a look, one a row, in the order in which a look teaches most.
class ReviewModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Reason, Frame, Doubt, Neighbours, ColumnCount };

    explicit ReviewModel(QObject* parent = nullptr);

    void setRows(std::vector<ReviewRow> rows);
    int frame(int row) const { return m_rows[static_cast<std::size_t>(row)].item.frame; }
    /// The row of a frame; -1 if it does not wait.
    int rowOf(int frame) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<ReviewRow> m_rows;
};

} // namespace widgets
