// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <QLabel>

#include "widgets/presenters/inspect/inspect_probe.h"

namespace widgets {

/// What every method matches at a point, as a small table in the lower right corner of its parent.
class InspectProbeCard : public QFrame {
    Q_OBJECT

public:
    explicit InspectProbeCard(QWidget* parent);

    void showProbe(const QString& camera, const InspectProbe& probe);
    /// The table as rich text.
    QString text() const { return m_table->text(); }

signals:
    void closed();

private:
    QLabel* m_heading;
    QLabel* m_table;
};

} // namespace widgets
