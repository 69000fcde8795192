// SPDX-License-Identifier: MIT
#include "core/io/import/gltf_import.h"

#include <algorithm>
#include <cmath>

#include "core/demo_hand/choreography.h"
#include "core/error.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/hands/hand_file.h"
#include "core/io/hands/rig_file.h"
#include "core/io/import/gltf_scene.h"

namespace core {

namespace {

constexpr int kMaxBones = 8;
constexpr double kLeastWeight = 1e-3;

std::string withSide(std::string name, Side side) {
    const std::string placeholder = "{side}";
    for (std::size_t at = name.find(placeholder); at != std::string::npos; at = name.find(placeholder))
        name.replace(at, placeholder.size(), sideName(side));
    return name;
}

/// Builds one hand from a scene.
class GltfHandBuilder {
public:
    GltfHandBuilder(const GltfScene& scene, const Rig& rig, Side side, std::string file)
        : m_scene(scene)
        , m_rig(rig)
        , m_side(side)
        , m_file(std::move(file)) {}

    HandModel build() {
        for (const RigJoint& joint : m_rig.joints)
            m_nodeOfJoint.push_back(nodeOf(joint));
        HandModel hand;
        hand.side = m_side;
        hand.skeleton = riggedSkeleton(m_rig, m_side, jointFrames());
        checkAxes(hand.skeleton);
        checkSide(hand.skeleton);
        const WeightedSurface surface = withHolesClosed(welded(handSurface()));
        if (surface.mesh.triangles.empty())
            throw bad("skins", "no part of the surface hangs on the rig's joints");
        hand.mesh = surface.mesh;
        hand.weights = compressedWeights(surface.weights, kMaxBones, kLeastWeight);
        checkHandModel(hand, m_file);
        return hand;
    }

private:
    Error bad(const std::string& field, const std::string& detail) const {
        return {ErrorCode::BadInput, m_file, field, detail};
    }

    int nodeOf(const RigJoint& joint) const {
        const std::vector<std::string> names =
            joint.namesInFile.empty() ? std::vector<std::string>{joint.name} : joint.namesInFile;
        for (const std::string& name : names) {
            for (std::size_t n = 0; n < m_scene.nodes.size(); ++n)
                if (m_scene.nodes[n].name == withSide(name, m_side))
                    return static_cast<int>(n);
        }
        throw bad("joint " + joint.name, "no node is named '" + withSide(names.front(), m_side) + "'");
    }

    std::vector<RigidMotion> jointFrames() const {
        std::vector<RigidMotion> frames;
        for (std::size_t j = 0; j < m_rig.joints.size(); ++j) {
            const Eigen::Affine3d& world = m_scene.nodes[static_cast<std::size_t>(m_nodeOfJoint[j])].worldFromNode;
            if (!world.matrix().allFinite() || !(std::abs(world.linear().determinant()) > 1e-12))
                throw bad("joint " + m_rig.joints[j].name, "its place in the scene is degenerate");
            frames.push_back(anatomicalFrame(world.translation(), world.linear() * m_rig.forwardInJoint,
                                             world.linear() * m_rig.dorsalInJoint));
        }
        return frames;
    }

    /// The bones of fingers must point to their children: else the rig's joint axes are those of another kind of file.
    void checkAxes(const Skeleton& skeleton) const {
        constexpr double kLeastCosine = 0.5;
        int along = 0, bones = 0;
        for (const Bone& bone : skeleton.bones) {
            if (bone.parent > 0) {
                const RigidMotion& parent = skeleton.bones[static_cast<std::size_t>(bone.parent)].worldFromBoneAtRest;
                const Eigen::Vector3d toChild =
                    (bone.worldFromBoneAtRest.translation - parent.translation).normalized();
                along += toChild.dot(parent.rotation.col(0)) > kLeastCosine ? 1 : 0;
                ++bones;
            }
        }
        if (2 * along < bones)
            throw bad("jointAxes", "the rig's forward direction does not point along the bones of this file");
    }

    void checkSide(const Skeleton& skeleton) const {
        const int index = skeleton.boneIndex("index_mcp"), little = skeleton.boneIndex("little_mcp");
        if (index < 0 || little < 0)
            return;
        const auto place = [&](int b) { return skeleton.bones[static_cast<std::size_t>(b)].worldFromBoneAtRest; };
        const double across = (place(index).translation - place(little).translation).dot(place(index).rotation.col(1));
        if ((across > 0) != (m_side == Side::Right)) {
            throw bad("", "this is the other hand, not the " + std::string(sideName(m_side)) +
                              " one, or the rig's dorsal direction is wrong");
        }
    }

