// SPDX-License-Identifier: MIT
#include "core/io/benchmark/benchmark_scene.h"

#include <filesystem>

#include "core/annotation/sequence_points.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/dataset/frames.h"

namespace core {

namespace fs = std::filesystem;

namespace {

std::vector<const Sequence*> chosenSequences(const Dataset& dataset, const std::vector<std::string>& names) {
    std::vector<const Sequence*> chosen;
    for (const std::string& name : names)
        chosen.push_back(&dataset.sequence(name));
    if (names.empty()) {
        for (const Sequence& sequence : dataset.sequences)
            if (!sequence.motion.empty())
                chosen.push_back(&sequence);
    }
    return chosen;
}

[[noreturn]] void throwLacks(const Dataset& dataset, const Sequence& sequence, const std::string& what) {
    throw Error(ErrorCode::NotFound, dataset.folder.string(), "sequence " + sequence.name, what);
}

std::map<int, JointPositions> readAnnotatedJoints(const Dataset& dataset, const Sequence& sequence,
                                                  const ClickSigmas& sigmas) {
    std::map<int, JointPositions> joints;
    const AnnotationSet annotations = readAnnotations(dataset, sequence);
    for (const int frame : annotatedFrames(annotations)) {
        JointPositions found = meanJointPoints(annotations, dataset.cameras, frame, sigmas);
        if (!found.empty())
            joints.emplace(frame, std::move(found));
    }
    return joints;
}

void addRealisticParts(const Dataset& dataset, const Sequence& sequence, const ClickSigmas& sigmas,
                       BenchmarkSequence& result) {
    if (!hasMasks(sequence))
        throwLacks(dataset, sequence, "has no masks, which the realistic setup takes its silhouettes from");
    result.masks = [folder = dataset.folder, sequence, cameras = dataset.cameras](int frame) {
        return readFrameMasks(folder, sequence, cameras, frame);
    };
    result.annotatedJoints = readAnnotatedJoints(dataset, sequence, sigmas);
    if (result.annotatedJoints.empty())
        throwLacks(dataset, sequence, "has no annotated 3D joints, which the realistic setup measures errors against");
}

} // namespace

BenchmarkScene readBenchmarkScene(const Dataset& dataset, const std::vector<std::string>& sequences,
                                  BenchmarkSetup setup) {
    BenchmarkScene scene{dataset.hands, dataset.cameras, {}};
    const ClickSigmas sigmas = setup == BenchmarkSetup::Realistic ? datasetClickSigmas(dataset) : ClickSigmas{};
    for (const Sequence* sequence : chosenSequences(dataset, sequences)) {
        BenchmarkSequence result{sequence->name, readMotion(dataset, *sequence), {}, {}};
        if (result.motion.empty())
            throwLacks(dataset, *sequence, "has no recorded motion to take start poses from");
        if (setup == BenchmarkSetup::Realistic)
            addRealisticParts(dataset, *sequence, sigmas, result);
        scene.sequences.push_back(std::move(result));
    }
    if (scene.sequences.empty())
        throw Error(ErrorCode::NotFound, dataset.folder.string(), "sequences", "none has a recorded motion");
    return scene;
}

} // namespace core
