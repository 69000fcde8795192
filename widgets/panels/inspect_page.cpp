// SPDX-License-Identifier: MIT
#include "widgets/panels/inspect_page.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr int kMostRows = 4;
constexpr int kViewsHeight = 620; ///< of the views and the plots below them, to begin with
constexpr int kPlotsHeight = 220;

/// The poses after `iteration` steps; the start before the first one.
const core::HandPoses& posesAt(const FitOutcome& outcome, const MethodOutcome& method, int iteration) {
    const auto& history = method.result.history;
    if (iteration <= 0 || history.empty())
        return history.empty() && iteration > 0 ? method.result.poses : outcome.startPoses;
    if (iteration >= static_cast<int>(history.size()))
        return method.result.poses;
    return history[static_cast<std::size_t>(iteration - 1)].poses;
}

double errorAt(const FitOutcome& outcome, const MethodOutcome& method, int iteration) {
    if (iteration <= 0)
        return outcome.initialErrorMm;
    if (iteration > static_cast<int>(method.iterationErrorMm.size()))
        return method.errorMm;
    return method.iterationErrorMm[static_cast<std::size_t>(iteration - 1)];
}

MeshLayer layerOf(const core::Dataset& dataset, const core::HandPoses& poses, const QString& name, const QColor& colour) {
    MeshLayer layer;
    layer.name = name;
    layer.colour = colour;
    for (std::size_t hand = 0; hand < dataset.hands.size() && hand < poses.size(); ++hand)
        layer.surfaces.push_back(makeViewSurface(dataset.hands[hand], poses[hand]));
    return layer;
}

} // namespace

InspectPage::InspectPage(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(workbench), m_job(workbench.pool), m_heading(new QLabel(this)),
      m_slider(new QSlider(Qt::Horizontal, this)), m_iterationText(new QLabel(this)), m_rows(new QSpinBox(this)),
      m_grid(new CameraGrid(this)), m_errors(new CurvePlot(this)), m_costs(new CurvePlot(this)) {
    build();
    connect(&workbench.fits, &FitRunner::finished, this, &InspectPage::takeOutcome);
    connect(&workbench.fits, &FitRunner::cleared, this, &InspectPage::takeOutcome);
    connect(&workbench.frames, &FrameLoader::pictureLoaded, this, &InspectPage::showPicture);
    connect(&workbench.selection, &Selection::cameraChanged, this, &InspectPage::layOutGrid);
    connect(m_slider, &QSlider::valueChanged, this, &InspectPage::showPoses);
    connect(m_rows, qOverload<int>(&QSpinBox::valueChanged), this, &InspectPage::layOutGrid);
    for (CurvePlot* plot : {m_errors, m_costs})
        connect(plot, &CurvePlot::xClicked, this, [this](double x) { setIteration(static_cast<int>(x + 0.5)); });
    connect(m_grid, &CameraGrid::viewAdded, this, [this](int index, CameraView* view) {
        view->setPlacingEnabled(false);
        connect(view, &CameraView::viewChanged, this, [this, index] { syncRow(index); });
    });
    takeOutcome();
}

void InspectPage::build() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kSpacing, kSpacing / 2, kSpacing, kSpacing / 2);
    row->setSpacing(kSpacing);
    m_slider->setFocusPolicy(Qt::NoFocus);
    m_rows->setRange(1, kMostRows);
    m_rows->setValue(2);
    m_rows->setFocusPolicy(Qt::ClickFocus);
    m_rows->setPrefix(tr("Cameras: "));
    m_rows->setToolTip(tr("Rows of cameras, from the current one on"));
    row->addWidget(m_heading);
    row->addWidget(m_slider, 1);
    row->addWidget(m_iterationText);
    row->addWidget(m_rows);
    auto* plots = new QWidget(this);
    auto* plotRow = new QHBoxLayout(plots);
    plotRow->setContentsMargins(0, 0, 0, 0);
    plotRow->setSpacing(kSpacing);
    plotRow->addWidget(m_errors);
    plotRow->addWidget(m_costs);
    const QString empty = tr("Fit a pair of frames: F");
    m_errors->setSettings({QString(), tr("Iteration"), tr("Error, mm"), 0, 0, 0, 0, false, empty});
    m_costs->setSettings({QString(), tr("Iteration"), tr("Cost, mm\u00b2"), 0, 0, 0, 0, true, empty});
    m_grid->setEmptyText(tr("Fit the current frame (F) to see the methods side by side."));
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->addWidget(m_grid);
    splitter->addWidget(plots);
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({kViewsHeight, kPlotsHeight});
    splitter->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(splitter, 1);
}

