// SPDX-License-Identifier: MIT
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/annotation/edits.h"
#include "core/annotation/import_edit.h"
#include "core/io/calibration/calibration.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"
#include "core/io/store/annotation_store.h"
#include "tests/app/batch/program.h"
#include "tests/support/clicks.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using nlohmann::json;
using test::Ended;
using test::runBatch;

const core::JointId kLeftIndex{core::Side::Left, "index_mcp"};
const core::JointId kRightIndex{core::Side::Right, "index_pip"};
const Vector3d kLeftPoint(-40, 12, 30), kRightPoint(55, -8, 21);

/// Two annotated copies of the small dataset: `m_set` with clicks of "ann" in frames 1 and 3, `m_empty` without.
class BatchFiles : public testing::Test {
protected:
    BatchFiles() {
        test::writeSmallDataset(m_set);
        test::writeSmallDataset(m_empty);
        m_dataset = core::readDataset(m_set);
        for (const int frame : {1, 3}) {
            test::clickEverywhere(m_clicks, m_dataset.cameras, frame, "ann", kLeftIndex, kLeftPoint);
            test::clickEverywhere(m_clicks, m_dataset.cameras, frame, "ann", kRightIndex, kRightPoint);
        }
        auto store = core::AnnotationStore::open(core::annotationFile(m_dataset, m_dataset.sequences[0]));
        store.commit(core::importEdit({}, m_clicks, "clicks"), "ann");
    }

    core::AnnotationSet annotationsOf(const fs::path& set) const {
        const core::Dataset dataset = core::readDataset(set);
        return core::readAnnotations(dataset, dataset.sequences[0]);
    }
    Ended exportTo(const std::string& kind, const fs::path& out) const {
        return runBatch({"export", m_set, "--sequence", "first", "--to", kind, "--out", out});
    }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set", m_empty = m_folder / "empty";
    core::Dataset m_dataset;
    core::AnnotationSet m_clicks;
};

TEST_F(BatchFiles, CalibrationConvertsThereAndBack) {
    const fs::path cameras = fs::path(m_set) / "cameras.json";
    const std::vector<core::Camera> wanted = core::readCameras(cameras);
    for (const auto& [kind, name] : {std::pair("anipose", "calibration.toml"), std::pair("opencv", "cameras.yml")}) {
        const fs::path there = m_folder / name, back = m_folder / (std::string(kind) + ".json");
        const Ended written = runBatch({"calibration", cameras, "--to", kind, "--out", there});
        ASSERT_EQ(written.status, 0) << written.err;
        EXPECT_NE(written.out.find("cam2"), std::string::npos) << written.out;
        const Ended read = runBatch({"calibration", there, "--to", "handlens", "--out", back});
        ASSERT_EQ(read.status, 0) << kind << ": " << read.err;
        const std::vector<core::Camera> got = core::readCameras(back);
        ASSERT_EQ(got.size(), wanted.size()) << kind;
        for (std::size_t c = 0; c < got.size(); ++c) {
            EXPECT_EQ(got[c].name, wanted[c].name);
            EXPECT_EQ(got[c].size, wanted[c].size) << kind;
            EXPECT_LT((*core::project(got[c], kLeftPoint) - *core::project(wanted[c], kLeftPoint)).norm(), 1e-6)
                << kind;
        }
    }
}

TEST_F(BatchFiles, TriangulateFindsThePointAndNamesTheWrongClick) {
    const std::vector<core::Camera> cameras = test::cameraRing(6);
    const fs::path camerasFile = m_folder / "cameras.json", file = m_folder / "points.json",
                   out = m_folder / "out.json";
    core::writeCameras(camerasFile, cameras);
    json views = json::array();
    for (const core::Camera& camera : cameras) {
        const Eigen::Vector2d px = *core::project(camera, kLeftPoint);
        views.push_back({{"camera", camera.name}, {"px", {px.x() + (camera.name == "cam4" ? 50 : 0), px.y()}}});
    }
    json points = json::array();
    points.push_back({{"id", "wrong in cam4"}, {"views", views}});
    points.push_back({{"id", "one view"}, {"views", json::array({views[0]})}});
    std::ofstream(file) << json{{"points", points}};
    const Ended ended = runBatch({"triangulate", "--cameras", camerasFile, "--points", file, "--out", out});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const json result = core::readJsonFile(out)["points"];
    ASSERT_EQ(result.size(), 2u);
    EXPECT_EQ(result[0]["id"], "wrong in cam4");
    EXPECT_LT((core::jsonVector(result[0]["xyz"], "", "") - kLeftPoint).norm(), 1e-6);
    EXPECT_LT(result[0]["rmsPx"].get<double>(), 1e-6);
    EXPECT_EQ(result[0]["inliers"], (std::vector<std::string>{"cam0", "cam1", "cam2", "cam3", "cam5"}));
    EXPECT_EQ(result[0]["outliers"], std::vector<std::string>{"cam4"});
    EXPECT_EQ(result[0]["covariance"].size(), 3u);
    EXPECT_TRUE(result[1]["xyz"].is_null());
    EXPECT_EQ(result[1]["reason"], "fewer than two views");
}

