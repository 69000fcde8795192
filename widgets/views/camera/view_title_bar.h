// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

namespace widgets {

/// What the thin line above a view says.
struct ViewTitle {
    QString name;
    QString detail;           ///< such as the frame offset; grey
    QString error;            ///< of the selected joint here, with its unit; right-aligned
    bool warning = false;     ///< this view disagrees: the line turns into a warning colour
    QColor colour = {};       ///< of the lines that this view draws into the others; a chip before the name
    QString next = {};        ///< says that a click is wanted here next: the line turns into the accent colour
    QString tip = {};         ///< what else its tool tip says
    bool keepsDetail = false; ///< the name is shortened before the detail is
    bool operator==(const ViewTitle&) const = default;
};

/// The thin line above a view. A double click asks to maximise it.
class ViewTitleBar : public QWidget {
    Q_OBJECT
public:
    explicit ViewTitleBar(QWidget* parent = nullptr);

    void setTitle(const ViewTitle& title);
    const ViewTitle& title() const { return m_title; }
    void setCurrent(bool current);
    QSize sizeHint() const override;

signals:
    void clicked();
    void doubleClicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    ViewTitle m_title;
    bool m_current = false;
};

} // namespace widgets
