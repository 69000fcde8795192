// SPDX-License-Identifier: MIT
#include "core/io/hands/hand_file.h"

#include <gtest/gtest.h>

#include "tests/support/expect_error.h"
#include "tests/support/small_hand.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::replaced;

class HandFile : public testing::Test {
protected:
    HandFile() { core::writeHandModel(m_file, test::smallHand(core::Side::Right)); }

    void expectRefused(const std::string& text, const std::string& field, const std::string& word) {
        test::writeText(m_file, text);
        test::expectError([&] { core::readHandModel(m_file); }, core::ErrorCode::BadInput,
                          m_file.string() + ": " + field, word);
    }

    test::TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "hand.json";
};

TEST_F(HandFile, ReadsBackExactlyWhatWasWritten) {
    const core::HandModel hand = test::smallHand(core::Side::Right), read = core::readHandModel(m_file);
    EXPECT_EQ(read.side, hand.side);
    EXPECT_EQ(read.mesh.vertices, hand.mesh.vertices);
    EXPECT_EQ(read.mesh.triangles, hand.mesh.triangles);
    EXPECT_EQ(read.weights.firstEntry, hand.weights.firstEntry);
    ASSERT_EQ(read.weights.entries.size(), hand.weights.entries.size());
    for (std::size_t i = 0; i < hand.weights.entries.size(); ++i) {
        EXPECT_EQ(read.weights.entries[i].bone, hand.weights.entries[i].bone);
        EXPECT_EQ(read.weights.entries[i].weight, hand.weights.entries[i].weight);
    }
    ASSERT_EQ(read.skeleton.bones.size(), hand.skeleton.bones.size());
    for (std::size_t b = 0; b < hand.skeleton.bones.size(); ++b) {
        EXPECT_EQ(read.skeleton.bones[b].name, hand.skeleton.bones[b].name);
        EXPECT_EQ(read.skeleton.bones[b].parent, hand.skeleton.bones[b].parent);
        EXPECT_EQ(read.skeleton.bones[b].lengthMm, hand.skeleton.bones[b].lengthMm);
        EXPECT_EQ(read.skeleton.bones[b].worldFromBoneAtRest.rotation,
                  hand.skeleton.bones[b].worldFromBoneAtRest.rotation);
        EXPECT_EQ(read.skeleton.bones[b].worldFromBoneAtRest.translation,
                  hand.skeleton.bones[b].worldFromBoneAtRest.translation);
    }
    ASSERT_EQ(read.skeleton.dofs.size(), hand.skeleton.dofs.size());
    for (std::size_t d = 0; d < hand.skeleton.dofs.size(); ++d) {
        EXPECT_EQ(read.skeleton.dofs[d].name, hand.skeleton.dofs[d].name);
        EXPECT_EQ(read.skeleton.dofs[d].bone, hand.skeleton.dofs[d].bone);
        EXPECT_EQ(read.skeleton.dofs[d].axisInBone, hand.skeleton.dofs[d].axisInBone);
        EXPECT_EQ(read.skeleton.dofs[d].minRad, hand.skeleton.dofs[d].minRad);
        EXPECT_EQ(read.skeleton.dofs[d].maxRad, hand.skeleton.dofs[d].maxRad);
    }
    EXPECT_EQ(read.skeleton.centreAtRest, hand.skeleton.centreAtRest);
}

TEST_F(HandFile, RefusesBrokenSkeletons) {
    const std::string good = test::readText(m_file);
    std::string twice = replaced(good, "\"index_pip\"", "\"index_mcp\"");
    expectRefused(replaced(twice, "\"bone\": \"index_pip\"", "\"bone\": \"index_mcp\""), "bones[2].name", "twice");
    expectRefused(replaced(good, "\"parent\": \"forearm\"", "\"parent\": \"elbow\""), "bones[1].parent",
                  "unknown bone \"elbow\"");
    expectRefused(replaced(good, "\"parent\": \"forearm\"", "\"parent\": null"), "bones[1].parent", "root");
    expectRefused(replaced(good, "\"rotation\": [[", "\"rotation\": [[-"), "bones[0].rotation", "not a rotation");
    expectRefused(replaced(good, "\"axis\": [0.0,1.0", "\"axis\": [0.0,2.0"), "dofs[0].axis", "unit");
    expectRefused(replaced(good, "\"minRad\": -1.5", "\"minRad\": 1.5"), "dofs[0].minRad", "larger");
    expectRefused(replaced(good, "\"bone\": \"index_mcp\"", "\"bone\": \"forearm\""), "dofs[0].bone", "root");
    expectRefused(replaced(good, "\"side\": \"right\"", "\"side\": \"middle\""), "side", "");
}

TEST_F(HandFile, RefusesBrokenSurfaces) {
    const std::string good = test::readText(m_file);
    expectRefused(replaced(good, "120.1", "null"), "vertices[3]", "finite");
    expectRefused(replaced(good, "\"vertices\": [", "\"vertices\": [1,"), "vertices", "three numbers");
    expectRefused(replaced(good, "\"triangles\": [0,2,1", "\"triangles\": [0,2,8"), "triangles[2]", "from 0 to 7");
    expectRefused(replaced(good, "\"triangles\": [0,2,1", "\"triangles\": [0,2,-1"), "triangles[2]", "from 0 to 7");
    expectRefused(replaced(good, "\"triangles\": [0,2,1", "\"triangles\": [0,2,2"), "triangles[0]",
                  "different vertices");
    expectRefused(replaced(good, "\"triangles\": [0,", "\"triangles\": ["), "triangles", "three indices");
}

TEST_F(HandFile, RefusesBrokenWeights) {
    const std::string good = test::readText(m_file);
    expectRefused(replaced(good, "\"values\": [1.0", "\"values\": [0.9"), "weights of vertex 0", "sum to 0.9");
    expectRefused(replaced(good, "\"values\": [1.0", "\"values\": [\"a\""), "weights.values[0]", "finite");
    expectRefused(replaced(good, "\"counts\": [1", "\"counts\": [0"), "weights.counts[0]", "from 1");
    expectRefused(replaced(good, "\"counts\": [1", "\"counts\": [2"), "weights.bones", "numbers");
    expectRefused(replaced(good, "\"counts\": [1,", "\"counts\": ["), "weights.counts", "8 numbers");
    std::string weights = good.substr(good.find("\"weights\""));
    expectRefused(good.substr(0, good.size() - weights.size()) + replaced(weights, "\"bones\": [0", "\"bones\": [3"),
                  "weights.bones[0]", "0 to 2");
}

TEST_F(HandFile, RefusesNegativeWeightsThatSumToOne) {
    core::HandModel hand = test::smallHand(core::Side::Left);
    hand.weights.entries[1].weight = -0.25;
    hand.weights.entries[2].weight = 1.25;
    test::expectError([&] { core::checkHandModel(hand, "h.json"); }, core::ErrorCode::BadInput, "h.json", "negative");
}

} // namespace
