// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QWidget>

#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/rater_study.h"
#include "widgets/models/agreement_model.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// How far raters agree with each other and with themselves, what all say of the selected joint together, and the
/// repeat round.
class RatersPanel : public QWidget {
    Q_OBJECT

public:
    RatersPanel(RaterStudy& study, const Selection& selection, const Reconstructions& reconstructions,
                const DatasetSession& datasets, QWidget* parent = nullptr);

signals:
    /// The buttons of the repeat round.
    void roundRequested();
    void nextTaskRequested();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void compareIfShown();
    void showComparisons();
    void showPair();
    void showConsensus();
    void showRound();

    RaterStudy& m_study;
    const Selection& m_selection;
    const Reconstructions& m_reconstructions;
    MessageBar* m_message;
    QComboBox* m_pairs;
    QLabel* m_clicks;
    QTableView* m_table;
    AgreementModel* m_model;
    QLabel* m_nothing;
    QLabel* m_consensus;
    QLabel* m_round;
    QPushButton* m_next;
    QPushButton* m_begin;
    QPushButton* m_compare;
};

} // namespace widgets
