// SPDX-License-Identifier: MIT
#include "widgets/models/rig_health_model.h"

#include <cmath>

#include <QFont>

#include "widgets/text/local_text.h"
#include "widgets/text/rig_text.h"

namespace widgets {

namespace {

/// With one decimal, and never as "-0.0".
QString meanText(double px) {
    return localNumber(std::abs(px) < 0.05 ? 0 : px, 1);
}

} // namespace

RigHealthModel::RigHealthModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void RigHealthModel::setHealth(const core::RigHealth& health) {
    beginResetModel();
    m_health = health;
    endResetModel();
}

int RigHealthModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_health.cameras.size());
}

int RigHealthModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString RigHealthModel::cell(const core::CameraHealth& camera, int column) const {
    switch (column) {
    case Camera:
        return QString::fromStdString(camera.camera);
    case Clicks:
        return QLocale().toString(camera.clicks);
    case State:
        return !camera.isKnown && !m_health.canTellCameras() ? tr("not known") : cameraStateText(camera);
    default:
        break;
    }
    if (!camera.isKnown)
        return {};
    switch (column) {
    case Rms:
        return localNumber(camera.rmsPx, 2);
    case MeanX:
        return meanText(camera.meanPx.x());
    case MeanY:
        return meanText(camera.meanPx.y());
    default:
        return localNumber(camera.spreadPx, 2);
    }
}

QString RigHealthModel::tip(const core::CameraHealth& camera) const {
    if (!camera.isKnown && !m_health.canTellCameras())
        return tr("Two cameras cannot tell which of them is off.");
    if (!camera.isKnown)
        return tr("%1: %n click(s) that other cameras confirm are too few to judge it", nullptr, camera.clicks)
            .arg(QString::fromStdString(camera.camera));
    return tr("%1: mean %2, %3 \u00b1 %4 px; clicks scatter by %5 px about it; %n wrong click(s)", nullptr,
              camera.wrongClicks)
        .arg(QString::fromStdString(camera.camera), localNumber(camera.meanPx.x(), 2),
             localNumber(camera.meanPx.y(), 2), localNumber(camera.meanSigmaPx, 2), localNumber(camera.scatterPx, 2));
}

QVariant RigHealthModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const core::CameraHealth& camera = m_health.cameras[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Camera || index.column() == State ? Qt::AlignLeft : Qt::AlignRight) |
                   Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return tip(camera);
    if (role == Qt::FontRole && (camera.isOff || camera.isLate || camera.isDrifting || camera.hasMoved)) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    return role == Qt::DisplayRole ? QVariant(cell(camera, index.column())) : QVariant();
}

QVariant RigHealthModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Camera || section == State ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    const QString names[ColumnCount] = {tr("Camera"),         tr("State"),          tr("n"),     tr("rms"),
                                        QStringLiteral("dx"), QStringLiteral("dy"), tr("\u03c3")};
    const QString tips[ColumnCount] = {
        QString(),
        QString(),
        tr("Clicks that other cameras confirm"),
        tr("RMS residual, px"),
        tr("Mean residual to the right, px; the joint is made from the other cameras"),
        tr("Mean residual downwards, px; the joint is made from the other cameras"),
        tr("Clicks and calibration error together, per axis, px: what a click is worth")};
    if (role == Qt::ToolTipRole)
        return tips[section];
    return role == Qt::DisplayRole ? QVariant(names[section]) : QVariant();
}

} // namespace widgets
