// SPDX-License-Identifier: MIT
#include "widgets/workspaces/workspaces.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QDataStream>
#include <QScrollArea>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/presenters/inspect/inspect_scene_lines.h"
#include "widgets/views/message_bar.h"

namespace widgets {

namespace {
constexpr const char* kAdjustmentsSetting = "adjustments";

/// A panel that scrolls where there is no room for it: it never makes the window larger than a small screen.
QScrollArea* scrolled(QWidget* panel, QWidget* parent) {
    auto* area = new QScrollArea(parent);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(panel);
    panel->setAutoFillBackground(false);
    area->viewport()->setAutoFillBackground(false);
    return area;
}

} // namespace

Workspaces::Workspaces(WindowSession& session, QWidget* parent)
    : QWidget(parent)
    , m_session(session)
    , m_columns(new QSplitter(Qt::Horizontal, this))
    , m_middle(new QStackedWidget(this))
    , m_right(new QSplitter(Qt::Vertical, this))
    , m_tabs(new QTabWidget(this))
    , m_joints(new JointsPanel(session.joints, session.document, session.reconstructions, session.selection, this))
    , m_grid(new CameraGrid(this))
    , m_scene(new SceneView(this))
    , m_fitting(new FittingPanel(session.selection, session.fits, this))
    , m_pictures(new FramePictures(session.frames, session.opened, *m_grid, this))
    , m_marks(new MarkPresenter(session.joints, session.reconstructions, session.selection, *m_grid, m_scene, this))
    , m_residuals(new ResidualArrows(session.rig, *m_grid, this))
    , m_layers(new LayerPresenter(session.selection, session.fits, *m_grid, m_scene, session.pool, this))
    , m_options(new ViewOptions(*m_grid, session.selection, session.reconstructions, this))
    , m_framing(
          new HandFraming({session.document, session.reconstructions, session.selection, session.opened, session.model},
                          *m_grid, session.pool, this))
    , m_quality(new QualityPanel({session.document, session.selection, session.reconstructions, session.joints,
                                  session.coverage, session.checks, session.raters, session.rig},
                                 this))
    , m_raters(new RatersPanel(session.raters, session.selection, session.reconstructions, session.opened, this))
    , m_review(
          new ReviewPanel({session.review, session.selection, session.firstPass, session.opened, session.joints}, this))
    , m_viewPanel(new ViewPanel(session.selection, session.opened, session.shownCameras, *m_layers, *m_options, this))
    , m_inspect(
          new InspectPage(session.fits, session.opened, session.selection, session.shownCameras, session.pool, this))
    , m_whatIf(new WhatIfPanel(session.fits, *m_inspect->columns(), session.opened, session.pool, this))
    , m_benchmark(new BenchmarkPage(session.benchmarks, session.opened, session.document, session.coverage, this))
    , m_scenePanel(new ScenePanel(m_scene, *m_layers, this))
    , m_masks(session.opened, session.selection, session.pool) {
    build();
    connectGrid();
    connectInspect();
    connectWords();
    connect(m_quality, &QualityPanel::badRmsPxChanged, m_joints, &JointsPanel::setBadRmsPx);
    connect(m_benchmark, &BenchmarkPage::pairOpened, this, &Workspaces::openPair);
    connect(&session, &WindowSession::ready, this, &Workspaces::takeSequence);
    connect(&session.shownCameras, &ShownCameras::changed, this, &Workspaces::showOrder);
    connect(m_pictures, &FramePictures::footageWanted, this, &Workspaces::footageWanted);
    connect(m_pictures, &FramePictures::shown, this, [this](int camera, const ImagePyramid& picture) {
        if (camera == m_grid->current() && !inspects())
            m_scene->setCameraImage(picture.image());
    });
    connect(&session.selection, &Selection::cameraChanged, this, &Workspaces::showCurrentCamera);
    connect(m_options, &ViewOptions::adjustmentsChanged, this,
            [this] { m_session.document.setSetting(kAdjustmentsSetting, m_options->adjustmentsText()); });
    connect(&session.model, &HandModelFit::changed, this, [this] {
        const auto& fit = m_session.model.fit();
        m_layers->setAnnotatedPose(fit ? std::optional(fit->poses) : std::nullopt, fit ? fit->frame : -1);
    });
}

void Workspaces::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_columns);
    m_middle->addWidget(m_grid);
    m_middle->addWidget(scrolled(m_inspect, this));
    m_middle->addWidget(scrolled(m_benchmark, this));
    m_tabs->addTab(scrolled(m_quality, this), tr("Quality"));
    m_tabs->addTab(scrolled(m_review, this), tr("Review"));
    m_tabs->addTab(scrolled(m_fitting, this), tr("Fit"));
    m_tabs->addTab(scrolled(m_whatIf, this), tr("What if"));
    m_tabs->addTab(scrolled(m_viewPanel, this), tr("View"));
    m_tabs->addTab(scrolled(m_raters, this), tr("Raters"));
    m_grid->setEmptyText(tr("All views are hidden: tick one under View, Cameras."));
    m_tabs->setDocumentMode(true);
    m_tabs->setFocusPolicy(Qt::NoFocus);
    m_right->addWidget(m_scenePanel);
    m_right->addWidget(m_tabs);
    m_columns->addWidget(m_joints);
    m_columns->addWidget(m_middle);
    m_columns->addWidget(m_right);
    for (QSplitter* splitter : {m_columns, m_right}) {
        splitter->setHandleWidth(kSpacing / 2);
        splitter->setChildrenCollapsible(false);
    }
    m_tabs->setTabVisible(tabOf(m_whatIf), false);
    m_columns->setStretchFactor(1, 1);
    connect(m_columns, &QSplitter::splitterMoved, this, [this] { m_columnsMoved = true; });
    shareWidth();
    m_right->setStretchFactor(0, 1);
    m_right->setSizes({420, 420});
}

