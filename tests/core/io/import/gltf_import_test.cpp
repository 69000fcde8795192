// SPDX-License-Identifier: MIT
#include "core/io/import/gltf_import.h"

#include <fstream>
#include <functional>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/gltf_scene.h"
#include "tests/support/shapes/mesh_checks.h"
#include "tests/support/temporary_folder.h"

namespace {

using Eigen::Vector3d;
using nlohmann::json;
namespace fs = std::filesystem;

/// Two boxes, a palm (open at the wrist, corners split) and a finger that is shown bent by 90 degrees but bound
/// straight. The armature is turned by 90 degrees about x and lies at (0.5, 0.1, -0.2) m. The skin lists its joints in
/// another order than the tree.
fs::path handFile(core::Side side) {
    return fs::path(HANDLENS_TEST_DATA) / "gltf" / (std::string(core::sideName(side)) + "_hand.gltf");
}

core::Rig smallRig() {
    core::Rig rig;
    rig.forwardInJoint = {0, 0, -1};
    rig.dorsalInJoint = {0, 1, 0};
    rig.joints = {{"wrist", "", {}},
                  {"index_mcp", "wrist", {"no such node", "index_mcp"}},
                  {"index_pip", "index_mcp", {}},
                  {"little_mcp", "wrist", {"pinky_{side}"}}};
    rig.dofs = {{"index_mcp", "abduction", {0, 0, 1}, -20, 20}, {"index_pip", "flexion", {0, 1, 0}, -100, 10}};
    return rig;
}

/// The file's JSON after a change, written to a new file and read again; the error, or nothing.
std::optional<core::Error> errorAfter(const std::function<void(json&)>& change, const core::Rig& rig = smallRig()) {
    const test::TemporaryFolder folder;
    json value = core::readJsonFile(handFile(core::Side::Right));
    change(value);
    const fs::path file = folder / "changed.gltf";
    std::ofstream(file) << value;
    try {
        core::readGltfHand(file, rig, core::Side::Right);
    } catch (const core::Error& error) {
        EXPECT_EQ(error.file(), file.string());
        return error;
    }
    return std::nullopt;
}

std::string fieldAfter(const std::function<void(json&)>& change) {
    const auto error = errorAfter(change);
    return error ? error->field() : "no error";
}

std::string glbOf(const fs::path& file) {
    const core::GltfFile source = core::readGltfFile(file);
    json root = source.root;
    root["buffers"][0].erase("uri");
    std::string text = root.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string binary = source.buffers[0];
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t value) {
        std::string bytes;
        for (int k = 0; k < 4; ++k)
            bytes.push_back(static_cast<char>((value >> (8 * k)) & 0xFF));
        return bytes;
    };
    return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" + text +
           word(binary.size()) + std::string("BIN\0", 4) + binary;
}

TEST(GltfHand, PutsJointsWhereTheFileShowsThemInMillimetres) {
    const core::HandModel hand = core::readGltfHand(handFile(core::Side::Right), smallRig(), core::Side::Right);
    ASSERT_EQ(hand.skeleton.bones.size(), 4U);
    const auto place = [&](int b) { return hand.skeleton.bones[b].worldFromBoneAtRest.translation; };
    EXPECT_LT((place(0) - Vector3d(500, 100, -200)).norm(), 1e-2);
    EXPECT_LT((place(1) - Vector3d(590, 100, -180)).norm(), 1e-2);
    EXPECT_LT((place(2) - Vector3d(630, 100, -180)).norm(), 1e-2);
    EXPECT_LT((place(3) - Vector3d(580, 100, -230)).norm(), 1e-2);
    EXPECT_EQ(hand.skeleton.bones[2].parent, 1);
    EXPECT_NEAR(hand.skeleton.bones[1].lengthMm, 40, 1e-2);
}

TEST(GltfHand, JointFramesAreAnatomical) {
    const core::HandModel hand = core::readGltfHand(handFile(core::Side::Right), smallRig(), core::Side::Right);
    const Eigen::Matrix3d mcp = hand.skeleton.bones[1].worldFromBoneAtRest.rotation;
    EXPECT_LT((mcp.col(0) - Vector3d::UnitX()).norm(), 1e-5); // along the finger
    EXPECT_LT((mcp.col(2) + Vector3d::UnitY()).norm(), 1e-5); // the back looks to -y: the armature turned z there
    EXPECT_LT((mcp.col(1) - Vector3d::UnitZ()).norm(), 1e-5); // the thumb's side
    const Eigen::Matrix3d pip = hand.skeleton.bones[2].worldFromBoneAtRest.rotation;
    EXPECT_LT((pip.col(0) - Vector3d::UnitY()).norm(), 1e-5); // bent towards the palm
}

