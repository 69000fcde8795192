// SPDX-License-Identifier: MIT
#include "core/benchmark/benchmark_run.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "core/benchmark/joint_errors.h"
#include "core/benchmark/paper_results.h"
#include "core/contour/rasteriser.h"
#include "core/error.h"
#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"

namespace core {

namespace {

/// The model's annotated joints, in the model's order.
std::vector<JointId> annotatedJoints(const BenchmarkScene& scene) {
    std::set<JointId> annotated;
    for (const BenchmarkSequence& sequence : scene.sequences) {
        for (const auto& [frame, joints] : sequence.annotatedJoints)
            for (const auto& [id, position] : joints)
                annotated.insert(id);
    }
    std::vector<JointId> joints = jointNames(scene.hands);
    std::erase_if(joints, [&](const JointId& id) { return !annotated.contains(id); });
    return joints;
}

const BenchmarkSequence& sequenceOf(const BenchmarkScene& scene, const std::string& name) {
    const auto found = std::find_if(scene.sequences.begin(), scene.sequences.end(),
                                    [&](const BenchmarkSequence& sequence) { return sequence.name == name; });
    if (found == scene.sequences.end())
        throw Error(ErrorCode::BadInput, "", "pairs", "unknown sequence " + name);
    return *found;
}

void requirePair(const BenchmarkScene& scene, const FramePair& pair, BenchmarkSetup setup) {
    const BenchmarkSequence& sequence = sequenceOf(scene, pair.sequence);
    const int frames = static_cast<int>(sequence.motion.size());
    const std::string where =
        "sequence " + pair.sequence + ", start " + std::to_string(pair.start) + ", test " + std::to_string(pair.test);
    if (pair.start < 0 || pair.test < 0 || pair.start >= frames || pair.test >= frames) {
        throw Error(ErrorCode::BadInput, "", "pairs",
                    where + ": the sequence has recorded poses for " + std::to_string(frames) + " frames");
    }
    if (setup == BenchmarkSetup::Realistic && !sequence.annotatedJoints.contains(pair.test))
        throw Error(ErrorCode::BadInput, "", "pairs", where + ": the test frame has no annotated 3D joints");
    if (setup == BenchmarkSetup::Realistic && !sequence.masks)
        throw Error(ErrorCode::BadInput, "", "pairs", where + ": the sequence has no masks");
}

int costRises(const FitResult& fit) {
    int rises = 0;
    for (std::size_t i = 1; i < fit.history.size(); ++i)
        rises += fit.history[i].costMm2 > fit.history[i - 1].costMm2 ? 1 : 0;
    return rises;
}

/// All work that shares one target: the pairs of one test frame.
struct TestFrame {
    const BenchmarkSequence* sequence = nullptr;
    int test = 0;
    std::vector<FramePair> pairs;
};

std::vector<TestFrame> testFrames(const BenchmarkScene& scene, const std::vector<FramePair>& pairs) {
    std::vector<TestFrame> frames;
    std::map<std::pair<std::string, int>, std::size_t> numberOf;
    for (const FramePair& pair : pairs) {
        const auto [at, isNew] = numberOf.try_emplace({pair.sequence, pair.test}, frames.size());
        if (isNew)
            frames.push_back({&sequenceOf(scene, pair.sequence), pair.test, {}});
        frames[at->second].pairs.push_back(pair);
    }
    return frames;
}

/// Targets of one test frame, made when the first fit needs them.
class Targets {
public:
    Targets(const BenchmarkScene& scene, BenchmarkSetup setup, const TestFrame& frame)
        : m_scene(scene)
        , m_setup(setup)
        , m_frame(frame) {}

    const std::vector<cv::Mat>& masks() {
        if (m_masks.empty())
            m_masks = m_setup == BenchmarkSetup::Realistic ? m_frame.sequence->masks(m_frame.test) : rendered();
        return m_masks;
    }

