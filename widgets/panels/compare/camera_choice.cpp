// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/camera_choice.h"

#include <algorithm>

#include <QSignalBlocker>
#include <QWidgetAction>

namespace widgets {

CameraChoice::CameraChoice(QWidget* parent)
    : QToolButton(parent)
    , m_menu(new QMenu(this)) {
    setPopupMode(QToolButton::InstantPopup);
    setMenu(m_menu);
    setFocusPolicy(Qt::NoFocus);
    setToolTip(tr("Which cameras are the rows"));
    showText({});
}

void CameraChoice::setCameras(const std::vector<std::string>& names) {
    if (std::equal(names.begin(), names.end(), m_boxes.begin(), m_boxes.end(),
                   [](const std::string& name, const QCheckBox* box) { return box->text().toStdString() == name; }))
        return;
    m_menu->clear();
    m_boxes.clear();
    for (const std::string& name : names) {
        auto* action = new QWidgetAction(m_menu);
        auto* box = new QCheckBox(QString::fromStdString(name), m_menu);
        box->setContentsMargins(6, 2, 6, 2);
        action->setDefaultWidget(box); // the menu stays open while boxes are ticked
        m_menu->addAction(action);
        m_boxes.push_back(box);
        connect(box, &QCheckBox::toggled, this, &CameraChoice::collect);
    }
    m_menu->addSeparator();
    connect(m_menu->addAction(tr("From the current one on")), &QAction::triggered, this, [this] {
        setChosen({});
        emit chosen({});
    });
}

void CameraChoice::setChosen(const std::vector<std::string>& names) {
    for (QCheckBox* box : m_boxes) {
        const QSignalBlocker blocker(box);
        box->setChecked(std::find(names.begin(), names.end(), box->text().toStdString()) != names.end());
    }
    showText(names);
}

void CameraChoice::collect() {
    std::vector<std::string> names;
    for (const QCheckBox* box : m_boxes)
        if (box->isChecked())
            names.push_back(box->text().toStdString());
    showText(names);
    emit chosen(names);
}

void CameraChoice::showText(const std::vector<std::string>& names) {
    setText(names.empty() ? tr("Choose") : tr("%n chosen", nullptr, static_cast<int>(names.size())));
}

} // namespace widgets
