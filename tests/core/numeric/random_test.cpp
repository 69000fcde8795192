// SPDX-License-Identifier: MIT
#include "core/numeric/random.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace core {
namespace {

TEST(RandomGenerator, GivesThePublishedNumbers) {
    RandomGenerator random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317ull);
    EXPECT_EQ(random.next(), 3203168211198807973ull);
    EXPECT_EQ(random.next(), 9817491932198370423ull);
}

TEST(RandomGenerator, DrawsEverySubsetAboutEquallyOften) {
    RandomGenerator random(5);
    std::map<std::set<int>, int> counts;
    for (int i = 0; i < 10000; ++i) {
        const std::vector<int> sample = sampleWithoutReplacement(5, 2, random);
        counts[{sample.begin(), sample.end()}]++;
    }
    ASSERT_EQ(counts.size(), 10u);
    for (const auto& [subset, count] : counts)
        EXPECT_NEAR(count, 1000, 150);
}

} // namespace
} // namespace core
