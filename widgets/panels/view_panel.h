// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QSlider>
#include <QWidget>

#include "widgets/document/selection.h"
#include "widgets/document/shown_cameras.h"
#include "widgets/presenters/layer_presenter.h"
#include "widgets/presenters/view_options.h"
#include "widgets/session/dataset_session.h"

class QFormLayout;

namespace widgets {

/// How the views look: mesh, brightness, contrast and gamma of one view or all, which cameras are shown and in which
/// order.
class ViewPanel : public QWidget {
    Q_OBJECT

public:
    ViewPanel(const Selection& selection, const DatasetSession& datasets, ShownCameras& cameras, LayerPresenter& layers,
              ViewOptions& options, QWidget* parent = nullptr);

    /// The keyboard goes to the list of cameras.
    void askForCameras();

private:
    QWidget* makeMeshGroup();
    QWidget* makeImageGroup();
    QWidget* makeCameraGroup();
    QSlider* addSlider(QFormLayout& form, const QString& text, int low, int high);
    void showLook();
    void changeLook();
    void showAdjustment();
    void changeAdjustment();
    void showCameras();
    void changeCameras();

    const Selection& m_selection;
    const DatasetSession& m_datasets;
    ShownCameras& m_shownCameras;
    LayerPresenter& m_layers;
    ViewOptions& m_options;
    QComboBox* m_style = nullptr;
    QSlider* m_opacity = nullptr;
    QSlider* m_brightness = nullptr;
    QSlider* m_contrast = nullptr;
    QSlider* m_gamma = nullptr;
    QCheckBox* m_allViews = nullptr;
    QListWidget* m_cameras = nullptr;
    bool m_showing = false;
};

} // namespace widgets