TEST(GltfHand, TheSurfaceIsThatOfTheShownPoseJoinedAndClosed) {
    const core::HandModel hand = core::readGltfHand(handFile(core::Side::Right), smallRig(), core::Side::Right);
    EXPECT_EQ(hand.mesh.vertices.size(), 8U + 1 + 12); // palm, its lid, finger
    EXPECT_EQ(hand.mesh.triangles.size(), 14U + 20);
    EXPECT_TRUE(test::isClosedAndOriented(hand.mesh));
    EXPECT_GT(core::signedVolume(hand.mesh), 90 * 80 * 24);
    Vector3d tip = Vector3d::Zero();
    int count = 0;
    for (const Vector3d& vertex : hand.mesh.vertices) {
        EXPECT_LT(vertex.norm(), 2000); // the mesh nodes' own places do not count
        if (vertex.y() > 125) {
            tip += vertex;
            ++count;
        }
    }
    ASSERT_EQ(count, 4);
    EXPECT_LT((tip / 4 - Vector3d(630, 130, -180)).norm(), 1e-2);
}

TEST(GltfHand, WeightsGoToTheRigsBones) {
    const core::HandModel hand = core::readGltfHand(handFile(core::Side::Right), smallRig(), core::Side::Right);
    for (int v = 0; v < static_cast<int>(hand.mesh.vertices.size()); ++v) {
        const int first = hand.weights.firstEntry[v];
        if (hand.mesh.vertices[v].y() > 125) {
            ASSERT_EQ(hand.weights.firstEntry[v + 1] - first, 1);
            EXPECT_EQ(hand.weights.entries[first].bone, 2);
        }
        if (std::abs(hand.mesh.vertices[v].y() - 100) < 13 && std::abs(hand.mesh.vertices[v].x() - 590) < 0.1 &&
            std::abs(hand.mesh.vertices[v].y() - 100) > 11) { // the palm's front corners: 3/4 wrist
            EXPECT_EQ(hand.weights.entries[first].bone, 0);
            EXPECT_NEAR(hand.weights.entries[first].weight, 0.75, 1e-6);
        }
    }
}

TEST(GltfHand, BendsAboutTheRigsAxes) {
    const core::HandModel hand = core::readGltfHand(handFile(core::Side::Right), smallRig(), core::Side::Right);
    core::Pose pose = hand.skeleton.restPose();
    ASSERT_EQ(hand.skeleton.dofs[1].name, "index_pip.flexion");
    pose[core::kRigidDofs + 1] = -std::numbers::pi / 2; // straight again
    Vector3d farthest = Vector3d::Zero();
    for (const Vector3d& vertex : core::posedVertices(hand, pose))
        farthest = vertex.x() > farthest.x() ? vertex : farthest;
    EXPECT_NEAR(farthest.x(), 660, 0.1);
    EXPECT_LT(std::abs(farthest.y() - 100), 8.1);
}

TEST(GltfHand, WeightsOfOtherJointsGoToTheJointAbove) {
    core::Rig rig = smallRig();
    rig.joints.erase(rig.joints.begin() + 2); // no pip
    rig.dofs.pop_back();
    const core::HandModel hand = core::readGltfHand(handFile(core::Side::Right), rig, core::Side::Right);
    for (int v = 0; v < static_cast<int>(hand.mesh.vertices.size()); ++v)
        if (hand.mesh.vertices[v].y() > 125)
            EXPECT_EQ(hand.weights.entries[hand.weights.firstEntry[v]].bone, 1); // the mcp
}

TEST(GltfHand, GlbReadsLikeGltf) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "hand.glb", std::ios::binary) << glbOf(handFile(core::Side::Left));
    const core::HandModel a = core::readGltfHand(handFile(core::Side::Left), smallRig(), core::Side::Left);
    const core::HandModel b = core::readGltfHand(folder / "hand.glb", smallRig(), core::Side::Left);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    for (std::size_t v = 0; v < a.mesh.vertices.size(); ++v)
        EXPECT_EQ(a.mesh.vertices[v], b.mesh.vertices[v]);
}

TEST(GltfHand, SaysWhichJointIsMissingAndWhichHandItIs) {
    core::Rig rig = smallRig();
    rig.joints[2].namesInFile = {"left_{side}_pip"};
    const auto missing = errorAfter([](json&) {}, rig);
    ASSERT_TRUE(missing);
    EXPECT_EQ(missing->field(), "joint index_pip");
    EXPECT_NE(missing->detail().find("left_right_pip"), std::string::npos);
    rig = smallRig();
    rig.joints[3].namesInFile = {"pinky_right"};
    EXPECT_THROW(core::readGltfHand(handFile(core::Side::Right), rig, core::Side::Left), core::Error);
    rig = smallRig();
    rig.forwardInJoint = {1, 0, 0};
    rig.dorsalInJoint = {0, 0, 1};
    const auto axes = errorAfter([](json&) {}, rig);
    ASSERT_TRUE(axes);
    EXPECT_EQ(axes->field(), "jointAxes");
}

