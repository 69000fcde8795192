// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QAbstractTableModel>
#include <QIcon>

#include "core/benchmark/comparison/pair_filter.h"
#include "core/benchmark/comparison/pair_table.h"

namespace widgets {

/// The pairs of a benchmark that pass a filter, sorted: a row per pair, a column per method for each of error,
/// iterations and seconds, and the error of one method minus that of another. It only shows.
class PairTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit PairTableModel(QObject* parent = nullptr);

    /// What stands in the headers before a method's name.
    void setMethodIcon(std::function<QIcon(const std::string& method)> icon) { m_methodIcon = std::move(icon); }
    /// Null for no results. Keeps order and compared methods if all methods of before are still there, and the filter
    /// if they are the same.
    /// Whether order and compared methods were kept.
    bool setTable(std::shared_ptr<const core::PairTable> table);
    /// Which methods A and B are.
    void setCompared(const core::ComparedMethods& compared);
    const core::ComparedMethods& compared() const { return m_compared; }
    void setFilter(core::PairFilter filter);
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
    /// By which quantity the rows are sorted; none: as in the results.
    const std::optional<core::PairQuantity>& sortedBy() const { return m_sorted; }
    Qt::SortOrder order() const { return m_order; }

    const std::shared_ptr<const core::PairTable>& table() const { return m_table; }
    /// The pairs that are shown, as indices into the table, in their order.
    const std::vector<std::size_t>& shown() const { return m_shown; }
    const core::FramePair& pair(int row) const { return m_table->pairs[m_shown[static_cast<std::size_t>(row)]]; }
    /// The column with this quantity, or -1.
    int columnOf(const core::PairQuantity& quantity) const;
    /// What a column shows.
    const core::PairQuantity& quantity(int column) const { return m_columns[static_cast<std::size_t>(column)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    void refresh();
    void makeColumns();
    QString headerText(const core::PairQuantity& quantity) const;
    QString headerTip(const core::PairQuantity& quantity) const;
    QString cell(const core::PairQuantity& quantity, std::size_t pair) const;
    bool isSmallestError(const core::PairQuantity& quantity, std::size_t pair) const;

    std::function<QIcon(const std::string& method)> m_methodIcon;
    std::shared_ptr<const core::PairTable> m_table;
    core::ComparedMethods m_compared;
    core::PairFilter m_filter;
    std::vector<core::PairQuantity> m_columns;
    std::optional<core::PairQuantity> m_sorted;
    Qt::SortOrder m_order = Qt::DescendingOrder;
    std::vector<std::size_t> m_shown;
};

} // namespace widgets
