// SPDX-License-Identifier: MIT
#include "app/batch/frame_range.h"

#include <algorithm>
#include <charconv>

#include "core/error.h"

namespace app {

std::vector<int> framesOfRange(const std::string& range, int frameCount, const std::string& option) {
    const auto fail = [&](const std::string& detail) {
        throw core::Error(core::ErrorCode::Usage, option, "", "\"" + range + "\": " + detail);
    };
    std::vector<int> parts{0, frameCount, 1};
    std::size_t begin = 0;
    for (std::size_t i = 0; begin <= range.size(); ++i) {
        const std::size_t end = std::min(range.find(':', begin), range.size());
        if (i >= parts.size())
            fail("expected A:B:STEP");
        if (end > begin) {
            const auto [stop, error] = std::from_chars(range.data() + begin, range.data() + end, parts[i]);
            if (error != std::errc() || stop != range.data() + end || parts[i] < 0)
                fail("expected A:B:STEP, whole numbers from 0 on");
        }
        begin = end + 1;
    }
    if (parts[2] < 1)
        fail("the step must be at least 1");
    std::vector<int> frames;
    for (long long frame = parts[0]; frame < std::min(parts[1], frameCount); frame += parts[2])
        frames.push_back(static_cast<int>(frame));
    if (frames.empty())
        fail("there is no such frame (the sequence has " + std::to_string(frameCount) + ")");
    return frames;
}

} // namespace app
