// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <opencv2/core/utility.hpp>

namespace core {

/// Calls work(i) for every i below `count`, such as the views of a frame, on OpenCV's threads; what its own loops nest
/// runs on one thread, so that results do not depend on how many there are. One of the exceptions that `work` throws
/// reaches the caller.
template <typename Work>
void forEachSideBySide(std::size_t count, const Work& work) {
    const int all = static_cast<int>(count);
    cv::parallel_for_(
        cv::Range(0, all),
        [&](const cv::Range& range) {
            for (int i = range.start; i < range.end; ++i)
                work(static_cast<std::size_t>(i));
        },
        all);
}

} // namespace core
