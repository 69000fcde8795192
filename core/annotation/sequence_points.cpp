// SPDX-License-Identifier: MIT
#include "core/annotation/sequence_points.h"

#include <algorithm>

namespace core {

SequencePoints sequencePoints(const AnnotationSet& set, const std::vector<Camera>& cameras, const std::string& rater,
                              const TriangulationOptions& options) {
    SequencePoints points;
    for (const int frame : annotatedFrames(set)) {
        for (auto& [id, joint] : reconstructFrame(set, cameras, frame, rater, {options, false, std::nullopt})) {
            if (joint.hasPoint()) {
                points[frame].emplace(id, std::move(*joint.result.point));
            }
        }
    }
    return points;
}

std::map<JointId, Eigen::Vector3d> meanJointPoints(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                                                   const TriangulationOptions& options) {
    std::map<JointId, std::vector<Eigen::Vector3d>> points;
    for (const std::string& rater : ratersOf(set, frame)) {
        for (const auto& [joint, found] : reconstructFrame(set, cameras, frame, rater, {options, false, std::nullopt})) {
            if (found.hasPoint()) {
                points[joint].push_back(found.result.point->pointInWorld);
            }
        }
    }
    std::map<JointId, Eigen::Vector3d> means;
    for (const auto& [joint, ofRaters] : points) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& point : ofRaters) {
            sum += point;
        }
        means[joint] = sum / static_cast<double>(ofRaters.size());
    }
    return means;
}

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) {
        return *middle;
    }
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

} // namespace core
