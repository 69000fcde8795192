// SPDX-License-Identifier: MIT
#pragma once

#include <QLineEdit>
#include <QPushButton>
#include <QWidget>

namespace widgets {

/// Asks once, in place, under which name a person's marks are to be kept; a name is filled in.
class NameBar : public QWidget {
    Q_OBJECT

public:
    explicit NameBar(QWidget* parent = nullptr);

    /// Shows the bar with that name filled in.
    void ask(const QString& name);

signals:
    /// Never empty.
    void answered(const QString& name);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void answer();

    QLineEdit* m_name;
    QPushButton* m_keep;
};

} // namespace widgets