TEST(GltfCheck, NamesTheFieldAtFault) {
    EXPECT_EQ(fieldAfter([](json&) {}), "no error");
    EXPECT_EQ(fieldAfter([](json& g) { g["asset"]["version"] = "1.0"; }), "asset.version");
    EXPECT_EQ(fieldAfter([](json& g) { g.erase("asset"); }), "asset.version");
    EXPECT_EQ(fieldAfter([](json& g) { g["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
              "extensionsRequired");
    EXPECT_EQ(fieldAfter([](json& g) { g["buffers"][0]["byteLength"] = 100000; }), "buffers[0].byteLength");
    EXPECT_EQ(fieldAfter([](json& g) { g["bufferViews"][1]["byteOffset"] = 100000; }), "bufferViews[1]");
    EXPECT_EQ(fieldAfter([](json& g) { g["accessors"][0]["count"] = 400; }), "accessors[0].count");
    EXPECT_EQ(fieldAfter([](json& g) { g["accessors"][2]["type"] = "VEC9"; }), "accessors[2].type");
    EXPECT_EQ(fieldAfter([](json& g) { g["accessors"][2]["componentType"] = 7; }), "accessors[2].componentType");
    EXPECT_EQ(fieldAfter([](json& g) { g["nodes"][3]["children"] = {0}; }), "nodes");
    EXPECT_EQ(fieldAfter([](json& g) { g["nodes"][3]["children"] = {2}; }), "nodes[3].children");
    EXPECT_EQ(fieldAfter([](json& g) { g["nodes"][3]["children"] = {77}; }), "nodes[3].children");
    EXPECT_EQ(fieldAfter([](json& g) { g["nodes"][5]["mesh"] = 7; }), "nodes[5].mesh");
    EXPECT_EQ(fieldAfter([](json& g) { g["nodes"][1]["rotation"] = {0, 1}; }), "nodes[1].rotation");
    EXPECT_EQ(fieldAfter([](json& g) {
                  g["skins"][0]["joints"] = {3, 1};
              }),
              "meshes[0].primitives[0].attributes.JOINTS_0");
    EXPECT_EQ(fieldAfter([](json& g) { g["skins"][0].erase("inverseBindMatrices"); }), "skins[0].inverseBindMatrices");
    EXPECT_EQ(fieldAfter([](json& g) { g["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }),
              "meshes[0].primitives[0].attributes");
    EXPECT_EQ(fieldAfter([](json& g) { g["meshes"][0]["primitives"][0]["indices"] = 7; }),
              "meshes[0].primitives[0].indices"); // the finger's: they go beyond the palm's vertices
    EXPECT_EQ(fieldAfter([](json& g) { g["nodes"][5].erase("skin"), g["nodes"][6].erase("skin"); }), "skins");
    EXPECT_EQ(fieldAfter([](json& g) { g["meshes"] = 3; }), "meshes");
}

TEST(GltfCheck, CutOffAndGarbledFilesNeverCrashTheReader) {
    const test::TemporaryFolder folder;
    const std::string whole = glbOf(handFile(core::Side::Right));
    const fs::path file = folder / "bad.glb";
    for (std::size_t length = 0; length < whole.size(); length += whole.size() / 40) {
        std::ofstream(file, std::ios::binary) << whole.substr(0, length);
        EXPECT_THROW(core::readGltfHand(file, smallRig(), core::Side::Right), core::Error) << length;
    }
    std::mt19937 random(7);
    int refused = 0;
    for (int trial = 0; trial < 300; ++trial) {
        std::string garbled = whole;
        for (int k = 0; k < 3; ++k)
            garbled[random() % garbled.size()] = static_cast<char>(random() & 0xFF);
        std::ofstream(file, std::ios::binary) << garbled;
        try {
            core::readGltfHand(file, smallRig(), core::Side::Right);
        } catch (const core::Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);
}

TEST(GltfCheck, OtherFilesAreRefused) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(core::readGltfHand(folder / "none.glb", smallRig(), core::Side::Left), core::Error);
    std::ofstream(folder / "empty.gltf") << "";
    EXPECT_THROW(core::readGltfHand(folder / "empty.gltf", smallRig(), core::Side::Left), core::Error);
    fs::copy_file(handFile(core::Side::Left), folder / "hand.json");
    EXPECT_THROW(core::readGltfHand(folder / "hand.json", smallRig(), core::Side::Left), core::Error);
}

TEST(ImportGltf, WithoutTheDemosJointsThereIsOneRestFrameSideBySide) {
    const core::NewDataset imported =
        core::importGltf(handFile(core::Side::Left), handFile(core::Side::Right), smallRig());
    ASSERT_EQ(imported.dataset.sequences.size(), 1U);
    EXPECT_EQ(imported.dataset.sequences[0].name, "rest");
    EXPECT_EQ(imported.dataset.sequences[0].frameCount, 1);
    EXPECT_EQ(imported.dataset.cameras.size(), 8U);
    const core::HandPoses& poses = imported.motions[0][0];
    const Vector3d left = core::jointPositions(imported.dataset.hands[0].skeleton, poses[0])[0];
    const Vector3d right = core::jointPositions(imported.dataset.hands[1].skeleton, poses[1])[0];
    EXPECT_NEAR(right.x() - left.x(), 220, 1e-6);
    const test::TemporaryFolder folder;
    core::writeDataset(imported.dataset, imported.motions, folder / "out");
    EXPECT_EQ(core::readDataset(folder / "out").hands[0].mesh.vertices.size(), 21U);
}

} // namespace
