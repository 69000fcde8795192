// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QComboBox>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QWidget>

#include "core/io/dataset/new_sequence.h"

namespace app {

/// The first step towards a dataset: which video or folder of images is of which camera, and from which frame on.
class FootagePage : public QWidget {
    Q_OBJECT

public:
    explicit FootagePage(QWidget* parent = nullptr);

    void addFootage(const QStringList& paths);
    /// The cameras to choose from; what a person has chosen stays, the rest goes by name.
    void setCameras(const QStringList& names);
    std::vector<core::Footage> footage() const;
    QString sequence() const { return m_sequence->text().trimmed(); }
    QTableWidget* table() const { return m_table; }
    /// Why the next step cannot be taken; empty if it can.
    QString problem() const;

signals:
    void changed();
    /// Paths that a person has chosen; they may hold several pieces of footage.
    void chosen(const QStringList& paths);

private:
    void addButtons(QVBoxLayout& column);
    void askForFootage(bool isFolder);
    QComboBox* choiceIn(int row) const;
    QStringList paths() const;

    QTableWidget* m_table;
    QLineEdit* m_sequence;
    QStringList m_cameras;
};

} // namespace app
