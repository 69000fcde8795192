// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_page.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/presenters/inspect_curves.h"

namespace widgets {

namespace {

constexpr int kMostRows = 4;
constexpr int kViewsHeight = 620; ///< of the views and the plots below them, to begin with
constexpr int kPlotsHeight = 220;
constexpr int kLeastSlider = 50;

/// Cut off visibly where there is no room for all of it.
class CutLabel : public QLabel {
public:
    using QLabel::QLabel;
    QSize minimumSizeHint() const override { return {1, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text(), Qt::ElideRight, width()));
    }
};

} // namespace

InspectPage::InspectPage(FitRunner& fits, const DatasetSession& datasets, const Selection& selection,
                         const ShownCameras& cameras, JobPool& pool, QWidget* parent)
    : QWidget(parent)
    , m_fits(fits)
    , m_datasets(datasets)
    , m_job(pool)
    , m_columns(new InspectColumns(fits, datasets, pool, this))
    , m_pages(new QStackedWidget(this))
    , m_hint(new QLabel(this))
    , m_fit(new QPushButton(tr("Fit this frame"), this))
    , m_message(new MessageBar(this))
    , m_heading(new QLabel(this))
    , m_trial(new CutLabel(this))
    , m_endTrial(new QToolButton(this))
    , m_slider(new QSlider(Qt::Horizontal, this))
    , m_iterationText(new QLabel(this))
    , m_rows(new QSpinBox(this))
    , m_views(new InspectGrid(*m_columns, datasets, selection, cameras, pool, this))
    , m_columnBar(new ColumnBar(*m_columns, this))
    , m_cameraChoice(new CameraChoice(this))
    , m_layerBar(new InspectLayerBar(*m_views->overlays(), this))
    , m_jointMarks(new InspectJointMarks(*m_columns, *m_views->overlays(), *m_views->grid(), this))
    , m_probePin(new InspectProbePin(*m_columns, *m_views, m_probeTargets, this))
    , m_joints(new InspectJointErrors(*m_columns, *m_jointMarks, this))
    , m_errors(new CurvePlot(this))
    , m_costs(new CurvePlot(this)) {
    build();
    connect(&fits, &FitRunner::started, this, &InspectPage::showHint);
    connect(&fits, &FitRunner::failed, this, &InspectPage::showHint);
    connect(&fits, &FitRunner::finished, this, &InspectPage::showHint);
    connect(&fits, &FitRunner::cleared, this, &InspectPage::showHint);
    connect(m_columns, &InspectColumns::changed, this, &InspectPage::takeColumns);
    connect(m_columns, &InspectColumns::previewed, this, &InspectPage::takePreviews);
    connect(m_columns, &InspectColumns::trialChanged, this, &InspectPage::showTrial);
    connect(m_columns, &InspectColumns::currentChanged, this, &InspectPage::showPhases);
    connect(m_endTrial, &QToolButton::clicked, this, &InspectPage::trialEnded);
    connect(m_fit, &QPushButton::clicked, this, &InspectPage::fitRequested);
    connect(m_slider, &QSlider::valueChanged, this, &InspectPage::showPoses);
    connect(m_rows, qOverload<int>(&QSpinBox::valueChanged), m_views, &InspectGrid::setRows);
    for (CurvePlot* plot : {m_errors, m_costs})
        connect(plot, &CurvePlot::xClicked, this, [this](double x) { setIteration(static_cast<int>(std::lround(x))); });
    connect(overlays(), &InspectOverlays::shownChanged, this, &InspectPage::posesShown); // in other colours
    connect(m_joints, &InspectJointErrors::jointChosen, this, &InspectPage::jointChosen);
    connect(m_columns, &InspectColumns::failed, m_message, &MessageBar::setMessage);
    connect(m_cameraChoice, &CameraChoice::chosen, m_views, &InspectGrid::chooseCameras);
    connect(m_views, &InspectGrid::camerasChanged, this, &InspectPage::showCameras);
    connect(m_views, &InspectGrid::pictureShown, this, &InspectPage::pictureShown);
    connect(m_views, &InspectGrid::pointerMoved, this, &InspectPage::showProbe);
    connect(m_views, &InspectGrid::pointerLeft, this, [this] {
        m_pointed.reset();
        m_layerBar->clearProbe();
    });
    connect(overlays(), &InspectOverlays::drawn, this, &InspectPage::showProbeAgain);
    connect(m_probePin, &InspectProbePin::changed, this, &InspectPage::showPinned);
    takeColumns();
}

