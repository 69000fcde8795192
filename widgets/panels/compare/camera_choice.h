// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QCheckBox>
#include <QMenu>
#include <QToolButton>

namespace widgets {

/// A button whose menu chooses cameras, each with a box that can be ticked one after the other.
class CameraChoice : public QToolButton {
    Q_OBJECT

public:
    explicit CameraChoice(QWidget* parent = nullptr);

    void setCameras(const std::vector<std::string>& names);
    /// None: as many as wanted, from the current one on.
    void setChosen(const std::vector<std::string>& names);
    const std::vector<QCheckBox*>& boxes() const { return m_boxes; }

signals:
    void chosen(const std::vector<std::string>& names);

private:
    void collect();
    void showText(const std::vector<std::string>& names);

    QMenu* m_menu;
    std::vector<QCheckBox*> m_boxes;
};

} // namespace widgets
