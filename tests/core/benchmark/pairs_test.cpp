// SPDX-License-Identifier: MIT
#include "core/benchmark/pairs.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/error.h"

namespace core {
namespace {

PairFrames wholeSequence(const std::string& name, int frameCount) {
    PairFrames frames{name, {}};
    for (int i = 0; i < frameCount; ++i)
        frames.frames.push_back(i);
    return frames;
}

TEST(Pairs, AreThePredictedNumberAndStayInTheSequence) {
    const std::vector<PairFrames> sequences = {wholeSequence("01", 231), wholeSequence("03", 155)};
    const std::vector<FramePair> pairs = drawPairs(sequences, {0.1, {1, 5, 10, 15}, 7});
    ASSERT_EQ(pairs.size(), (23u + 16u) * 4u); // 15.5 rounds up
    const std::set<FramePair> unique(pairs.begin(), pairs.end());
    EXPECT_EQ(unique.size(), pairs.size());
    std::set<int> tests;
    for (const FramePair& pair : pairs) {
        EXPECT_GE(pair.start, 0);
        EXPECT_GE(pair.test, 15);
        EXPECT_LT(pair.test, pair.sequence == "01" ? 231 : 155);
        if (pair.sequence == "01")
            tests.insert(pair.test);
    }
    EXPECT_EQ(tests.size(), 23u);
}

TEST(Pairs, DependOnTheSeedButNotOnTheOtherSequences) {
    const PairOptions options{0.1, {1, 5}, 7};
    const std::vector<FramePair> both = drawPairs({wholeSequence("01", 200), wholeSequence("02", 150)}, options);
    const std::vector<FramePair> second = drawPairs({wholeSequence("02", 150)}, options);
    EXPECT_TRUE(std::equal(second.begin(), second.end(), both.begin() + 40, both.end()));
    EXPECT_EQ(both, drawPairs({wholeSequence("01", 200), wholeSequence("02", 150)}, options));
    EXPECT_NE(second, drawPairs({wholeSequence("02", 150)}, {0.1, {1, 5}, 8}));
}

TEST(Pairs, DrawFromTheFramesGiven) {
    const PairFrames annotated{"s", {3, 20, 40, 60, 80, 100}};
    for (const FramePair& pair : drawPairs({annotated}, {0.5, {10}, 1}))
        EXPECT_TRUE(pair.test >= 20 && pair.test <= 100 && pair.test % 20 == 0);
    EXPECT_EQ(drawPairs({annotated}, {1.0, {10}, 1}).size(), 5u); // frame 3 comes before the difference
}

TEST(Pairs, RefuseImpossibleOptions) {
    const std::vector<PairFrames> sequences = {wholeSequence("s", 20)};
    EXPECT_THROW(drawPairs(sequences, {0.0, {1}, 0}), Error);
    EXPECT_THROW(drawPairs(sequences, {1.5, {1}, 0}), Error);
    EXPECT_THROW(drawPairs(sequences, {0.1, {}, 0}), Error);
    EXPECT_THROW(drawPairs(sequences, {0.1, {0}, 0}), Error);
    EXPECT_THROW(drawPairs(sequences, {0.1, {5, 5}, 0}), Error);
}

} // namespace
} // namespace core
