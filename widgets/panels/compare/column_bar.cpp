// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/column_bar.h"

#include <algorithm>

#include <QApplication>
#include <QMouseEvent>

#include "core/fitting/method_name.h"
#include "widgets/panels/state_colours.h"
#include "widgets/views/method_chip.h"

namespace widgets {

namespace {

constexpr int kChip = 10;
constexpr int kButton = 16;

QToolButton* headButton(const QString& icon, const QString& tip, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(QIcon::fromTheme(icon));
    button->setIconSize({kButton, kButton});
    button->setAutoRaise(true);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::NoFocus);
    return button;
}

} // namespace

ColumnHead::ColumnHead(QWidget* parent)
    : QFrame(parent)
    , m_chip(new QLabel(this))
    , m_text(new QLabel(this))
    , m_error(new QLabel(this))
    , m_settings(headButton(QStringLiteral("configure"), tr("Settings of this method, and what if"), this))
    , m_close(headButton(QStringLiteral("window-close"), tr("Remove this column"), this)) {
    m_close->setIcon({});
    m_close->setText(QStringLiteral("\u00d7"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::OpenHandCursor);
    setToolTip(tr("Drag it to another place"));
    for (QToolButton* button : {m_settings, m_close})
        button->setCursor(Qt::ArrowCursor);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpacing / 2, 0, 0, 0);
    row->setSpacing(kSpacing / 2);
    m_text->setMinimumWidth(1);
    m_text->setTextFormat(Qt::PlainText);
    row->addWidget(m_chip);
    row->addWidget(m_text, 1);
    row->addWidget(m_error);
    row->addWidget(m_settings);
    row->addWidget(m_close);
    connect(m_settings, &QToolButton::clicked, this, &ColumnHead::settingsWanted);
    connect(m_close, &QToolButton::clicked, this, &ColumnHead::removed);
    for (QLabel* label : {m_chip, m_text, m_error})
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
}

void ColumnHead::show(const QString& title, const QColor& colour, bool hasSettings, bool canGo) {
    QPixmap chip(kChip, kChip);
    chip.fill(colour);
    m_chip->setPixmap(chip);
    m_title = title;
    setToolTip(title + QLatin1Char('\n') + tr("Drag it to another place"));
    m_settings->setVisible(hasSettings);
    m_close->setVisible(canGo);
    showTitle();
    QFrame::show();
}

void ColumnHead::showTitle() {
    m_text->setText(fontMetrics().elidedText(m_title, Qt::ElideMiddle, std::max(1, m_text->width())));
}

void ColumnHead::setError(const QString& error) {
    if (error == m_error->text())
        return;
    m_error->setText(error);
    layout()->activate();
    showTitle();
}

void ColumnHead::setCurrent(bool current) {
    setBackgroundRole(current ? QPalette::Mid : QPalette::Button);
    QFont bold = font();
    bold.setBold(current);
    m_text->setFont(bold);
}

void ColumnHead::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    layout()->activate();
    showTitle();
}

void ColumnHead::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_pressedAt = event->pos();
    m_dragging = false;
    emit pressed();
}

void ColumnHead::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton))
        return;
    if ((event->pos() - m_pressedAt).manhattanLength() >= QApplication::startDragDistance() && !m_dragging) {
        m_dragging = true;
        setCursor(Qt::ClosedHandCursor);
        raise();
    }
    if (m_dragging)
        move(mapToParent(event->pos()).x() - m_pressedAt.x(), y());
}

void ColumnHead::mouseReleaseEvent(QMouseEvent* event) {
    setCursor(Qt::OpenHandCursor);
    if (!m_dragging || event->button() != Qt::LeftButton)
        return;
    m_dragging = false;
    emit dropped(mapToParent(event->pos()).x());
}

