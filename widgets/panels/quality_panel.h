// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableView>
#include <QWidget>

#include "widgets/models/finding_model.h"
#include "widgets/session/window_session.h"

namespace widgets {

/// What deserves a look in the current frame or the whole sequence, and how the sequence stands. A row jumps to its
/// joint and view.
class QualityPanel : public QWidget {
    Q_OBJECT

public:
    explicit QualityPanel(WindowSession& session, QWidget* parent = nullptr);

    /// The keyboard goes to the error threshold.
    void askForThreshold();

signals:
    void badRmsPxChanged(double px);

private:
    void build();
    void refresh();
    void refreshSummary();
    QString nothingText() const;
    std::vector<Finding> frameFindings() const;
    std::vector<Finding> sequenceFindings() const;
    void jump(const QModelIndex& index);

    WindowSession& m_session;
    QDoubleSpinBox* m_threshold;
    QComboBox* m_scope;
    QLabel* m_summary;
    QLabel* m_nothing;
    QTableView* m_table;
    FindingModel* m_model;
};

} // namespace widgets
