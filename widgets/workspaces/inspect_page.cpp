// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_page.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/presenters/inspect_curves.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr int kMostRows = 4;
constexpr int kViewsHeight = 620; ///< of the views and the plots below them, to begin with
constexpr int kPlotsHeight = 220;

} // namespace

InspectPage::InspectPage(const FitRunner& fits, const DatasetSession& datasets, const Selection& selection,
                         const ShownCameras& cameras, JobPool& pool, QWidget* parent)
    : QWidget(parent)
    , m_fits(fits)
    , m_datasets(datasets)
    , m_selection(selection)
    , m_cameras(cameras)
    , m_frames(pool)
    , m_job(pool)
    , m_pages(new QStackedWidget(this))
    , m_hint(new QLabel(this))
    , m_fit(new QPushButton(tr("Fit this frame"), this))
    , m_heading(new QLabel(this))
    , m_slider(new QSlider(Qt::Horizontal, this))
    , m_iterationText(new QLabel(this))
    , m_rows(new QSpinBox(this))
    , m_grid(new CameraGrid(this))
    , m_overlays(new InspectOverlays(*m_grid, pool, this))
    , m_layerBar(new InspectLayerBar(*m_overlays, this))
    , m_errors(new CurvePlot(this))
    , m_costs(new CurvePlot(this)) {
    build();
    m_frames.setFetchingAhead(false);
    m_frames.setBudget(std::int64_t(128) << 20);
    connect(&fits, &FitRunner::started, this, &InspectPage::showHint);
    connect(&fits, &FitRunner::failed, this, &InspectPage::showHint);
    connect(&fits, &FitRunner::finished, this, &InspectPage::takeOutcome);
    connect(&fits, &FitRunner::cleared, this, &InspectPage::takeOutcome);
    connect(&m_frames, &FrameLoader::pictureLoaded, this, &InspectPage::showPicture);
    connect(&m_frames, &FrameLoader::pictureFailed, this, &InspectPage::showFailure);
    connect(m_fit, &QPushButton::clicked, this, &InspectPage::fitRequested);
    connect(&selection, &Selection::cameraChanged, this, &InspectPage::layOutGrid);
    connect(m_slider, &QSlider::valueChanged, this, &InspectPage::showPoses);
    connect(m_rows, qOverload<int>(&QSpinBox::valueChanged), this, &InspectPage::layOutGrid);
    for (CurvePlot* plot : {m_errors, m_costs})
        connect(
            plot, &CurvePlot::xClicked, this, [this](double x) { setIteration(static_cast<int>(std::lround(x))); });
    connect(m_grid, &CameraGrid::viewAdded, this, [this](int index, CameraView* view) {
        view->setPlacingEnabled(false);
        connect(view, &CameraView::viewChanged, this, [this, index] { syncRow(index); });
        connect(view, &CameraView::pointerMoved, this, [this, index](QPointF px) { showProbe(index, px); });
        connect(view, &CameraView::pointerLeft, m_layerBar, &InspectLayerBar::clearProbe);
    });
    connect(m_overlays, &InspectOverlays::shownChanged, this, &InspectPage::showLayers);
    connect(m_overlays, &InspectOverlays::drawn, this, &InspectPage::showTitles);
    takeOutcome();
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
    m_rows->setRange(1, kMostRows);
    m_rows->setValue(2);
    m_rows->setFocusPolicy(Qt::ClickFocus);
    m_rows->setPrefix(tr("Cameras: "));
    m_rows->setToolTip(tr("Rows of cameras, from the current one on"));
    row->addWidget(m_heading);
    row->addWidget(m_slider, 1);
    row->addWidget(m_iterationText);
    row->addWidget(m_rows);
    return row;
}

QWidget* InspectPage::makeViews() {
    auto* plots = new QWidget(this);
    auto* plotRow = new QHBoxLayout(plots);
    plotRow->setContentsMargins(0, 0, 0, 0);
    plotRow->setSpacing(kSpacing);
    plotRow->addWidget(m_errors);
    plotRow->addWidget(m_costs);
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
    splitter->addWidget(m_grid);
    splitter->addWidget(plots);
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({kViewsHeight, kPlotsHeight});
    splitter->setChildrenCollapsible(false);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(makeIterationRow());
    column->addWidget(m_layerBar);
    column->addWidget(splitter, 1);
    return page;
}

std::size_t InspectPage::methodCount() const {
    return m_fits.outcome() ? m_fits.outcome()->methods.size() : 0;
}

