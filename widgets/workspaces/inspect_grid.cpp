// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_grid.h"

#include <algorithm>
#include <cmath>

#include <QLocale>
#include <QVBoxLayout>

namespace widgets {

InspectGrid::InspectGrid(InspectColumns& columns, const DatasetSession& datasets, const Selection& selection,
                         const ShownCameras& cameras, JobPool& pool, QWidget* parent)
    : QWidget(parent)
    , m_columns(columns)
    , m_datasets(datasets)
    , m_selection(selection)
    , m_cameras(cameras)
    , m_frames(pool)
    , m_grid(new CameraGrid(this))
    , m_overlays(new InspectOverlays(*m_grid, pool, this))
    , m_wipe(new ColumnWipe(*m_grid, columns, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_grid);
    m_frames.setFetchingAhead(false);
    m_frames.setBudget(std::int64_t(128) << 20);
    connect(&m_frames, &FrameLoader::pictureLoaded, this, &InspectGrid::showPicture);
    connect(&m_frames, &FrameLoader::pictureFailed, this, &InspectGrid::showFailure);
    connect(&selection, &Selection::cameraChanged, this, &InspectGrid::layOut);
    connect(m_grid, &CameraGrid::viewAdded, this, &InspectGrid::connectView);
    connect(m_grid, &CameraGrid::currentChanged, this, [this](int view) {
        if (view >= 0 && m_columns.count() > 0)
            m_columns.setCurrent(columnOf(view));
    });
    connect(m_overlays, &InspectOverlays::shownChanged, this, &InspectGrid::showLayers);
    connect(m_overlays, &InspectOverlays::drawn, this, [this] {
        clearHidden();
        showTitles();
    });
    connect(&columns, &InspectColumns::changed, this, [this] {
        m_posed.reset(); // of the columns before
        layOut();
    });
    connect(
        &columns, &InspectColumns::previewed, this,
        [this] {
            for (int index = 0; index < m_grid->count(); ++index)
                showPictureMessage(index); // a reason of before may be out of date
            showOutlines();
            showTitles();
        });
    connect(&columns, &InspectColumns::currentChanged, this, [this] { m_grid->setCurrent(currentView()); });
    connect(&columns, &InspectColumns::shownChanged, this, [this] {
        showLayers();
        m_overlays->drawAgain();
    });
    layOut();
}

void InspectGrid::connectView(int index, CameraView* view) {
    view->setPlacingEnabled(false);
    connect(
        view, &CameraView::viewChanged, this, [this, index] { syncRow(index); });
    connect(
        view, &CameraView::pointerMoved, this, [this, index](QPointF px) { emit pointerMoved(index, px); });
    connect(
        view, &CameraView::pointClicked, this, [this, index](QPointF px) { emit pointClicked(index, px); });
    connect(view, &CameraView::contextMenuRequested, this,
            [this, index](QPointF, const core::JointId&, QPoint position) { emit menuRequested(index, position); });
    connect(view, &CameraView::pointerLeft, this, &InspectGrid::pointerLeft);
}

std::size_t InspectGrid::columnOf(int view) const {
    return m_columns.count() ? static_cast<std::size_t>(view) % m_columns.count() : 0;
}

int InspectGrid::currentView() const {
    if (m_grid->count() == 0 || m_columns.count() == 0)
        return -1;
    const auto columns = static_cast<int>(m_columns.count());
    const int row = std::max(0, m_grid->current()) / columns;
    return std::min(row * columns + static_cast<int>(m_columns.current()), m_grid->count() - 1);
}

int InspectGrid::cameraOf(int view) const {
    const std::size_t row = m_columns.count() ? static_cast<std::size_t>(view) / m_columns.count() : 0;
    return view >= 0 && row < m_rowCameras.size() ? m_rowCameras[row] : -1;
}

int InspectGrid::viewOf(const std::string& column, int camera) const {
    for (int view = 0; view < m_grid->count(); ++view)
        if (cameraOf(view) == camera && columnId(m_columns.columns()[columnOf(view)]) == column)
            return view;
    return -1;
}

std::optional<InspectGrid::Region> InspectGrid::region(std::size_t row) const {
    const auto view = static_cast<int>(row * m_columns.count());
    if (view >= m_grid->count() || m_grid->view(view)->isFitted())
        return {};
    const CameraView& shown = *m_grid->view(view);
    return Region{shown.viewportToImage(QRectF(shown.viewport()->rect()).center()),
                  shown.viewport()->width() / shown.scale()};
}

void InspectGrid::setRegion(std::size_t row, const std::optional<Region>& region) {
    const auto view = static_cast<int>(row * m_columns.count());
    if (view >= m_grid->count())
        return;
    CameraView& shown = *m_grid->view(view); // the others of the row follow
    if (region && region->widthPx > 0)
        shown.lookAt(region->centrePx, shown.viewport()->width() / region->widthPx);
    else
        shown.fitImage();
}

void InspectGrid::setRows(int rows) {
    if (rows == m_rows)
        return;
    m_rows = rows;
    layOut();
    emit camerasChanged();
}

void InspectGrid::chooseCameras(std::vector<std::string> cameras) {
    if (cameras == m_chosenCameras)
        return;
    m_chosenCameras = std::move(cameras);
    layOut();
    emit camerasChanged();
}

std::vector<int> InspectGrid::wantedCameras() const {
    std::vector<int> rows;
    const auto& dataset = m_datasets.dataset();
    if (!dataset)
        return rows;
    for (const std::string& name : m_chosenCameras)
        if (const int camera = dataset->cameraIndex(name); camera >= 0)
            rows.push_back(camera);
    const auto& shown = m_cameras.names();
    if (!rows.empty() || shown.empty())
        return rows;
    const auto current = std::find(shown.begin(), shown.end(), m_selection.camera());
    const std::size_t first = current == shown.end() ? 0 : static_cast<std::size_t>(current - shown.begin());
    const std::size_t count = std::min(shown.size(), static_cast<std::size_t>(m_rows));
    for (std::size_t i = 0; i < count; ++i)
        rows.push_back(dataset->cameraIndex(shown[(first + i) % shown.size()]));
    return rows;
}

void InspectGrid::layOut() {
    const auto& outcome = m_columns.outcome();
    requestPictures();
    m_rowCameras = outcome ? wantedCameras() : std::vector<int>{};
    std::vector<core::Camera> cameras;
    for (const int camera : m_rowCameras)
        cameras.insert(cameras.end(), m_columns.count(),
                       m_datasets.dataset()->cameras[static_cast<std::size_t>(camera)]);
    m_grid->setFixedColumns(m_columns.count() == 1 ? CameraGrid::kPacked : static_cast<int>(m_columns.count()));
    m_grid->setCameras(cameras);
    for (int index = 0; index < m_grid->count(); ++index) {
        const auto camera = static_cast<std::size_t>(cameraOf(index));
        CameraView* view = m_grid->view(index);
        view->setHome(outcome->handsPx[camera]);
    }
    m_outlines.reset();
    showOutlines();
    for (const int camera : m_rowCameras)
        showPicture(camera, picture(camera));
    m_grid->setCurrent(currentView());
    m_wipe->refresh();
    showTitles();
    if (m_posed)
        showPoses(m_posed, m_iteration);
}

/// The silhouettes that were met, unless they are those of the recorded pose: mask files, or outlines with noise.
void InspectGrid::showOutlines() {
    const auto& outcome = m_columns.outcome();
    if (!outcome)
        return;
    const bool isShown = outcome->request.target == FitTarget::Masks || m_recordedShown;
    const Outlines shown{isShown, m_columns.trial().outlinesPx};
    if (m_outlines == shown)
        return;
    m_outlines = shown;
    for (int index = 0; index < m_grid->count(); ++index) {
        std::vector<SkeletonLine> outline;
        if (isShown)
            for (const QLineF& line : outcome->outlinesPx[static_cast<std::size_t>(cameraOf(index))])
                outline.push_back({line.p1(), line.p2(), Qt::white});
        m_grid->view(index)->setSkeleton(outline);
    }
}

bool InspectGrid::hasNoisyOutlines() const {
    return m_columns.trial().outlinesPx != nullptr;
}

/// Those of the test frame, whatever frame the person has gone to since.
void InspectGrid::requestPictures() {
    const auto& outcome = m_columns.outcome();
    if (!outcome || !m_datasets.sequence())
        return;
    if (m_sequence != m_datasets.sequence()) {
        m_sequence = m_datasets.sequence();
        m_dataset = m_datasets.dataset(); // keeps the sequence alive, so that another one cannot have its address
        m_frames.setSequence(m_datasets.dataset(), m_datasets.sequence(), m_datasets.motion());
    }
    m_frames.request(outcome->request.test);
}

ImagePyramid InspectGrid::picture(int camera) const {
    return m_columns.outcome() && camera >= 0 ? m_frames.picture(camera) : ImagePyramid();
}

/// Without a picture the views are empty: they may have shown another camera's before.
void InspectGrid::showPicture(int camera, const ImagePyramid& picture) {
    for (int index = 0; index < m_grid->count(); ++index) {
        if (cameraOf(index) != camera)
            continue;
        showPictureMessage(index);
        m_grid->view(index)->setImage(picture);
    }
    emit pictureShown(camera);
}

void InspectGrid::showPictureMessage(int index) {
    const bool isLacking = m_frames.lacksPicture(cameraOf(index));
    m_grid->view(index)->setMessage(isLacking ? tr("No picture at this instant.") : QString());
}

void InspectGrid::showFailure(int camera, const QString& message) {
    for (int index = 0; index < m_grid->count(); ++index)
        if (cameraOf(index) == camera)
            m_grid->view(index)->setMessage(message);
}

void InspectGrid::showTitles() {
    const auto& outcome = m_columns.outcome();
    for (int index = 0; outcome && index < m_grid->count(); ++index) {
        const std::size_t column = columnOf(index);
        if (column >= outcome->methods.size())
            return;
        const MethodOutcome& method = outcome->methods[column];
        const double iou = m_overlays->iou(index);
        const QString agreement = std::isnan(iou) ? QString() : tr("IoU %1").arg(QLocale().toString(iou, 'f', 3));
        CameraView* view = m_grid->view(index);
        const QString camera = QString::fromStdString(view->camera().name);
        const bool isLeftOut = m_columns.trial().what.isLeftOut(static_cast<std::size_t>(cameraOf(index)));
        ViewTitle title{m_columns.title(column), isLeftOut ? tr("%1, left out").arg(camera) : camera,
                        method.failure.isEmpty() ? agreement : tr("failed"), false};
        title.colour = m_columns.colour(column);
        title.keepsDetail = true; // the column's head has the method's name, too; nothing else names the camera
        if (!std::isnan(iou))
            title.tip = m_overlays->isWithoutForearm(index)
                            ? tr("IoU: intersection over union of both silhouettes in this view, without the forearm, "
                                 "which the fit leaves out")
                            : tr("IoU: intersection over union of both silhouettes in this view");
        view->setTitle(title);
        if (const QString why = method.failure.isEmpty() ? method.note : method.failure; !why.isEmpty())
            view->setMessage(why);
    }
}

QString InspectGrid::errorText(std::size_t column) const {
    const auto& outcome = m_columns.outcome();
    if (!outcome || column >= outcome->methods.size() || !outcome->methods[column].failure.isEmpty())
        return {};
    const double errorMm = inspectedErrorMm(*outcome, outcome->methods[column], m_iteration);
    return std::isnan(errorMm) ? QString() : tr("%1 mm").arg(QLocale().toString(errorMm, 'f', 2));
}

void InspectGrid::setIteration(int iteration) {
    m_iteration = iteration;
    showTitles();
}

void InspectGrid::showPoses(std::shared_ptr<const InspectedPoses> posed, int iteration) {
    m_posed = std::move(posed);
    m_iteration = iteration;
    if (m_posed)
        m_overlays->show({m_datasets.dataset(), m_columns.outcome(), m_posed, m_rowCameras, iteration});
    else
        m_overlays->show({});
    showLayers();
}

/// Where a column is switched off, nothing lies over the picture.
void InspectGrid::clearHidden() {
    for (int index = 0; index < m_grid->count(); ++index) {
        if (m_columns.isShown(columnOf(index), cameraOf(index)))
            continue;
        m_grid->view(index)->setShapes({});
        m_grid->view(index)->setFieldImage({});
    }
}

void InspectGrid::setLook(const LayerLook& look, bool startShown, bool recordedShown) {
    m_look = look;
    m_startShown = startShown;
    m_recordedShown = recordedShown;
    showOutlines();
    showLayers();
}

void InspectGrid::showLayers() {
    if (!m_posed || m_posed->methods.size() != m_columns.count())
        return;
    InspectedPoses poses = *m_posed;
    if (m_overlays->isShown(InspectLayer::Error))
        poses.methods = poses.methodsByError;
    for (int index = 0; index < m_grid->count(); ++index) {
        const std::size_t column = columnOf(index);
        LayerLook look = m_look;
        if (m_overlays->isShown(InspectLayer::Error) && look.style == MeshStyle::Off)
            look.style = MeshStyle::Shaded; // the layer is the colour of the mesh
        if (!m_columns.isShown(column, cameraOf(index)))
            look.style = MeshStyle::Off;
        m_grid->view(index)->setMeshLayers(
            inspectedColumn(poses, column, look, m_startShown, m_recordedShown && !hasNoisyOutlines()));
    }
}

void InspectGrid::syncRow(int index) {
    if (m_syncing || m_columns.count() == 0)
        return;
    m_syncing = true;
    const CameraView* source = m_grid->view(index);
    const QPointF centre = source->viewportToImage(QRectF(source->viewport()->rect()).center());
    const int columns = static_cast<int>(m_columns.count());
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
