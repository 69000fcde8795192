// SPDX-License-Identifier: MIT
#include "widgets/panels/quality/rig_health_view.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/text/rig_text.h"

namespace widgets {

RigHealthView::RigHealthView(const RigStudy& rig, QWidget* parent)
    : QWidget(parent)
    , m_rig(rig)
    , m_findings(new QLabel(this))
    , m_table(new QTableView(this))
    , m_model(new RigHealthModel(this))
    , m_hint(new QLabel(this))
    , m_refine(new QPushButton(tr("Refine calibration..."), this))
    , m_arrows(new QToolButton(this)) {
    build();
    connect(&rig, &RigStudy::changed, this, &RigHealthView::refresh);
    connect(m_refine, &QPushButton::clicked, this, &RigHealthView::refineRequested);
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& index) {
        emit cameraChosen(index.siblingAtColumn(RigHealthModel::Camera).data().toString().toStdString());
    });
    refresh();
}

void RigHealthView::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    for (QLabel* label : {m_findings, m_hint}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    QPalette quiet = palette();
    quiet.setColor(QPalette::WindowText, quietTextColour(quiet));
    m_hint->setPalette(quiet);
    m_table->setModel(m_model);
    styleTable(*m_table);
    m_table->horizontalHeader()->setSectionResizeMode(RigHealthModel::Camera, QHeaderView::ResizeToContents);
    constexpr int kRowsAtLeast = 4;
    m_table->setMinimumHeight((kRowsAtLeast + 1) * m_table->verticalHeader()->defaultSectionSize());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_table, m_refine, m_arrows})
        widget->setFocusPolicy(Qt::NoFocus);
    m_refine->setToolTip(tr("Adjusts the cameras to the clicks; nothing changes before you use the result"));
    m_arrows->hide();
    auto* row = new QHBoxLayout;
    row->addWidget(m_refine);
    row->addWidget(m_arrows);
    row->addStretch(1);
    column->addWidget(m_findings);
    column->addWidget(m_table, 1);
    column->addWidget(m_hint);
    column->addLayout(row);
}

void RigHealthView::setArrowsAction(QAction* action) {
    m_arrows->setDefaultAction(action);
    m_arrows->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_arrows->show();
}

void RigHealthView::refresh() {
    const auto& state = m_rig.state();
    m_model->setHealth(state ? state->health : core::RigHealth{});
    const bool any = state && state->health.joints > 0;
    m_table->setVisible(any);
    m_refine->setEnabled(any);
    if (!state) {
        m_findings->show();
        m_findings->setText(tr("The clicks of all sequences are being looked at."));
        m_hint->clear();
        return;
    }
    QStringList texts = rigFindingTexts(state->health, state->sequences) + state->unread;
    if (!any)
        texts << tr("No joint is clicked in two cameras yet: the calibration cannot be judged.");
    else if (!state->health.isKnown && state->health.canTellCameras())
        texts << tr("There are too few clicks to judge the calibration.");
    m_findings->setText(texts.join(QLatin1Char('\n')));
    m_findings->setVisible(!texts.isEmpty());
    m_hint->setText(any ? clickSigmaText(m_rig.clickSigmas()) + QLatin1Char('\n') +
                              refinementNeedsText(state->health, state->needs)
                        : QString());
}

} // namespace widgets
