// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/contour/rasteriser.h"
#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"
#include "core/io/import/tzionas_import.h"
#include "tests/support/fitting_scene.h"

namespace {

using core::HandPoses;

TEST(EstimatorOnRecordedHands, ComesWithinOneAndAHalfMillimetresFiveFramesApart) {
    const std::filesystem::path shared = std::filesystem::path(HANDLENS_SHARED_DATA) / "tzionas-hands";
    if (!std::filesystem::exists(shared / "01"))
        GTEST_SKIP() << "the shared data is not there: " << shared;
    core::TzionasImportOptions options;
    options.sequenceFolders = {shared / "01"};
    options.modelFiles = shared / "model";
    const core::ImportedDataset imported = core::importTzionas(options);
    const auto& [hands, cameras] = std::tie(imported.dataset.hands, imported.dataset.cameras);
    const core::Motion& motion = imported.motions.front();
    const core::PoseEstimator estimator(hands, cameras);
    const HandPoses &start = motion.at(60), &truth = motion.at(65);
    std::vector<cv::Mat> masks;
    for (const core::Camera& camera : cameras)
        masks.push_back(core::renderHandsMask(camera, hands, truth));
    const double before = core::meanJointDistanceMm(hands, start, truth);
    EXPECT_GT(before, 4);
    for (const auto& [method, boundMm] : {std::pair("dch-thres", 1.5), std::pair("best", 1.0)}) {
        const core::FitResult result = estimator.fit(masks, start, core::parseMethod(method), {}, {}, 2);
        EXPECT_LT(core::meanJointDistanceMm(hands, result.poses, truth), boundMm)
            << method << " from " << before << " mm";
    }
}

} // namespace
