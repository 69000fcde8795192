// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/annotation/quality.h"
#include "core/annotation/sequence_points.h"
#include "core/hand/hand_model.h"

namespace core {

/// The findings about one rater's annotations of a sequence, kept up to date frame by frame: a frame is looked at again
/// when its marks have changed, and everything that depends on other frames (bone lengths, exchanged hands) is computed
/// again from the points that are known. A value: copy it to look at a state from another thread.
class QualityChecker {
public:
    /// Angles are checked only with `hands`.
    QualityChecker(std::vector<Camera> cameras, std::vector<HandModel> hands, std::string rater,
                   QualityOptions options = {});

    /// Looks at the marks of one frame.
    void check(const AnnotationSet& set, int frame);
    /// The findings about all frames looked at, by frame.
    std::vector<QualityFinding> findings() const;
    const SequencePoints& points() const { return m_points; }

private:
    std::vector<Camera> m_cameras;
    std::vector<HandModel> m_hands;
    std::string m_rater;
    QualityOptions m_options;
    SequencePoints m_points;
    std::map<int, std::vector<QualityFinding>> m_markFindings; ///< what a frame's own marks say
};

/// The findings about all frames of a sequence, by frame.
std::vector<QualityFinding> checkSequence(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                          const std::string& rater, const std::vector<HandModel>& hands,
                                          const QualityOptions& options = {});

} // namespace core
