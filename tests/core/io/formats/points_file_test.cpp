// SPDX-License-Identifier: MIT
#include "core/io/formats/points_file.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"
#include "tests/support/camera_ring.h"
#include "tests/support/temporary_folder.h"

namespace {

class PointsFile : public testing::Test {
protected:
    std::vector<core::PointClicks> read(const std::string& text) {
        std::ofstream(m_folder / "points.json") << text;
        return core::readPointClicks(m_folder / "points.json", m_cameras);
    }
    std::string problemOf(const std::string& text) {
        try {
            read(text);
        } catch (const core::Error& error) {
            return error.what();
        }
        return "";
    }

    test::TemporaryFolder m_folder;
    std::vector<core::Camera> m_cameras = test::cameraRing(3);
};

TEST_F(PointsFile, ReadsClicksByCameraName) {
    const auto points = read(
        R"({"points": [{"id": "a", "views": [{"camera": "cam2", "px": [1.25, -3]}, {"camera": "cam0", "px": [4, 5]}]},
                                            {"id": "b", "views": []}]})");
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].id, "a");
    EXPECT_EQ(points[0].observations[0].camera, 2);
    EXPECT_EQ(points[0].observations[0].px, Eigen::Vector2d(1.25, -3));
    EXPECT_EQ(points[0].observations[1].camera, 0);
    EXPECT_TRUE(points[1].observations.empty());
}

TEST_F(PointsFile, NamesWhatIsWrong) {
    EXPECT_NE(problemOf(R"({"points": [{"id": "a", "views": [{"camera": "cam9", "px": [1, 2]}]}]})")
                  .find("points[0].views[0].camera"),
              std::string::npos);
    EXPECT_NE(
        problemOf(
            R"({"points": [{"id": "a", "views": [{"camera": "cam0", "px": [1, 2]}, {"camera": "cam0", "px": [1, 2]}]}]})")
            .find("twice"),
        std::string::npos);
    EXPECT_NE(problemOf(R"({"points": [{"id": "a", "views": [{"camera": "cam0", "px": [1]}]}]})"), "");
    EXPECT_NE(problemOf(R"({"points": [{"id": 7, "views": []}]})"), "");
    EXPECT_NE(problemOf(R"([])"), "");
}

TEST_F(PointsFile, WritesPointsOutliersAndReasons) {
    const Eigen::Vector3d truth(3, 4, 5);
    std::vector<core::PointClicks> points{{"good", {}}, {"alone", {{1, {500, 500}}}}};
    for (int i = 0; i < 3; ++i)
        points[0].observations.push_back({i, *core::project(m_cameras[i], truth)});
    std::vector<core::TriangulationResult> results;
    for (const auto& point : points)
        results.push_back(core::triangulate(m_cameras, point.observations));
    results[0].point->inlier[1] = false; // as if it had disagreed
    core::writeTriangulatedPoints(m_folder / "out.json", m_cameras, points, results);
    const auto out = core::readJsonFile(m_folder / "out.json")["points"];
    EXPECT_LT((core::jsonVector(out[0]["xyz"], "", "") - truth).norm(), 1e-6);
    EXPECT_EQ(core::jsonMatrix(out[0]["covariance"], "", ""), results[0].point->covariance);
    EXPECT_EQ(out[0]["inliers"], (nlohmann::json{"cam0", "cam2"}));
    EXPECT_EQ(out[0]["outliers"], nlohmann::json{"cam1"});
    EXPECT_EQ(out[0]["reason"], "");
    EXPECT_EQ(out[1]["id"], "alone");
    EXPECT_TRUE(out[1]["xyz"].is_null() && out[1]["covariance"].is_null() && out[1]["rmsPx"].is_null());
    EXPECT_EQ(out[1]["reason"], core::failureText(core::TriangulationFailure::FewerThanTwoViews));
}

} // namespace
