// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTimer>

#include "widgets/jobs/dataset_maker.h"
#include "widgets/views/rig_drawing.h"

namespace app {

/// The second step: the calibration, what it was recognised as, its cameras drawn in space, and what is wrong with it.
class CalibrationPage : public QWidget {
    Q_OBJECT

public:
    explicit CalibrationPage(QWidget* parent = nullptr);

    QString path() const { return m_path->text().trimmed(); }
    void setPath(const QString& path);
    /// Nothing: as is usual for its kind.
    std::optional<double> mmPerUnit() const;
    void show(const widgets::CalibrationLook& look);
    void showFailure(const QString& message);
    /// Why the next step cannot be taken; empty if it can.
    QString problem() const;
    widgets::RigDrawing* drawing() const { return m_drawing; }
    QListWidget* findings() const { return m_findings; }

signals:
    /// Another file or unit: it is to be read.
    void changed();

private:
    void clear();
    QString summary() const;

    QLineEdit* m_path;
    QComboBox* m_unit;
    QLabel* m_summary;
    widgets::RigDrawing* m_drawing;
    QListWidget* m_findings;
    QTimer m_wait; ///< until the name is typed
    std::optional<widgets::CalibrationLook> m_look;
    QString m_failure;
};

} // namespace app
