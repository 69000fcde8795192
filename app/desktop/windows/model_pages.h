// SPDX-License-Identifier: MIT
#pragma once

#include <QLineEdit>
#include <QRadioButton>
#include <QWidget>

#include "widgets/jobs/dataset_maker.h"

namespace app {

/// The third step: which hand models the dataset gets.
class HandsPage : public QWidget {
    Q_OBJECT

public:
    explicit HandsPage(QWidget* parent = nullptr);

    void setDataset(const QString& folder);
    void fill(widgets::NewDatasetRequest& request) const;
    /// Why the next step cannot be taken; empty if it can.
    QString problem() const;

signals:
    void changed();

private:
    QRadioButton* m_demo;
    QRadioButton* m_none;
    QRadioButton* m_other;
    QLineEdit* m_folder;
};

/// The fourth step: silhouettes that are there already.
class MasksPage : public QWidget {
    Q_OBJECT

public:
    explicit MasksPage(QWidget* parent = nullptr);

    void setMasks(const QString& folderOrPattern);
    void fill(widgets::NewDatasetRequest& request) const;
    QString problem() const;

signals:
    void changed();

private:
    QRadioButton* m_none;
    QRadioButton* m_given;
    QLineEdit* m_path;
};

} // namespace app
