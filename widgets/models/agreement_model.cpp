// SPDX-License-Identifier: MIT
#include "widgets/models/agreement_model.h"

#include <QLocale>

#include "widgets/text/edit_text.h"

namespace widgets {

namespace {

QString millimetres(double value) {
    return QLocale().toString(value, 'f', 2);
}

} // namespace

AgreementModel::AgreementModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void AgreementModel::setComparison(const std::optional<core::RaterComparison>& comparison) {
    beginResetModel();
    m_rows.clear();
    if (comparison) {
        m_rows.emplace_back(tr("All joints"), comparison->all);
        for (const auto& [joint, agreement] : comparison->byJoint)
            m_rows.emplace_back(shortJointText(joint), agreement);
    }
    endResetModel();
}

int AgreementModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int AgreementModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString AgreementModel::cell(int row, int column) const {
    const auto& [name, agreement] = m_rows[static_cast<std::size_t>(row)];
    switch (column) {
    case Joint:
        return name;
    case Count:
        return QLocale().toString(agreement.count);
    case MeanMm:
        return millimetres(agreement.meanMm);
    case MaxMm:
        return millimetres(agreement.maxMm);
    default:
        return millimetres(agreement.axes[column - BiasX].biasMm);
    }
}

QVariant AgreementModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Joint ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.column() >= BiasX) {
        const core::BlandAltman& axis =
            m_rows[static_cast<std::size_t>(index.row())].second.axes[index.column() - BiasX];
        return tr("Bias %1 mm, 95 % of the differences between %2 and %3 mm")
            .arg(millimetres(axis.biasMm), millimetres(axis.lowerMm()), millimetres(axis.upperMm()));
    }
    return role == Qt::DisplayRole ? QVariant(cell(index.row(), index.column())) : QVariant();
}

QVariant AgreementModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Joint ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section >= BiasX)
        return tr("Mean difference along this axis of the world, mm (Bland and Altman)");
    if (role != Qt::DisplayRole)
        return {};
    const QString names[ColumnCount] = {
        tr("Joint"), tr("n"), tr("mm"), tr("max"), QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    return names[section];
}

} // namespace widgets
