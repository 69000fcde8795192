// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;

namespace widgets {

/// A bar at the top of a view or panel that says what is wrong and what to do about it. Hidden while it has nothing to
/// say.
class MessageBar : public QWidget {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);

    /// Shows the text, or hides the bar if it is empty.
    void setMessage(const QString& text);
    QString message() const;

signals:
    void dismissed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QLabel* m_label;
};

} // namespace widgets
