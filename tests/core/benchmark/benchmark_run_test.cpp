// SPDX-License-Identifier: MIT
#include "core/benchmark/benchmark_run.h"

#include <atomic>
#include <set>

#include <gtest/gtest.h>

#include "core/contour/rasteriser.h"
#include "core/fitting/method_name.h"
#include "tests/core/benchmark/tiny_benchmark.h"

namespace core {
namespace {

using test::pretendToFit;
using test::tinyPairs;
using test::tinyScene;

BenchmarkOptions twoMethods() {
    BenchmarkOptions options;
    options.methods = {"ch:iterations=6", "dch-thres:tau=45:iterations=2"};
    return options;
}

TEST(BenchmarkRun, MeasuresEveryMethodOnEveryPairInOrder) {
    const BenchmarkScene scene = tinyScene();
    const std::vector<FramePair> pairs = tinyPairs(scene);
    const BenchmarkResults results = runBenchmark(scene, pairs, twoMethods(), pretendToFit);
    ASSERT_EQ(results.rows.size(), 2 * pairs.size());
    ASSERT_EQ(results.joints.size(), 4u);
    EXPECT_FALSE(results.stopped);
    for (std::size_t i = 0; i < results.rows.size(); ++i) {
        EXPECT_EQ(results.rows[i].pair, pairs[i / 2]);
        EXPECT_EQ(results.rows[i].method, twoMethods().methods[i % 2]);
    }
}

/// Oracle: masks rendered and errors computed here, pair by pair.
TEST(BenchmarkRun, ErrorsAreMeanJointDistancesToTheTestFrame) {
    const BenchmarkScene scene = tinyScene();
    const BenchmarkResults results = runBenchmark(scene, tinyPairs(scene), twoMethods(), pretendToFit);
    for (const PairResult& row : results.rows) {
        const auto& motion = scene.sequences[row.pair.sequence == "one" ? 0 : 1].motion;
        const HandPoses& start = motion[static_cast<std::size_t>(row.pair.start)];
        const HandPoses& truth = motion[static_cast<std::size_t>(row.pair.test)];
        std::vector<cv::Mat> masks;
        for (const Camera& camera : scene.cameras)
            masks.push_back(renderHandsMask(camera, scene.hands, truth));
        const FitResult fit = pretendToFit(masks, start, parseMethod(row.method), {});
        EXPECT_NEAR(row.initialErrorMm, meanJointDistanceMm(scene.hands, start, truth), 1e-6);
        EXPECT_NEAR(row.errorMm, meanJointDistanceMm(scene.hands, fit.poses, truth), 1e-6);
        const auto estimated = jointPositions(scene.hands[1].skeleton, fit.poses[1]);
        const auto recorded = jointPositions(scene.hands[1].skeleton, truth[1]);
        EXPECT_NEAR(row.jointErrorsMm[3], (estimated[1] - recorded[1]).norm(), 1e-6);
        EXPECT_EQ(row.iterations, row.method[0] == 'c' ? 6 : 2);
        EXPECT_EQ(row.costRises, row.method[0] == 'c' ? 1 : 0);
        EXPECT_EQ(row.seconds, 0.25);
    }
}

TEST(BenchmarkRun, DoesNotDependOnTheNumberOfThreads) {
    const BenchmarkScene scene = tinyScene();
    BenchmarkOptions options = twoMethods();
    const BenchmarkResults one = runBenchmark(scene, tinyPairs(scene), options, pretendToFit);
    options.threads = 4;
    EXPECT_EQ(runBenchmark(scene, tinyPairs(scene), options, pretendToFit).rows, one.rows);
}

TEST(BenchmarkRun, ShardsAreDisjointAndTogetherTheWhole) {
    const BenchmarkScene scene = tinyScene();
    const std::vector<FramePair> pairs = tinyPairs(scene);
    BenchmarkResults whole = runBenchmark(scene, pairs, twoMethods(), pretendToFit);
    BenchmarkResults joined = whole;
    joined.rows.clear();
    for (int i = 0; i < 3; ++i) {
        BenchmarkOptions options = twoMethods();
        options.shard = {i, 3};
        const BenchmarkResults part = runBenchmark(scene, pairs, options, pretendToFit);
        EXPECT_LT(part.rows.size(), whole.rows.size());
        joined.rows.insert(joined.rows.end(), part.rows.begin(), part.rows.end());
    }
    ASSERT_EQ(joined.rows.size(), whole.rows.size());
    sortRows(joined);
    EXPECT_EQ(joined.rows, whole.rows);
}

TEST(BenchmarkRun, StopsBetweenFitsAndGoesOnWhereItEnded) {
    const BenchmarkScene scene = tinyScene();
    const std::vector<FramePair> pairs = tinyPairs(scene);
    const BenchmarkResults whole = runBenchmark(scene, pairs, twoMethods(), pretendToFit);
    std::stop_source stop;
    const auto stopAfterFive = [&](const BenchmarkProgress& progress) {
        if (progress.finished == 5)
            stop.request_stop();
    };
    const BenchmarkResults part =
        runBenchmark(scene, pairs, twoMethods(), pretendToFit, stopAfterFive, stop.get_token());
    EXPECT_TRUE(part.stopped);
    EXPECT_EQ(part.rows.size(), 5u);
    std::atomic<int> fits = 0;
    const PairEstimator counting = [&](const auto& masks, const auto& start, const auto& method,
                                       std::stop_token token) {
        ++fits;
        return pretendToFit(masks, start, method, std::move(token));
    };
    std::vector<int> seen;
    const auto note = [&](const BenchmarkProgress& progress) { seen.push_back(progress.finished); };
    const BenchmarkResults rest = runBenchmark(scene, pairs, twoMethods(), counting, note, {}, part.rows);
    EXPECT_EQ(rest.rows, whole.rows);
    EXPECT_FALSE(rest.stopped);
    EXPECT_EQ(fits, static_cast<int>(whole.rows.size()) - 5);
    EXPECT_EQ(seen.front(), 5);
    EXPECT_EQ(seen.back(), static_cast<int>(whole.rows.size()));
}

TEST(BenchmarkRun, DropsTheFitThatWasStopped) {
    const BenchmarkScene scene = tinyScene();
    const PairEstimator stopped = [](const auto& masks, const auto& start, const auto& method, std::stop_token token) {
        FitResult result = pretendToFit(masks, start, method, std::move(token));
        result.termination = FitTermination::Stopped;
        return result;
    };
    EXPECT_TRUE(runBenchmark(scene, tinyPairs(scene), twoMethods(), stopped).rows.empty());
}

TEST(BenchmarkRun, PassesOnWhatAnEstimatorThrows) {
    const BenchmarkScene scene = tinyScene();
    BenchmarkOptions options = twoMethods();
    options.threads = 3;
    const PairEstimator broken = [](const auto&, const auto&, const auto&, std::stop_token) -> FitResult {
        throw Error(ErrorCode::BadInput, "", "masks", "are broken");
    };
    EXPECT_THROW(runBenchmark(scene, tinyPairs(scene), options, broken), Error);
}

TEST(BenchmarkRun, RealisticTakesMasksAndAnnotatedJoints) {
    BenchmarkScene scene = tinyScene();
    scene.sequences.pop_back();
    BenchmarkSequence& sequence = scene.sequences[0];
    const Eigen::Vector3d annotated(1, 2, 3);
    sequence.annotatedJoints[20] = {{{Side::Right, "index_mcp"}, annotated}, {{Side::Right, "unknown"}, annotated}};
    std::set<int> asked;
    sequence.masks = [&](int frame) {
        asked.insert(frame);
        return std::vector<cv::Mat>(3, cv::Mat(96, 54, CV_8U, cv::Scalar(255)));
    };
    BenchmarkOptions options{BenchmarkSetup::Realistic, {"ch"}, 1, {}};
    const auto frames = pairFrames(scene, BenchmarkSetup::Realistic);
    ASSERT_EQ(frames[0].frames, std::vector<int>{20});
    const auto pairs = drawPairs(frames, {1.0, {5}, 0});
    const BenchmarkResults results = runBenchmark(scene, pairs, options, pretendToFit);
    ASSERT_EQ(results.rows.size(), 1u);
    ASSERT_EQ(results.joints, (std::vector<JointId>{{Side::Right, "index_mcp"}}));
    EXPECT_EQ(asked, std::set<int>{20});
    const Eigen::Vector3d start = jointPositions(scene.hands[1].skeleton, sequence.motion[15][1])[1];
    EXPECT_NEAR(results.rows[0].initialErrorMm, (start - annotated).norm(), 1e-6);
    EXPECT_THROW(runBenchmark(scene, {{"one", 5, 10}}, options, pretendToFit), Error) << "frame 10 is not annotated";
}

TEST(BenchmarkRun, RefusesWhatMakesNoSense) {
    const BenchmarkScene scene = tinyScene();
    const auto run = [&](const std::vector<FramePair>& pairs, const BenchmarkOptions& options) {
        runBenchmark(scene, pairs, options, pretendToFit);
    };
    BenchmarkOptions options = twoMethods();
    EXPECT_THROW(run({{"three", 1, 2}}, options), Error);
    EXPECT_THROW(run({{"two", 1, 30}}, options), Error);
    EXPECT_THROW(run({{"two", -1, 3}}, options), Error);
    EXPECT_THROW(run({}, options), Error);
    options.shard = {2, 2};
    EXPECT_THROW(run(tinyPairs(scene), options), Error);
    options = twoMethods();
    options.methods = {"nonsense"};
    EXPECT_THROW(run(tinyPairs(scene), options), Error);
    options.methods = {"ch", "ch"};
    EXPECT_THROW(run(tinyPairs(scene), options), Error);
}

} // namespace
} // namespace core
