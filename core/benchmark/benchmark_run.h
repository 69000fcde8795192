// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/benchmark_setup.h"
#include "core/benchmark/joint_errors.h"
#include "core/benchmark/pairs.h"
#include "core/fitting/fit_result.h"
#include "core/fitting/method.h"
#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"
#include "core/hand/motion.h"

namespace core {

/// One sequence as the benchmark sees it.
struct BenchmarkSequence {
    std::string name;
    Motion motion; ///< recorded poses
    /// Realistic only: annotated joints per frame, world, mm.
    std::map<int, JointPositions> annotatedJoints;
    /// Realistic only: observed silhouettes of a frame, one per camera (an empty Mat leaves the camera out).
    /// Called from several threads at once.
    std::function<std::vector<cv::Mat>(int frame)> masks;
};

/// What is measured: full models, cameras, sequences.
struct BenchmarkScene {
    std::vector<HandModel> hands;
    std::vector<Camera> cameras;
    std::vector<BenchmarkSequence> sequences;
};

struct BenchmarkOptions {
    BenchmarkSetup setup = BenchmarkSetup::Synthetic;
    std::vector<std::string> methods = {"dch-thres"}; ///< as parseMethod reads them
    int threads = 1;                                  ///< workers; the results do not depend on it
    Shard shard;
};

/// Finished fits, out of all that this run has to do (those finished earlier count as finished).
struct BenchmarkProgress {
    int finished = 0;
    int total = 0;
    const PairResult* latest = nullptr; ///< null in the first call, which comes before any fit
};

/// Called after every fit, from one thread at a time but not always the same one.
using BenchmarkProgressFunction = std::function<void(const BenchmarkProgress&)>;

/// Estimates one pair: masks per camera, start poses, method. Called from several threads at once.
using PairEstimator = std::function<FitResult(const std::vector<cv::Mat>& masks, const HandPoses& start,
                                              const Method& method, std::stop_token stop)>;

/// Runs every method on every pair of the shard. `finished` are results of an earlier run of the same work: they are
/// kept, not computed again. Rows come in the order of the pairs, then of the methods, whatever the number of threads.
/// When stopped, returns the rows that are finished, with `stopped` set. Throws Error(Usage) for a method that cannot
/// be parsed and Error(BadInput) for a pair that the scene does not have or, in the realistic setup, that has
/// no annotations.
BenchmarkResults runBenchmark(const BenchmarkScene& scene, const std::vector<FramePair>& pairs,
                              const BenchmarkOptions& options, const PairEstimator& estimator,
                              const BenchmarkProgressFunction& progress = {}, std::stop_token stop = {},
                              const std::vector<PairResult>& finished = {});

/// Throws what runBenchmark would throw for methods, pairs and shard that make no sense, before any work is done.
void requireRunnable(const BenchmarkScene& scene, const std::vector<FramePair>& pairs, const BenchmarkOptions& options);

/// The joints over which errors are taken: all named joints, or (realistic) the model's annotated ones.
std::vector<JointId> benchmarkJoints(const BenchmarkScene& scene, BenchmarkSetup setup);

/// The joints that errors are measured against: recorded at the test frame, or (realistic) annotated there.
JointPositions referenceJoints(const BenchmarkScene& scene, BenchmarkSetup setup, const FramePair& pair);
/// The joints of the recorded pose of the start frame.
JointPositions startJoints(const BenchmarkScene& scene, const FramePair& pair);

/// The estimator that users get: a PoseEstimator over the scene's hands and cameras, one thread per fit.
PairEstimator poseEstimatorOf(const BenchmarkScene& scene);

/// Frames that can be test frames of the setup: all with a recorded pose, or the annotated ones.
std::vector<PairFrames> pairFrames(const BenchmarkScene& scene, BenchmarkSetup setup);

} // namespace core
