// SPDX-License-Identifier: MIT
#include "widgets/panels/name_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {
constexpr int kNameWidth = 180;
constexpr int kStripe = 4;
} // namespace

NameBar::NameBar(QWidget* parent)
    : QWidget(parent)
    , m_name(new QLineEdit(this))
    , m_keep(new QPushButton(tr("Use this name"), this)) {
    auto* label = new QLabel(tr("Your marks are kept under your &name:"), this);
    label->setBuddy(m_name);
    m_name->setMaximumWidth(kNameWidth);
    m_name->setFocusPolicy(Qt::ClickFocus); // the keys are the annotation's until a person clicks here
    m_keep->setFocusPolicy(Qt::NoFocus);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2 * kSpacing, kSpacing / 2, kSpacing, kSpacing / 2);
    row->setSpacing(kSpacing);
    for (QWidget* widget : std::initializer_list<QWidget*>{label, m_name, m_keep})
        row->addWidget(widget);
    row->addStretch(1);
    connect(m_name, &QLineEdit::returnPressed, this, &NameBar::answer);
    connect(m_name, &QLineEdit::textChanged, this,
            [this](const QString& text) { m_keep->setEnabled(!text.trimmed().isEmpty()); });
    connect(m_keep, &QPushButton::clicked, this, &NameBar::answer);
    hide();
}

void NameBar::ask(const QString& name) {
    m_name->setText(name);
    show();
}

void NameBar::answer() {
    const QString name = m_name->text().trimmed();
    if (name.isEmpty())
        return;
    hide();
    emit answered(name);
}

void NameBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), mixed(palette().color(QPalette::Window), palette().color(QPalette::Highlight), 0.15));
    painter.fillRect(0, 0, kStripe, height(), palette().color(QPalette::Highlight));
}

} // namespace widgets
