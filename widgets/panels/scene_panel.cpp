// SPDX-License-Identifier: MIT
#include "widgets/panels/scene_panel.h"

#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/views/method_chip.h"

namespace widgets {

ScenePanel::ScenePanel(SceneView* scene, LayerPresenter& layers, QWidget* parent)
    : QWidget(parent)
    , m_layers(layers)
    , m_choice(new QComboBox(this)) {
    m_choice->setObjectName(QStringLiteral("sceneChoice"));
    m_choice->setFocusPolicy(Qt::NoFocus);
    m_choice->setToolTip(tr("Whose pose stands in the scene"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_choice);
    column->addWidget(scene, 1);
    connect(m_choice, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { m_layers.setSceneChoice(m_choice->itemData(index).toString()); });
    connect(&layers, &LayerPresenter::sceneChoicesChanged, this, &ScenePanel::refresh);
    refresh();
}

void ScenePanel::showNext() {
    const QStringList names = m_layers.sceneChoices();
    if (names.size() > 1)
        m_layers.setSceneChoice(names[(names.indexOf(m_layers.sceneChoice()) + 1) % names.size()]);
}

void ScenePanel::refresh() {
    const QStringList names = m_layers.sceneChoices();
    const QSignalBlocker blocker(m_choice);
    m_choice->clear();
    for (const QString& name : names)
        m_choice->addItem(methodChip(name.toStdString()),
                          name == QLatin1String(LayerPresenter::kRecorded) ? tr("Recorded pose") : name, name);
    m_choice->setCurrentIndex(m_choice->findData(m_layers.sceneChoice()));
    m_choice->setVisible(names.size() > 1);
}

} // namespace widgets
