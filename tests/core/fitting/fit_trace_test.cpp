// SPDX-License-Identifier: MIT
#include "core/fitting/fit_trace.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/distance/circular_distance.h"
#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"
#include "tests/support/fitting_scene.h"

namespace {

using core::FitResult;
using core::IterationMatches;
using core::MatchRecord;
using core::MatchVerdict;

class Trace : public testing::Test {
protected:
    FitResult fit(const std::string& method, bool matches, int threads = 1) const {
        return m_estimator.fit(m_scene.masks, m_scene.start, core::parseMethod(method), {}, {}, threads,
                               {.matches = matches});
    }

    test::FittingScene m_scene{"fit trace"};
    core::PoseEstimator m_estimator{m_scene.hands, m_scene.cameras};
};

int count(const IterationMatches& cameras, bool kept) {
    int total = 0;
    for (const core::CameraMatches& camera : cameras)
        for (const MatchRecord& match : camera.matches)
            total += (match.verdict == MatchVerdict::Kept) == kept;
    return total;
}

template <typename Check>
void forEveryMatch(const FitResult& result, Check&& check) {
    for (const core::FitIteration& iteration : result.history)
        for (std::size_t v = 0; v < iteration.matchRecords->size(); ++v)
            for (const MatchRecord& match : (*iteration.matchRecords)[v].matches)
                check(match, result.trace->targets[v].contour);
}

TEST_F(Trace, RecordingChangesNothing) {
    for (const char* const method : {"ch", "dch-thres", "dch-quant", "dch-quant2", "dch-dt3", "best"}) {
        const FitResult plain = fit(method, false);
        const FitResult recorded = fit(method, true, 2);
        EXPECT_EQ(plain.trace, nullptr);
        EXPECT_EQ(plain.history.front().matchRecords, nullptr);
        ASSERT_EQ(plain.history.size(), recorded.history.size()) << method;
        for (std::size_t h = 0; h < 2; ++h)
            EXPECT_EQ(plain.poses[h], recorded.poses[h]) << method << ": bit by bit";
        for (std::size_t i = 0; i < plain.history.size(); ++i)
            EXPECT_EQ(plain.history[i].costMm2, recorded.history[i].costMm2) << method << " " << i;
    }
}

TEST_F(Trace, HoldsAsManyMatchesAsTheIterationCounted) {
    for (const char* const method : {"ch", "dch-thres", "dch-quant2", "best", "best:both=1"}) {
        const FitResult result = fit(method, true);
        for (const core::FitIteration& iteration : result.history) {
            ASSERT_NE(iteration.matchRecords, nullptr) << method;
            EXPECT_EQ(count(*iteration.matchRecords, true), iteration.matches) << method;
            EXPECT_GE(count(*iteration.matchRecords, false), iteration.rejected) << method;
        }
        EXPECT_GT(count(result.trace->finalMatches, true), 100) << method;
    }
}

TEST_F(Trace, MatchesOfChAreTheNearestContourPoints) {
    int seen = 0;
    forEveryMatch(fit("ch", true), [&](const MatchRecord& match, const core::OrientedContour& contour) {
        if (seen++ % 37 != 0) // every 37th is enough for a search through all contour points
            return;
        float nearest = std::numeric_limits<float>::infinity();
        for (std::size_t q = 0; q < contour.size(); ++q)
            nearest = std::min(nearest, std::hypot(contour.x[q] - match.rimPx.x(), contour.y[q] - match.rimPx.y()));
        EXPECT_NEAR(core::matchGeometry(match, contour).residualPx, nearest, 1e-3f);
        EXPECT_EQ(match.verdict, MatchVerdict::Kept);
    });
    EXPECT_GT(seen, 1000);
}

TEST_F(Trace, DchThresKeepsWhatPassesTheAngleTest) {
    int kept = 0, refused = 0;
    forEveryMatch(fit("dch-thres:tau=15", true), [&](const MatchRecord& match, const core::OrientedContour& contour) {
        const core::MatchGeometry geometry = core::matchGeometry(match, contour);
        const double apart = core::signedCircularDistance(static_cast<double>(match.rimAngleRad),
                                                          static_cast<double>(geometry.contourAngleRad));
        const bool isKept = match.verdict == MatchVerdict::Kept;
        EXPECT_EQ(isKept, apart < 15 * std::numbers::pi / 180);
        EXPECT_EQ(core::matchVerdictName(match.verdict), isKept ? "" : "orientation");
        ++(isKept ? kept : refused);
    });
    EXPECT_GT(kept, 1000);
    EXPECT_GT(refused, 100);
}

TEST(MatchGeometry, IsNotANumberWithoutAContourPoint) {
    MatchRecord match;
    match.rimPx = {3, 4};
    EXPECT_TRUE(std::isnan(core::matchGeometry(match, {}).residualPx));
    core::OrientedContour contour;
    contour.x = {0};
    contour.y = {0};
    contour.angleRad = {0.5f};
    match.contourPoint = 0;
    EXPECT_FLOAT_EQ(core::matchGeometry(match, contour).residualPx, 5);
    EXPECT_FLOAT_EQ(core::matchGeometry(match, contour).contourAngleRad, 0.5f);
}

} // namespace
