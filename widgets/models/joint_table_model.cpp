// SPDX-License-Identifier: MIT
#include "widgets/models/joint_table_model.h"

#include <algorithm>

#include <QColor>
#include <QFont>
#include <QLocale>

#include "widgets/text/advice.h"
#include "widgets/text/edit_text.h"

namespace widgets {

namespace {

const QColor kBadColour(0xE5, 0x5B, 0x5B);

/// No mark is placed, but there are proposed ones.
bool isProposed(const core::JointReconstruction* found) {
    return found && found->status == core::JointStatus::None &&
           std::any_of(
               found->views.begin(), found->views.end(),
               [](const auto& view) { return view.mark && view.mark->isProposal(); });
}

QString stateText(const core::JointReconstruction* found, double badRmsPx) {
    if (found && core::isBad(*found, badRmsPx))
        return JointTableModel::tr("bad");
    if (isProposed(found))
        return JointTableModel::tr("proposed");
    switch (found ? found->status : core::JointStatus::None) {
    case core::JointStatus::Done:
        return JointTableModel::tr("done");
    case core::JointStatus::Partial:
        return JointTableModel::tr("partial");
    case core::JointStatus::None:
        break;
    }
    return JointTableModel::tr("none", "state of a joint without marks");
}

/// How likely a program's guesses are; empty if none says.
QString likelihoodText(const core::JointReconstruction& found) {
    std::vector<double> likelihoods;
    for (const core::ViewReconstruction& view : found.views)
        if (view.mark && view.mark->isProposal() && view.mark->likelihood)
            likelihoods.push_back(*view.mark->likelihood);
    if (likelihoods.empty())
        return {};
    const auto [least, most] = std::minmax_element(likelihoods.begin(), likelihoods.end());
    return JointTableModel::tr("Proposed marks with a likelihood of %1 to %2")
        .arg(QLocale().toString(*least, 'g', 2), QLocale().toString(*most, 'g', 2));
}

/// What the numbers leave open: where the marks come from, and why there is no point.
QString toolTip(const core::JointReconstruction& found) {
    QString text = placedInWords(found);
    const QString likelihood = likelihoodText(found);
    if (!likelihood.isEmpty())
        text += QLatin1Char('\n') + likelihood;
    if (found.hasPoint())
        return text;
    text += QLatin1Char('\n') + failureInWords(found.result.failure);
    for (const core::CurveGap& gap : found.gaps)
        text += QStringLiteral("\n%1: %2").arg(QString::fromStdString(gap.camera), curveGapText(gap));
    return text;
}

} // namespace

JointTableModel::JointTableModel(const JointList& joints, const Reconstructions& reconstructions, QObject* parent)
    : QAbstractTableModel(parent)
    , m_joints(joints)
    , m_reconstructions(reconstructions) {
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
    return found && core::isBad(*found, m_badRmsPx);
}

QVariant JointTableModel::value(const core::JointReconstruction* found, int column) const {
    if (column == Views) {
        const auto counts = [](const core::ViewReconstruction& view) {
            return view.hasPicture && view.mark && view.mark->isPlaced();
        };
        return found ? static_cast<int>(std::count_if(found->views.begin(), found->views.end(), counts)) : 0;
    }
    if (!found || !found->hasPoint() || (column == ErrorPx && found->isAccepted))
        return {};
    if (column == ErrorPx)
        return found->result.point->rmsPx;
    return column == SigmaMm ? QVariant(core::sigmaMm(found->result.point->covariance)) : QVariant();
}

QVariant JointTableModel::text(const core::JointId& joint, const core::JointReconstruction* found, int column) const {
    if (column == Joint)
        return shortJointText(joint);
    if (column == State)
        return stateText(found, m_badRmsPx);
    const QVariant number = value(found, column);
    if (!number.isValid() || (column == Views && number.toInt() == 0))
        return QString();
    return column == Views ? placedText(*found) : QLocale().toString(number.toDouble(), 'f', 2);
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
        return found ? QVariant(toolTip(*found)) : QVariant();
    case Qt::FontRole: {
        QFont font;
        font.setItalic(true);
        return isProposed(found) ? QVariant(font) : QVariant();
    }
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
        const QString tips[ColumnCount] = {
            tr("Joint, in the order in which you work"), tr("Views that you clicked + views that you accepted"),
            tr("Root mean square distance from click to reprojection, over the views used"),
            tr("Uncertainty of the 3D joint (standard deviation)"),
            tr("Done: every view with a picture is placed or cannot be placed; bad: error above the threshold, an "
               "outlier, or no 3D point")};
        return tips[section];
    }
    return {};
}

} // namespace widgets