    /// The rig's bone that a node's weights go to, or -1.
    int boneOfNode(int node) const {
        for (int n = node; n >= 0; n = m_scene.nodes[static_cast<std::size_t>(n)].parent) {
            const auto joint = std::find(m_nodeOfJoint.begin(), m_nodeOfJoint.end(), n);
            if (joint != m_nodeOfJoint.end())
                return static_cast<int>(joint - m_nodeOfJoint.begin());
        }
        // Above the rig's root, such as a forearm: it moves with the root.
        for (int n = m_nodeOfJoint.front(); n >= 0; n = m_scene.nodes[static_cast<std::size_t>(n)].parent)
            if (n == node)
                return 0;
        return -1;
    }

    /// The part of the surface that hangs on the rig's joints, weights by bone.
    WeightedSurface handSurface() const {
        std::vector<int> boneOf;
        for (std::size_t n = 0; n < m_scene.nodes.size(); ++n)
            boneOf.push_back(boneOfNode(static_cast<int>(n)));
        const WeightedSurface& source = m_scene.surface;
        WeightedSurface result{source.mesh, {{0}, {}}};
        std::vector<bool> belongs;
        for (std::size_t v = 0; v < source.mesh.vertices.size(); ++v) {
            std::vector<double> ofBone(m_rig.joints.size(), 0);
            double sum = 0;
            for (int e = source.weights.firstEntry[v]; e < source.weights.firstEntry[v + 1]; ++e) {
                const int bone =
                    boneOf[static_cast<std::size_t>(source.weights.entries[static_cast<std::size_t>(e)].bone)];
                if (bone >= 0) {
                    ofBone[static_cast<std::size_t>(bone)] +=
                        source.weights.entries[static_cast<std::size_t>(e)].weight;
                    sum += source.weights.entries[static_cast<std::size_t>(e)].weight;
                }
            }
            belongs.push_back(sum > 0.5);
            for (std::size_t b = 0; b < ofBone.size(); ++b)
                if (ofBone[b] > 0)
                    result.weights.entries.push_back({static_cast<int>(b), ofBone[b] / sum});
            result.weights.firstEntry.push_back(static_cast<int>(result.weights.entries.size()));
        }
        std::erase_if(result.mesh.triangles, [&](const std::array<int, 3>& t) {
            return !std::all_of(t.begin(), t.end(), [&](int v) { return belongs[static_cast<std::size_t>(v)]; });
        });
        return result;
    }

    const GltfScene& m_scene;
    const Rig& m_rig;
    Side m_side;
    std::string m_file;
    std::vector<int> m_nodeOfJoint;
};

/// Both hands upright, backs to the onlooker, 220 mm apart.
Choreography restChoreography(const std::vector<HandModel>& hands) {
    Choreography rest{"rest", 1, {}, {}, std::nullopt};
    for (const HandModel& hand : hands) {
        const double x = hand.side == Side::Left ? -110 : 110;
        const RigidMotion frame = anatomicalFrame({x, 90, 0}, {0, -1, 0}, {0, 0, -1});
        rest.keys.push_back({{0, frame.translation, Eigen::Quaterniond(frame.rotation),
                              Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hand.skeleton.dofs.size()))}});
    }
    return rest;
}

void clampToLimits(Choreography& choreography, const std::vector<HandModel>& hands) {
    for (std::size_t h = 0; h < hands.size(); ++h) {
        for (HandKey& key : choreography.keys[h]) {
            for (Eigen::Index d = 0; d < key.anglesRad.size(); ++d) {
                const DegreeOfFreedom& dof = hands[h].skeleton.dofs[static_cast<std::size_t>(d)];
                key.anglesRad[d] = std::clamp(key.anglesRad[d], dof.minRad, dof.maxRad);
            }
        }
    }
}

bool hasDofsOf(const Rig& rig, const Rig& other) {
    return std::all_of(
        other.dofs.begin(), other.dofs.end(),
        [&](const RigDof& wanted) {
            return std::any_of(
                rig.dofs.begin(), rig.dofs.end(),
                [&](const RigDof& dof) { return dof.joint == wanted.joint && dof.name == wanted.name; });
        });
}

} // namespace

HandModel readGltfHand(const std::filesystem::path& file, const Rig& rig, Side side) {
    const GltfScene scene = readGltfScene(file);
    return GltfHandBuilder(scene, rig, side, file.string()).build();
}

NewDataset importGltf(const std::filesystem::path& left, const std::filesystem::path& right, const Rig& rig) {
    std::vector<HandModel> hands{readGltfHand(left, rig, Side::Left), readGltfHand(right, rig, Side::Right)};
    std::vector<Choreography> choreographies{restChoreography(hands)};
    if (hasDofsOf(rig, defaultRig("handlens"))) {
        for (Choreography& choreography : demoChoreographies(hands)) {
            clampToLimits(choreography, hands);
            choreographies.push_back(std::move(choreography));
        }
    }
    return playedDataset(hands, choreographies);
}

} // namespace core
