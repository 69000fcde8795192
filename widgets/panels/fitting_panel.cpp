// SPDX-License-Identifier: MIT
#include "widgets/panels/fitting_panel.h"

#include <algorithm>
#include <cmath>

#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/fitting/method_name.h"
#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/views/joint_colours.h"
#include "widgets/views/method_chip.h"

namespace widgets {

FittingPanel::FittingPanel(Selection& selection, FitRunner& fits, QWidget* parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_fits(fits)
    , m_message(new MessageBar(this))
    , m_start(new QSpinBox(this))
    , m_test(new QSpinBox(this))
    , m_target(new QComboBox(this))
    , m_attach(new QPushButton(tr("Attach masks..."), this))
    , m_run(new QPushButton(this))
    , m_progress(new QProgressBar(this))
    , m_table(new QTableView(this))
    , m_model(new ResultTableModel(this))
    , m_plot(new CurvePlot(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
    column->setSpacing(kSpacing);
    column->addWidget(m_message);
    column->addWidget(m_attach);
    column->addLayout(makeFrameRow());
    column->addWidget(m_target);
    column->addLayout(makeMethodRows());
    column->addLayout(makeRunRow());
    column->addWidget(m_table);
    column->addWidget(m_plot, 1);
    column->addStretch(0); // where the plot is not shown
    m_target->addItem(tr("Silhouettes of the recorded pose"), static_cast<int>(FitTarget::Recorded));
    m_target->addItem(tr("Silhouettes of the mask files"), static_cast<int>(FitTarget::Masks));
    m_target->setToolTip(tr(
        "What the fit is to meet. Against mask files, errors are measured over the joints marked in the test frame."));
    m_target->setFocusPolicy(Qt::NoFocus);
    m_attach->setToolTip(
        tr("A folder of masks, white where the hands are: CAMERA/000012.png, CAMERA_000012.png or the like"));
    m_attach->setFocusPolicy(Qt::NoFocus);
    connect(m_attach, &QPushButton::clicked, this, &FittingPanel::masksRequested);
    m_table->setModel(m_model);
    styleTable(*m_table);
    m_table->setItemDelegateForColumn(ResultTableModel::Method,
                                      new MethodDelegate(ResultTableModel::ValueRole, m_table));
    m_table->setFocusPolicy(Qt::NoFocus);
    m_plot->setSettings({QString(), tr("Iteration"), tr("Error, mm"), 0, 0, 0, 0, true,
                         tr("The error of every iteration appears here."), true});
    connectFits();
    connect(&m_selection, &Selection::frameCountChanged, this, &FittingPanel::showTargets);
    showRunning(false);
    showOutcome();
    showTargets();
}

/// A choice only where there is one.
void FittingPanel::showTargets() {
    m_attach->setVisible(m_fits.needsSilhouettes() && m_selection.frameCount() > 0);
    m_target->setVisible(m_fits.hasMasks());
    m_target->setEnabled(m_fits.hasMotion());
    m_target->setCurrentIndex(m_fits.hasMotion() || !m_fits.hasMasks() ? 0 : 1);
}

QLayout* FittingPanel::makeFrameRow() {
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& text, QSpinBox* box, const QString& tip) {
        auto* label = new QLabel(text, this);
        label->setBuddy(box);
        box->setAlignment(Qt::AlignRight);
        box->setFocusPolicy(Qt::ClickFocus);
        box->setToolTip(tip);
        row->addWidget(label);
        row->addWidget(box, 1);
    };
    add(tr("Start"), m_start,
        tr("Frame whose pose the fit starts from: the recorded one or, without, the hand model of its marks"));
    add(tr("Test"), m_test, tr("Frame whose silhouettes are to be met"));
    auto* here = new QToolButton(this);
    here->setText(tr("Here"));
    here->setToolTip(tr("Test the current frame"));
    here->setFocusPolicy(Qt::NoFocus);
    row->addWidget(here);
    connect(here, &QToolButton::clicked, this,
            [this] { showPair(usualStart(m_selection.frame()), m_selection.frame()); });
    for (QSpinBox* box : {m_start, m_test})
        connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &FittingPanel::takePair);
    connect(&m_selection, &Selection::frameChanged, this, &FittingPanel::followFrame);
    connect(&m_selection, &Selection::frameCountChanged, this, [this](int count) {
        for (QSpinBox* box : {m_start, m_test}) {
            const QSignalBlocker blocker(box);
            box->setRange(0, std::max(0, count - 1));
        }
        m_follows = true;
        followFrame();
    });
    return row;
}

void FittingPanel::showPair(int start, int test) {
    const QSignalBlocker startBlocker(m_start), testBlocker(m_test);
    m_start->setValue(start);
    m_test->setValue(test);
}

/// A person has chosen a pair.
void FittingPanel::takePair() {
    m_follows = false;
    if (m_test->value() != m_start->value())
        m_apart = m_test->value() - m_start->value();
}

/// Its button and that of the empty Inspect workspace do the same then.
void FittingPanel::followFrame() {
    if (m_follows)
        showPair(usualStart(m_selection.frame()), m_selection.frame());
}

/// As far before as the last pair's; at the sequence's end from the other side.
int FittingPanel::usualStart(int test) const {
    const int last = std::max(0, m_selection.frameCount() - 1);
    const int start = std::clamp(test - m_apart, 0, last);
    return start != test ? start : std::clamp(test + m_apart, 0, last);
}

QLayout* FittingPanel::makeMethodRows() {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * kSpacing);
    grid->setVerticalSpacing(2);
    int index = 0;
    for (const std::string& name : core::plainMethodNames()) {
        auto* box = new QCheckBox(QString::fromStdString(name), this);
        box->setIcon(methodChip(name));
        box->setChecked(name == "ch" || name == "dch-thres");
        box->setFocusPolicy(Qt::NoFocus);
        grid->addWidget(box, index / 2, index % 2);
        m_methods.push_back(box);
        ++index;
    }
    return grid;
}

