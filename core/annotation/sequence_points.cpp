// SPDX-License-Identifier: MIT
#include "core/annotation/sequence_points.h"

namespace core {

SequencePoints sequencePoints(const AnnotationSet& set, const std::vector<Camera>& cameras, const std::string& rater,
                              const TriangulationOptions& options) {
    SequencePoints points;
    for (const int frame : annotatedFrames(set)) {
        for (auto& [id, joint] : reconstructFrame(set, cameras, frame, rater, {options, false, std::nullopt}))
            if (joint.hasPoint())
                points[frame].emplace(id, std::move(*joint.result.point));
    }
    return points;
}

std::map<JointId, Eigen::Vector3d> meanJointPoints(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                                   int frame, const ClickSigmas& sigmas) {
    std::map<JointId, std::vector<Eigen::Vector3d>> points;
    for (const std::string& rater : ratersOf(set, frame)) {
        const TriangulationOptions options = sigmas.optionsFor(rater);
        for (const auto& [joint, found] : reconstructFrame(set, cameras, frame, rater, {options, false, std::nullopt}))
            if (found.hasPoint())
                points[joint].push_back(found.result.point->pointInWorld);
    }
    std::map<JointId, Eigen::Vector3d> means;
    for (const auto& [joint, ofRaters] : points) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& point : ofRaters)
            sum += point;
        means[joint] = sum / static_cast<double>(ofRaters.size());
    }
    return means;
}

} // namespace core
