// SPDX-License-Identifier: MIT
#include "core/error.h"
#include "core/io/files/content_hash.h"
#include "core/io/footage/frame_times.h"
#include "core/io/footage/video_file.h"
#include "core/io/footage/video_index.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/memory_file.h"

namespace fuzz {

namespace {

template <typename Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// An index file with this content, of that video and with the sum that belongs to it.
std::string indexOf(const core::FileStamp& stamp, std::string_view content) {
    std::string bytes = "handlens-video-index-1\n";
    append(bytes, stamp.size);
    append(bytes, stamp.time);
    bytes += content;
    append(bytes, core::contentHash(bytes.data(), bytes.size()));
    return bytes;
}

} // namespace

void readIndex(std::string_view bytes) {
    static const std::filesystem::path video = std::filesystem::path(HANDLENS_TEST_DATA) / "fuzz/video/h264.mp4";
    const MemoryFile file(indexOf(core::stampOf(video), bytes));
    const std::optional<core::VideoIndex> index = core::readVideoIndex(file.path(), video);
    if (!index)
        return;
    core::analyseTimes(index->timesSec);
    core::VideoFile opened(video, file.path(), 1);
    opened.setBudget(1 << 18);
    const int last = index->pictures() - 1;
    for (const int frame : {last, 0, last / 2, last / 3}) {
        try {
            opened.glance(frame);
            opened.read(frame);
            opened.fetchAhead(-1, {});
        } catch (const core::Error&) { // the index does not fit the video
        }
    }
}

} // namespace fuzz
