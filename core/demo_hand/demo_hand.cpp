// SPDX-License-Identifier: MIT
#include "core/demo_hand/demo_hand.h"

#include <map>

#include "core/demo_hand/demo_hand_solid.h"
#include "core/demo_hand/demo_skinning.h"
#include "core/demo_hand/implicit_surface.h"
#include "core/demo_hand/remeshing.h"

namespace core {

namespace {

/// Anatomical frames of all joints at rest, parallel to rig.joints.
std::vector<RigidMotion> restFrames(const DemoHandShape& shape, const Rig& rig) {
    std::map<std::string, RigidMotion> frames;
    frames["wrist"] = RigidMotion{};
    for (const RayShape& ray : shape.rays) {
        const std::vector<std::string> names = rayJointNames(ray);
        for (std::size_t j = 0; j < names.size(); ++j) {
            const std::size_t from = std::min(j, names.size() - 2);
            frames[names[j]] = anatomicalFrame(ray.joints[j], ray.joints[from + 1] - ray.joints[from], ray.dorsal);
        }
    }
    std::vector<RigidMotion> result;
    for (const RigJoint& joint : rig.joints)
        result.push_back(frames.at(joint.name));
    return result;
}

} // namespace

HandModel makeDemoHand(const DemoHandShape& shape, const Rig& rig) {
    const DemoHandSolid solid(shape);
    const SolidField field = [&solid](const Eigen::Vector3d& point) { return solid.distance(point); };
    HandModel hand;
    hand.side = Side::Right;
    hand.skeleton = riggedSkeleton(rig, hand.side, restFrames(shape, rig));
    const EdgeLengthField edgeLength = [&solid](const Eigen::Vector3d& point) { return solid.edgeLengthMm(point); };
    const Eigen::Vector3d wrist = Eigen::Vector3d::Zero();
    const TriangleMesh fine = polygonise(field, solid.bounds(), shape.gridStepMm, wrist);
    hand.mesh = remeshed(field, fine, edgeLength, shape.relaxations);
    hand.weights = demoSkinWeights(shape, solid, hand.skeleton, hand.mesh);
    return hand;
}

HandModel mirroredHand(const HandModel& hand) {
    const Eigen::Vector3d flip(1, -1, 1);
    HandModel mirrored = hand;
    mirrored.side = hand.side == Side::Left ? Side::Right : Side::Left;
    for (Eigen::Vector3d& vertex : mirrored.mesh.vertices)
        vertex = vertex.cwiseProduct(flip);
    for (auto& triangle : mirrored.mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    mirrored.skeleton.centreAtRest = hand.skeleton.centreAtRest.cwiseProduct(flip);
    for (Bone& bone : mirrored.skeleton.bones) {
        RigidMotion& frame = bone.worldFromBoneAtRest;
        frame.rotation = flip.asDiagonal() * frame.rotation * flip.asDiagonal();
        frame.translation = frame.translation.cwiseProduct(flip);
    }
    for (DegreeOfFreedom& dof : mirrored.skeleton.dofs)
        dof.axisInBone = -dof.axisInBone.cwiseProduct(flip);
    return mirrored;
}

} // namespace core
