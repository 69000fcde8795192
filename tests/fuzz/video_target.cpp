// SPDX-License-Identifier: MIT
#include "core/error.h"
#include "core/io/footage/video_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/memory_file.h"

namespace fuzz {

void readVideo(std::string_view bytes) {
    constexpr std::int64_t kMostPixels = 1 << 22; // larger pictures only take longer
    const MemoryFile file(bytes);
    try {
        core::VideoFile video(file.path(), {}, 1);
        if (std::int64_t(video.info().size.width) * video.info().size.height > kMostPixels)
            return;
        video.setBudget(1 << 20);
        const int last = video.info().frames - 1;
        for (const int frame : {last, 0, last / 2, last / 2 + 1, last / 3}) {
            try {
                video.glance(frame);
                video.read(frame);
                video.read(frame, {}, 4);
                video.fetchAhead(-1, {});
                video.survey(0, last, {});
                video.glance(frame, true);
            } catch (const core::Error&) { // this frame is damaged; the others may be whole
            }
        }
    } catch (const core::Error&) {
    }
}

} // namespace fuzz
