// SPDX-License-Identifier: MIT
// What `subject` says where there is little to measure from: two views in a unit of their own, one hand, few frames.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/annotation/import_edit.h"
#include "core/hand/skeleton.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/files/json_file.h"
#include "core/io/store/annotation_store.h"
#include "core/subject/hand_tips.h"
#include "tests/app/batch/program.h"
#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

namespace {

using test::Ended;
using test::runBatch;

constexpr double kUnitMm = 31; ///< squares of a chess board

/// The demo's left hand with its tips, 21 joints and more, clicked in two views of a stereo rig.
class BatchSubject : public testing::Test {
protected:
    void write(const std::vector<int>& frames, double unitMm = kUnitMm) {
        const core::NewDataset demo = core::makeDemoDataset();
        core::Dataset dataset = demo.dataset;
        dataset.folder.clear();
        dataset.cameras = stereo(dataset.cameras);
        dataset.sequences.resize(1);
        core::Sequence& sequence = dataset.sequences[0];
        sequence.name = "one";
        sequence.motion.clear();
        sequence.masks.clear();
        sequence.annotations = "annotations/one.sqlite";
        sequence.views.clear();
        for (const core::Camera& camera : dataset.cameras)
            sequence.views.push_back({camera.name, core::ViewKind::None, "", 0});
        const core::AnnotationSet set = clicks(dataset, demo.motions[0], frames);
        for (core::Camera& camera : dataset.cameras)
            camera.cameraFromWorld.translation /= unitMm;
        core::writeDataset(dataset, {{}}, m_set);
        const core::Dataset written = core::readDataset(m_set);
        auto store = core::AnnotationStore::open(core::annotationFile(written, written.sequences[0]));
        store.commit(core::importEdit({}, set, "clicks"), "ann");
    }
    /// Two of the ring that look at the hand from one side.
    static std::vector<core::Camera> stereo(const std::vector<core::Camera>& ring) { return {ring[0], ring[1]}; }

    static core::AnnotationSet clicks(const core::Dataset& dataset, const core::Motion& motion,
                                      const std::vector<int>& frames) {
        const core::HandModel hand = core::withTips(dataset.hands[0]);
        auto random = test::randomFor("BatchSubject");
        core::AnnotationSet set;
        for (const int frame : frames) {
            const auto joints = core::jointPositions(hand.skeleton, motion[static_cast<std::size_t>(frame)][0]);
            for (std::size_t b = 0; b < joints.size(); ++b)
                test::clickEverywhere(set, dataset.cameras, frame, "ann",
                                      {core::Side::Left, hand.skeleton.bones[b].name}, joints[b], 0.3, &random);
        }
        return set;
    }
    Ended measure(const std::string& sequence = "one") const {
        return runBatch({"subject", m_set, "--sequence", sequence, "--json", m_json, "--out", m_out});
    }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set", m_out = m_folder / "person", m_json = m_folder / "subject.json";
};

TEST_F(BatchSubject, MeasuresOneHandFromTwoViewsInAUnitOfTheirOwnAndThreeFrames) {
    write({0, 20, 40});
    const Ended ended = measure();
    ASSERT_EQ(ended.status, 0) << ended.err;
    const nlohmann::json found = core::readJsonFile(m_json);
    core::checkSchema(found, "subject", m_json);
    EXPECT_NEAR(found["calibrationUnitMm"].get<double>(), kUnitMm, 0.02 * kUnitMm);
    EXPECT_EQ(found["calibrationUnitKnown"], false) << "a hand does not tell squares from their neighbours";
    EXPECT_NE(ended.out.find("the scale cannot be told from the unit"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("fewer than 5 frames: the bones keep the model's proportions"), std::string::npos);
    EXPECT_NE(ended.out.find("the girth stays the model's"), std::string::npos) << "there are no masks";
    EXPECT_EQ(found["lengthsKept"], true);
    EXPECT_EQ(found["frames"].size(), 3u);
    ASSERT_EQ(found["hands"].size(), 2u);
    EXPECT_EQ(found["hands"][0]["frames"], 3);
    EXPECT_EQ(found["hands"][1]["frames"], 0);
    EXPECT_NE(ended.out.find("right hand: "), std::string::npos);
    EXPECT_NE(ended.out.find("annotated in no frame: it follows the other hand"), std::string::npos);
    const double left = found["hands"][0]["scale"]["value"], right = found["hands"][1]["scale"]["value"];
    EXPECT_NEAR(left, 1, 0.01) << "the unit is chosen so that it is 1";
    EXPECT_NEAR(right, left, 0.005);
    int tips = 0;
    for (const auto& bone : found["hands"][0]["bones"])
        tips += bone["to"].get<std::string>().ends_with("_tip");
    EXPECT_EQ(tips, 5);
    const core::Dataset person = core::readDataset(m_out);
    const core::Dataset model = core::readDataset(m_set);
    EXPECT_NEAR(person.cameras[0].cameraFromWorld.translation.norm() /
                    model.cameras[0].cameraFromWorld.translation.norm(),
                found["calibrationUnitMm"].get<double>(), 1e-6)
        << "the new dataset's cameras are in mm";
    EXPECT_EQ(runBatch({"check", m_out}).status, 0);
}

TEST_F(BatchSubject, KnowsCentimetresAndMetresFromTheHand) {
    for (const double unit : {10.0, 1000.0}) {
        std::filesystem::remove_all(m_set);
        std::filesystem::remove_all(m_out);
        write({0, 20, 40}, unit);
        const Ended ended = measure();
        ASSERT_EQ(ended.status, 0) << ended.err;
        const nlohmann::json found = core::readJsonFile(m_json);
        EXPECT_EQ(found["calibrationUnitMm"], unit);
        EXPECT_EQ(found["calibrationUnitKnown"], true);
    }
}

TEST_F(BatchSubject, OfOneFrameOnlyTheScaleIsMeasured) {
    write({20}, 1);
    const Ended ended = measure();
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("fewer than 3 frames: only the scale is measured"), std::string::npos) << ended.out;
    EXPECT_EQ(core::readJsonFile(m_json)["girthKept"], true);
}

TEST_F(BatchSubject, RefusesInOneSentenceAndLeavesNothingBehind) {
    write({});
    const Ended none = measure();
    EXPECT_EQ(none.status, 1);
    EXPECT_EQ(std::count(none.err.begin(), none.err.end(), '\n'), 1) << none.err;
    const Ended unknown = measure("two");
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("two"), std::string::npos) << unknown.err;
    EXPECT_FALSE(std::filesystem::exists(m_out));
    EXPECT_FALSE(std::filesystem::exists(m_json));
}

} // namespace
