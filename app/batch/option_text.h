// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/geometry/camera.h"

namespace app {

/// "1080x1920". Throws Error(Usage) naming the option.
core::ImageSize parseImageSize(const std::string& text, const std::string& option);

} // namespace app
