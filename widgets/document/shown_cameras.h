// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QObject>

namespace widgets {

/// The cameras whose views are shown, by name, in the order of the views.
class ShownCameras : public QObject {
    Q_OBJECT

public:
    explicit ShownCameras(QObject* parent = nullptr);

    void setNames(std::vector<std::string> names);
    const std::vector<std::string>& names() const { return m_names; }

signals:
    void changed();

private:
    std::vector<std::string> m_names;
};

} // namespace widgets
