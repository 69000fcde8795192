// SPDX-License-Identifier: MIT
#include "widgets/models/refinement_model.h"

#include <cmath>

#include "widgets/text/local_text.h"

namespace widgets {

RefinementModel::RefinementModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void RefinementModel::setChanges(std::vector<core::CameraRefinement> changes) {
    beginResetModel();
    m_changes = std::move(changes);
    endResetModel();
}

int RefinementModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_changes.size());
}

int RefinementModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString RefinementModel::cell(const core::CameraRefinement& change, int column) const {
    const auto known = [](double value, int decimals) {
        return std::isfinite(value) ? localNumber(value, decimals) : QString();
    };
    switch (column) {
    case Camera:
        return QString::fromStdString(change.camera);
    case Clicks:
        return QLocale().toString(change.clicks);
    case BeforePx:
        return known(change.beforeRmsPx, 2);
    case AfterPx:
        return known(change.afterRmsPx, 2);
    case TurnDeg:
        return localNumber(change.turnDeg, 3);
    case ShiftMm:
        return localNumber(change.shiftMm, 2);
    default:
        return localNumber(100 * change.focalShare, 2);
    }
}

QVariant RefinementModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Camera ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    return role == Qt::DisplayRole ? QVariant(cell(m_changes[static_cast<std::size_t>(index.row())], index.column()))
                                   : QVariant();
}

QVariant RefinementModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Camera ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    const QString names[ColumnCount] = {tr("Camera"),         tr("Clicks"),    tr("px before"), tr("px after"),
                                        tr("turned, \u00b0"), tr("moved, mm"), tr("focal, %")};
    const QString tips[ColumnCount] = {QString(),
                                       QString(),
                                       tr("RMS of its clicks with the calibration in use"),
                                       tr("RMS of its clicks with the refined calibration"),
                                       tr("By how much the camera turns"),
                                       tr("By how much the camera's centre moves"),
                                       tr("By how much its focal length grows")};
    if (role == Qt::ToolTipRole)
        return tips[section];
    return role == Qt::DisplayRole ? QVariant(names[section]) : QVariant();
}

} // namespace widgets
