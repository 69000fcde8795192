// SPDX-License-Identifier: MIT
// Whether fits that may be trusted are right: `best` on simulated recordings of people, rigs and noise that are drawn
// anew for every seed. A line per fit, then for each half of the people (even seeds, odd seeds) how many fits are
// trusted and how many of these are within 3 mm. Usage: handlens_doubt_trial DATASET [people] [first seed]
// DATASET holds hands, cameras and recorded motion; nothing is read from its pictures.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/benchmark/realism_scene.h"
#include "core/error.h"
#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"
#include "core/io/benchmark/benchmark_scene.h"
#include "core/io/dataset/dataset.h"
#include "core/numeric/normal.h"
#include "core/simulation/simulated_world.h"

namespace {

constexpr double kRightMm = 3;

struct Half {
    int fits = 0, right = 0, trusted = 0, trustedRight = 0;
};

/// Another person before another rig; every third recording is used as it is, the others after the rig was refined
/// and the hands were measured.
core::RealismSetting drawnSetting(std::uint64_t seed) {
    core::RandomGenerator random(core::drawSeed(seed, "person"));
    core::RealismSetting setting;
    setting.id = "drawn-" + std::to_string(seed);
    setting.world.scale = std::exp(0.04 * core::standardNormal(random));
    setting.world.girthMm = 0.7 * core::standardNormal(random);
    setting.world.lengthShare = 0.02;
    setting.world.contourPx = 0.3 + 1.9 * random.uniform();
    setting.world.forearm = random.uniform() < 0.7;
    const double share = random.uniform();
    setting.world.rig = {share * core::kCasualRig.turnDeg, share * core::kCasualRig.shiftMm,
                         share * core::kCasualRig.focalShare};
    setting.isAdapted = seed % 3 != 0;
    return setting;
}

void tryPerson(const core::BenchmarkScene& clean, std::uint64_t seed, Half& half) {
    const core::RealismSetting setting = drawnSetting(seed);
    core::PairOptions draw;
    draw.fraction = 0.004; // one test frame of most sequences
    draw.seed = seed;
    const auto pairs = core::drawPairs(core::pairFrames(clean, core::BenchmarkSetup::Synthetic), draw);
    const core::BenchmarkScene scene = core::realismScene(clean, setting, pairs, seed);
    const core::PoseEstimator estimator(scene.hands, scene.cameras);
    const auto joints = core::benchmarkJoints(scene, core::BenchmarkSetup::Realistic);
    for (const core::BenchmarkSequence& sequence : scene.sequences) {
        for (const core::FramePair& pair : pairs) {
            if (pair.sequence != sequence.name)
                continue;
            const core::FitResult fit =
                estimator.fit(sequence.masks(pair.test), sequence.motion[static_cast<std::size_t>(pair.start)],
                              core::parseMethod("best"), {}, {}, 1, {.confidence = true});
            const auto reference = core::referenceJoints(scene, core::BenchmarkSetup::Realistic, pair);
            const double errorMm =
                core::jointErrors(joints, core::namedJointPositions(scene.hands, fit.poses), reference).meanMm;
            const double doubt = fit.confidence ? fit.confidence->doubt : 1;
            const bool isRight = errorMm <= kRightMm, isTrusted = doubt < core::kTrustedDoubt;
            ++half.fits;
            half.right += isRight;
            half.trusted += isTrusted;
            half.trustedRight += isRight && isTrusted;
            std::printf("%llu,%s,%d,%d,%d,%.1f,%.3f,%.4f\n", static_cast<unsigned long long>(seed),
                        setting.isAdapted ? "adapted" : "as it is", static_cast<int>(setting.world.forearm), pair.start,
                        pair.test, setting.world.contourPx, errorMm, doubt);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: handlens_doubt_trial DATASET [people] [first seed]\n");
        return 2;
    }
    try {
        const int people = argc > 2 ? std::atoi(argv[2]) : 20;
        const auto first = static_cast<std::uint64_t>(argc > 3 ? std::atoi(argv[3]) : 100);
        const core::BenchmarkScene clean =
            core::readBenchmarkScene(core::readDataset(argv[1]), {}, core::BenchmarkSetup::Synthetic);
        std::printf("seed,hand and rig,forearm,start,test,contour px,error mm,doubt\n");
        std::array<Half, 2> halves;
        for (int i = 0; i < people; ++i)
            tryPerson(clean, first + static_cast<std::uint64_t>(i), halves[i % 2]);
        for (const Half& half : halves) {
            std::printf("%d fits, %d within %g mm; %d trusted, %d of them within %g mm: %.1f %%\n", half.fits,
                        half.right, kRightMm, half.trusted, half.trustedRight, kRightMm,
                        half.trusted > 0 ? 100.0 * half.trustedRight / half.trusted : 0.0);
        }
    } catch (const core::Error& error) {
        std::fprintf(stderr, "handlens_doubt_trial: %s\n", error.what());
        return 1;
    }
    return 0;
}
