// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/io/footage/video_index.h"

namespace core {

/// Looks through a whole video for its pictures. Where the container's time stamps can be relied on, its packets are
/// read and the first pictures decoded; else every picture is decoded once. Throws Error(BadInput) if it is not a
/// readable video.
VideoIndex indexVideo(const std::filesystem::path& file);

} // namespace core
