// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/io/dataset/dataset.h"
#include "tests/app/batch/program.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::runBatch;

/// The joints of the hands in tests/data/gltf.
const char* const kRig = R"({"format": "handlens-rig", "version": 1, "name": "small",
 "jointAxes": {"forward": [0, 0, -1], "dorsal": [0, 1, 0]},
 "joints": [{"name": "wrist", "parent": null}, {"name": "index_mcp", "parent": "wrist"}, {"name": "index_pip", "parent": "index_mcp"}],
 "dofs": [{"joint": "index_mcp", "name": "flexion", "axis": [0, 1, 0], "limitsDeg": [-100, 10]}]})";

TEST(BatchImport, MakesADatasetOfTwoGltfHands) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "rig.json", kRig);
    const fs::path hands = fs::path(HANDLENS_TEST_DATA) / "gltf";
    const std::string out = folder / "set";
    const Ended ended = runBatch({"import", "gltf", "--left", hands / "left_hand.gltf", "--right",
                                  hands / "right_hand.gltf", "--rig", folder / "rig.json", "--out", out});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("right hand: 21 vertices, 34 triangles, 7 degrees of freedom"), std::string::npos)
        << ended.out;
    const core::Dataset dataset = core::readDataset(out);
    ASSERT_EQ(dataset.hands.size(), 2u);
    EXPECT_EQ(dataset.hands[1].skeleton.bones[2].name, "index_pip");
    EXPECT_LT(
        (dataset.hands[1].skeleton.bones[1].worldFromBoneAtRest.translation - Eigen::Vector3d(590, 100, -180)).norm(),
        0.1);
    EXPECT_EQ(runBatch({"check", out}).status, 0);
}

TEST(BatchImport, MakesADatasetOfTheAuthorsHands) {
    const fs::path hands = fs::path(HANDLENS_SHARED_DATA) / "tzionas-hands";
    if (!fs::exists(hands / "02"))
        GTEST_SKIP() << "the authors' hands are not at " << hands;
    const test::TemporaryFolder folder;
    const std::string out = folder / "set";
    const Ended ended = runBatch(
        {"import", "tzionas", "--models", hands / "02", "--model-files", hands / "model", "--ring", "4", "--out", out});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("2 hands, 1 sequences, 4 cameras"), std::string::npos) << ended.out;
    EXPECT_EQ(ended.out.find("fitting poses"), std::string::npos)
        << "progress belongs to standard error: " << ended.out;
    const core::Dataset dataset = core::readDataset(out);
    ASSERT_EQ(dataset.sequences.size(), 1u);
    EXPECT_EQ(dataset.sequences[0].name, "02");
    EXPECT_EQ(dataset.sequences[0].frameCount, 153);
    EXPECT_EQ(core::readMotion(dataset, dataset.sequences[0]).size(), 153u);
    EXPECT_EQ(runBatch({"check", out}).status, 0);
}

} // namespace
