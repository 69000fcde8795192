// SPDX-License-Identifier: MIT
#include "widgets/panels/view_panel.h"

#include <algorithm>
#include <cmath>

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/panels/mark_legend.h"
#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {

constexpr double kPercent = 100;
constexpr double kOctave = 50; ///< slider steps for a doubling of contrast or gamma

int octaves(double factor) {
    return static_cast<int>(std::lround(std::log2(factor) * kOctave));
}

double factor(int steps) {
    return std::exp2(steps / kOctave);
}

} // namespace

ViewPanel::ViewPanel(const Selection& selection, const DatasetSession& datasets, ShownCameras& cameras,
                     LayerPresenter& layers, ViewOptions& options, QWidget* parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_datasets(datasets)
    , m_shownCameras(cameras)
    , m_layers(layers)
    , m_options(options) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
    column->setSpacing(kSpacing);
    column->addWidget(makeMeshGroup());
    column->addWidget(makeImageGroup());
    column->addWidget(makeCameraGroup(), 1);
    column->addWidget(new MarkLegend(this));
    connect(&layers, &LayerPresenter::lookChanged, this, &ViewPanel::showLook);
    connect(&selection, &Selection::cameraChanged, this, &ViewPanel::showAdjustment);
    connect(&options, &ViewOptions::adjustmentsLoaded, this, &ViewPanel::showAdjustment);
    connect(&cameras, &ShownCameras::changed, this, &ViewPanel::showCameras);
    showLook();
    showAdjustment();
}

QSlider* ViewPanel::addSlider(QFormLayout& form, const QString& text, int low, int high) {
    auto* slider = new QSlider(Qt::Horizontal, this);
    slider->setRange(low, high);
    slider->setFocusPolicy(Qt::NoFocus);
    form.addRow(text, slider);
    return slider;
}

QWidget* ViewPanel::makeMeshGroup() {
    auto* group = new QGroupBox(tr("Mesh"), this);
    auto* form = new QFormLayout(group);
    m_style = new QComboBox(this);
    m_style->addItems({tr("Off"), tr("Shaded"), tr("Wireframe")});
    m_style->setFocusPolicy(Qt::NoFocus);
    form->addRow(tr("Style"), m_style);
    m_opacity = addSlider(*form, tr("Opacity"), 5, 100);
    connect(m_style, qOverload<int>(&QComboBox::currentIndexChanged), this, &ViewPanel::changeLook);
    connect(m_opacity, &QSlider::valueChanged, this, &ViewPanel::changeLook);
    return group;
}

QWidget* ViewPanel::makeImageGroup() {
    auto* group = new QGroupBox(tr("Image"), this);
    auto* form = new QFormLayout(group);
    m_brightness = addSlider(*form, tr("Brightness"), -100, 100);
    m_contrast = addSlider(*form, tr("Contrast"), -100, 100);
    m_gamma = addSlider(*form, tr("Gamma"), -100, 100);
    m_allViews = new QCheckBox(tr("All views"), this);
    m_allViews->setChecked(true);
    m_allViews->setFocusPolicy(Qt::NoFocus);
    auto* reset = new QPushButton(tr("Reset"), this);
    reset->setFocusPolicy(Qt::NoFocus);
    auto* row = new QHBoxLayout;
    row->addWidget(m_allViews, 1);
    row->addWidget(reset);
    form->addRow(row);
    for (QSlider* slider : {m_brightness, m_contrast, m_gamma})
        connect(slider, &QSlider::valueChanged, this, &ViewPanel::changeAdjustment);
    connect(reset, &QPushButton::clicked, this, [this] {
        m_options.setAdjustment(m_allViews->isChecked() ? std::string() : m_selection.camera(), {});
        showAdjustment();
    });
    return group;
}

QWidget* ViewPanel::makeCameraGroup() {
    auto* group = new QGroupBox(tr("Cameras"), this);
    auto* column = new QVBoxLayout(group);
    m_cameras = new QListWidget(this);
    m_cameras->setDragDropMode(QAbstractItemView::InternalMove);
    m_cameras->setFocusPolicy(Qt::ClickFocus);
    m_cameras->setToolTip(tr("Untick to hide a view; drag to change the order"));
    m_cameras->setFrameShape(QFrame::NoFrame);
    column->addWidget(m_cameras);
    connect(m_cameras, &QListWidget::itemChanged, this, &ViewPanel::changeCameras);
    connect(m_cameras->model(), &QAbstractItemModel::rowsMoved, this, &ViewPanel::changeCameras);
    return group;
}

void ViewPanel::askForCameras() {
    m_cameras->setFocus(Qt::ShortcutFocusReason);
    if (m_cameras->currentRow() < 0)
        m_cameras->setCurrentRow(0);
}

void ViewPanel::showLook() {
    m_showing = true;
    m_style->setCurrentIndex(static_cast<int>(m_layers.look().style));
    m_opacity->setValue(static_cast<int>(std::lround(m_layers.look().opacity * kPercent)));
    m_showing = false;
}

void ViewPanel::changeLook() {
    if (m_showing)
        return;
    LayerLook look = m_layers.look();
    look.style = static_cast<MeshStyle>(m_style->currentIndex());
    look.opacity = m_opacity->value() / kPercent;
    m_layers.setLook(look);
}

void ViewPanel::showAdjustment() {
    m_showing = true;
    const ImageAdjustment adjustment = m_options.adjustment(m_selection.camera());
    m_brightness->setValue(static_cast<int>(std::lround(adjustment.brightness * kPercent)));
    m_contrast->setValue(octaves(adjustment.contrast));
    m_gamma->setValue(octaves(adjustment.gamma));
    m_showing = false;
}

void ViewPanel::changeAdjustment() {
    if (m_showing)
        return;
    const ImageAdjustment adjustment{m_brightness->value() / kPercent, factor(m_contrast->value()),
                                     factor(m_gamma->value())};
    m_options.setAdjustment(m_allViews->isChecked() ? std::string() : m_selection.camera(), adjustment);
}

void ViewPanel::showCameras() {
    const auto& dataset = m_datasets.dataset();
    if (!dataset || m_showing)
        return;
    m_showing = true;
    m_cameras->clear();
    std::vector<std::string> names = m_shownCameras.names();
    const std::size_t shown = names.size();
    for (const core::Camera& camera : dataset->cameras)
        if (std::find(names.begin(), names.end(), camera.name) == names.end())
            names.push_back(camera.name);
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto* item = new QListWidgetItem(QString::fromStdString(names[i]), m_cameras);
        item->setFlags((item->flags() | Qt::ItemIsUserCheckable) & ~Qt::ItemIsDropEnabled);
        item->setCheckState(i < shown ? Qt::Checked : Qt::Unchecked);
    }
    m_showing = false;
}

void ViewPanel::changeCameras() {
    if (m_showing)
        return;
    std::vector<std::string> shown;
    for (int row = 0; row < m_cameras->count(); ++row)
        if (m_cameras->item(row)->checkState() == Qt::Checked)
            shown.push_back(m_cameras->item(row)->text().toStdString());
    m_showing = true; // the list is right as it is
    m_shownCameras.setNames(shown);
    m_showing = false;
}

} // namespace widgets
