// SPDX-License-Identifier: MIT
#include "core/io/import/tzionas_import.h"

#include <sstream>

#include <gtest/gtest.h>

#include "core/io/hands/off_mesh.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;
using test::replaced;

const fs::path kHands = fs::path(HANDLENS_SHARED_DATA) / "tzionas-hands";

#define SKIP_WITHOUT_HANDS()                                                                                           \
    if (!fs::exists(kHands / "01"))                                                                                    \
        GTEST_SKIP() << "the authors' hands are not at " << kHands;

/// Bone origins of one frame (0 = after the rigging pose) of a MOTION file, in its order, read without the product's
/// code.
std::vector<Eigen::Vector3d> recordedOrigins(const fs::path& file, int frame) {
    std::ifstream in(file);
    std::vector<Eigen::Vector3d> origins;
    int row = 0;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        double values[12];
        int count = 0;
        while (count < 12 && words >> values[count])
            ++count;
        row = count == 12 ? row + 1 : 0;
        if (row == frame + 2)
            origins.emplace_back(values[9], values[10], values[11]);
    }
    return origins;
}

TEST(TzionasImport, ReproducesTheRecordedBoneOrigins) {
    SKIP_WITHOUT_HANDS();
    core::TzionasImportOptions options;
    options.sequenceFolders = {kHands / "02", kHands / "03/"};
    options.modelFiles = kHands / "model";
    const core::ImportedDataset imported = core::importTzionas(options);
    ASSERT_EQ(imported.dataset.hands.size(), 2u);
    ASSERT_EQ(imported.dataset.sequences.size(), 2u);
    EXPECT_EQ(imported.dataset.sequences[0].name, "02");
    EXPECT_EQ(imported.dataset.sequences[0].frameCount, 153);
    EXPECT_EQ(imported.dataset.sequences[1].name, "03");
    EXPECT_LT(imported.meanErrorMm, 0.01);
    EXPECT_LT(imported.maxErrorMm, 0.1);
    for (std::size_t h = 0; h < 2; ++h) {
        const core::HandModel& hand = imported.dataset.hands[h];
        EXPECT_EQ(hand.skeleton.poseSize(), 37);
        EXPECT_EQ(hand.skeleton.bones.size(), 20u);
        for (const int frame : {0, 77, 152}) {
            const auto recorded =
                recordedOrigins(kHands / "02" / (h == 0 ? "Model_Hand_L.MOTION" : "Model_Hand_R.MOTION"), frame);
            const auto joints =
                core::jointPositions(hand.skeleton, imported.motions[0][static_cast<std::size_t>(frame)][h]);
            ASSERT_EQ(recorded.size(), joints.size());
            for (std::size_t b = 0; b < joints.size(); ++b)
                EXPECT_LT((joints[b] - recorded[b]).norm(), 0.1) << frame << " " << hand.skeleton.bones[b].name;
        }
    }
}

TEST(TzionasImport, KeepsAllVerticesInTheirOrder) {
    SKIP_WITHOUT_HANDS();
    const core::TriangleMesh mesh = core::readOffMesh(kHands / "model/Model_Hand_L.OFF");
    ASSERT_EQ(mesh.vertices.size(), 10653u);
    EXPECT_EQ(mesh.triangles.size(), 21302u);
    EXPECT_LT((mesh.vertices[0] - Eigen::Vector3d(-25.4931, 10.471, -36.1938)).norm(), 1e-4);
    EXPECT_GT(core::signedVolume(mesh), 1e5);
    for (const core::MeshEdge& edge : core::meshEdges(mesh.triangles))
        ASSERT_TRUE(edge.triangleA >= 0 && edge.triangleB >= 0) << "the surface is closed";
}

