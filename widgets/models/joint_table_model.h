// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractTableModel>

#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"

namespace widgets {

/// The joints of the annotator's list in the current frame: views, error, uncertainty, state. It only shows.
class JointTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Joint, Views, ErrorPx, SigmaMm, State, ColumnCount };
    /// Numbers as they are (double), for sorting and tests.
    enum Role { ValueRole = Qt::UserRole, BadRole };

    JointTableModel(const JointList& joints, const Reconstructions& reconstructions, QObject* parent = nullptr);

    /// A joint is bad when its error is above this, px.
    void setBadRmsPx(double px);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    core::JointId jointAt(int row) const;
    /// -1 if the joint is not in the list.
    int rowOf(const core::JointId& joint) const;

private:
    QVariant text(const core::JointId& joint, const core::JointReconstruction* found, int column) const;
    QVariant value(const core::JointReconstruction* found, int column) const;
    bool isBad(const core::JointReconstruction* found) const;
    void refresh();

    const JointList& m_joints;
    const Reconstructions& m_reconstructions;
    double m_badRmsPx = 2.0;
};

} // namespace widgets