    const HandPoses& poses(int frame) const { return m_frame.sequence->motion[static_cast<std::size_t>(frame)]; }

private:
    std::vector<cv::Mat> rendered() const {
        std::vector<cv::Mat> masks;
        for (const Camera& camera : m_scene.cameras)
            masks.push_back(renderHandsMask(camera, m_scene.hands, poses(m_frame.test)));
        return masks;
    }

    const BenchmarkScene& m_scene;
    BenchmarkSetup m_setup;
    const TestFrame& m_frame;
    std::vector<cv::Mat> m_masks;
};

/// One run: the test frames of the shard, handed out to workers one at a time.
class Run {
public:
    Run(const BenchmarkScene& scene, const BenchmarkOptions& options, const PairEstimator& estimator,
        const BenchmarkProgressFunction& progress, std::stop_token stop)
        : m_scene(scene)
        , m_options(options)
        , m_estimator(estimator)
        , m_progress(progress)
        , m_stop(std::move(stop)) {
        m_results.methods = options.methods;
        m_results.joints = benchmarkJoints(scene, options.setup);
        m_results.papersHands = isPapersHands(scene.hands);
        for (const std::string& name : options.methods)
            m_methods.push_back(parseMethod(name));
    }

    BenchmarkResults run(const std::vector<FramePair>& pairs, const std::vector<PairResult>& finished) {
        requireRunnable(m_scene, pairs, m_options);
        m_results.pairs = pairs;
        m_frames = testFrames(m_scene, pairsOfShard(pairs, m_options.shard));
        takeFinished(finished);
        tell(nullptr);
        work();
        m_results.stopped = static_cast<int>(m_results.rows.size()) < m_total;
        sortRows(m_results);
        return std::move(m_results);
    }

private:
    void takeFinished(const std::vector<PairResult>& finished) {
        std::set<std::pair<FramePair, std::string>> wanted;
        for (const TestFrame& frame : m_frames) {
            for (const FramePair& pair : frame.pairs)
                for (const std::string& method : m_options.methods)
                    wanted.emplace(pair, method);
        }
        m_total = static_cast<int>(wanted.size());
        for (const PairResult& row : finished)
            if (wanted.contains({row.pair, row.method}) && m_done.emplace(row.pair, row.method).second)
                m_results.rows.push_back(row);
    }

    void work() {
        {
            std::vector<std::jthread> workers;
            for (int i = 1; i < m_options.threads; ++i)
                workers.emplace_back([this] { takeFrames(); });
            takeFrames();
        }
        if (m_failure)
            std::rethrow_exception(m_failure);
    }

    void takeFrames() {
        try {
            for (std::size_t i = m_next++; i < m_frames.size() && !ending(); i = m_next++)
                solve(m_frames[i]);
        } catch (...) {
            const std::scoped_lock lock(m_mutex);
            m_failure = m_failure ? m_failure : std::current_exception();
            m_failed = true;
        }
    }

    bool ending() const { return m_stop.stop_requested() || m_failed; }

    void solve(const TestFrame& frame) {
        Targets targets(m_scene, m_options.setup, frame);
        for (const FramePair& pair : frame.pairs) {
            for (std::size_t m = 0; m < m_methods.size(); ++m) {
                if (m_done.contains({pair, m_options.methods[m]}))
                    continue;
                if (ending())
                    return;
                const FitResult fit = m_estimator(targets.masks(), targets.poses(pair.start), m_methods[m], m_stop);
                if (fit.termination != FitTermination::Stopped)
                    add(measured(pair, m_options.methods[m], fit));
            }
        }
    }

    PairResult measured(const FramePair& pair, const std::string& method, const FitResult& fit) const {
        const JointPositions reference = referenceJoints(m_scene, m_options.setup, pair);
        const JointErrors start = jointErrors(m_results.joints, startJoints(m_scene, pair), reference);
        const JointErrors end = jointErrors(m_results.joints, namedJointPositions(m_scene.hands, fit.poses), reference);
        const int iterations = static_cast<int>(fit.history.size());
        return {pair,          method, start.meanMm, end.meanMm, iterations, costRises(fit), toMillionths(fit.seconds),
                end.perJointMm};
    }

