// SPDX-License-Identifier: MIT
#include "core/fitting/phases.h"

#include <gtest/gtest.h>

#include "core/fitting/fit_loop.h"
#include "core/fitting/method_name.h"
#include "tests/support/fitting_scene.h"

namespace {

using core::Detail;
using core::Phase;

/// What each iteration of an attempt does in which no step settles.
struct Planned {
    bool rigidOnly;
    Detail detail;
    double gatePx;
};
std::vector<Planned> planned(const std::vector<Phase>& phases, int from = 0) {
    std::vector<Planned> plan;
    for (const Phase& phase : phases)
        for (int i = 0; i < phase.iterations && from + static_cast<int>(plan.size()) < phase.until; ++i)
            plan.push_back({phase.rigidOnly, phase.detail, phase.gatePx});
    return plan;
}

TEST(Phases, ThePapersScheduleMovesAllInEveryIterationOnTheFullMesh) {
    const auto plan = planned(core::schedulePhases(core::parseMethod("dch-quant:schedule=paper:iterations=30")));
    ASSERT_EQ(plan.size(), 30u);
    for (const Planned& iteration : plan) {
        EXPECT_FALSE(iteration.rigidOnly);
        EXPECT_EQ(iteration.detail, Detail::Full);
        EXPECT_TRUE(std::isinf(iteration.gatePx));
    }
}

TEST(Phases, RigidFirstGoesFromCoarseToFineWithinTheIterations) {
    for (const int most : {1, 3, 8, 14, 17, 19, 25, 60}) {
        const auto plan =
            planned(core::schedulePhases(core::parseMethod("dch-thres:iterations=" + std::to_string(most))));
        ASSERT_EQ(plan.size(), static_cast<std::size_t>(most));
        for (int i = 0; i < most; ++i) {
            const Planned& iteration = plan[static_cast<std::size_t>(i)];
            EXPECT_EQ(iteration.rigidOnly, i < 14);
            EXPECT_EQ(iteration.detail, i < 14          ? Detail::Coarse
                                        : i >= most - 5 ? Detail::Full
                                                        : Detail::Medium)
                << i << " of " << most;
            EXPECT_TRUE(std::isinf(iteration.gatePx));
        }
    }
}

TEST(Phases, TheLastTwoFifthsOfQuantHaveANarrowGate) {
    for (const int most : {1, 7, 20, 25, 60}) {
        for (const char* method : {"dch-quant", "dch-quant2"}) {
            const auto phases =
                core::schedulePhases(core::parseMethod(std::string(method) + ":iterations=" + std::to_string(most)));
            const auto plan = planned(phases);
            ASSERT_EQ(plan.size(), static_cast<std::size_t>(most));
            for (int i = 0; i < most; ++i)
                EXPECT_EQ(plan[static_cast<std::size_t>(i)].gatePx <= 12, i >= 0.6 * most) << i << " of " << most;
        }
    }
}

TEST(Phases, WhereOutlinesAreNoisyTheLastFiveIterationsAreAStageOfTheirOwn) {
    for (const std::string name : {"dch-thres", "dch-thres:schedule=paper", "dch-quant"}) {
        const core::Method method = core::parseMethod(name);
        const auto phases = core::noisyPhases(method);
        ASSERT_GE(phases.size(), 2u);
        EXPECT_GT(phases.back().stage, phases[phases.size() - 2].stage) << name << ": it is never skipped";
        EXPECT_EQ(phases.back().iterations, 5);
        EXPECT_EQ(phases.back().detail, core::Detail::Full);
        EXPECT_EQ(core::mostIterations(phases), method.maxIterations) << name;
        for (const core::Phase& phase : phases)
            EXPECT_GT(phase.settledMm, 0.05) << "steps that noise makes do not count";
    }
}

TEST(Phases, OnceSettledWeightsAndPriorFollowTheNoise) {
    core::IterationSettings settings;
    settings.motionPrior = core::kMotionPrior;
    const core::IterationSettings quiet = core::settledOn(settings, 1), noisy = core::settledOn(settings, 2);
    EXPECT_NEAR(noisy.motionPrior, 4 * quiet.motionPrior, 1e-12) << "as the variance";
    EXPECT_NEAR(noisy.robustPx, 2 * quiet.robustPx, 1e-12);
    settings.motionPrior = 0;
    EXPECT_EQ(core::settledOn(settings, 2).motionPrior, 0) << "no prior, however noisy";
}

TEST(Phases, AfterAnEarlyEndOfTheRigidPhaseTheOthersEndWhereTheyWouldHave) {
    auto phases = core::schedulePhases(core::parseMethod("dch-thres"));
    ASSERT_EQ(phases[0].stage, 0);
    phases.erase(phases.begin()); // settled after its sixth iteration
    const auto plan = planned(phases, 6);
    ASSERT_EQ(plan.size(), 19u);
    EXPECT_EQ(plan[13].detail, Detail::Medium);
    EXPECT_EQ(plan[14].detail, Detail::Full);
}

TEST(Phases, SettingsOverrideWhatThePhaseSaysAndKeepTheRest) {
    core::IterationSettings base;
    base.rule = core::matchRule(core::parseMethod("dch-quant:gate=40"));
    base.damping = 0.5;
    base.startPrior = 3;
    const auto kept = core::settingsOf(Phase{.rigidOnly = true, .detail = Detail::Medium, .points = 77}, base);
    EXPECT_TRUE(kept.rigidOnly);
    EXPECT_EQ(kept.detail, Detail::Medium);
    EXPECT_EQ(kept.pointsPerCamera, 77);
    EXPECT_EQ(kept.damping, 0.5);
    EXPECT_EQ(kept.startPrior, 3);
    EXPECT_EQ(kept.rule.gatePx, 40);
    EXPECT_EQ(kept.rule.tauRad, base.rule.tauRad);
    EXPECT_EQ(core::settingsOf(Phase{.gatePx = 12}, base).rule.gatePx, 12);
    EXPECT_EQ(core::settingsOf(Phase{.gatePx = 100}, base).rule.gatePx, 40);
    EXPECT_NEAR(core::settingsOf(Phase{.tauDeg = 90}, base).rule.tauRad, 1.5708, 1e-4);
}

TEST(Phases, TheOptionsOfBestChangeEveryPhase) {
    const auto all = [](const core::BestPhases& phases) {
        std::vector<Phase> list = phases.main;
        for (const auto& more : {phases.again, phases.fromOtherFingers, phases.polish})
            list.insert(list.end(), more.begin(), more.end());
        return list;
    };
    EXPECT_EQ(core::mostIterations(core::bestPhases({}).main) + core::mostIterations(core::bestPhases({}).polish), 29);
    EXPECT_TRUE(core::bestPhases({.polish = false}).polish.empty());
    EXPECT_TRUE(core::bestPhases({}).main.front().rigidOnly);
    for (const Phase& phase :
         all(core::bestPhases({.palm = false, .coarse = false, .wide = false, .bothWays = true}))) {
        EXPECT_FALSE(phase.rigidOnly);
        EXPECT_EQ(phase.detail, Detail::Full);
        EXPECT_EQ(phase.tauDeg, 22.5);
        EXPECT_EQ(phase.contourPoints, phase.points);
    }
}

TEST(Phases, FingersAreKeptApartOnTheWayFromOtherStartsOfNoisySilhouettesAlone) {
    const core::BestPhases phases = core::bestPhases({}, true);
    for (const auto* attempt : {&phases.again, &phases.fromOtherFingers})
        for (const Phase& phase : *attempt)
            EXPECT_GT(core::settingsOf(phase, {}).overlapWeight, 0);
    for (const auto* rest : {&phases.main, &phases.polish})
        for (const Phase& phase : *rest)
            EXPECT_EQ(core::settingsOf(phase, {}).overlapWeight, 0);
    for (const core::BestOptions& off : {core::BestOptions{.apart = false}, core::BestOptions{.live = true}})
        for (const Phase& phase : core::bestPhases(off, true).fromOtherFingers)
            EXPECT_EQ(phase.overlapWeight, 0);
    for (const Phase& phase : core::bestPhases({}, false).fromOtherFingers)
        EXPECT_EQ(phase.overlapWeight, 0) << "exact silhouettes";
    for (const Phase& phase : core::schedulePhases(core::parseMethod("dch-thres")))
        EXPECT_EQ(phase.overlapWeight, 0) << "the paper's methods have no such term";
}

/// Phases run on a scene from its true pose, where every step is small.
class PhaseRun : public testing::Test {
protected:
    core::FitAttempt run(const std::vector<Phase>& phases) {
        core::FitProfile profile;
        core::PoseRefiner refiner(m_hands, m_scene.cameras, m_targets, m_scene.truth, 1, profile);
        const core::FitProgress progress;
        core::FitLoop loop(refiner, {}, {}, progress, 10);
        core::FitAttempt attempt;
        attempt.poses = m_scene.truth;
        EXPECT_TRUE(loop.run(phases, attempt));
        return attempt;
    }