TEST(TzionasImport, PutsBothHandsWellInsideEveryViewOfTheRing) {
    SKIP_WITHOUT_HANDS();
    core::TzionasImportOptions options;
    options.sequenceFolders = {kHands / "04"};
    options.modelFiles = kHands / "model";
    const core::ImportedDataset imported = core::importTzionas(options);
    ASSERT_EQ(imported.dataset.cameras.size(), 8u);
    for (const core::Camera& camera : imported.dataset.cameras) {
        EXPECT_EQ(camera.size, (core::ImageSize{1080, 1920}));
        for (std::size_t f = 0; f < imported.motions[0].size(); f += 43) {
            for (std::size_t h = 0; h < 2; ++h) {
                for (const Eigen::Vector3d& vertex :
                     core::posedVertices(imported.dataset.hands[h], imported.motions[0][f][h])) {
                    const auto px = core::project(camera, vertex);
                    ASSERT_TRUE(px && px->x() > 60 && px->y() > 60 && px->x() < 1080 - 61 && px->y() < 1920 - 61)
                        << camera.name;
                }
            }
        }
    }
}

/// A left hand of three bones in one folder, written by hand: `angle` of the last bone about its Y axis in the second
/// of two frames.
class TinyRecording : public testing::Test {
protected:
    TinyRecording() {
        fs::create_directory(m_sequence);
        write("SKEL", "3\r\nRoot_NULL_Bone_0\r\nLower Arm L\r\n20\r\nLower Arm "
                      "L\r\nLFing.3_0\r\n40\r\nLFing.3_0\r\nLFing.3_1\r\n30\r\n");
        write("OFF",
              "OFF\r\n4 4 0\r\n0 -5 -5\r\n0 5 0\r\n100 0 5\r\n0 0 8\r\n3 0 1 2\r\n3 0 3 1\r\n3 1 3 2\r\n3 2 3 0\r\n");
        write("SKIN", "3\nLower Arm L LFing.3_0 LFing.3_1\n1 0 0\n0 1 0\n0 0.5 0.5\n0 0 1\n");
        const std::string axes = "1 0 0\n0 1 0\n0 0 1\n";
        write("LIMITS", "Lower Arm L\n1 1 1 1\n" + axes + "-1 1\n-1 1\n-1 1\nLFing.3_0\n0 0 0 0\n" + axes +
                            "0 0\n0 0\n0 0\nLFing.3_1\n0 0 1 0\n" + axes + "0 0\n-10 10\n0 0\n");
        const std::string one = "1 0 0 0 1 0 0 0 1 ";
        // The whole hand moves by (5, 6, 700); the last bone bends by 30 degrees, 20 more than its limit.
        write("MOTION", "Lower Arm L\n" + one + "0 0 0\n" + one + "5 6 700\n" + one + "5 6 700\nLFing.3_0\n" + one +
                            "20 0 0\n" + one + "25 6 700\n" + one + "25 6 700\nLFing.3_1\n" + one + "60 0 0\n" + one +
                            "65 6 700\n" + "0.866025 0 0.5 0 1 0 -0.5 0 0.866025 65 6 700\n");
        m_options.sequenceFolders = {m_sequence};
    }

    fs::path file(const std::string& extension) const { return m_sequence / ("Model_Hand_L." + extension); }
    void write(const std::string& extension, const std::string& text) const { test::writeText(file(extension), text); }
    void expectRefused(const std::string& extension, const std::string& what, const std::string& by,
                       const std::string& word) {
        const std::string good = test::readText(file(extension));
        write(extension, replaced(good, what, by));
        test::expectError([&] { core::importTzionas(m_options); }, BadInput, "Model_Hand_L." + extension, word);
        write(extension, good);
    }

    test::TemporaryFolder m_folder;
    fs::path m_sequence = m_folder / "walking";
    core::TzionasImportOptions m_options;
};

TEST_F(TinyRecording, IsImportedFromOneFolderAndKeepsPosesBeyondTheLimits) {
    const core::ImportedDataset imported = core::importTzionas(m_options);
    ASSERT_EQ(imported.dataset.hands.size(), 1u);
    EXPECT_EQ(imported.dataset.sequences[0].name, "walking");
    EXPECT_EQ(imported.dataset.sequences[0].frameCount, 2);
    EXPECT_EQ(imported.dataset.hands[0].skeleton.bones[2].name, "index_pip");
    ASSERT_EQ(imported.motions[0][1][0].size(), core::kRigidDofs + 1);
    EXPECT_NEAR(imported.motions[0][0][0][core::kRigidDofs], 0, 1e-6);
    EXPECT_NEAR(imported.motions[0][1][0][core::kRigidDofs], M_PI / 6, 1e-5);
    EXPECT_LT((imported.motions[0][1][0].head<3>() - Eigen::Vector3d(5, 6, 700)).norm(), 1e-4);
}

