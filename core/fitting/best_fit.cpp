// SPDX-License-Identifier: MIT
#include "core/fitting/best_fit.h"

#include <numbers>

namespace core {

namespace {

struct Phase {
    int iterations;
    bool rigidOnly;
    double tauDeg;
    Detail detail;
    int points;
    int contourPoints;
    double tangentWeight;
};

IterationSettings settingsOf(const Phase& phase) {
    IterationSettings s;
    s.rule.search = MatchRule::Search::WithinTau;
    s.rule.tauRad = static_cast<float>(phase.tauDeg * std::numbers::pi / 180);
    s.detail = phase.detail;
    s.pointsPerCamera = phase.points;
    s.contourPointsPerCamera = phase.contourPoints;
    s.rigidOnly = phase.rigidOnly;
    s.tangentWeight = phase.tangentWeight;
    return s;
}

} // namespace

void fitBest(PoseRefiner& refiner, bool live, std::stop_token stop, const FitProgress& progress, FitResult& result) {
    const std::vector<Phase> phases = live ? std::vector<Phase>{{5, true, 45, Detail::Coarse, 100, 100, 0.3},
                                                                {8, false, 45, Detail::Coarse, 100, 100, 0.3},
                                                                {4, false, 22.5, Detail::Medium, 150, 150, 0.1}}
                                           : std::vector<Phase>{{8, true, 45, Detail::Medium, 200, 200, 0.3},
                                                                {12, false, 45, Detail::Medium, 200, 200, 0.3},
                                                                {8, false, 22.5, Detail::Full, 300, 300, 0.1}};
    int total = 0, done = 0;
    for (const Phase& phase : phases) {
        total += phase.iterations;
    }
    result.termination = FitTermination::MaxIterations;
    for (const Phase& phase : phases) {
        const IterationSettings settings = settingsOf(phase);
        for (int i = 0; i < phase.iterations; ++i) {
            if (stop.stop_requested()) {
                result.termination = FitTermination::Stopped;
                return;
            }
            FitIteration record = refiner.iterate(result.poses, settings);
            record.iteration = done++;
            record.poses = result.poses;
            result.history.push_back(record);
            if (progress) {
                progress(done, total);
            }
            if (record.matches == 0) {
                result.termination = FitTermination::NoMatches;
                return;
            }
            if (record.stepMm < 0.01) {
                break;
            }
        }
    }
}

} // namespace core
