// SPDX-License-Identifier: MIT
#include "core/io/calibration/tzionas_cameras.h"
#include "core/io/import/tzionas_files.h"

#include <gtest/gtest.h>

#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::replaced;
using enum core::ErrorCode;

constexpr const char* kSkel = "3\r\nRoot_NULL_Bone_0\r\nLower Arm L\r\n20.5\r\nLower Arm "
                              "L\r\nLFing.3_Hand\r\n70\r\nLFing.3_Hand\r\nLFing.3_0\r\n40\r\n";
constexpr const char* kSkin = "3\nLower Arm L LFing.3_0 LFing.3_Hand \n1 0 0 \n0.25 0.5 0.2505\n";
constexpr const char* kLimits =
    "Lower Arm L\n1 1 1 1\n9 9 9\n9 9 9\n9 9 9\n-3e+38 3e+38\n-3e+38 3e+38\n-3e+38 3e+38\n\n"
    "LFing.3_0\n0 1 1 1\n1 0 0\n0 0.6 0.8\n0 0 2\n-0 0\n-90 20\n-15 15\n\n"
    "LFing.3_Hand\n0 0 1 0\n1 0 0\n0 1 0\n0 0 1\n-5 5\n-10 10\n-5 5\n";

class AuthorsFiles : public testing::Test {
protected:
    std::filesystem::path write(const std::string& text) {
        test::writeText(m_file, text);
        return m_file;
    }
    std::vector<core::Bone> bones() { return core::readSkel(write(kSkel)).bones; }

    test::TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "Model_Hand_L.X";
};

TEST_F(AuthorsFiles, SkelHoldsNamesWithBlanksAndWindowsLineEnds) {
    const core::SkelFile skel = core::readSkel(write(kSkel));
    EXPECT_EQ(skel.motionFrames, 3);
    ASSERT_EQ(skel.bones.size(), 3u);
    EXPECT_EQ(skel.bones[0].name, "Lower Arm L");
    EXPECT_EQ(skel.bones[0].parent, -1);
    EXPECT_EQ(skel.bones[0].lengthMm, 20.5);
    EXPECT_EQ(skel.bones[2].name, "LFing.3_0");
    EXPECT_EQ(skel.bones[2].parent, 1);
}

TEST_F(AuthorsFiles, SkelIsRefusedWithItsLine) {
    const auto refuse = [&](const std::string& text, const std::string& word) {
        write(text);
        test::expectError([&] { core::readSkel(m_file); }, BadInput, "Model_Hand_L.X", word);
    };
    refuse("", "ends where");
    refuse("x\n", "line 1");
    refuse("3\n", "no bones");
    refuse(replaced(kSkel, "20.5", "-1"), "line 4: a length is negative");
    refuse(replaced(kSkel, "20.5", "nan"), "line 4");
    refuse(replaced(kSkel, "Lower Arm L\r\nLFing.3_Hand", "Upper Arm L\r\nLFing.3_Hand"),
           "line 5: unknown bone name 'Upper Arm L'");
    refuse(replaced(kSkel, "LFing.3_0", "Lower Arm L"), "comes twice");
    refuse(replaced(kSkel, "Lower Arm L\r\nLFing.3_Hand", "Root_NULL_Bone_0\r\nLFing.3_Hand"), "Root_NULL_Bone_0");
    refuse(std::string("\x7f"
                       "ELF\x02\x01\x01\x00\x00",
                       9),
           "line 1");
    refuse(std::string(kSkel).substr(0, 60), "ends where");
}

