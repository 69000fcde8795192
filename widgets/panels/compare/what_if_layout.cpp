// SPDX-License-Identifier: MIT
// How the panel is built; what it does stands in what_if_panel.cpp.
#include "widgets/panels/compare/what_if_panel.h"

#include <algorithm>
#include <cmath>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {

constexpr int kPlotHeight = 130;
constexpr double kNoiseStepPx = 0.25; ///< of the slider

QPushButton* makeButton(const QString& text, const QString& icon, const QString& tip, QWidget* parent) {
    auto* button = new QPushButton(QIcon::fromTheme(icon), text, parent);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::NoFocus);
    return button;
}

} // namespace

WhatIfPanel::WhatIfPanel(const FitRunner& fits, InspectColumns& columns, const DatasetSession& datasets, JobPool& pool,
                         QWidget* parent)
    : QWidget(parent)
    , m_fits(fits)
    , m_columns(columns)
    , m_datasets(datasets)
    , m_runner(fits, datasets, pool)
    , m_hint(new QLabel(tr("Fit a pair: the settings of its methods can be changed here then."), this))
    , m_content(new QWidget(this))
    , m_column(new QComboBox(this))
    , m_line(new QLineEdit(this))
    , m_problem(new QLabel(this))
    , m_form(new MethodForm(this))
    , m_noiseSlider(new QSlider(Qt::Horizontal, this))
    , m_noise(new QDoubleSpinBox(this))
    , m_draw(new QSpinBox(this))
    , m_cameraGrid(new QGridLayout)
    , m_measure(makeButton(tr("What does each camera add?"), QStringLiteral("camera-video"),
                           tr("Fits without each camera in turn: how much the error grows stands beside it"), this))
    , m_sweep(makeButton({}, QStringLiteral("office-chart-line"),
                         tr("Fits at a row of values of this parameter, for every column that has it, and fills the "
                            "curve; once more stops"),
                         this))
    , m_progress(new QProgressBar(this))
    , m_apply(makeButton(tr("Use"), QStringLiteral("dialog-ok-apply"), tr("Gives the column these settings"), this))
    , m_add(makeButton(tr("Add as another column"), QStringLiteral("list-add"),
                       tr("Keeps the column, and shows these settings beside it"), this))
    , m_back(makeButton(tr("Restore"), QStringLiteral("edit-undo"), tr("All as it was fitted"), this))
    , m_answer(new QLabel(this))
    , m_held(new QLabel(this))
    , m_plot(new CurvePlot(this)) {
    build();
    connectParts();
    takeColumns();
}

int WhatIfPanel::noiseStep(double px) {
    return static_cast<int>(std::lround(px / kNoiseStepPx));
}

void WhatIfPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_runner.prepare();
}

void WhatIfPanel::connectParts() {
    connect(&m_columns, &InspectColumns::changed, this, &WhatIfPanel::takeColumns);
    connect(&m_columns, &InspectColumns::currentChanged, this, [this] { showColumn(m_columns.current()); });
    connect(m_column, qOverload<int>(&QComboBox::currentIndexChanged), this, &WhatIfPanel::takeColumns);
    connect(m_line, &QLineEdit::editingFinished, this, [this] {
        if (m_line->isModified())
            takeLine();
        m_line->setModified(false);
    });
    connect(m_form, &MethodForm::edited, this, &WhatIfPanel::edit);
    connect(m_noiseSlider, &QSlider::valueChanged, m_noise, [this](int at) { m_noise->setValue(at * kNoiseStepPx); });
    connect(m_noise, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double px) {
        const QSignalBlocker blocker(m_noiseSlider);
        m_noiseSlider->setValue(noiseStep(px));
        explore(kNoiseKey);
    });
    connect(m_draw, qOverload<int>(&QSpinBox::valueChanged), this, [this] {
        if (m_key == kNoiseKey)
            startCurve(kNoiseKey); // its points are of the other draw
        explore(kNoiseKey);
    });
    connect(&m_runner, &WhatIf::found, this, &WhatIfPanel::take);
    connect(
        &m_runner, &WhatIf::failed, this,
        [this](const QString& message) {
            m_isSweeping = false;
            showSweep();
            m_answer->setText(message);
        });
    connect(&m_runner, &WhatIf::finished, this, [this] {
        if (m_isSweeping) {
            endSweep();
            return;
        }
        const auto most = std::max_element(m_without.begin(), m_without.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        if (most != m_without.end())
            m_answer->setText(tr("The error grows most without %1.")
                                  .arg(m_cameras[static_cast<std::size_t>(most->first)]->objectName()));
    });
    connect(m_sweep, &QPushButton::clicked, this, &WhatIfPanel::sweepOrStop);
    connect(m_measure, &QPushButton::clicked, this, &WhatIfPanel::measureCameras);
    connect(m_apply, &QPushButton::clicked, this, &WhatIfPanel::apply);
    connect(m_add, &QPushButton::clicked, this, &WhatIfPanel::addColumn);
    connect(m_back, &QPushButton::clicked, this, &WhatIfPanel::goBack);
}

