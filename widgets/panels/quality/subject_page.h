// SPDX-License-Identifier: MIT
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QWidget>

#include "widgets/jobs/subject_study.h"
#include "widgets/models/subject_model.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// Measures the hands of the person who was annotated: which sequences, the bones, scale and girth that were found, and
/// a new dataset with these hands.
class SubjectPage : public QWidget {
    Q_OBJECT

public:
    explicit SubjectPage(SubjectStudy& study, QWidget* parent = nullptr);

    /// Measures from what is chosen, or says what is missing.
    void measure();
    core::SubjectRequest request() const;

signals:
    /// The person wants to open a dataset that was saved.
    void openRequested(const QString& folder);

private:
    void build();
    QLayout* makeChoice();
    QLayout* makeButtons();
    void showSources();
    void showResult();
    void showRunning();
    void askWhereToSave();

    SubjectStudy& m_study;
    MessageBar* m_message;
    MessageBar* m_saved;
    QListWidget* m_sources;
    QSpinBox* m_mostFrames;
    QCheckBox* m_withMasks;
    QPushButton* m_measure;
    QProgressBar* m_progress;
    QLabel* m_stage;
    QPushButton* m_stop;
    QLabel* m_result;
    QTableView* m_table;
    SubjectModel* m_model;
    QPushButton* m_save;
};

} // namespace widgets