void InspectPage::build() {
    m_pages->addWidget(makeEmptyPage());
    m_pages->addWidget(makeViews());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages);
}

QWidget* InspectPage::makeEmptyPage() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setSpacing(2 * kSpacing);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_fit->setFocusPolicy(Qt::NoFocus);
    m_fit->setMinimumSize(180, 36);
    m_fit->setToolTip(tr("With the methods chosen under Fit, from the pose of some frames before"));
    column->addStretch(2);
    column->addWidget(m_hint);
    column->addWidget(m_fit, 0, Qt::AlignHCenter);
    column->addStretch(3);
    return page;
}

QLayout* InspectPage::makeIterationRow() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kSpacing, kSpacing / 2, kSpacing, kSpacing / 2);
    row->setSpacing(kSpacing);
    m_slider->setFocusPolicy(Qt::NoFocus);
    m_slider->setMinimumWidth(kLeastSlider);
    m_rows->setRange(1, kMostRows);
    m_rows->setValue(2);
    m_rows->setFocusPolicy(Qt::ClickFocus);
    m_rows->setPrefix(tr("Cameras: "));
    m_rows->setToolTip(tr("Rows of cameras, from the current one on"));
    m_trial->setForegroundRole(QPalette::Link);
    m_endTrial->setIcon(QIcon::fromTheme(QStringLiteral("edit-undo")));
    m_endTrial->setAutoRaise(true);
    m_endTrial->setFocusPolicy(Qt::NoFocus);
    m_endTrial->setToolTip(tr("All as it was fitted"));
    row->addWidget(m_heading);
    row->addWidget(m_trial);
    row->addWidget(m_endTrial);
    row->addWidget(m_slider, 1);
    row->addWidget(m_iterationText);
    row->addWidget(m_rows);
    row->addWidget(m_cameraChoice);
    row->addWidget(m_columnBar->addButton());
    return row;
}

QWidget* InspectPage::makeViews() {
    auto* plots = new QWidget(this);
    auto* plotRow = new QHBoxLayout(plots);
    plotRow->setContentsMargins(0, 0, 0, 0);
    plotRow->setSpacing(kSpacing);
    plotRow->addWidget(m_errors, 3);
    plotRow->addWidget(m_costs, 3);
    plotRow->addWidget(m_joints, 2);
    plotRow->addWidget(m_probePin->card());
    CurvePlotSettings settings;
    settings.xLabel = tr("Iteration");
    settings.xWhole = true;
    settings.yLogarithmic = true;
    settings.emptyText = tr("There is no reference to measure the error against.");
    settings.yLabel = tr("Error, mm");
    m_errors->setSettings(settings);
    settings.yLabel = tr("Cost, mm\u00b2");
    m_costs->setSettings(settings);
    auto* splitter = new QSplitter(Qt::Vertical, this);
    auto* views = new QWidget(this);
    auto* viewColumn = new QVBoxLayout(views);
    viewColumn->setContentsMargins(0, 0, 0, 0);
    viewColumn->setSpacing(0);
    viewColumn->addWidget(m_columnBar);
    viewColumn->addWidget(m_views, 1);
    splitter->addWidget(views);
    splitter->addWidget(plots);
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({kViewsHeight, kPlotsHeight});
    splitter->setChildrenCollapsible(false);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_message);
    column->addLayout(makeIterationRow());
    column->addWidget(m_layerBar);
    column->addWidget(splitter, 1);
    return page;
}

