// SPDX-License-Identifier: MIT
#include "core/io/demo/realistic_demo.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "core/annotation/sequence_points.h"
#include "core/contour/rasteriser.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/frames.h"
#include "core/io/files/json_file.h"
#include "tests/support/temporary_folder.h"

namespace core {
namespace {

TEST(RealisticDemo, IsADatasetWhoseTruthIsBesideIt) {
    const test::TemporaryFolder folder;
    RealisticDemoOptions options;
    options.framesPerSequence = 1;
    options.threads = 2;
    const RealisticDemoSummary summary = writeRealisticDemo(folder / "set", options);
    EXPECT_EQ(summary.frames, 4);
    EXPECT_EQ(summary.pictures, 32);
    const Dataset dataset = readDataset(folder / "set"), truth = readDataset(folder / "set/truth");
    EXPECT_NE(dataset.cameras[0].cameraFromWorld.translation, truth.cameras[0].cameraFromWorld.translation);
    EXPECT_NE(dataset.hands[0].mesh.vertices, truth.hands[0].mesh.vertices);
    const nlohmann::json document = readOwnFile(folder / "set/truth/truth.json", "truth");
    ASSERT_EQ(document["frames"].size(), 4u);
    const Sequence& sequence = dataset.sequences[0];
    const nlohmann::json& frame = document["frames"][0];
    const int number = frame["frame"].get<int>();

    // The clicks, seen by the true cameras, give the true joints.
    const auto points = meanJointPoints(readAnnotations(dataset, sequence), truth.cameras, number);
    EXPECT_EQ(points.size(), 28u);
    std::vector<double> errors;
    for (const nlohmann::json& joint : frame["joints"]) {
        const JointId id{*sideFromName(joint["hand"].get<std::string>()), joint["name"].get<std::string>()};
        const auto found = points.find(id);
        const auto& xyz = joint["xyz"];
        if (found != points.end()) {
            errors.push_back(
                (found->second - Eigen::Vector3d(xyz[0].get<double>(), xyz[1].get<double>(), xyz[2].get<double>()))
                    .norm());
        }
    }
    std::sort(errors.begin(), errors.end());
    ASSERT_EQ(errors.size(), 28u);
    EXPECT_LT(errors[errors.size() / 2], 1.2);

    // The masks hold the true silhouette, and the arms.
    const Motion motion = readMotion(truth, truth.sequences[0]);
    const auto masks = readFrameMasks(dataset.folder, sequence, dataset.cameras, number);
    for (std::size_t c = 0; c < masks.size(); ++c) {
        const cv::Mat hands = renderHandsMask(truth.cameras[c], truth.hands, motion[static_cast<std::size_t>(number)]);
        EXPECT_GT(cv::countNonZero(masks[c] & hands), 0.9 * cv::countNonZero(hands)) << c;
        EXPECT_GT(cv::countNonZero(masks[c]), cv::countNonZero(hands)) << c;
    }
    EXPECT_FALSE(FrameSource(dataset, sequence, {}).hasPicture(0, number + 1));
    EXPECT_TRUE(FrameSource(dataset, sequence, {}).hasPicture(0, number));
}

TEST(RealisticDemo, ThatIsStoppedWritesNothing) {
    const test::TemporaryFolder folder;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(writeRealisticDemo(folder / "set", {}, {}, stop.get_token()).stopped);
    EXPECT_FALSE(std::filesystem::exists(folder / "set"));
}

} // namespace
} // namespace core