/// The views come first: on a small screen the columns beside them are narrow. Inspect has no column on the left, and
/// its tables stand on the right.
void Workspaces::shareWidth() {
    const int left = std::clamp(width() * 21 / 100, 200, 290);
    const int right =
        m_kind == Kind::Inspect ? std::clamp(width() * 30 / 100, 280, 420) : std::clamp(width() * 25 / 100, 220, 350);
    m_columns->setSizes({left, std::max(0, width() - left - right), right});
}

void Workspaces::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (!m_columnsMoved)
        shareWidth();
}

void Workspaces::connectGrid() {
    connect(m_grid, &CameraGrid::viewAdded, this, &Workspaces::connectView);
    connect(m_grid, &CameraGrid::currentChanged, this, [this](int camera) {
        if (camera >= 0 && m_session.opened.dataset())
            m_session.selection.setCamera(m_grid->view(camera)->camera().name);
    });
    connect(m_scene, &SceneView::jointClicked, &m_session.selection, &Selection::setJoint);
    connect(m_scene, &SceneView::cameraClicked, this, [this](int camera) {
        if (camera >= 0 && camera < m_grid->count())
            m_session.selection.setCamera(m_grid->view(camera)->camera().name);
    });
}

void Workspaces::connectInspect() {
    connect(m_layers, &LayerPresenter::lookChanged, this, &Workspaces::lookInspected);
    connect(m_inspect, &InspectPage::posesShown, this, &Workspaces::showInScene);
    new InspectSceneLines(*m_inspect->overlays(), *m_layers, *m_scene, m_session.pool, this);
    connect(m_inspect, &InspectPage::pictureShown, this, [this](int camera) {
        if (camera == m_grid->current())
            showCurrentCamera();
    });
    connect(m_inspect, &InspectPage::jointChosen, &m_session.selection, &Selection::setJoint);
    connect(m_inspect->columnBar(), &ColumnBar::settingsWanted, this, [this](std::size_t column) {
        m_whatIf->showColumn(column);
        raisePanel(m_whatIf);
    });
    connect(m_inspect, &InspectPage::trialEnded, m_whatIf, &WhatIfPanel::goBack);
    connect(m_inspect, &InspectPage::fitRequested, m_fitting, &FittingPanel::fitCurrentFrame);
    connect(&m_session.selection, &Selection::frameChanged, this, &Workspaces::showInScene);
    connect(&m_session.fits, &FitRunner::failed, this, [this] {
        if (m_kind != Kind::Benchmark)
            m_tabs->setCurrentIndex(tabOf(m_fitting)); // where the reason stands, and what to do
    });
    connect(&m_masks, &MaskAttacher::failed, m_fitting, &FittingPanel::showMessage);
    lookInspected();
}

void Workspaces::connectWords() {
    const auto update = [this] { emit wordsChanged(words()); };
    for (const auto& signal : {&FitRunner::finished, &FitRunner::cleared})
        connect(&m_session.fits, signal, this, update);
    connect(&m_session.benchmarks, &BenchmarkRunner::updated, this, update);
    connect(this, &Workspaces::currentChanged, this, update);
}

