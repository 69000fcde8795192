// SPDX-License-Identifier: MIT
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>

#include "widgets/document/joint_list.h"
#include "widgets/jobs/first_pass.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// What the first pass labels, its start and its progress; where the detector is not installed, what is missing and how
/// to get it.
class FirstPassForm : public QWidget {
    Q_OBJECT

public:
    FirstPassForm(FirstPass& pass, DatasetSession& datasets, JointList& joints, QWidget* parent = nullptr);

    /// Starts with what is chosen, or says what is missing; another sequence is opened first.
    void start();
    /// Chooses the frames first, first + step, ... up to `last`, as far as the sequence has them.
    void setFrames(int first, int last, int step);
    FirstPassRequest request() const;
    /// Whether a button asks to hide it.
    void setClosable(bool closable);

signals:
    /// The person is done here.
    void closeRequested();

private:
    void build();
    QLayout* makeFrames();
    QLayout* makeButtons();
    void showSequences();
    void takeSequence();
    void showChoice();
    void listProposed(const FirstPassResult& result);
    void showRunning();
    void showMissing();
    void askForPackage();

    FirstPass& m_pass;
    DatasetSession& m_datasets;
    JointList& m_joints;
    MessageBar* m_message;
    QComboBox* m_sequence;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QSpinBox* m_step;
    QCheckBox* m_left;
    QCheckBox* m_right;
    QCheckBox* m_allJoints;
    QLabel* m_choice;
    QPushButton* m_start;
    QPushButton* m_stop;
    QPushButton* m_close;
    QProgressBar* m_progress;
    bool m_isClosable = false;
    bool m_saysMissing = false;    ///< that the detector is not installed
    bool m_startsWhenOpen = false; ///< as soon as the chosen sequence is open
};

} // namespace widgets
