// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QLabel>
#include <QListWidget>

namespace app {

/// Lets a person choose a kind of annotation file: what each holds, which programs read it, and what is lost in it.
class ExportWindow : public QDialog {
    Q_OBJECT

public:
    /// `kind` is the one that is chosen at first.
    explicit ExportWindow(const QString& kind, QWidget* parent = nullptr);

    QString kind() const;

signals:
    /// The window has closed; where to comes next.
    void chosen(const QString& kind);

private:
    void explain();
    void choose();

    QListWidget* m_kinds;
    QLabel* m_holds;
    QLabel* m_readBy;
    QLabel* m_lost;
    QLabel* m_whose;
};

} // namespace app
