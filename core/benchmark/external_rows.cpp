// SPDX-License-Identifier: MIT
#include "core/benchmark/external_rows.h"

#include <algorithm>

#include "core/error.h"
#include "core/fitting/method_name.h"

namespace core {

namespace {

void requireKnownJoints(const std::vector<JointId>& known, const ExternalEstimates& estimates) {
    for (const auto& [pair, joints] : estimates.joints) {
        for (const auto& [id, position] : joints) {
            if (std::find(known.begin(), known.end(), id) == known.end()) {
                throw Error(ErrorCode::Usage, estimates.name, "joint",
                            jointLabel(id) + " is none of the benchmark's joints");
            }
        }
    }
}

bool isMethod(const std::string& name) {
    try {
        parseMethod(name);
        return true;
    } catch (const Error&) {
        return false;
    }
}

} // namespace

std::vector<PairResult> externalRows(const BenchmarkScene& scene, BenchmarkSetup setup,
                                     const std::vector<FramePair>& pairs, const ExternalEstimates& estimates) {
    if (estimates.name.empty() || isMethod(estimates.name))
        throw Error(ErrorCode::Usage, "", "external", "'" + estimates.name + "' cannot be the name of another tracker");
    const std::vector<JointId> joints = benchmarkJoints(scene, setup);
    requireKnownJoints(setup == BenchmarkSetup::Realistic ? jointNames(scene.hands) : joints, estimates);
    std::vector<PairResult> rows;
    for (const FramePair& pair : pairs) {
        const auto found = estimates.joints.find(pair);
        if (found == estimates.joints.end())
            continue;
        const JointPositions reference = referenceJoints(scene, setup, pair);
        const JointErrors start = jointErrors(joints, startJoints(scene, pair), reference);
        const JointErrors end = jointErrors(joints, found->second, reference);
        rows.push_back({pair, estimates.name, start.meanMm, end.meanMm, 0, 0, 0, end.perJointMm});
    }
    if (rows.empty())
        throw Error(ErrorCode::Usage, estimates.name, "", "has none of the benchmark's frame pairs");
    return rows;
}

} // namespace core
