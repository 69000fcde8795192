// SPDX-License-Identifier: MIT
#include "core/rig/rig_clicks.h"

#include <map>
#include <set>
#include <utility>

#include "core/annotation/reconstruction.h"

namespace core {

void addRigJoints(std::vector<RigJoint>& joints, const AnnotationSet& set, const std::vector<Camera>& cameras,
                  int sequence, const std::string& rater) {
    std::map<std::string, int> cameraIndex;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        cameraIndex[cameras[i].name] = static_cast<int>(i);
    RigJoint current;
    const auto finish = [&] {
        if (current.clicks.size() >= 2)
            joints.push_back(current);
        current.clicks.clear();
    };
    for (const auto& [key, mark] : set.marks) {
        const auto camera = cameraIndex.find(key.camera);
        if (camera == cameraIndex.end() || (!rater.empty() && key.rater != rater) ||
            !isEvidenceIn(mark, cameras[static_cast<std::size_t>(camera->second)]))
            continue;
        if (current.frame != key.frame || current.rater != key.rater || current.joint != key.joint)
            finish();
        current.sequence = sequence;
        current.frame = key.frame;
        current.rater = key.rater;
        current.joint = key.joint;
        current.clicks.push_back({camera->second, mark.px});
    }
    finish();
}

int countFrames(const std::vector<RigJoint>& joints) {
    std::set<std::pair<int, int>> frames;
    for (const RigJoint& joint : joints)
        frames.emplace(joint.sequence, joint.frame);
    return static_cast<int>(frames.size());
}

} // namespace core
