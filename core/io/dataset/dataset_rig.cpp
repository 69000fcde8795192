// SPDX-License-Identifier: MIT
#include "core/io/dataset/dataset_rig.h"

#include <algorithm>

#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/rig/rig_findings.h"

namespace core {

std::vector<RigJoint> readRigJoints(const Dataset& dataset, const std::vector<std::string>& sequences,
                                    const std::string& rater) {
    std::vector<RigJoint> joints;
    for (const std::string& name : sequences)
        dataset.sequence(name); // an unknown one is an error
    bool isRaterKnown = rater.empty();
    for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
        const Sequence& sequence = dataset.sequences[s];
        if (!sequences.empty() && std::find(sequences.begin(), sequences.end(), sequence.name) == sequences.end())
            continue;
        const AnnotationSet set = readAnnotations(dataset, sequence);
        if (!isRaterKnown) {
            const std::vector<std::string> raters = ratersOf(set);
            isRaterKnown = std::find(raters.begin(), raters.end(), rater) != raters.end();
        }
        addRigJoints(joints, set, dataset.cameras, static_cast<int>(s), rater);
    }
    if (!isRaterKnown) {
        throw Error(ErrorCode::NotFound, dataset.folder.string(), "rater",
                    "\"" + rater + "\" has marked nothing in these sequences");
    }
    return joints;
}

std::vector<std::string> sequenceNames(const Dataset& dataset) {
    std::vector<std::string> names;
    for (const Sequence& sequence : dataset.sequences)
        names.push_back(sequence.name);
    return names;
}

ClickSigmas datasetClickSigmas(const Dataset& dataset) {
    std::vector<RigJoint> joints;
    for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
        try {
            addRigJoints(joints, readAnnotations(dataset, dataset.sequences[s]), dataset.cameras, static_cast<int>(s));
        } catch (const Error&) { // reported where that sequence is read; the clicks of the others are enough
            continue;
        }
    }
    return estimateClickSigmas(dataset.cameras, joints);
}

std::vector<std::string> datasetRigFindings(const Dataset& dataset) {
    return rigFindings(judgeRig(dataset.cameras, readRigJoints(dataset)), sequenceNames(dataset));
}

} // namespace core
