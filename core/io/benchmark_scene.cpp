// SPDX-License-Identifier: MIT
#include "core/io/benchmark_scene.h"

#include <filesystem>

#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/dataset_annotations.h"
#include "core/io/frames.h"
#include "core/io/image_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

std::vector<const Sequence*> chosenSequences(const Dataset& dataset, const std::vector<std::string>& names) {
    std::vector<const Sequence*> chosen;
    for (const std::string& name : names) {
        chosen.push_back(&dataset.sequence(name));
    }
    if (names.empty()) {
        for (const Sequence& sequence : dataset.sequences) {
            if (!sequence.motion.empty()) {
                chosen.push_back(&sequence);
            }
        }
    }
    return chosen;
}

[[noreturn]] void throwLacks(const Dataset& dataset, const Sequence& sequence, const std::string& what) {
    throw Error(ErrorCode::NotFound, dataset.folder.string(), "sequence " + sequence.name, what);
}

/// Silhouettes of a frame from the sequence's mask files; a camera without a file is left out.
std::vector<cv::Mat> readMasks(const fs::path& folder, const std::string& pattern, const std::vector<Camera>& cameras,
                               int frame) {
    std::vector<cv::Mat> masks;
    for (const Camera& camera : cameras) {
        const fs::path file = folder / fillPattern(pattern, camera.name, frame);
        masks.push_back(fs::exists(file) ? readMask(file) : cv::Mat());
    }
    return masks;
}

/// The 3D joints that a frame's marks give: the mean over its raters.
JointPositions annotatedJointsOf(const AnnotationSet& annotations, const std::vector<Camera>& cameras, int frame) {
    ReconstructionOptions options;
    options.details = false;
    std::map<JointId, std::vector<Eigen::Vector3d>> points;
    for (const std::string& rater : ratersOf(annotations, frame)) {
        for (const auto& [joint, found] : reconstructFrame(annotations, cameras, frame, rater, options)) {
            if (found.hasPoint()) {
                points[joint].push_back(found.result.point->pointInWorld);
            }
        }
    }
    JointPositions joints;
    for (const auto& [joint, raters] : points) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& point : raters) {
            sum += point;
        }
        joints[joint] = sum / static_cast<double>(raters.size());
    }
    return joints;
}

std::map<int, JointPositions> readAnnotatedJoints(const Dataset& dataset, const Sequence& sequence) {
    std::map<int, JointPositions> joints;
    const AnnotationSet annotations = readAnnotations(dataset, sequence);
    for (const int frame : annotatedFrames(annotations)) {
        JointPositions found = annotatedJointsOf(annotations, dataset.cameras, frame);
        if (!found.empty()) {
            joints.emplace(frame, std::move(found));
        }
    }
    return joints;
}

void addRealisticParts(const Dataset& dataset, const Sequence& sequence, BenchmarkSequence& result) {
    if (sequence.masks.empty()) {
        throwLacks(dataset, sequence, "has no masks, which the realistic setup takes its silhouettes from");
    }
    result.masks = [folder = dataset.folder, pattern = sequence.masks, cameras = dataset.cameras](int frame) {
        return readMasks(folder, pattern, cameras, frame);
    };
    result.annotatedJoints = readAnnotatedJoints(dataset, sequence);
    if (result.annotatedJoints.empty()) {
        throwLacks(dataset, sequence, "has no annotated 3D joints, which the realistic setup measures errors against");
    }
}

} // namespace

BenchmarkScene readBenchmarkScene(const Dataset& dataset, const std::vector<std::string>& sequences,
                                  BenchmarkSetup setup) {
    BenchmarkScene scene{dataset.hands, dataset.cameras, {}};
    for (const Sequence* sequence : chosenSequences(dataset, sequences)) {
        BenchmarkSequence result{sequence->name, readMotion(dataset, *sequence), {}, {}};
        if (result.motion.empty()) {
            throwLacks(dataset, *sequence, "has no recorded motion to take start poses from");
        }
        if (setup == BenchmarkSetup::Realistic) {
            addRealisticParts(dataset, *sequence, result);
        }
        scene.sequences.push_back(std::move(result));
    }
    if (scene.sequences.empty()) {
        throw Error(ErrorCode::NotFound, dataset.folder.string(), "sequences", "none has a recorded motion");
    }
    return scene;
}

} // namespace core
