// SPDX-License-Identifier: MIT
// Stated and true uncertainty of clicked joints, on simulated rigs that are exact or off by as much as real ones are:
// as the file says, and refined from five frames; then the time of it all for 200 frames. Usage: handlens_rig_trial
// [seeds]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "core/rig/rig_health.h"
#include "core/rig/rig_refinement.h"
#include "tests/core/rig/rig_truth.h"

namespace {

using test::RigScene;
using test::TruthComparison;

void print(const char* level, const char* rig, const TruthComparison& row) {
    std::printf("%-8s %-9s %7.2f %7.2f %7.2f %7.2f %8.2f %7.2f %%\n", level, rig, row.rawMm, row.alignedMm,
                row.statedMm, row.neesRaw, row.neesAligned, 100 * row.dropped);
}

/// All joints of a rig share the errors of its cameras: NEES of one rig varies.
void printRange(const char* level, const char* rig, std::vector<double> nees) {
    std::sort(nees.begin(), nees.end());
    const auto at = [&](double share) { return nees[static_cast<std::size_t>(share * (nees.size() - 1))]; };
    std::printf("%-8s %-9s NEES of one rig: %.1f in the middle, %.1f to %.1f in nine of ten\n", level, rig, at(0.5),
                at(0.05), at(0.95));
}

void tryLevel(const char* level, double factor, int seeds) {
    TruthComparison before, known, refined;
    std::vector<double> ofOne, ofOneRefined;
    for (int seed = 0; seed < seeds; ++seed) {
        RigScene scene(std::string(level) + std::to_string(seed));
        scene.jointCount = 28;
        scene.loosen(factor);
        const auto chosen = scene.clicks(RigScene::frames(5, 16)), others = scene.clicks(RigScene::frames(10, 8, 4));
        test::add(before, compareWithTruth(scene, scene.nominal, others, {}), 1.0 / seeds);
        const core::ClickSigmas sigmas = core::estimateClickSigmas(scene.nominal, chosen);
        const TruthComparison asGiven = compareWithTruth(scene, scene.nominal, others, sigmas);
        ofOne.push_back(asGiven.neesRaw);
        test::add(known, asGiven, 1.0 / seeds);
        const core::RigRefinement refinement = core::refineRig(scene.nominal, chosen).value();
        const auto world = core::worldCovariance(scene.nominal, sigmas, refinement.middleInWorld);
        const core::ClickSigmas after = core::estimateClickSigmas(refinement.cameras, chosen);
        const TruthComparison adjusted =
            compareWithTruth(scene, refinement.cameras, others, after, world.value_or(Eigen::Matrix3d::Zero()));
        ofOneRefined.push_back(adjusted.neesRaw);
        test::add(refined, adjusted, 1.0 / seeds);
    }
    print(level, "assumed", before);
    print(level, "as given", known);
    print(level, "refined", refined);
    printRange(level, "as given", ofOne);
    printRange(level, "refined", ofOneRefined);
}

double secondsSince(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void timeWholeDataset() {
    RigScene scene("Time");
    scene.jointCount = 28;
    scene.loosen();
    const auto joints = scene.clicks(RigScene::frames(200, 2));
    const std::clock_t start = std::clock();
    const core::RigResiduals residuals = core::computeRigResiduals(scene.nominal, joints);
    const double residualSeconds = secondsSince(start);
    const core::RigHealth health = core::judgeRig(scene.nominal, joints, residuals);
    const double healthSeconds = secondsSince(start);
    core::estimateClickSigmas(scene.nominal, joints, residuals);
    const double sigmaSeconds = secondsSince(start);
    const auto refinement = core::refineRig(scene.nominal, joints, residuals);
    std::printf("%d joints in %d frames, 8 views, processor time: residuals %.2f s, health %.2f, sigmas %.2f, "
                "refinement %.2f; together %.2f s\n",
                health.joints, health.frames, residualSeconds, healthSeconds - residualSeconds,
                sigmaSeconds - healthSeconds, secondsSince(start) - sigmaSeconds, secondsSince(start));
    if (!refinement)
        std::printf("no refinement\n");
}

} // namespace

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
    std::printf("simulated; mean over %d rigs, 28 joints in 10 frames that nothing was estimated from\n", seeds);
    std::printf("%-8s %-9s %7s %7s %7s %7s %8s %9s\n", "level", "rig", "raw mm", "aligned", "stated", "NEES", "aligned",
                "dropped");
    tryLevel("exact", 0, seeds);
    tryLevel("studio", 0.27, seeds);
    tryLevel("lab", 0.65, seeds);
    tryLevel("casual", 1, seeds);
    timeWholeDataset();
    return 0;
}
