// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QWidget>

#include "widgets/presenters/layer_presenter.h"
#include "widgets/views/scene/scene_view.h"

namespace widgets {

/// The 3D scene and, where there is a choice, the list of whose pose stands in it.
class ScenePanel : public QWidget {
    Q_OBJECT

public:
    /// Takes the scene in.
    ScenePanel(SceneView* scene, LayerPresenter& layers, QWidget* parent = nullptr);

    /// The next of the list, after the last one the first again.
    void showNext();

private:
    void refresh();

    LayerPresenter& m_layers;
    QComboBox* m_choice;
};

} // namespace widgets