void WhatIfPanel::build() {
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
    m_hint->setWordWrap(true);
    whole->addWidget(m_hint);
    whole->addWidget(m_content, 1);
    auto* column = new QVBoxLayout(m_content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    m_column->setFocusPolicy(Qt::NoFocus);
    m_column->setToolTip(tr("The column whose settings are changed"));
    m_column->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_line->setToolTip(tr("The method as on the command line; Enter takes it over"));
    m_line->setAccessibleName(tr("Method with its settings"));
    m_line->setFocusPolicy(Qt::ClickFocus);
    m_problem->setWordWrap(true);
    m_problem->setForegroundRole(QPalette::BrightText);
    QPalette colours = m_problem->palette();
    colours.setColor(QPalette::BrightText, kBadColour);
    m_problem->setPalette(colours);
    m_problem->hide();
    m_answer->setWordWrap(true);
    m_held->setWordWrap(true);
    m_held->setForegroundRole(QPalette::PlaceholderText);
    m_held->hide();
    m_plot->setFixedHeight(kPlotHeight);
    column->addWidget(m_column);
    column->addWidget(m_line);
    column->addWidget(m_problem);
    column->addWidget(m_plot); // in sight while a setting below it is dragged
    column->addWidget(m_held);
    column->addLayout(makeSweepRow());
    column->addWidget(m_answer);
    column->addWidget(m_form);
    column->addLayout(makeButtons());
    column->addLayout(makeSilhouettes());
    column->addStretch(1);
}

QLayout* WhatIfPanel::makeSweepRow() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    m_progress->setTextVisible(true);
    m_progress->hide();
    row->addWidget(m_sweep);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    return row;
}

QLayout* WhatIfPanel::makeButtons() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing / 2);
    row->addWidget(m_apply);
    row->addWidget(m_add, 1);
    row->addWidget(m_back);
    return row;
}

QLayout* WhatIfPanel::makeDrawRow() {
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Draw of the noise"), this);
    m_draw->setRange(0, kMostNoiseDraw);
    m_draw->setAlignment(Qt::AlignRight);
    m_draw->setFocusPolicy(Qt::ClickFocus);
    m_draw->setKeyboardTracking(false);
    label->setBuddy(m_draw);
    for (QWidget* part : std::initializer_list<QWidget*>{label, m_draw})
        part->setToolTip(tr("Which draw of the noise: other wiggles of the same size. One draw alone may be luck."));
    row->addWidget(label, 1);
    row->addWidget(m_draw);
    return row;
}

QLayout* WhatIfPanel::makeSilhouettes() {
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpacing / 2);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Noise of the outlines"), this);
    const QString tip = tr("What if the silhouettes were noisier? By how much their outlines move, pixels");
    m_noiseSlider->setRange(0, noiseStep(kMostOutlineNoisePx));
    m_noiseSlider->setFocusPolicy(Qt::NoFocus);
    m_noiseSlider->setMinimumWidth(60);
    m_noise->setRange(0, kMostOutlineNoisePx);
    m_noise->setSingleStep(kNoiseStepPx);
    m_noise->setSuffix(tr(" px"));
    m_noise->setAlignment(Qt::AlignRight);
    m_noise->setFocusPolicy(Qt::ClickFocus);
    m_noise->setKeyboardTracking(false);
    label->setBuddy(m_noise);
    for (QWidget* part : std::initializer_list<QWidget*>{label, m_noiseSlider, m_noise})
        part->setToolTip(tip);
    row->addWidget(label);
    row->addWidget(m_noiseSlider, 1);
    row->addWidget(m_noise);
    column->addLayout(row);
    column->addLayout(makeDrawRow());
    m_cameraGrid->setHorizontalSpacing(kSpacing);
    m_cameraGrid->setVerticalSpacing(2);
    column->addWidget(new QLabel(tr("Cameras that take part"), this));
    column->addLayout(m_cameraGrid);
    column->addWidget(m_measure, 0, Qt::AlignLeft);
    return column;
}

} // namespace widgets