TEST_F(TinyRecording, FindsSharedFilesInTheModelFolder) {
    fs::create_directory(m_folder / "model");
    for (const char* extension : {"OFF", "SKIN", "LIMITS"})
        fs::rename(file(extension), m_folder / "model" / file(extension).filename());
    test::expectError([&] { core::importTzionas(m_options); }, NotFound, "walking/Model_Hand_L.OFF", "no such file");
    m_options.modelFiles = m_folder / "model";
    EXPECT_EQ(core::importTzionas(m_options).dataset.hands.size(), 1u);
}

TEST_F(TinyRecording, IsRefusedWithTheFileThatIsWrong) {
    expectRefused("OFF", "OFF", "PLY", "begins with OFF");
    expectRefused("OFF", "4 4 0", "4 5 0", "a triangle");
    expectRefused("OFF", "4 4 0", "4 3 0", "goes on after its last triangle");
    expectRefused("OFF", "4 4 0", "5 4 0", "numbers expected");
    expectRefused("OFF", "3 2 3 0", "3 2 3 4", "not a triangle of the file's vertices");
    expectRefused("OFF", "3 2 3 0", "3 2 3 0.5", "not a triangle of the file's vertices");
    expectRefused("OFF", "3 2 3 0", "4 2 3 0 1", "numbers expected");
    expectRefused("OFF", "100 0 5", "100 nan 5", "finite");
    expectRefused("SKIN", "0 0.5 0.5", "0 0.5 0.4", "sum to 1");
    expectRefused("MOTION", "65 6 700", "65 6", "12 numbers");
    expectRefused("LIMITS", "LFing.3_1", "LFing.7_1", "unknown bone name");
    write("OFF", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11));
    test::expectError([&] { core::importTzionas(m_options); }, BadInput, "Model_Hand_L.OFF", "begins with OFF");
    test::expectError(
        [&] {
            m_options.sequenceFolders = {m_folder.path()};
            core::importTzionas(m_options);
        },
        NotFound, m_folder.path().string(), "MOTION");
}

TEST_F(TinyRecording, RefusesSequencesOfDifferentHandsOrTheSameName) {
    fs::create_directories(m_folder / "other/walking");
    fs::copy(m_sequence, m_folder / "other/walking", fs::copy_options::recursive);
    m_options.sequenceFolders.push_back(m_folder / "other/walking");
    test::expectError([&] { core::importTzionas(m_options); }, Usage, "other/walking", "two folders are named");
    fs::rename(m_folder / "other/walking", m_folder / "other/folding");
    m_options.sequenceFolders[1] = m_folder / "other/folding";
    EXPECT_EQ(core::importTzionas(m_options).dataset.sequences.size(), 2u);
    const fs::path motion = m_folder / "other/folding/Model_Hand_L.MOTION";
    test::writeText(motion, replaced(test::readText(motion), "60 0 0", "61 0 0"));
    test::expectError([&] { core::importTzionas(m_options); }, BadInput, motion.string(), "another hand");
}

TEST_F(TinyRecording, TakesCamerasFromAFileAndStopsWhenAsked) {
    m_options.camerasFile = m_folder / "Cameras.txt";
    test::writeText(m_options.camerasFile, "1\n525 0 319.5\n0 525 239.5\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n");
    const core::Dataset dataset = core::importTzionas(m_options).dataset;
    ASSERT_EQ(dataset.cameras.size(), 1u);
    EXPECT_EQ(dataset.cameras[0].size, (core::ImageSize{640, 480}));
    EXPECT_EQ(dataset.sequences[0].views.size(), 1u);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(core::importTzionas(m_options, stop.get_token()), core::Error);
}

} // namespace
