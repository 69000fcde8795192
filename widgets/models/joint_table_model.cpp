// SPDX-License-Identifier: MIT
#include "widgets/models/joint_table_model.h"

#include <algorithm>

#include <QColor>
#include <QLocale>

#include "widgets/document/advice.h"
#include "widgets/document/edit_text.h"

namespace widgets {

namespace {

const QColor kBadColour(0xE5, 0x5B, 0x5B);

QString stateText(const core::JointReconstruction* found) {
    const core::JointStatus status = found ? found->status : core::JointStatus::None;
    switch (status) {
    case core::JointStatus::Done:
        return JointTableModel::tr("done");
    case core::JointStatus::Partial:
        return JointTableModel::tr("partial");
    case core::JointStatus::None:
        break;
    }
    return JointTableModel::tr("none", "state of a joint without marks");
}

bool hasOutlier(const core::JointReconstruction& found) {
    return std::any_of(found.views.begin(), found.views.end(), [](const auto& view) { return view.outlier; });
}

} // namespace

JointTableModel::JointTableModel(const JointList& joints, const Reconstructions& reconstructions, QObject* parent)
    : QAbstractTableModel(parent), m_joints(joints), m_reconstructions(reconstructions) {
    connect(&joints, &JointList::changed, this, [this] {
        beginResetModel();
        endResetModel();
    });
    connect(&reconstructions, &Reconstructions::changed, this, &JointTableModel::refresh);
}

void JointTableModel::setBadRmsPx(double px) {
    m_badRmsPx = px;
    refresh();
}

void JointTableModel::refresh() {
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int JointTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_joints.joints().size());
}

int JointTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

core::JointId JointTableModel::jointAt(int row) const {
    return m_joints.joints()[static_cast<std::size_t>(row)];
}

int JointTableModel::rowOf(const core::JointId& joint) const {
    const auto& joints = m_joints.joints();
    const auto at = std::find(joints.begin(), joints.end(), joint);
    return at == joints.end() ? -1 : static_cast<int>(at - joints.begin());
}

bool JointTableModel::isBad(const core::JointReconstruction* found) const {
    if (!found)
        return false;
    if (!found->hasPoint())
        return found->manualViews >= 2;
    return found->result.point->rmsPx > m_badRmsPx || hasOutlier(*found);
}

QVariant JointTableModel::value(const core::JointReconstruction* found, int column) const {
    if (column == Views)
        return found ? found->manualViews : 0;
    if (!found || !found->hasPoint())
        return {};
    if (column == ErrorPx)
        return found->result.point->rmsPx;
    return column == SigmaMm ? QVariant(core::sigmaMm(found->result.point->covariance)) : QVariant();
}

QVariant JointTableModel::text(const core::JointId& joint, const core::JointReconstruction* found, int column) const {
    if (column == Joint)
        return shortJointText(joint);
    if (column == State)
        return stateText(found);
    const QVariant number = value(found, column);
    if (!number.isValid() || (column == Views && number.toInt() == 0))
        return QString();
    return column == Views ? QLocale().toString(number.toInt()) : QLocale().toString(number.toDouble(), 'f', 2);
}

QVariant JointTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const core::JointId joint = jointAt(index.row());
    const core::JointReconstruction* found = m_reconstructions.find(joint);
    switch (role) {
    case Qt::DisplayRole:
        return text(joint, found, index.column());
    case Qt::TextAlignmentRole:
        if (index.column() == Joint || index.column() == State)
            return int(Qt::AlignLeft | Qt::AlignVCenter);
        return int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        return isBad(found) ? QVariant(kBadColour) : QVariant();
    case Qt::ToolTipRole:
        return found && !found->hasPoint() ? QVariant(reasonText(found->result.reason)) : QVariant();
    case ValueRole:
        return value(found, index.column());
    case BadRole:
        return isBad(found);
    default:
        return {};
    }
}

QVariant JointTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Joint || section == State ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::DisplayRole) {
        const QString names[ColumnCount] = {tr("Joint"), tr("Views"), tr("px"), tr("mm"), tr("State")};
        return names[section];
    }
    if (role == Qt::ToolTipRole) {
        const QString tips[ColumnCount] = {tr("Joint, in the order in which you work"), tr("Views with a click of yours"),
                                           tr("Root mean square distance from click to reprojection, over the views used"),
                                           tr("Uncertainty of the 3D joint (standard deviation)"),
                                           tr("Done: every view is placed or cannot be placed")};
        return tips[section];
    }
    return {};
}

} // namespace widgets
