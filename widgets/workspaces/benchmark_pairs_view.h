// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QWidget>

#include "widgets/models/pair_table_model.h"

namespace widgets {

/// The pairs of a benchmark as a table with a filter, and the choice of the two methods that are compared. Several
/// pairs can be selected, to be run again.
class BenchmarkPairsView : public QWidget {
    Q_OBJECT

public:
    explicit BenchmarkPairsView(QWidget* parent = nullptr);

    /// Null for no results. Filter, order, compared methods and selection stay where the methods do.
    void setTable(const std::shared_ptr<const core::PairTable>& table);

    const PairTableModel& model() const { return *m_model; }
    QString filter() const { return m_filter->text(); }
    /// Shows the pairs that a text lets pass; all of them while it makes no sense. Returns what is wrong with it, empty
    /// if nothing is.
    QString setFilter(const QString& text);
    /// Which methods A and B are: false if there is no such method.
    bool setCompared(const QString& a, const QString& b);
    /// Sorts by a quantity; false if the table has no column of it.
    bool sortBy(const core::PairQuantity& quantity, Qt::SortOrder order);
    /// Indices into the table.
    std::vector<std::size_t> selected() const;
    void select(const std::vector<std::size_t>& pairs);
    void askForFilter();
    /// Asks that the selected pairs are run.
    void runSelected();

signals:
    /// Other pairs are shown, or A and B are others.
    void shownChanged();
    void selectionChanged();
    void pairOpened(std::size_t pair);
    void runRequested(const std::vector<std::size_t>& pairs);

private:
    QLayout* makeChoiceRow();
    void makeTable();
    void takeChoice();
    void takeFilter();
    void showChoice();
    void showCounts();
    void showOrder();
    void showMenu(const QPoint& place);

    PairTableModel* m_model;
    QTableView* m_table;
    QComboBox* m_a;
    QComboBox* m_b;
    QLineEdit* m_filter;
    QLabel* m_count;
    QLabel* m_wrong; ///< with the filter
    QPushButton* m_run;
    QString m_problem;
};

} // namespace widgets
