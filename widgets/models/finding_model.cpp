// SPDX-License-Identifier: MIT
#include "widgets/models/finding_model.h"

#include <QLocale>

#include "widgets/text/edit_text.h"

namespace widgets {

FindingModel::FindingModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void FindingModel::setFindings(std::vector<Finding> findings) {
    beginResetModel();
    m_findings = std::move(findings);
    endResetModel();
}

int FindingModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_findings.size());
}

int FindingModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant FindingModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const Finding& found = finding(index.row());
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Frame ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return QStringLiteral("%1: %2").arg(jointText(found.joint), found.text);
    if (role != Qt::DisplayRole)
        return {};
    if (index.column() == Frame)
        return QLocale().toString(found.frame);
    if (index.column() == Joint)
        return found.joint.joint.empty() ? QString() : shortJointText(found.joint);
    return found.text;
}

QVariant FindingModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Frame ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[ColumnCount] = {tr("Finding"), tr("Joint"), tr("Frame")};
    return names[section];
}

} // namespace widgets