WorkWords Workspaces::words() const {
    switch (m_kind) {
    case Kind::Inspect:
        return fitWords(m_session.fits.outcome().get());
    case Kind::Benchmark:
        return benchmarkWords(m_session.benchmarks.results().get());
    case Kind::Annotate:
        break;
    }
    return {};
}

void Workspaces::lookInspected() {
    m_inspect->setLook(m_layers->look(), m_layers->isLayerShown(QLatin1String(LayerPresenter::kStart)),
                       m_layers->isLayerShown(QLatin1String(LayerPresenter::kRecorded)));
}

bool Workspaces::inspects() const {
    return m_kind == Kind::Inspect && m_session.fits.outcome();
}

/// The inspected pair's poses at the iteration that is shown, or those of the current frame. Marks of another frame
/// stay out.
void Workspaces::showInScene() {
    const auto& outcome = m_session.fits.outcome();
    const std::vector<MeshLayer> posed = inspects() ? m_inspect->posedLayers() : std::vector<MeshLayer>{};
    m_layers->setInspected(posed.empty() ? std::nullopt : std::optional(posed));
    m_scene->setJointsShown(!inspects() || outcome->request.test == m_session.selection.frame());
    m_fitting->plot()->setVisible(!inspects()); // Inspect has the same curves, and larger
}

ImagePyramid Workspaces::shownPicture(int camera) const {
    if (camera < 0)
        return {};
    return inspects() ? m_inspect->picture(camera) : m_session.frames.picture(camera);
}

void Workspaces::connectView(int camera, CameraView* view) {
    Annotator& annotator = m_session.annotator;
    const auto name = [view] { return view->camera().name; };
    const auto vector = [](QPointF px) { return Eigen::Vector2d(px.x(), px.y()); };
    connect(view, &CameraView::pointPlaced, &annotator,
            [&annotator, name, vector](QPointF px) { annotator.place(name(), vector(px)); });
    connect(view, &CameraView::pointWithdrawn, &annotator, &Annotator::withdrawPlace);
    connect(
        view, &CameraView::markDragged, &annotator,
        [&annotator, name, vector](const core::JointId& joint, QPointF px) {
            annotator.drag(name(), joint, vector(px));
        });
    connect(view, &CameraView::markDropped, &annotator,
            [&annotator, name, vector](const core::JointId& joint, QPointF px) {
                annotator.drop(name(), joint, vector(px));
            });
    connect(view, &CameraView::markDragCancelled, &annotator, &Annotator::cancelDrag);
    connect(view, &CameraView::markSelected, this, [this, name](const core::JointId& joint) {
        m_session.selection.setCamera(name());
        m_session.selection.setJoint(joint);
    });
    connect(view, &CameraView::viewChanged, m_pictures, &FramePictures::chooseDrafts);
    connect(view, &CameraView::contextMenuRequested, this,
            [this, camera, name](QPointF px, const core::JointId& joint, const QPoint& position) {
                m_session.selection.setCamera(name());
                emit viewMenuRequested(camera, px, joint, position);
            });
}

void Workspaces::takeSequence() {
    const auto& dataset = m_session.opened.dataset();
    m_grid->setCameras(dataset->cameras);
    for (CameraView* view : m_grid->views())
        view->setMessage({});
    m_scene->setCameras(dataset->cameras);
    showOrder();
    m_marks->setDataset(dataset, m_session.opened.sequence());
    m_residuals->refresh();
    m_layers->setSequence(dataset, m_session.opened.motion());
    for (int camera = 0; camera < m_grid->count(); ++camera)
        m_pictures->show(camera, m_session.frames.picture(camera));
    showCurrentCamera();
    m_scene->resetView();
    m_framing->frameHands();
    m_options->setAdjustmentsFromText(m_session.document.setting(kAdjustmentsSetting).value_or(std::string()));
}

void Workspaces::showOrder() {
    const auto& dataset = m_session.opened.dataset();
    if (!dataset || m_grid->count() == 0)
        return;
    std::vector<int> order;
    for (const std::string& camera : m_session.shownCameras.names())
        order.push_back(dataset->cameraIndex(camera));
    m_grid->setOrder(order);
}

void Workspaces::showCurrentCamera() {
    const auto& dataset = m_session.opened.dataset();
    const int camera = dataset ? dataset->cameraIndex(m_session.selection.camera()) : -1;
    if (camera >= m_grid->count())
        return;
    m_grid->setCurrent(camera);
    m_scene->setCurrentCamera(camera);
    const ImagePyramid picture = shownPicture(camera);
    m_scene->setCameraImage(picture.isNull() ? QImage() : picture.image());
}