ColumnBar::ColumnBar(InspectColumns& columns, QWidget* parent)
    : QWidget(parent)
    , m_columns(columns)
    , m_row(new QHBoxLayout)
    , m_add(headButton(QStringLiteral("list-add"), tr("Add a column: a method, the start, the truth, a tracker"), this))
    , m_menu(new QMenu(this)) {
    auto* whole = new QHBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(0);
    m_row->setSpacing(2);
    whole->addLayout(m_row, 1);
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_add->setMenu(m_menu);
    m_add->setAccessibleName(tr("Add a column"));
    connect(m_menu, &QMenu::aboutToShow, this, &ColumnBar::fillMenu);
    connect(&columns, &InspectColumns::changed, this, &ColumnBar::showColumns);
    connect(&columns, &InspectColumns::previewed, this, &ColumnBar::showColumns);
    connect(&columns, &InspectColumns::currentChanged, this, &ColumnBar::showCurrent);
    showColumns();
}

void ColumnBar::showColumns() {
    const std::size_t count = m_columns.outcome() ? m_columns.count() : 0;
    while (m_heads.size() > count) {
        m_heads.back()->hide();
        m_heads.back()->deleteLater(); // it may be the one that was pressed
        m_heads.pop_back();
    }
    while (m_heads.size() < count) {
        const std::size_t column = m_heads.size();
        auto* head = new ColumnHead(this);
        m_heads.push_back(head);
        m_row->addWidget(head, 1);
        connect(head, &ColumnHead::pressed, this, [this, column] { m_columns.setCurrent(column); });
        connect(
            head, &ColumnHead::settingsWanted, this,
            [this, column] {
                m_columns.setCurrent(column);
                emit settingsWanted(column);
            });
        connect(
            head, &ColumnHead::removed, this, [this, column] { m_columns.remove(column); });
        connect(head, &ColumnHead::dropped, this, [this, column](int x) { drop(column, x); });
    }
    for (std::size_t column = 0; column < count; ++column) {
        const InspectColumn& shown = m_columns.columns()[column];
        m_heads[column]->show(m_columns.title(column), m_columns.colour(column),
                              shown.kind == InspectColumn::Kind::Method, count > 1);
    }
    m_row->invalidate();
    showCurrent();
}

void ColumnBar::setErrors(const QStringList& errors) {
    for (std::size_t column = 0; column < m_heads.size(); ++column)
        m_heads[column]->setError(errors.value(static_cast<int>(column)));
}

void ColumnBar::showCurrent() {
    for (std::size_t column = 0; column < m_heads.size(); ++column)
        m_heads[column]->setCurrent(column == m_columns.current() && m_heads.size() > 1);
}

/// Where the middle of the pointer's head lies decides.
void ColumnBar::drop(std::size_t column, int x) {
    const int width = std::max(1, m_row->geometry().width());
    const int last = static_cast<int>(m_heads.size()) - 1;
    const int to = std::clamp(x * static_cast<int>(m_heads.size()) / width, 0, std::max(0, last));
    if (static_cast<std::size_t>(to) == column) {
        m_row->invalidate();
        m_row->activate(); // back to its place
        updateGeometry();
        m_heads[column]->move(m_row->itemAt(static_cast<int>(column))->geometry().topLeft());
        return;
    }
    m_columns.move(column, static_cast<std::size_t>(to));
    m_row->invalidate();
    m_row->activate();
}

void ColumnBar::fillMenu() {
    m_menu->clear();
    const auto add = [this](const InspectColumn& column, bool isPossible) {
        const auto& columns = m_columns.columns();
        QAction* action = m_menu->addAction(methodChip(columnId(column)), columnTitle(column));
        action->setEnabled(isPossible && std::find(columns.begin(), columns.end(), column) == columns.end());
        connect(action, &QAction::triggered, this, [this, column] { m_columns.add(column); });
    };
    for (const std::string& name : core::plainMethodNames())
        add({InspectColumn::Kind::Method, name}, true);
    m_menu->addSeparator();
    for (const InspectColumn::Kind kind : {InspectColumn::Kind::Start, InspectColumn::Kind::Truth})
        add({kind, {}}, m_columns.isAvailable({kind, {}}));
    for (const Tracker& tracker : m_columns.trackers())
        add({InspectColumn::Kind::Tracker, tracker.name}, true);
    connect(m_menu->addAction(tr("A tracker's estimates...")), &QAction::triggered, this, &ColumnBar::trackerWanted);
}

} // namespace widgets