TEST_F(BatchFiles, ExportWritesTheGroundTruthAndAnnotationsReadsIt) {
    const fs::path file = m_folder / "truth.json";
    const Ended written = exportTo("handlens", file);
    ASSERT_EQ(written.status, 0) << written.err;
    const json truth = core::readJsonFile(file);
    EXPECT_EQ(truth["format"], "handlens-ground-truth");
    ASSERT_EQ(truth["frames"].size(), 2u);
    EXPECT_EQ(truth["frames"][1]["frame"], 3);
    const json& joint = truth["frames"][1]["raters"][0]["hands"]["left"]["joints"]["index_mcp"];
    EXPECT_LT((core::jsonVector(joint["xyz"], "", "") - kLeftPoint).norm(), 1e-6);
    EXPECT_EQ(joint["status"], "done");
    EXPECT_EQ(joint["views"].size(), 3u);

    const Ended read = runBatch({"annotations", m_empty, "--sequence", "first", "--from", "handlens", file});
    ASSERT_EQ(read.status, 0) << read.err;
    EXPECT_NE(read.out.find("12 marks read"), std::string::npos) << read.out;
    const core::AnnotationSet set = annotationsOf(m_empty);
    ASSERT_EQ(set.marks.size(), m_clicks.marks.size());
    for (const auto& [key, mark] : m_clicks.marks) {
        ASSERT_TRUE(core::markAt(set, key)) << key.frame << key.camera;
        EXPECT_LT((core::markAt(set, key)->px - mark.px).norm(), 1e-6);
        EXPECT_TRUE(core::markAt(set, key)->isEvidence());
    }
}

TEST_F(BatchFiles, ExportWritesEveryKind) {
    const std::pair<const char*, const char*> kinds[] = {{"coco", "keypoints"},
                                                         {"trc", "PathFileType"},
                                                         {"csv", "index_mcp"},
                                                         {"csv-marks", "cam1"},
                                                         {"anipose3d", "fnum"}};
    for (const auto& [kind, word] : kinds) {
        const fs::path out = m_folder / kind;
        const Ended ended = exportTo(kind, out);
        ASSERT_EQ(ended.status, 0) << kind << ": " << ended.err;
        EXPECT_NE(core::readTextFile(out).find(word), std::string::npos) << kind;
        EXPECT_NE(ended.out.find(out.string()), std::string::npos) << ended.out;
    }
    for (const char* kind : {"tzionas", "deeplabcut", "anipose2d", "interhand", "freihand"}) {
        const fs::path out = m_folder / kind;
        const Ended ended = exportTo(kind, out);
        ASSERT_EQ(ended.status, 0) << kind << ": " << ended.err;
        EXPECT_TRUE(fs::exists(out)) << kind;
        EXPECT_TRUE(fs::is_directory(out) ? !fs::is_empty(out) : fs::file_size(out) > 100) << kind;
    }
}

TEST_F(BatchFiles, AnnotationsReadsMarksFromACsv) {
    const fs::path file = m_folder / "marks.csv";
    ASSERT_EQ(exportTo("csv-marks", file).status, 0);
    const Ended read = runBatch({"annotations", m_empty, "--sequence", "first", "--from", "csv-marks", file});
    ASSERT_EQ(read.status, 0) << read.err;
    EXPECT_EQ(annotationsOf(m_empty).marks.size(), 12u);
    const Ended wrong = runBatch(
        {"annotations", m_empty, "--sequence", "first", "--from", "csv-marks", fs::path(m_set) / "cameras.json"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(annotationsOf(m_empty).marks.size(), 12u) << "a file that cannot be read changes nothing";
}

} // namespace