void Workspaces::setCurrent(Kind kind) {
    if (kind == m_kind)
        return;
    m_kind = kind;
    m_middle->setCurrentIndex(static_cast<int>(kind));
    if (const auto& outcome = m_session.fits.outcome(); outcome && kind == Kind::Inspect)
        m_session.selection.setFrame(outcome->request.test);
    m_joints->setVisible(kind == Kind::Annotate);
    m_right->setVisible(kind != Kind::Benchmark);
    if (!m_columnsMoved)
        shareWidth();
    showTabs();
    m_layers->setInspecting(kind == Kind::Inspect);
    showInScene();
    showCurrentCamera();
    emit currentChanged(kind);
}

/// What belongs to annotating is hidden in the other workspaces; its tab comes back to the front afterwards.
void Workspaces::showTabs() {
    const bool annotates = m_kind == Kind::Annotate;
    if (!annotates && !m_annotationTab)
        m_annotationTab = m_tabs->currentWidget();
    for (QWidget* panel : std::initializer_list<QWidget*>{m_quality, m_review, m_raters})
        m_tabs->setTabVisible(tabOf(panel), annotates);
    m_tabs->setTabVisible(tabOf(m_whatIf), m_kind == Kind::Inspect);
    if (!annotates)
        m_tabs->setCurrentIndex(tabOf(m_fitting));
    else if (QWidget* tab = std::exchange(m_annotationTab, nullptr))
        m_tabs->setCurrentWidget(tab);
}

void Workspaces::openPair(const QString& sequence, const FitRequest& request) {
    const auto fit = [this, request] {
        m_session.selection.setFrame(request.test);
        m_fitting->fit(request);
        setCurrent(Kind::Inspect);
    };
    if (QString::fromStdString(m_session.opened.sequence()->name) == sequence) {
        fit();
        return;
    }
    auto* once = new QObject(this);
    connect(&m_session, &WindowSession::ready, once, [once, fit] {
        once->deleteLater();
        fit();
    });
    connect(&m_session.opened, &DatasetSession::openFailed, once, &QObject::deleteLater);
    m_session.opened.openSequence(sequence, request.test);
}

void Workspaces::raisePanel(QWidget* panel) {
    const bool isOfAnnotating = panel == m_quality || panel == m_review || panel == m_raters;
    if (panel == m_whatIf)
        setCurrent(Kind::Inspect);
    else if (m_kind == Kind::Benchmark || (isOfAnnotating && m_kind != Kind::Annotate))
        setCurrent(Kind::Annotate);
    m_tabs->setCurrentIndex(tabOf(panel));
}

/// The tab in which a panel scrolls.
int Workspaces::tabOf(const QWidget* panel) const {
    int tab = 0;
    while (tab < m_tabs->count() && !m_tabs->widget(tab)->isAncestorOf(panel))
        ++tab;
    return tab;
}

QWidget* Workspaces::part(const QString& name) const {
    const std::map<QString, QWidget*> parts{
        {QStringLiteral("scene"), m_scene},
        {QStringLiteral("joints"), m_joints},
        {QStringLiteral("diagram"), m_joints->diagram()},
        {QStringLiteral("fit"), m_fitting},
        {QStringLiteral("quality"), m_quality},
        {QStringLiteral("review"), m_review},
        {QStringLiteral("raters"), m_raters},
        {QStringLiteral("view"), m_viewPanel},
        {QStringLiteral("whatif"), m_whatIf},
        {QStringLiteral("inspect"), m_inspect},
        {QStringLiteral("benchmark"), m_benchmark},
        {QStringLiteral("curves"), inspects() ? m_inspect->errorPlot() : m_fitting->plot()},
        {QStringLiteral("views"), m_grid}};
    const auto found = parts.find(name);
    return found == parts.end() ? m_grid->view(name) : found->second;
}

QByteArray Workspaces::saveState() const {
    QByteArray state;
    QDataStream stream(&state, QIODevice::WriteOnly);
    stream << m_columns->saveState() << m_right->saveState();
    return state;
}

void Workspaces::restoreState(const QByteArray& state) {
    if (state.isEmpty())
        return;
    QDataStream stream(state);
    QByteArray columns, right;
    stream >> columns >> right;
    m_columnsMoved = m_columns->restoreState(columns);
    m_right->restoreState(right);
}

} // namespace widgets
