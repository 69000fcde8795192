// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include <QAbstractTableModel>

#include "core/annotation/annotation_set.h"
#include "core/subject/subject_estimate.h"

namespace widgets {

/// The measured bones of a person's hands, one a row: the model's length, the person's, the change and its uncertainty.
class SubjectModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Hand, Bone, ModelMm, LengthMm, Change, SigmaMm, ColumnCount };

    explicit SubjectModel(QObject* parent = nullptr);

    /// `hands` with their sides; empty: no rows.
    void setHands(const std::vector<std::pair<core::Side, core::SubjectHand>>& hands);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString cell(const std::pair<core::Side, core::SubjectBone>& row, int column) const;

    std::vector<std::pair<core::Side, core::SubjectBone>> m_rows;
};

} // namespace widgets
