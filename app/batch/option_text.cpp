// SPDX-License-Identifier: MIT
#include "app/batch/option_text.h"

#include <cstdio>

#include "core/error.h"

namespace app {

core::ImageSize parseImageSize(const std::string& text, const std::string& option) {
    core::ImageSize size;
    char rest = 0;
    const bool isRead = std::sscanf(text.c_str(), "%6dx%6d%c", &size.width, &size.height, &rest) == 2;
    if (!isRead || size.width < 1 || size.height < 1 || size.width > 100000 || size.height > 100000)
        throw core::Error(core::ErrorCode::Usage, "", option, "width and height are expected, such as 1080x1920");
    return size;
}

} // namespace app
