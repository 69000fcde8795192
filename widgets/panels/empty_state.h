// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>
#include <QWidget>

namespace widgets {

/// What fills the window while no dataset is open: what to do, and the buttons to do it.
class EmptyState : public QWidget {
    Q_OBJECT

public:
    explicit EmptyState(QWidget* parent = nullptr);

    void setRecentDatasets(const QStringList& folders);

signals:
    void openRequested();
    void demoRequested();
    /// A dataset is to be made.
    void newRequested();
    void recentRequested(const QString& folder);

private:
    QVBoxLayout* m_recent;
    QLabel* m_recentTitle;
};

} // namespace widgets
