// SPDX-License-Identifier: MIT
#include "core/fitting/stopwatch.h"

#include <thread>

#include <gtest/gtest.h>

namespace {

TEST(Stopwatch, CountsSecondsSinceTheLastRestart) {
    const auto before = std::chrono::steady_clock::now();
    core::Stopwatch watch;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double first = watch.seconds();
    const double second = watch.restart();
    const double after = watch.seconds();
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    EXPECT_GE(first, 0.02);
    EXPECT_GE(second, first);
    EXPECT_LE(second + after, all);
    EXPECT_GE(after, 0);
}

} // namespace