std::size_t InspectPage::methodCount() const {
    return m_workbench.fits.outcome() ? m_workbench.fits.outcome()->methods.size() : 0;
}

int InspectPage::lastIteration() const {
    int last = 0;
    if (const auto& outcome = m_workbench.fits.outcome()) {
        for (const MethodOutcome& method : outcome->methods)
            last = std::max(last, static_cast<int>(method.result.history.size()));
    }
    return last;
}

int InspectPage::iteration() const {
    return m_slider->value();
}

void InspectPage::setIteration(int iteration) {
    m_slider->setValue(std::clamp(iteration, 0, lastIteration()));
}

void InspectPage::takeOutcome() {
    const auto& outcome = m_workbench.fits.outcome();
    {
        const QSignalBlocker blocker(m_slider);
        m_slider->setRange(0, lastIteration());
        m_slider->setValue(lastIteration());
    }
    m_slider->setEnabled(outcome != nullptr);
    m_heading->setText(outcome ? tr("Frame %1 from frame %2").arg(outcome->request.test).arg(outcome->request.start) : QString());
    showCurves();
    layOutGrid();
}

std::vector<int> InspectPage::rowCameras() const {
    std::vector<int> rows;
    const auto& shown = m_workbench.shownCameras();
    const auto& dataset = m_workbench.session.dataset();
    if (shown.empty() || !dataset)
        return rows;
    const auto current = std::find(shown.begin(), shown.end(), m_workbench.selection.camera());
    const std::size_t first = current == shown.end() ? 0 : static_cast<std::size_t>(current - shown.begin());
    const std::size_t count = std::min(shown.size(), static_cast<std::size_t>(m_rows->value()));
    for (std::size_t i = 0; i < count; ++i)
        rows.push_back(dataset->cameraIndex(shown[(first + i) % shown.size()]));
    return rows;
}

void InspectPage::layOutGrid() {
    m_shownCameras = methodCount() > 0 ? rowCameras() : std::vector<int>{};
    std::vector<core::Camera> cameras;
    for (const int camera : m_shownCameras)
        cameras.insert(cameras.end(), methodCount(), m_workbench.session.dataset()->cameras[static_cast<std::size_t>(camera)]);
    m_grid->setFixedColumns(static_cast<int>(methodCount()));
    m_grid->setCameras(cameras);
    for (std::size_t index = 0; index < cameras.size(); ++index) {
        const auto camera = static_cast<std::size_t>(m_shownCameras[index / methodCount()]);
        CameraView* view = m_grid->view(static_cast<int>(index));
        view->setHome(m_workbench.fits.outcome()->handsPx[camera]);
        std::vector<SkeletonLine> outline;
        for (const QLineF& line : m_workbench.fits.outcome()->outlinesPx[camera])
            outline.push_back({line.p1(), line.p2(), Qt::white});
        view->setSkeleton(outline);
    }
    for (const int camera : m_shownCameras)
        showPicture(camera, m_workbench.frames.picture(camera));
    showPoses();
}

void InspectPage::showPicture(int camera, const ImagePyramid& picture) {
    const auto& outcome = m_workbench.fits.outcome();
    if (!outcome || picture.isNull() || m_workbench.frames.requestedFrame() != outcome->request.test)
        return;
    for (std::size_t row = 0; row < m_shownCameras.size(); ++row) {
        for (std::size_t column = 0; m_shownCameras[row] == camera && column < methodCount(); ++column)
            m_grid->view(static_cast<int>(row * methodCount() + column))->setImage(picture);
    }
}