QLayout* FittingPanel::makeRunRow() {
    auto* row = new QHBoxLayout;
    m_run->setFocusPolicy(Qt::NoFocus);
    m_progress->setTextVisible(true);
    row->addWidget(m_run);
    row->addWidget(m_progress, 1);
    connect(m_run, &QPushButton::clicked, this, [this] {
        if (m_fits.isRunning())
            m_fits.stop();
        else
            m_fits.run(request());
    });
    return row;
}

void FittingPanel::connectFits() {
    connect(&m_fits, &FitRunner::started, this, [this] {
        m_message->setMessage({});
        showRunning(true);
    });
    connect(&m_fits, &FitRunner::progressed, this, [this](double fraction, const QString& text) {
        m_progress->setValue(static_cast<int>(fraction * 1000));
        m_progress->setFormat(text + QStringLiteral("  %p %"));
    });
    connect(&m_fits, &FitRunner::finished, this, [this] {
        showRunning(false);
        showOutcome();
    });
    connect(&m_fits, &FitRunner::failed, this, [this](const QString& message) {
        showRunning(false);
        showMessage(message);
    });
    connect(&m_fits, &FitRunner::cleared, this, [this] {
        showRunning(false);
        m_message->setMessage({});
        showOutcome();
        showTargets();
    });
}

void FittingPanel::showMessage(const QString& text) {
    m_message->setMessage(text);
    showTargets();
}

void FittingPanel::showRunning(bool running) {
    m_run->setText(running ? tr("Stop") : tr("Fit"));
    m_progress->setVisible(running);
    m_progress->setRange(0, 1000);
    if (running)
        m_progress->setValue(0);
}

std::vector<std::string> FittingPanel::chosenMethods() const {
    std::vector<std::string> chosen;
    for (const QCheckBox* box : m_methods)
        if (box->isChecked())
            chosen.push_back(box->text().toStdString());
    return chosen;
}

FitRequest FittingPanel::request() const {
    return {m_start->value(), m_test->value(), chosenMethods(),
            static_cast<FitTarget>(m_target->currentData().toInt())};
}

void FittingPanel::fitCurrentFrame() {
    const int apart = m_apart, test = m_selection.frame();
    fit({usualStart(test), test, chosenMethods(), static_cast<FitTarget>(m_target->currentData().toInt())});
    m_apart = apart; // at the sequence's end it may be another one
}

void FittingPanel::fit(const FitRequest& request) {
    showPair(request.start, request.test);
    takePair();
    for (QCheckBox* box : m_methods)
        box->setChecked(std::find(request.methods.begin(), request.methods.end(), box->text().toStdString()) !=
                        request.methods.end());
    m_target->setCurrentIndex(m_target->findData(static_cast<int>(request.target)));
    m_fits.run(request);
}

std::vector<Curve> FittingPanel::curves() const {
    std::vector<Curve> curves;
    if (!m_fits.outcome())
        return curves;
    for (const MethodOutcome& method : m_fits.outcome()->methods) {
        Curve curve;
        curve.name = QString::fromStdString(method.method);
        curve.colour = methodColour(method.method);
        if (!std::isnan(m_fits.outcome()->initialErrorMm))
            curve.points.emplace_back(0.0, m_fits.outcome()->initialErrorMm);
        for (std::size_t i = 0; i < method.iterationErrorMm.size(); ++i)
            if (!std::isnan(method.iterationErrorMm[i]))
                curve.points.emplace_back(static_cast<double>(i + 1), method.iterationErrorMm[i]);
        if (!curve.points.empty())
            curves.push_back(std::move(curve));
    }
    return curves;
}

void FittingPanel::showOutcome() {
    m_model->setOutcome(m_fits.outcome());
    const int rows = m_model->rowCount();
    m_table->setVisible(rows > 0);
    const int height =
        m_table->horizontalHeader()->sizeHint().height() + rows * m_table->verticalHeader()->defaultSectionSize() + 2;
    m_table->setFixedHeight(height);
    m_plot->setCurves(curves());
}

} // namespace widgets