TEST_F(AuthorsFiles, SkinIsRenormalisedAndItsColumnsFollowItsOwnNames) {
    const std::vector<core::Bone> skeleton = bones();
    const core::SkinWeights weights = core::readSkin(write(kSkin), skeleton, 2);
    EXPECT_EQ(weights.firstEntry, (std::vector<int>{0, 1, 4}));
    EXPECT_EQ(weights.entries[0].bone, 0);
    EXPECT_EQ(weights.entries[2].bone, 2); // second column: LFing.3_0
    EXPECT_NEAR(weights.entries[2].weight, 0.5 / 1.0005, 1e-15);
    EXPECT_NEAR(weights.entries[1].weight + weights.entries[2].weight + weights.entries[3].weight, 1, 1e-15);
}

TEST_F(AuthorsFiles, SkinIsRefusedWithItsLine) {
    const std::vector<core::Bone> skeleton = bones();
    const auto refuse = [&](const std::string& text, const std::string& word, std::size_t vertices = 2) {
        write(text);
        test::expectError([&] { core::readSkin(m_file, skeleton, vertices); }, BadInput, "Model_Hand_L.X", word);
    };
    refuse(replaced(kSkin, "0.2505", "0.35"), "line 4: the weights of a vertex must be positive and sum to 1");
    refuse(replaced(kSkin, "0.25 0.5 0.2505", "-0.25 1 0.25"), "positive");
    refuse(replaced(kSkin, "1 0 0", "1 0"), "line 3: 3 numbers expected");
    refuse(replaced(kSkin, "1 0 0", "1 0 inf"), "line 3");
    refuse(replaced(kSkin, "LFing.3_0", "LFing.9_0"), "unknown bone name");
    refuse(replaced(kSkin, "LFing.3_0", "Lower Arm L"), "repeated bone name");
    refuse(replaced(kSkin, "3\n", "4\n"), "4 announced");
    refuse(kSkin, "ends where the weights of vertex 2", 3);
    refuse(kSkin, "more rows than the mesh has vertices", 1);
}

TEST_F(AuthorsFiles, LimitsGiveOnlyFreeAxesInTheOrderOfTheBones) {
    const std::vector<core::Bone> skeleton = bones();
    const std::vector<core::DegreeOfFreedom> dofs = core::readLimits(write(kLimits), skeleton);
    ASSERT_EQ(dofs.size(), 3u);
    EXPECT_EQ(dofs[0].name, "index_cmc.flexion");
    EXPECT_EQ(dofs[0].bone, 1);
    EXPECT_EQ(dofs[1].name, "index_mcp.flexion");
    EXPECT_EQ(dofs[2].name, "index_mcp.abduction");
    EXPECT_LT((dofs[1].axisInBone - Eigen::Vector3d(0, 0.6, 0.8)).norm(), 1e-12);
    EXPECT_LT((dofs[2].axisInBone - Eigen::Vector3d::UnitZ()).norm(), 1e-12); // normalised
    EXPECT_NEAR(dofs[1].minRad, -M_PI / 2, 1e-12);
    EXPECT_NEAR(dofs[1].maxRad, M_PI / 9, 1e-12);
}

TEST_F(AuthorsFiles, LimitsAreRefusedWithTheirLine) {
    const std::vector<core::Bone> skeleton = bones();
    const auto refuse = [&](const std::string& text, const std::string& word) {
        write(text);
        test::expectError([&] { core::readLimits(m_file, skeleton); }, BadInput, "Model_Hand_L.X", word);
    };
    refuse(replaced(kLimits, "-90 20", "20 -90"), "lower limit");
    refuse(replaced(kLimits, "0 0.6 0.8", "0 0 0"), "axis of a free rotation is zero");
    refuse(replaced(kLimits, "LFing.3_0", "LFing.3_7"), "unknown bone name");
    refuse(replaced(kLimits, "LFing.3_0", "Lower Arm L"), "twice");
    refuse(std::string(kLimits).substr(0, std::string(kLimits).size() - 6), "ends where");
    refuse(std::string(kLimits).substr(0, std::string(kLimits).find("LFing.3_Hand")),
           "2 bones, but the skeleton has 3");
}

