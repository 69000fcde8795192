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

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) {
        return *middle;
    }
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

} // namespace core
