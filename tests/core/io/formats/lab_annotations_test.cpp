// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "core/io/calibration/calibration.h"
#include "core/io/dataset/new_sequence.h"
#include "core/io/formats/annotation_formats.h"
#include "core/io/hdf5/sleap_file.h"
#include "tests/support/temporary_folder.h"

// Files that laboratories work with. They are not part of this project; where they are missing, the tests are skipped.
namespace {

namespace fs = std::filesystem;

const fs::path kLabFiles = fs::path(HANDLENS_SHARED_DATA) / "labs";

TEST(LabAnnotations, AProjectOfSleapAndItsAnalysisHoldTheSamePoints) {
    const fs::path project = kLabFiles / "sleap_minimal_top_proofread.slp",
                   analysis = kLabFiles / "sleap_minimal_top_proofread.analysis.h5";
    if (!fs::exists(project) || !fs::exists(analysis))
        GTEST_SKIP() << "the data is not at " << kLabFiles;
    const core::SleapFile own = core::readSleapFile(project), exported = core::readSleapFile(analysis);
    std::map<std::pair<int, std::string>, Eigen::Vector2d> places;
    std::set<std::string> nodes;
    for (const core::SleapInstance& instance : own.instances) {
        for (const core::SleapPoint& point : instance.points) {
            places[{instance.frame, point.node}] = {point.x, point.y};
            nodes.insert(point.node);
        }
    }
    EXPECT_EQ(nodes.size(), 15u);
    int count = 0;
    double most = 0;
    for (const core::SleapInstance& instance : exported.instances) {
        EXPECT_EQ(instance.video, own.instances.front().video);
        for (const core::SleapPoint& point : instance.points) {
            const auto place = places.find({instance.frame, point.node});
            ASSERT_NE(place, places.end()) << "frame " << instance.frame << ", " << point.node;
            most = std::max(most, (place->second - Eigen::Vector2d(point.x, point.y)).norm());
            ++count;
        }
    }
    EXPECT_EQ(count, static_cast<int>(places.size()));
    EXPECT_GT(count, 200);
    EXPECT_LT(most, 1e-3);
}

TEST(LabAnnotations, LabelsOfDannceTriangulateToWhereTheyCameFrom) {
    const fs::path path = kLabFiles / "dannce_label3d_dannce.mat";
    if (!fs::exists(path))
        GTEST_SKIP() << "the data is not at " << path;
    const test::TemporaryFolder folder;
    core::CalibrationOptions calibration;
    calibration.size = core::ImageSize{1152, 1024};
    core::Dataset dataset;
    dataset.folder = folder.path();
    dataset.cameras = core::readCalibration(path, calibration);
    dataset.sequences = {core::sequenceWithoutFootage("mouse", dataset.cameras, 100000)};
    std::ofstream map(folder / "map.json");
    map << R"({"format":"handlens-joint-map","version":1,"joints":[)";
    constexpr int kParts = 22;
    for (int i = 0; i < kParts; ++i)
        map << (i > 0 ? "," : "") << R"({"name":"p)" << i << R"(","joint":"part)" << i << R"(","hand":"left"})";
    map << "]}";
    map.close();
    core::AnnotationImportOptions options;
    options.jointMap = folder / "map.json";
    const core::ImportedAnnotations got =
        core::importAnnotations(dataset, dataset.sequences[0], "label3d", path, options);
    EXPECT_GT(got.set.marks.size(), 1000u);
    std::map<std::pair<int, core::JointId>, std::vector<core::Observation>> views;
    for (const auto& [key, mark] : got.set.marks)
        views[{key.frame, key.joint}].push_back({dataset.cameraIndex(key.camera), mark.px});
    double most = 0;
    for (const auto& [key, seen] : views) {
        const core::TriangulationResult result = core::triangulate(dataset.cameras, seen, {});
        ASSERT_TRUE(result.point);
        most = std::max(most, result.point->rmsPx);
    }
    EXPECT_LT(most, 0.02) << "px, over " << views.size() << " joints";
}

} // namespace
