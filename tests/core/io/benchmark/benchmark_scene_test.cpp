// SPDX-License-Identifier: MIT
#include "core/io/benchmark/benchmark_scene.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/annotation/edits.h"
#include "core/contour/rasteriser.h"
#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/footage/image_file.h"
#include "core/io/store/annotation_store.h"
#include "tests/core/benchmark/tiny_benchmark.h"
#include "tests/support/temporary_folder.h"

namespace core {
namespace {

/// The tiny scene as a dataset; sequence "still" has no motion.
Dataset tinyDataset(const std::filesystem::path& folder) {
    const BenchmarkScene scene = test::tinyScene();
    Dataset dataset;
    dataset.name = "tiny";
    dataset.cameras = scene.cameras;
    dataset.hands = scene.hands;
    dataset.handFiles = {"left.json", "right.json"};
    dataset.sequences.push_back({"one", 40, 50, {}, "masks/{camera}-{frame:03}.png", "one.json", "one.sqlite"});
    dataset.sequences.push_back({"two", 30, 50, {}, "", "two.json", ""});
    dataset.sequences.push_back({"still", 30, 50, {}, "", "", ""});
    writeDataset(dataset, {scene.sequences[0].motion, scene.sequences[1].motion, {}}, folder);
    return readDataset(folder);
}

/// What is wrong with reading the scene; empty if nothing is.
std::string problem(const Dataset& dataset, const std::vector<std::string>& sequences, BenchmarkSetup setup) {
    try {
        readBenchmarkScene(dataset, sequences, setup);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(BenchmarkScene, TakesTheSequencesThatHaveAMotion) {
    const test::TemporaryFolder folder;
    const Dataset dataset = tinyDataset(folder / "ds");
    const BenchmarkScene scene = readBenchmarkScene(dataset, {}, BenchmarkSetup::Synthetic);
    ASSERT_EQ(scene.sequences.size(), 2u);
    EXPECT_EQ(scene.sequences[0].motion.size(), 40u);
    EXPECT_EQ(scene.sequences[1].name, "two");
    EXPECT_EQ(scene.cameras.size(), 3u);
    EXPECT_EQ(readBenchmarkScene(dataset, {"two"}, BenchmarkSetup::Synthetic).sequences.size(), 1u);
    EXPECT_NE(problem(dataset, {"still"}, BenchmarkSetup::Synthetic).find("still"), std::string::npos);
    EXPECT_NE(problem(dataset, {"nowhere"}, BenchmarkSetup::Synthetic), "");
}

TEST(BenchmarkScene, RealisticReadsMasksAndTriangulatesAnnotations) {
    const test::TemporaryFolder folder;
    const Dataset dataset = tinyDataset(folder / "ds");
    EXPECT_NE(problem(dataset, {"two"}, BenchmarkSetup::Realistic).find("no masks"), std::string::npos);
    EXPECT_NE(problem(dataset, {"one"}, BenchmarkSetup::Realistic).find("annotated 3D joints"), std::string::npos);
    const JointId joint{Side::Left, "index_mcp"};
    const Eigen::Vector3d truth =
        namedJointPositions(dataset.hands, readMotion(dataset, dataset.sequences[0])[20]).at(joint);
    {
        AnnotationStore store = AnnotationStore::open(dataset.folder / "one.sqlite");
        for (const Camera& camera : dataset.cameras)
            store.commit(placeEdit(store.annotations(), {20, "me", joint, camera.name}, *project(camera, truth)), "me");
        const Camera& first = dataset.cameras[0];
        store.commit(placeEdit(store.annotations(), {25, "me", joint, first.name}, *project(first, truth)), "me");
    }
    const BenchmarkScene scene = readBenchmarkScene(dataset, {"one"}, BenchmarkSetup::Realistic);
    const auto& annotated = scene.sequences[0].annotatedJoints;
    ASSERT_EQ(annotated.size(), 1u) << "one view gives no joint";
    EXPECT_LT((annotated.at(20).at(joint) - truth).norm(), 1e-3);
    const cv::Mat mask = renderHandsMask(dataset.cameras[1], dataset.hands, scene.sequences[0].motion[20]);
    ensureFolder(dataset.folder / "masks");
    writePng(dataset.folder / "masks/cam1-020.png", mask);
    const std::vector<cv::Mat> masks = scene.sequences[0].masks(20);
    ASSERT_EQ(masks.size(), 3u);
    EXPECT_TRUE(masks[0].empty() && masks[2].empty()) << "cameras without a file are left out";
    EXPECT_EQ(cv::countNonZero(masks[1] != mask), 0);
}

} // namespace
} // namespace core
