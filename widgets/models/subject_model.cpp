// SPDX-License-Identifier: MIT
#include "widgets/models/subject_model.h"

#include "widgets/text/local_text.h"

namespace widgets {

SubjectModel::SubjectModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void SubjectModel::setHands(const std::vector<std::pair<core::Side, core::SubjectHand>>& hands) {
    beginResetModel();
    m_rows.clear();
    for (const auto& [side, hand] : hands)
        for (const core::SubjectBone& bone : hand.bones)
            m_rows.emplace_back(side, bone);
    endResetModel();
}

int SubjectModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int SubjectModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString SubjectModel::cell(const std::pair<core::Side, core::SubjectBone>& row, int column) const {
    const auto& [side, bone] = row;
    switch (column) {
    case Hand:
        return side == core::Side::Left ? tr("left") : tr("right");
    case Bone:
        return QStringLiteral("%1 \u2013 %2").arg(QString::fromStdString(bone.from), QString::fromStdString(bone.to));
    case ModelMm:
        return localNumber(bone.modelMm, 2);
    case LengthMm:
        return localNumber(bone.lengthMm, 2);
    case Change:
        return bone.modelMm > 0 ? localNumber(100 * (bone.lengthMm / bone.modelMm - 1), 1) : QString();
    default:
        return localNumber(bone.sigmaMm, 2);
    }
}

QVariant SubjectModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((index.column() <= Bone ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    return role == Qt::DisplayRole ? QVariant(cell(m_rows[static_cast<std::size_t>(index.row())], index.column()))
                                   : QVariant();
}

QVariant SubjectModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section <= Bone ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    const QString names[ColumnCount] = {tr("Hand"),         tr("Bone"),      tr("Model, mm"),
                                        tr("Measured, mm"), tr("Change, %"), tr("\u00b1 mm")};
    if (role == Qt::ToolTipRole && section == SigmaMm)
        return tr("Standard deviation of the measured length");
    return role == Qt::DisplayRole ? QVariant(names[section]) : QVariant();
}

} // namespace widgets
