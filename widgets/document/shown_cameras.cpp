// SPDX-License-Identifier: MIT
#include "widgets/document/shown_cameras.h"

#include <utility>

namespace widgets {

ShownCameras::ShownCameras(QObject* parent)
    : QObject(parent) {}

void ShownCameras::setNames(std::vector<std::string> names) {
    m_names = std::move(names);
    emit changed();
}

} // namespace widgets
