// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/pair_filter.h"

#include <limits>
#include <optional>

#include <gtest/gtest.h>

namespace core {
namespace {

using Pairs = std::vector<std::size_t>;

/// Four pairs of two sequences, by methods whose names hold the signs of filters.
PairTable table() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    PairTable made;
    made.methods = {"ch", "dch-thres:tau=45", "dch-dt3"};
    made.pairs = {{"01", 19, 20}, {"01", 15, 20}, {"02", 5, 20}, {"02", 25, 30}};
    made.startErrorMm = {10, 20, 30, 40};
    made.columns = {{{1, 2, 3, 4}, {10, 10, 10, 10}, {0.5, 0.5, 0.5, 0.5}},
                    {{2, 2, 1, 1}, {5, 6, 7, 8}, {0.1, 0.2, 0.3, 0.4}},
                    {{3, 1, kNone, 2}, {1, 1, kNone, 1}, {1, 1, kNone, 1}}};
    return made;
}

/// The pairs that a text lets pass, A being dch-dt3 and B being ch.
Pairs passing(const std::string& text) {
    const auto filter = parsePairFilter(text, table(), {2, 0});
    if (const auto* problem = std::get_if<PairFilterProblem>(&filter)) {
        ADD_FAILURE() << text << ": " << problem->word;
        return {};
    }
    return filteredPairs(table(), std::get<PairFilter>(filter));
}

TEST(PairFilter, NothingLetsAllPass) {
    EXPECT_EQ(passing(""), (Pairs{0, 1, 2, 3}));
    EXPECT_EQ(passing("   "), (Pairs{0, 1, 2, 3}));
}

TEST(PairFilter, ComparesErrorsOfMethodsAndTheirDifferences) {
    EXPECT_EQ(passing("ch>2"), (Pairs{2, 3}));
    EXPECT_EQ(passing("ch >= 2"), (Pairs{1, 2, 3}));
    EXPECT_EQ(passing("ch=2"), (Pairs{1}));
    EXPECT_EQ(passing("ch!=2"), (Pairs{0, 2, 3}));
    EXPECT_EQ(passing("dch-thres:tau=45<2"), (Pairs{2, 3}));
    EXPECT_EQ(passing("A-B>1"), (Pairs{0})) << "2, -1, none, -2";
    EXPECT_EQ(passing("A - B < -1"), (Pairs{3}));
    EXPECT_EQ(passing("dch-dt3-ch>1"), passing("A-B>1"));
    EXPECT_EQ(passing("ch-dch-thres:tau=45>1,5"), (Pairs{2, 3}));
}

TEST(PairFilter, ComparesWhatElseIsKnownOfAPair) {
    EXPECT_EQ(passing("sequence=02"), (Pairs{2, 3}));
    EXPECT_EQ(passing("seq!=02"), (Pairs{0, 1}));
    EXPECT_EQ(passing("02"), (Pairs{2, 3}));
    EXPECT_EQ(passing("difference>=5"), (Pairs{1, 2, 3}));
    EXPECT_EQ(passing("start<10"), (Pairs{2}));
    EXPECT_EQ(passing("test=30"), (Pairs{3}));
    EXPECT_EQ(passing("initial<=20"), (Pairs{0, 1}));
    EXPECT_EQ(passing("dch-thres:tau=45.seconds>0.25"), (Pairs{2, 3}));
    EXPECT_EQ(passing("dch-thres:tau=45.iterations<6"), (Pairs{0}));
}

TEST(PairFilter, WantsEveryConditionMetAndFailsWhatHasNoValue) {
    EXPECT_EQ(passing("01 difference=5"), (Pairs{1}));
    EXPECT_EQ(passing("dch-dt3>0"), (Pairs{0, 1, 3}));
    EXPECT_EQ(passing("dch-dt3!=99"), (Pairs{0, 1, 3}));
}

TEST(PairFilter, SaysWhichWordMakesNoSense) {
    const auto problem = [](const std::string& text) {
        const auto filter = parsePairFilter(text, table(), {2, 0});
        const auto* found = std::get_if<PairFilterProblem>(&filter);
        return found ? std::optional(*found) : std::nullopt;
    };
    const auto unknown = problem("ch>1 best>2");
    ASSERT_TRUE(unknown);
    EXPECT_EQ(unknown->kind, PairFilterProblem::Kind::UnknownQuantity);
    EXPECT_EQ(unknown->word, "best");
    EXPECT_EQ(problem("ch>far")->kind, PairFilterProblem::Kind::NotANumber);
    EXPECT_EQ(problem("ch>")->kind, PairFilterProblem::Kind::NotANumber);
    EXPECT_EQ(problem("ch")->kind, PairFilterProblem::Kind::NoComparison);
    EXPECT_EQ(problem(">1")->kind, PairFilterProblem::Kind::NoComparison);
    EXPECT_EQ(problem("ch<>1")->kind, PairFilterProblem::Kind::UnknownQuantity);
}

} // namespace
} // namespace core