void InspectPage::showTitles() {
    const auto& outcome = m_workbench.fits.outcome();
    for (std::size_t row = 0; row < m_shownCameras.size(); ++row) {
        const core::Camera& camera = m_workbench.session.dataset()->cameras[static_cast<std::size_t>(m_shownCameras[row])];
        for (std::size_t column = 0; column < methodCount(); ++column) {
            const MethodOutcome& method = outcome->methods[column];
            const double errorMm = errorAt(*outcome, method, iteration());
            const QString error = std::isnan(errorMm) ? QString() : tr("%1 mm").arg(QLocale().toString(errorMm, 'f', 2));
            m_grid->view(static_cast<int>(row * methodCount() + column))
                ->setTitle({QString::fromStdString(method.method), QString::fromStdString(camera.name),
                            method.failure.isEmpty() ? error : tr("failed"), false});
        }
    }
}

void InspectPage::showPoses() {
    const auto& outcome = m_workbench.fits.outcome();
    m_iterationText->setText(outcome ? tr("Iteration %1 of %2").arg(iteration()).arg(lastIteration()) : QString());
    for (CurvePlot* plot : {m_errors, m_costs})
        plot->setCursor(outcome ? iteration() : std::nan(""));
    if (!outcome || !m_workbench.session.dataset()) {
        m_job.stop();
        return;
    }
    showTitles();
    m_job.start([this, outcome, dataset = m_workbench.session.dataset(), iteration = iteration()](const JobContext& context) -> Job::Delivery {
        MeshLayer truth = layerOf(*dataset, outcome->truePoses, tr("recorded"), Qt::white);
        truth.opacity = 0;
        const bool showsTruth = outcome->request.target == FitTarget::Recorded; // else the observed outline is drawn
        std::vector<std::vector<MeshLayer>> columns;
        for (const MethodOutcome& method : outcome->methods) {
            if (context.stop.stop_requested())
                return {};
            MeshLayer layer = layerOf(*dataset, posesAt(*outcome, method, iteration), QString::fromStdString(method.method), methodColour(method.method));
            layer.opacity = 0.5;
            columns.push_back(showsTruth ? std::vector{layer, truth} : std::vector{layer});
        }
        return [this, columns] {
            for (int index = 0; index < m_grid->count(); ++index)
                m_grid->view(index)->setMeshLayers(columns[static_cast<std::size_t>(index) % columns.size()]);
        };
    });
}

void InspectPage::showCurves() {
    std::vector<Curve> errors, costs;
    if (const auto& outcome = m_workbench.fits.outcome()) {
        for (const MethodOutcome& method : outcome->methods) {
            Curve error{QString::fromStdString(method.method), methodColour(method.method), false, false, {}};
            Curve cost = error;
            error.points.emplace_back(0, outcome->initialErrorMm);
            for (std::size_t i = 0; i < method.iterationErrorMm.size(); ++i) {
                error.points.emplace_back(double(i + 1), method.iterationErrorMm[i]);
                cost.points.emplace_back(double(i), method.result.history[i].costMm2);
            }
            errors.push_back(std::move(error));
            costs.push_back(std::move(cost));
        }
    }
    m_errors->setCurves(errors);
    m_costs->setCurves(costs);
}

void InspectPage::syncRow(int index) {
    if (m_syncing || methodCount() == 0)
        return;
    m_syncing = true;
    const CameraView* source = m_grid->view(index);
    const QPointF centre = source->viewportToImage(QRectF(source->viewport()->rect()).center());
    const int columns = static_cast<int>(methodCount());
    for (int other = index / columns * columns; other < (index / columns + 1) * columns && other < m_grid->count(); ++other) {
        if (other == index)
            continue;
        if (source->isFitted())
            m_grid->view(other)->fitImage();
        else
            m_grid->view(other)->lookAt(centre, source->scale());
    }
    m_syncing = false;
}

} // namespace widgets