    test::FittingScene m_scene{"phases", 3};
    core::FittingHands m_hands = core::makeFittingHands(m_scene.hands);
    std::vector<core::CameraTarget> m_targets = core::makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
};

constexpr double kAlways = 1e9; ///< every step settles
constexpr double kNever = 0;    ///< no step does

TEST_F(PhaseRun, ASettledStepEndsItsWholeStage) {
    const core::FitAttempt settled =
        run({Phase{.iterations = 3, .settledMm = kAlways}, Phase{.iterations = 3, .settledMm = kNever},
             Phase{.stage = 1, .iterations = 2, .settledMm = kNever}});
    EXPECT_EQ(settled.history.size(), 3u); // one of the first phase, none of the second, two of the third
    EXPECT_EQ(settled.termination, core::FitTermination::MaxIterations);
}

TEST_F(PhaseRun, TheTerminationIsThatOfTheLastPhase) {
    EXPECT_EQ(
        run({Phase{.iterations = 2, .settledMm = kNever}, Phase{.stage = 1, .iterations = 2, .settledMm = kAlways}})
            .termination,
        core::FitTermination::Converged);
    const core::FitAttempt used =
        run({Phase{.until = 1, .settledMm = kAlways}, Phase{.stage = 1, .until = 1, .settledMm = kAlways}});
    EXPECT_EQ(used.history.size(), 1u);
    EXPECT_EQ(used.termination, core::FitTermination::MaxIterations); // nothing is left for the second phase
}

} // namespace
