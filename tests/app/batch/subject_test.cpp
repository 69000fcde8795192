// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/annotation/import_edit.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/files/json_file.h"
#include "core/io/store/annotation_store.h"
#include "core/subject/hand_shape.h"
#include "tests/app/batch/program.h"
#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/two_finger_hand.h"

#include <nlohmann/json.hpp>

namespace {

using test::Ended;
using test::runBatch;

constexpr double kScale = 1.04;
constexpr int kFrames = 8;

/// A dataset with clicks of the left hand of a person who is 4 % larger than the model.
class BatchSubject : public testing::Test {
protected:
    BatchSubject() {
        core::Dataset dataset;
        dataset.name = "person";
        dataset.cameras = test::cameraRing(4);
        dataset.hands = {test::twoFingerHand(core::Side::Left)};
        dataset.handFiles = {"hands/left.json"};
        core::Sequence sequence{"one", kFrames, 25, {}, "", "", "annotations/one.sqlite"};
        for (const core::Camera& camera : dataset.cameras)
            sequence.views.push_back({camera.name, core::ViewKind::None, "", 0});
        dataset.sequences = {sequence};
        core::writeDataset(dataset, {{}}, m_set);
        dataset.folder = m_set;
        auto store = core::AnnotationStore::open(core::annotationFile(dataset, dataset.sequences[0]));
        store.commit(core::importEdit({}, clicks(dataset), "clicks"), "ann");
    }

    static core::AnnotationSet clicks(const core::Dataset& dataset) {
        const core::ShapeSpace space(dataset.hands[0]);
        core::HandShape shape = space.modelShape();
        shape[0] = std::log(kScale);
        const core::Skeleton larger = space.shaped(shape).skeleton;
        test::RandomValues poses("batch subject");
        auto random = test::randomFor("batch subject");
        core::AnnotationSet set;
        for (int frame = 0; frame < kFrames; ++frame) {
            const auto joints = core::jointPositions(larger, test::somePose(larger, poses));
            for (std::size_t b = 0; b < joints.size(); ++b)
                test::clickEverywhere(set, dataset.cameras, frame, "ann", {core::Side::Left, larger.bones[b].name},
                                      joints[b], 0.2, &random);
        }
        return set;
    }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set", m_out = m_folder / "measured", m_json = m_folder / "subject.json";
};

TEST_F(BatchSubject, MakesADatasetWithTheHandsOfThePerson) {
    const Ended ended = runBatch({"subject", m_set, "--sequence", "one", "--json", m_json, "--out", m_out});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("8 annotated frames"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("left hand: scale 1.0"), std::string::npos) << ended.out;
    const nlohmann::json measured = core::readJsonFile(m_json);
    core::checkSchema(measured, "subject", m_json);
    EXPECT_NEAR(measured["hands"][0]["scale"]["value"].get<double>(), kScale, 0.01);
    const core::Dataset before = core::readDataset(m_set), after = core::readDataset(m_out);
    EXPECT_NEAR(after.hands[0].skeleton.bones[1].lengthMm, kScale * before.hands[0].skeleton.bones[1].lengthMm, 1);
    EXPECT_EQ(core::readAnnotations(after, after.sequences[0]).marks,
              core::readAnnotations(before, before.sequences[0]).marks);
    EXPECT_EQ(runBatch({"check", m_out}).status, 0);
}

TEST_F(BatchSubject, LeavesNothingBehindWhereItCannotMeasure) {
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"--sequence", "two"}, {"--sequence", "one", "--rater", "bob"}}) {
        std::vector<std::string> arguments{"subject", m_set, "--json", m_json, "--out", m_out};
        arguments.insert(arguments.end(), wrong.begin(), wrong.end());
        const Ended ended = runBatch(arguments);
        EXPECT_EQ(ended.status, 1) << ended.out;
        EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
        EXPECT_FALSE(std::filesystem::exists(m_out));
        EXPECT_FALSE(std::filesystem::exists(m_json));
    }
}

} // namespace
