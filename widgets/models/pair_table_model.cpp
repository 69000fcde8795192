// SPDX-License-Identifier: MIT
#include "widgets/models/pair_table_model.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QFont>

#include "widgets/text/local_text.h"

namespace widgets {

namespace {

using core::PairField;
using core::PairQuantity;

bool isOfMethod(PairField field) {
    return field == PairField::ErrorMm || field == PairField::Iterations || field == PairField::Seconds;
}

bool isOfMethods(PairField field) {
    return isOfMethod(field) || field == PairField::ErrorDifferenceMm;
}

/// The places of these methods in another table; no value if one is missing there.
std::optional<std::vector<std::size_t>> placesOf(const std::vector<std::string>& methods,
                                                 const std::vector<std::string>& others) {
    std::vector<std::size_t> places;
    for (const std::string& method : methods) {
        const auto found = std::find(others.begin(), others.end(), method);
        if (found == others.end())
            return std::nullopt;
        places.push_back(static_cast<std::size_t>(found - others.begin()));
    }
    return places;
}

} // namespace

PairTableModel::PairTableModel(QObject* parent)
    : QAbstractTableModel(parent) {
    makeColumns();
}

bool PairTableModel::setTable(std::shared_ptr<const core::PairTable> table) {
    beginResetModel();
    const std::shared_ptr<const core::PairTable> before = std::exchange(m_table, std::move(table));
    const auto now = before && m_table ? placesOf(before->methods, m_table->methods) : std::nullopt;
    if (now) {
        m_compared = {(*now)[m_compared.a], (*now)[m_compared.b]};
        if (m_sorted) {
            m_sorted->method = isOfMethods(m_sorted->field) ? (*now)[m_sorted->method] : m_sorted->method;
            m_sorted->other =
                m_sorted->field == PairField::ErrorDifferenceMm ? (*now)[m_sorted->other] : m_sorted->other;
        }
        if (before->methods != m_table->methods)
            m_filter.clear(); // it names methods by their places
    } else {
        m_filter.clear();
        m_compared = {m_table && m_table->methods.size() > 1 ? 1u : 0u, 0u};
        m_sorted = PairQuantity{PairField::ErrorDifferenceMm, m_compared.a, m_compared.b};
        m_order = Qt::DescendingOrder;
    }
    makeColumns();
    refresh();
    endResetModel();
    return now.has_value();
}

void PairTableModel::setCompared(const core::ComparedMethods& compared) {
    if (compared == m_compared)
        return;
    beginResetModel();
    m_compared = compared;
    if (m_sorted && m_sorted->field == PairField::ErrorDifferenceMm)
        m_sorted = PairQuantity{PairField::ErrorDifferenceMm, compared.a, compared.b};
    makeColumns();
    refresh();
    endResetModel();
}

void PairTableModel::setFilter(core::PairFilter filter) {
    beginResetModel();
    m_filter = std::move(filter);
    refresh();
    endResetModel();
}

void PairTableModel::sort(int column, Qt::SortOrder order) {
    if (column < 0 || column >= columnCount())
        return;
    beginResetModel();
    m_sorted = quantity(column);
    m_order = order;
    refresh();
    endResetModel();
}

void PairTableModel::refresh() {
    m_shown = m_table ? core::filteredPairs(*m_table, m_filter) : std::vector<std::size_t>{};
    if (m_table && m_sorted)
        m_shown = core::sortedPairs(*m_table, std::move(m_shown), *m_sorted, m_order == Qt::DescendingOrder);
}

void PairTableModel::makeColumns() {
    m_columns = {{PairField::Sequence, 0, 0},
                 {PairField::Start, 0, 0},
                 {PairField::Test, 0, 0},
                 {PairField::Difference, 0, 0},
                 {PairField::StartErrorMm, 0, 0}};
    if (!m_table)
        return;
    if (m_table->methods.size() > 1)
        m_columns.push_back({PairField::ErrorDifferenceMm, m_compared.a, m_compared.b});
    for (const PairField field : {PairField::ErrorMm, PairField::Iterations, PairField::Seconds})
        for (std::size_t method = 0; method < m_table->methods.size(); ++method)
            m_columns.push_back({field, method, 0});
}

int PairTableModel::columnOf(const PairQuantity& quantity) const {
    const auto found = std::find(m_columns.begin(), m_columns.end(), quantity);
    return found == m_columns.end() ? -1 : static_cast<int>(found - m_columns.begin());
}

int PairTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int PairTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QString PairTableModel::cell(const PairQuantity& quantity, std::size_t pair) const {
    if (quantity.field == PairField::Sequence)
        return QString::fromStdString(m_table->pairs[pair].sequence);
    const double value = core::pairValue(*m_table, quantity, pair);
    if (std::isnan(value) || (quantity.field == PairField::Seconds && value == 0)) // of an external tracker
        return {};
    switch (quantity.field) {
    case PairField::StartErrorMm:
    case PairField::ErrorMm:
        return localNumber(value, 2);
    case PairField::ErrorDifferenceMm:
        return (value > 0 ? QStringLiteral("+") : QString()) + localNumber(value, 2);
    case PairField::Seconds:
        return localNumber(value, 3);
    default:
        return QString::number(static_cast<int>(value)); // frames are names, not amounts
    }
}

/// The best of several methods stands out in its row.
bool PairTableModel::isSmallestError(const PairQuantity& quantity, std::size_t pair) const {
    if (quantity.field != PairField::ErrorMm || m_table->columns.size() < 2)
        return false;
    const double mine = core::pairValue(*m_table, quantity, pair);
    return !std::isnan(mine) &&
           std::none_of(m_table->columns.begin(), m_table->columns.end(),
                        [&](const core::PairTable::Column& column) { return column.errorMm[pair] < mine; });
}

QVariant PairTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const PairQuantity& what = quantity(index.column());
    const std::size_t pair = m_shown[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return cell(what, pair);
    if (role == Qt::TextAlignmentRole)
        return int((what.field == PairField::Sequence ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::FontRole && isSmallestError(what, pair)) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    return {};
}

QString PairTableModel::headerText(const PairQuantity& quantity) const {
    const QString method =
        isOfMethod(quantity.field) ? QString::fromStdString(m_table->methods[quantity.method]) : QString();
    switch (quantity.field) {
    case PairField::Sequence:
        return tr("Sequence");
    case PairField::Start:
        return tr("Start");
    case PairField::Test:
        return tr("Test");
    case PairField::Difference:
        return tr("Apart");
    case PairField::StartErrorMm:
        return tr("Start mm");
    case PairField::ErrorMm:
        return tr("%1 mm").arg(method);
    case PairField::ErrorDifferenceMm:
        return tr("A \u2212 B mm");
    case PairField::Iterations:
        return tr("%1 iterations").arg(method);
    case PairField::Seconds:
        return tr("%1 s").arg(method);
    }
    return {};
}

QString PairTableModel::headerTip(const PairQuantity& quantity) const {
    const auto name = [this](std::size_t method) { return QString::fromStdString(m_table->methods[method]); };
    switch (quantity.field) {
    case PairField::Difference:
        return tr("Frames between start and test");
    case PairField::StartErrorMm:
        return tr("Mean joint error of the start pose");
    case PairField::ErrorMm:
        return tr("Mean joint error of %1; the smallest of a row is bold").arg(name(quantity.method));
    case PairField::ErrorDifferenceMm:
        return tr("Error of %1 minus error of %2: above 0 where %1 is worse")
            .arg(name(quantity.method), name(quantity.other));
    default:
        return {};
    }
}

QVariant PairTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    const PairQuantity& what = quantity(section);
    // Styles draw icons at the left end: the name stands beside its chip.
    const bool isLeft = what.field == PairField::Sequence || (what.field == PairField::ErrorMm && m_methodIcon);
    if (role == Qt::TextAlignmentRole)
        return int((isLeft ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return headerTip(what);
    if (role == Qt::DecorationRole && what.field == PairField::ErrorMm)
        return m_methodIcon ? QVariant(m_methodIcon(m_table->methods[what.method])) : QVariant();
    return role == Qt::DisplayRole ? QVariant(headerText(what)) : QVariant();
}

} // namespace widgets