int InspectPage::lastIteration() const {
    int last = 0;
    if (const auto& outcome = m_columns->outcome())
        for (const MethodOutcome& method : outcome->methods)
            last = std::max(last, static_cast<int>(method.result.history.size()));
    return last;
}

int InspectPage::iteration() const {
    return m_slider->value();
}

void InspectPage::setIteration(int iteration) {
    m_slider->setValue(std::clamp(iteration, 0, lastIteration()));
}

/// Of the same pair, the iteration stays that is looked at.
void InspectPage::takeColumns() {
    const auto& outcome = m_columns->outcome();
    const bool isKept = m_shown && outcome && isSamePair(*m_shown, *outcome);
    showRange(isKept);
    if (!isKept) {
        m_probeTargets.clear();
        m_posedBefore.reset();
        m_pointed.reset();
    }
    m_shown = outcome;
    m_slider->setEnabled(outcome != nullptr);
    m_pages->setCurrentIndex(outcome ? 1 : 0);
    m_posed.reset();
    if (const auto& dataset = m_datasets.dataset()) {
        std::vector<std::string> cameras;
        for (const core::Camera& camera : dataset->cameras)
            cameras.push_back(camera.name);
        m_cameraChoice->setCameras(cameras);
        showCameras();
    }
    showHint();
    showTrial();
    showCurves();
    showPoses();
    showLegend();
}

/// The pair and its columns are the same: nothing but poses, titles and curves is another.
void InspectPage::takePreviews() {
    showRange(true);
    m_shown = m_columns->outcome();
    showTrial();
    showPoses();
    showCurves();
    showLegend();
}

QString InspectPage::trialText() const {
    const auto& dataset = m_datasets.dataset();
    const QString text = dataset ? widgets::trialText(m_columns->trial(), dataset->cameras) : QString();
    return text.isEmpty() ? text : tr("What if: %1").arg(text);
}

/// The heads of the columns name the settings.
void InspectPage::showTrial() {
    const QString all = trialText();
    ColumnTrial trial = m_columns->trial();
    trial.methods.clear();
    const auto& dataset = m_datasets.dataset();
    const QString text = dataset ? widgets::trialText(trial, dataset->cameras) : QString();
    m_trial->setText(tr("What if: %1").arg(text.isEmpty() ? tr("other settings") : text));
    m_trial->setToolTip(all);
    m_trial->setVisible(!all.isEmpty());
    m_endTrial->setVisible(!all.isEmpty());
    for (CurvePlot* plot : {m_errors, m_costs}) { // which leave the window alone, too
        CurvePlotSettings settings = plot->settings();
        settings.xLabel = text.isEmpty() ? tr("Iteration") : tr("Iteration; %1").arg(text);
        plot->setSettings(settings);
    }
}

/// As many iterations as the longest method made; the last one stays the last one.
void InspectPage::showRange(bool isSamePair) {
    const QSignalBlocker blocker(m_slider);
    const bool wasAtEnd = m_slider->value() == m_slider->maximum();
    m_slider->setRange(0, lastIteration());
    if (!isSamePair || wasAtEnd)
        m_slider->setValue(lastIteration());
}

void InspectPage::showCameras() {
    m_cameraChoice->setChosen(m_views->chosenCameras());
    m_rows->setVisible(m_views->chosenCameras().empty());
}

void InspectPage::showHint() {
    const bool running = m_fits.isRunning();
    m_hint->setText(running ? tr("Fitting...") : tr("Fit the current frame to see the methods side by side."));
    m_fit->setEnabled(!running);
    const auto& pending = m_fits.pending();
    m_heading->setText(
        pending && m_shown
            ? tr("%1 (frame %2 from frame %3 is being fitted)").arg(heading()).arg(pending->test).arg(pending->start)
            : heading());
}

QString InspectPage::heading() const {
    return m_shown ? tr("Frame %1 from frame %2").arg(m_shown->request.test).arg(m_shown->request.start) : QString();
}

