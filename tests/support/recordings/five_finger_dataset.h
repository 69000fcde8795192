// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "core/annotation/edits.h"
#include "core/annotation/import_edit.h"
#include "core/io/dataset/dataset.h"
#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"
#include "tests/support/five_finger_skeleton.h"
#include "widgets/document/annotation_document.h"

namespace test {

/// Both hands as skeletons without a surface, and a ring of 8 cameras.
inline std::shared_ptr<const core::Dataset> fiveFingerDataset() {
    auto dataset = std::make_shared<core::Dataset>();
    dataset->name = "five fingers";
    dataset->cameras = cameraRing(8);
    for (const core::Side side : {core::Side::Left, core::Side::Right}) {
        core::HandModel hand;
        hand.side = side;
        hand.skeleton = fiveFingerSkeleton(side);
        dataset->hands.push_back(hand);
    }
    return dataset;
}

/// Joints of both hands, side by side and slightly bent.
inline std::map<core::JointId, Eigen::Vector3d> fiveFingerJoints(const core::Dataset& dataset, double bendRad) {
    std::map<core::JointId, Eigen::Vector3d> joints;
    for (const core::HandModel& hand : dataset.hands) {
        core::Pose pose = curledPose(hand.skeleton, bendRad);
        pose.head<3>() = Eigen::Vector3d(-80, hand.side == core::Side::Left ? 70 : -70, 0);
        const auto points = core::jointPositions(hand.skeleton, pose);
        for (std::size_t bone = 0; bone < points.size(); ++bone)
            joints[{hand.side, hand.skeleton.bones[bone].name}] = points[bone];
    }
    return joints;
}

/// One edit that marks these joints in every camera that sees them.
inline core::Edit clicksEdit(const core::Dataset& dataset, int frame, const std::string& rater,
                             const std::map<core::JointId, Eigen::Vector3d>& joints, double sigmaPx = 0,
                             std::mt19937_64* random = nullptr) {
    core::AnnotationSet set;
    for (const auto& [joint, point] : joints)
        clickEverywhere(set, dataset.cameras, frame, rater, joint, point, sigmaPx, random);
    return core::importEdit({}, set, "clicks");
}

} // namespace test
