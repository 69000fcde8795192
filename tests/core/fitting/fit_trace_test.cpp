// SPDX-License-Identifier: MIT
#include "core/fitting/fit_trace.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/distance/circular_distance.h"
#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"
#include "core/fitting/rim_matches.h"
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

/// Of the vertex that a camera sees nearest to a pixel: the bone with the most weight. -1 if none is within 3 px.
int boneOfNearestVertex(const test::FittingScene& scene, const core::HandPoses& poses, const core::Camera& camera,
                        const MatchRecord& match) {
    const core::HandModel& hand = scene.hands[match.hand];
    const std::vector<Eigen::Vector3d> vertices = core::posedVertices(hand, poses[match.hand]);
    double nearest = 3;
    int bone = -1;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const auto px = core::project(camera, vertices[v]);
        const double distance = px ? (px->cast<float>() - match.rimPx).norm() : nearest;
        if (distance >= nearest)
            continue;
        nearest = distance;
        const auto from = hand.weights.entries.begin() + hand.weights.firstEntry[v];
        const auto to = hand.weights.entries.begin() + hand.weights.firstEntry[v + 1];
        bone = std::max_element(from, to, [](const auto& a, const auto& b) { return a.weight < b.weight; })->bone;
    }
    return bone;
}

TEST_F(Trace, ARimPointKnowsTheBoneThatMovesIt) {
    const FitResult result = fit("ch", true);
    int same = 0, other = 0;
    std::set<int> bones;
    for (std::size_t v = 0; v < result.trace->finalMatches.size(); ++v) {
        const core::CameraMatches& camera = result.trace->finalMatches[v];
        for (std::size_t i = 0; i < camera.matches.size(); i += 5) {
            const MatchRecord& match = camera.matches[i];
            const int expected = boneOfNearestVertex(m_scene, result.poses,
                                                     m_scene.cameras[static_cast<std::size_t>(camera.camera)], match);
            if (expected < 0)
                continue;
            ++(expected == match.bone ? same : other);
            bones.insert(match.bone);
        }
    }
    EXPECT_GT(same, 100);
    EXPECT_LT(other, 0.1 * same) << "but for points between two bones";
    EXPECT_EQ(bones.size(), m_scene.hands.front().skeleton.bones.size()) << "all are seen";
}

TEST_F(Trace, SaysWhichPartOfThePictureWasLeftOutAsAForearm) {
    for (const char* const method : {"dch-thres", "best"}) {
        const FitResult clean = fit(method, true);
        EXPECT_FALSE(clean.trace->forearms[0] || clean.trace->forearms[1]) << method;
        for (const core::CameraMatches& camera : clean.trace->finalMatches)
            EXPECT_TRUE(camera.leftOut.empty()) << method;
    }
    const std::vector<cv::Mat> hands = m_scene.seen(m_scene.truth);
    test::drawForearms(m_scene, m_scene.masks);
    for (const char* const method : {"dch-thres", "best"}) {
        const FitResult cut = fit(method, true);
        EXPECT_TRUE(cut.trace->forearms[0] && cut.trace->forearms[1]) << method;
        EXPECT_FALSE(cut.history.front().matchRecords->front().leftOut.empty()) << method;
        int arm = 0, outside = 0;
        for (const core::CameraMatches& camera : cut.trace->finalMatches) {
            const auto c = static_cast<std::size_t>(camera.camera);
            for (int y = 0; y < hands[c].rows; ++y)
                for (int x = 0; x < hands[c].cols; ++x)
                    if (m_scene.masks[c].at<unsigned char>(y, x) && !hands[c].at<unsigned char>(y, x)) {
                        ++arm;
                        outside +=
                            core::isInside(camera.leftOut, {static_cast<float>(x), static_cast<float>(y)}) ? 0 : 1;
                    }
            for (const MatchRecord& match : camera.matches)
                EXPECT_TRUE(match.verdict != MatchVerdict::Kept || !core::isInside(camera.leftOut, match.rimPx));
        }
        EXPECT_GT(arm, 1000);
        EXPECT_LT(outside, 0.03 * arm) << method;
        const FitResult ignored = fit(std::string(method) + ":forearm=ignore", true);
        for (const core::CameraMatches& camera : ignored.trace->finalMatches)
            EXPECT_TRUE(camera.leftOut.empty()) << method;
    }
}

TEST_F(Trace, AnIterationSaysWhatMoved) {
    const FitResult result = fit("dch-thres", true), paper = fit("dch-thres:schedule=paper", true);
    EXPECT_TRUE(result.history.front().rigidOnly);
    EXPECT_EQ(result.history.front().level, 0);
    EXPECT_FALSE(result.history.back().rigidOnly);
    EXPECT_EQ(result.history.back().level, 2);
    EXPECT_FALSE(paper.history.front().rigidOnly);
    EXPECT_EQ(paper.history.front().level, 2);
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