void InspectPage::showPoses() {
    const auto& outcome = m_columns->outcome();
    m_iterationText->setText(outcome ? tr("Iteration %1 of %2").arg(iteration()).arg(lastIteration()) : QString());
    for (CurvePlot* plot : {m_errors, m_costs})
        plot->setCursor(outcome ? iteration() : std::nan(""));
    if (!outcome || !m_datasets.dataset()) {
        m_job.stop();
        m_views->showPoses(nullptr, 0);
        emit posesShown();
        return;
    }
    m_views->setIteration(iteration());
    showErrors();
    m_joints->showIteration(m_datasets.dataset(), iteration());
    m_job.start([this, outcome, dataset = m_datasets.dataset(), iteration = iteration(),
                 before = m_posedBefore](const JobContext& context) -> Job::Delivery {
        auto posed = std::make_shared<const InspectedPoses>(
            inspectedPoses(*dataset, *outcome, iteration, context.stop, before.get()));
        if (posed->methods.size() < outcome->methods.size())
            return {}; // stopped
        return [this, posed] {
            m_posed = m_posedBefore = posed;
            m_views->showPoses(posed, this->iteration());
            emit posesShown();
        };
    });
}

void InspectPage::showProbe(int view, QPointF px) {
    const auto& outcome = m_columns->outcome();
    const int camera = m_views->cameraOf(view);
    if (!outcome || camera < 0)
        return;
    m_pointed = {view, px};
    const MethodOutcome& method = outcome->methods[m_views->columnOf(view)];
    m_layerBar->showProbe(inspectProbe(method, shownMatches(method, camera, iteration()), px,
                                       m_datasets.dataset()->hands, m_probeTargets));
}

/// Of other matches, at the place where the pointer still is.
void InspectPage::showProbeAgain() {
    if (m_pointed)
        showProbe(m_pointed->first, m_pointed->second);
}

void InspectPage::showErrors() {
    QStringList errors;
    for (std::size_t column = 0; column < m_columns->count(); ++column)
        errors << m_views->errorText(column);
    m_columnBar->setErrors(errors);
}

/// The card takes the room of the joints: it covers nothing of what it explains.
void InspectPage::showPinned() {
    m_joints->setVisible(!m_probePin->card()->isVisibleTo(this));
}

void InspectPage::setLook(const LayerLook& look, bool startShown, bool recordedShown) {
    m_views->setLook(look, startShown, recordedShown);
    m_recordedShown = recordedShown;
    showLegend();
}

/// The observed silhouette is the recorded pose's, which can be hidden, or what the mask files show.
void InspectPage::showLegend() {
    const auto& outcome = m_columns->outcome();
    m_layerBar->setSilhouetteShown(
        outcome && (outcome->request.target == FitTarget::Masks || (m_recordedShown && !outcome->truePoses.empty())),
        m_columns->trial().outlinesPx != nullptr);
}

std::vector<MeshLayer> InspectPage::posedLayers() const {
    std::vector<MeshLayer> layers;
    const auto& outcome = m_columns->outcome();
    if (m_posed && outcome) {
        const auto& methods = overlays()->isShown(InspectLayer::Error) ? m_posed->methodsByError : m_posed->methods;
        layers = {m_posed->start, m_posed->recorded};
        for (std::size_t column = 0; column < methods.size() && column < outcome->methods.size(); ++column)
            if (m_columns->columns()[column].kind == InspectColumn::Kind::Method)
                layers.push_back(methods[column]);
    }
    return layers;
}

void InspectPage::showCurves() {
    const auto& outcome = m_columns->outcome();
    const InspectCurves curves = outcome ? inspectCurves(*outcome) : InspectCurves();
    m_errors->setCurves(curves.errors);
    m_costs->setCurves(curves.costs);
    showPhases();
}

void InspectPage::showPhases() {
    const auto& outcome = m_columns->outcome();
    const std::size_t column = m_columns->current();
    const bool isThere = outcome && column < outcome->methods.size();
    for (CurvePlot* plot : {m_errors, m_costs})
        plot->setMarks(isThere ? phaseMarks(outcome->methods[column]) : std::vector<PlotMark>{});
}

} // namespace widgets
