// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "widgets/text/finding.h"

namespace widgets {

/// Findings about the annotations, one a row: where, and what is wrong there.
class FindingModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { What, Joint, Frame, ColumnCount };

    explicit FindingModel(QObject* parent = nullptr);

    void setFindings(std::vector<Finding> findings);
    const Finding& finding(int row) const { return m_findings[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<Finding> m_findings;
};

} // namespace widgets
