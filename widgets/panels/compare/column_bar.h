// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QWidget>

#include "widgets/presenters/inspect_columns.h"

namespace widgets {

/// The head of one column: what it shows, its settings, away with it. Dragged, it changes places.
class ColumnHead : public QFrame {
    Q_OBJECT

public:
    explicit ColumnHead(QWidget* parent = nullptr);

    void show(const QString& title, const QColor& colour, bool hasSettings, bool canGo);
    /// Beside the title, to its right.
    void setError(const QString& error);
    void setCurrent(bool current);
    QString error() const { return m_error->text(); }
    QString title() const { return m_title; }

signals:
    void pressed();
    void settingsWanted();
    void removed();
    /// Dropped at this x of the parent.
    void dropped(int x);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showTitle();

    QLabel* m_chip;
    QLabel* m_text;
    QLabel* m_error;
    QToolButton* m_settings;
    QToolButton* m_close;
    QString m_title;
    QPoint m_pressedAt;
    bool m_dragging = false;
};

/// The heads of the Inspect workspace's columns, each above its views, and a menu to add one.
class ColumnBar : public QWidget {
    Q_OBJECT

public:
    explicit ColumnBar(InspectColumns& columns, QWidget* parent = nullptr);

    const std::vector<ColumnHead*>& heads() const { return m_heads; }
    /// Of the columns, at what is shown of them.
    void setErrors(const QStringList& errors);
    /// The menu's button, for the page to place: the heads fill the bar.
    QToolButton* addButton() const { return m_add; }

signals:
    void settingsWanted(std::size_t column);
    /// A tracker's file is to be chosen.
    void trackerWanted();

private:
    void showColumns();
    void showCurrent();
    void fillMenu();
    void drop(std::size_t column, int x);

    InspectColumns& m_columns;
    std::vector<ColumnHead*> m_heads;
    QHBoxLayout* m_row;
    QToolButton* m_add;
    QMenu* m_menu;
};

} // namespace widgets