int InspectPage::lastIteration() const {
    int last = 0;
    if (const auto& outcome = m_fits.outcome())
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

void InspectPage::takeOutcome() {
    const auto& outcome = m_fits.outcome();
    {
        const QSignalBlocker blocker(m_slider);
        m_slider->setRange(0, lastIteration());
        m_slider->setValue(lastIteration());
    }
    m_slider->setEnabled(outcome != nullptr);
    m_heading->setText(outcome ? tr("Frame %1 from frame %2").arg(outcome->request.test).arg(outcome->request.start)
                               : QString());
    m_pages->setCurrentIndex(outcome ? 1 : 0);
    m_posed.reset();
    requestPictures();
    showHint();
    showCurves();
    layOutGrid();
}

/// Those of the test frame, whatever frame the person has gone to since.
void InspectPage::requestPictures() {
    const auto& outcome = m_fits.outcome();
    if (!outcome || !m_datasets.sequence())
        return;
    if (m_sequence != m_datasets.sequence()) {
        m_sequence = m_datasets.sequence();
        m_dataset = m_datasets.dataset(); // keeps the sequence alive, so that another one cannot have its address
        m_frames.setSequence(m_datasets.dataset(), m_datasets.sequence(), m_datasets.motion());
    }
    m_frames.request(outcome->request.test);
}

void InspectPage::showHint() {
    const bool running = m_fits.isRunning();
    m_hint->setText(running ? tr("Fitting...") : tr("Fit the current frame to see the methods side by side."));
    m_fit->setEnabled(!running);
}

std::vector<int> InspectPage::rowCameras() const {
    std::vector<int> rows;
    const auto& shown = m_cameras.names();
    const auto& dataset = m_datasets.dataset();
    if (shown.empty() || !dataset)
        return rows;
    const auto current = std::find(shown.begin(), shown.end(), m_selection.camera());
    const std::size_t first = current == shown.end() ? 0 : static_cast<std::size_t>(current - shown.begin());
    const std::size_t count = std::min(shown.size(), static_cast<std::size_t>(m_rows->value()));
    for (std::size_t i = 0; i < count; ++i)
        rows.push_back(dataset->cameraIndex(shown[(first + i) % shown.size()]));
    return rows;
}

void InspectPage::layOutGrid() {
    m_rowCameras = methodCount() > 0 ? rowCameras() : std::vector<int>{};
    std::vector<core::Camera> cameras;
    for (const int camera : m_rowCameras)
        cameras.insert(cameras.end(), methodCount(), m_datasets.dataset()->cameras[static_cast<std::size_t>(camera)]);
    m_grid->setFixedColumns(static_cast<int>(methodCount()));
    m_grid->setCameras(cameras);
    for (std::size_t index = 0; index < cameras.size(); ++index) {
        const auto camera = static_cast<std::size_t>(m_rowCameras[index / methodCount()]);
        CameraView* view = m_grid->view(static_cast<int>(index));
        view->setHome(m_fits.outcome()->handsPx[camera]);
        std::vector<SkeletonLine> outline;
        for (const QLineF& line : m_fits.outcome()->outlinesPx[camera])
            outline.push_back({line.p1(), line.p2(), Qt::white});
        view->setSkeleton(outline);
    }
    for (const int camera : m_rowCameras)
        showPicture(camera, picture(camera));
    showPoses();
}

ImagePyramid InspectPage::picture(int camera) const {
    return m_fits.outcome() && camera >= 0 ? m_frames.picture(camera) : ImagePyramid();
}

/// Without a picture the views are empty: they may have shown another camera's before.
void InspectPage::showPicture(int camera, const ImagePyramid& picture) {
    for (std::size_t row = 0; row < m_rowCameras.size(); ++row) {
        for (std::size_t column = 0; m_rowCameras[row] == camera && column < methodCount(); ++column) {
            CameraView* view = m_grid->view(static_cast<int>(row * methodCount() + column));
            view->setMessage(m_frames.lacksPicture(camera) ? tr("No picture at this instant.") : QString());
            view->setImage(picture);
        }
    }
    emit pictureShown(camera);
}

void InspectPage::showFailure(int camera, const QString& message) {
    for (std::size_t row = 0; row < m_rowCameras.size(); ++row)
        for (std::size_t column = 0; m_rowCameras[row] == camera && column < methodCount(); ++column)
            m_grid->view(static_cast<int>(row * methodCount() + column))->setMessage(message);
}

void InspectPage::showTitles() {
    const auto& outcome = m_fits.outcome();
    for (std::size_t row = 0; row < m_rowCameras.size(); ++row) {
        const core::Camera& camera = m_datasets.dataset()->cameras[static_cast<std::size_t>(m_rowCameras[row])];
        for (std::size_t column = 0; column < methodCount(); ++column) {
            const MethodOutcome& method = outcome->methods[column];
            const double errorMm = inspectedErrorMm(*outcome, method, iteration());
            const int index = static_cast<int>(row * methodCount() + column);
            QString error = std::isnan(errorMm) ? QString() : tr("%1 mm").arg(QLocale().toString(errorMm, 'f', 2));
            if (const double iou = m_overlays->iou(index); !std::isnan(iou))
                error = tr("%1, IoU %2").arg(error, QLocale().toString(iou, 'f', 3));
            ViewTitle title{QString::fromStdString(method.method), QString::fromStdString(camera.name),
                            method.failure.isEmpty() ? error : tr("failed"), false};
            title.colour = methodColour(method.method);
            m_grid->view(index)->setTitle(title);
        }
    }
}

void InspectPage::showPoses() {
    const auto& outcome = m_fits.outcome();
    m_iterationText->setText(outcome ? tr("Iteration %1 of %2").arg(iteration()).arg(lastIteration()) : QString());
    for (CurvePlot* plot : {m_errors, m_costs})
        plot->setCursor(outcome ? iteration() : std::nan(""));
    if (!outcome || !m_datasets.dataset()) {
        m_job.stop();
        m_overlays->show({});
        emit posesShown();
        return;
    }
    showTitles();
    m_job.start([this, outcome, dataset = m_datasets.dataset(),
                 iteration = iteration()](const JobContext& context) -> Job::Delivery {
        auto posed =
            std::make_shared<const InspectedPoses>(inspectedPoses(*dataset, *outcome, iteration, context.stop));
        if (posed->methods.size() < outcome->methods.size())
            return {}; // stopped
        return [this, posed] {
            m_posed = posed;
            m_overlays->show({m_dataset, m_fits.outcome(), m_posed, m_rowCameras, this->iteration()});
            showLayers();
            emit posesShown();
        };
    });
}

ShownMatches InspectPage::matches(const QString& method, int camera) const {
    if (const auto& outcome = m_fits.outcome())
        for (const MethodOutcome& candidate : outcome->methods)
            if (QString::fromStdString(candidate.method) == method)
                return shownMatches(candidate, camera, iteration());
    return {};
}

void InspectPage::showProbe(int view, QPointF px) {
    const auto& outcome = m_fits.outcome();
    const std::size_t row = methodCount() ? static_cast<std::size_t>(view) / methodCount() : 0;
    if (!outcome || row >= m_rowCameras.size())
        return;
    const MethodOutcome& method = outcome->methods[static_cast<std::size_t>(view) % methodCount()];
    m_layerBar->showProbe(method.method, shownMatches(method, m_rowCameras[row], iteration()), px);
}

void InspectPage::setLook(const LayerLook& look, bool startShown, bool recordedShown) {
    m_look = look;
    m_startShown = startShown;
    m_recordedShown = recordedShown;
    showLayers();
}

void InspectPage::showLayers() {
    if (!m_posed)
        return;
    InspectedPoses poses = *m_posed;
    if (m_overlays->isShown(InspectLayer::Error))
        for (MeshLayer& method : poses.methods)
            method = colouredByError(method, poses.recorded);
    for (int index = 0; index < m_grid->count(); ++index)
        m_grid->view(index)->setMeshLayers(inspectedColumn(poses, static_cast<std::size_t>(index) % methodCount(),
                                                           m_look, m_startShown, m_recordedShown));
}

std::vector<MeshLayer> InspectPage::posedLayers() const {
    std::vector<MeshLayer> layers;
    if (m_posed) {
        layers = {m_posed->start, m_posed->recorded};
        layers.insert(layers.end(), m_posed->methods.begin(), m_posed->methods.end());
    }
    return layers;
}

void InspectPage::showCurves() {
    const auto& outcome = m_fits.outcome();
    const InspectCurves curves = outcome ? inspectCurves(*outcome) : InspectCurves();
    m_errors->setCurves(curves.errors);
    m_costs->setCurves(curves.costs);
}

void InspectPage::syncRow(int index) {
    if (m_syncing || methodCount() == 0)
        return;
    m_syncing = true;
    const CameraView* source = m_grid->view(index);
    const QPointF centre = source->viewportToImage(QRectF(source->viewport()->rect()).center());
    const int columns = static_cast<int>(methodCount());
    for (int other = index / columns * columns; other < (index / columns + 1) * columns && other < m_grid->count();
         ++other) {
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