    void add(PairResult row) {
        const std::scoped_lock lock(m_mutex);
        m_results.rows.push_back(std::move(row));
        tell(&m_results.rows.back());
    }

    void tell(const PairResult* latest) const {
        if (m_progress)
            m_progress({static_cast<int>(m_results.rows.size()), m_total, latest});
    }

    const BenchmarkScene& m_scene;
    const BenchmarkOptions& m_options;
    const PairEstimator& m_estimator;
    const BenchmarkProgressFunction& m_progress;
    std::stop_token m_stop;
    std::vector<Method> m_methods;
    std::vector<TestFrame> m_frames;
    std::set<std::pair<FramePair, std::string>> m_done;
    int m_total = 0;
    std::atomic<std::size_t> m_next = 0;
    std::atomic<bool> m_failed = false;
    std::mutex m_mutex; ///< guards m_results and m_failure while workers run
    BenchmarkResults m_results;
    std::exception_ptr m_failure;
};

} // namespace

BenchmarkResults runBenchmark(const BenchmarkScene& scene, const std::vector<FramePair>& pairs,
                              const BenchmarkOptions& options, const PairEstimator& estimator,
                              const BenchmarkProgressFunction& progress, std::stop_token stop,
                              const std::vector<PairResult>& finished) {
    return Run(scene, options, estimator, progress, std::move(stop)).run(pairs, finished);
}

void requireRunnable(const BenchmarkScene& scene, const std::vector<FramePair>& pairs,
                     const BenchmarkOptions& options) {
    std::set<std::string> methods;
    for (const std::string& name : options.methods) {
        parseMethod(name);
        if (!methods.insert(name).second)
            throw Error(ErrorCode::Usage, "", "methods", name + " is named twice");
    }
    for (const FramePair& pair : pairs)
        requirePair(scene, pair, options.setup);
    pairsOfShard(pairs, options.shard); // may be empty if there are more shards than test frames
    if (pairs.empty()) {
        throw Error(ErrorCode::Usage, "", "pairs",
                    "there are none: too few frames for this fraction and these differences");
    }
}

std::vector<JointId> benchmarkJoints(const BenchmarkScene& scene, BenchmarkSetup setup) {
    return setup == BenchmarkSetup::Realistic ? annotatedJoints(scene) : jointNames(scene.hands);
}

JointPositions referenceJoints(const BenchmarkScene& scene, BenchmarkSetup setup, const FramePair& pair) {
    const BenchmarkSequence& sequence = sequenceOf(scene, pair.sequence);
    return setup == BenchmarkSetup::Realistic
               ? sequence.annotatedJoints.at(pair.test)
               : namedJointPositions(scene.hands, sequence.motion[static_cast<std::size_t>(pair.test)]);
}

JointPositions startJoints(const BenchmarkScene& scene, const FramePair& pair) {
    const BenchmarkSequence& sequence = sequenceOf(scene, pair.sequence);
    return namedJointPositions(scene.hands, sequence.motion[static_cast<std::size_t>(pair.start)]);
}

PairEstimator poseEstimatorOf(const BenchmarkScene& scene) {
    auto estimator = std::make_shared<PoseEstimator>(scene.hands, scene.cameras);
    return [estimator](const std::vector<cv::Mat>& masks, const HandPoses& start, const Method& method,
                       std::stop_token stop) { return estimator->fit(masks, start, method, std::move(stop)); };
}

std::vector<PairFrames> pairFrames(const BenchmarkScene& scene, BenchmarkSetup setup) {
    std::vector<PairFrames> result;
    for (const BenchmarkSequence& sequence : scene.sequences) {
        PairFrames frames{sequence.name, {}};
        for (int frame = 0; frame < static_cast<int>(sequence.motion.size()); ++frame)
            if (setup == BenchmarkSetup::Synthetic || sequence.annotatedJoints.contains(frame))
                frames.frames.push_back(frame);
        result.push_back(std::move(frames));
    }
    return result;
}

} // namespace core