TEST_F(AuthorsFiles, MotionGivesPosesPerFrameWithTrueRotations) {
    const std::vector<core::Bone> skeleton = bones();
    const std::string pose = "0 -1 0 1.00001 0 0 0 0 1 1 2 3\n", rest = "1 0 0 0 1 0 0 0 1 4 5 6\n";
    write("LFing.3_Hand\n" + rest + pose + "Lower Arm L\n" + pose + rest + "LFing.3_0\n" + rest + rest);
    const auto table = core::readMotionTable(m_file, skeleton, 2);
    ASSERT_EQ(table.size(), 2u);
    EXPECT_EQ(table[1][1].translation, Eigen::Vector3d(1, 2, 3)); // by name, not by place
    EXPECT_EQ(table[0][0].translation, Eigen::Vector3d(1, 2, 3));
    EXPECT_TRUE(core::isRotation(table[1][1].rotation, 1e-12));
    EXPECT_NEAR(table[1][1].rotation(1, 0), 1, 1e-5);
    const auto refuse = [&](const std::string& text, const std::string& word, int frames = 2) {
        write(text);
        test::expectError([&] { core::readMotionTable(m_file, skeleton, frames); }, BadInput, "Model_Hand_L.X", word);
    };
    const std::string good = test::readText(m_file);
    refuse(good, "", 3);
    refuse(good, "", 1);
    refuse(replaced(good, "1.00001", "-1"), "line 3: the first nine numbers are not a rotation");
    refuse(replaced(good, "4 5 6", "4 5"), "line 2: 12 numbers");
    refuse(replaced(good, "4 5 6", "4 5 nan"), "line 2");
    refuse(good.substr(0, good.find("LFing.3_0")), "2 bones, but the skeleton has 3");
}

TEST_F(AuthorsFiles, CamerasGetTheirSizeFromThePrincipalPoint) {
    write("1.000000 \n525.0 0.000 319.5\n0.000 525.0 239.5\n0.000 0.000 1.000\n1 0 0  7\n0 1 0  8\n0 0 1  9\n");
    const std::vector<core::Camera> cameras = core::readTzionasCameras(m_file);
    ASSERT_EQ(cameras.size(), 1u);
    EXPECT_EQ(cameras[0].name, "cam0");
    EXPECT_EQ(cameras[0].size, (core::ImageSize{640, 480}));
    EXPECT_EQ(cameras[0].cameraFromWorld.translation, Eigen::Vector3d(7, 8, 9));
    EXPECT_EQ(core::readTzionasCameras(m_file, core::ImageSize{100, 200})[0].size, (core::ImageSize{100, 200}));
    write(replaced(test::readText(m_file), "1 0 0  7", "-1 0 0  7"));
    test::expectError([&] { core::readTzionasCameras(m_file); }, BadInput, "Model_Hand_L.X: cameras[0].R", "rotation");
}

TEST(StandardJointName, KnowsAllTwentyBonesOfAHandAndNothingElse) {
    EXPECT_EQ(core::standardJointName("Lower Arm R"), "forearm");
    EXPECT_EQ(core::standardJointName("RFing.0_Hand"), "little_cmc");
    EXPECT_EQ(core::standardJointName("LFing.3_0"), "index_mcp");
    EXPECT_EQ(core::standardJointName("LFing.2_1"), "middle_pip");
    EXPECT_EQ(core::standardJointName("LFing.1_2"), "ring_dip");
    EXPECT_EQ(core::standardJointName("LFing.4_Hand"), "thumb_cmc");
    EXPECT_EQ(core::standardJointName("LFing.4_0"), "thumb_mcp");
    EXPECT_EQ(core::standardJointName("LFing.4_1"), "thumb_ip");
    for (const char* other :
         {"LFing.4_2", "LFing.5_0", "LFing.3_3", "LFing.3_", "LFing.3", "XFing.3_0", "", "Lower Arm"})
        EXPECT_FALSE(core::standardJointName(other)) << other;
}

} // namespace
