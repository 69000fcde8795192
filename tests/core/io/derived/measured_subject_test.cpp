// SPDX-License-Identifier: MIT
#include "core/io/derived/measured_subject.h"

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "core/annotation/import_edit.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/derived_dataset.h"
#include "core/io/derived/subject_file.h"
#include "core/io/files/json_file.h"
#include "core/io/store/annotation_store.h"
#include "core/rig/rig_findings.h"
#include "core/subject/hand_tips.h"
#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/two_finger_hand.h"

#include <nlohmann/json.hpp>

namespace {

constexpr double kScale = 1.05;

/// Clicks of the left hand of a person who is 5 % larger than the model, tips too, seen by a calibration in
/// centimetres. The model has no tips; the right hand is never clicked.
class MeasuredSubject : public testing::Test {
protected:
    MeasuredSubject() {
        core::Dataset dataset;
        dataset.name = "person";
        dataset.cameras = test::cameraRing(4);
        dataset.hands = {test::twoFingerHand(core::Side::Left), test::twoFingerHand(core::Side::Right)};
        dataset.handFiles = {"hands/left.json", "hands/right.json"};
        core::Sequence sequence{"one", 10, 25, {}, "", "", "annotations/one.sqlite"};
        for (const core::Camera& camera : dataset.cameras)
            sequence.views.push_back({camera.name, core::ViewKind::None, "", 0});
        dataset.sequences = {sequence};
        const core::AnnotationSet set = clicks(dataset.cameras);
        for (core::Camera& camera : dataset.cameras)
            camera.cameraFromWorld.translation /= 10;
        core::writeDataset(dataset, {{}}, m_folder / "cm");
        m_dataset = core::readDataset(m_folder / "cm");
        auto store = core::AnnotationStore::open(core::annotationFile(m_dataset, m_dataset.sequences[0]));
        store.commit(core::importEdit({}, set, "clicks"), "ann");
    }

    static core::AnnotationSet clicks(const std::vector<core::Camera>& cameras) {
        const core::ShapeSpace space(core::withTips(test::twoFingerHand(core::Side::Left)));
        core::HandShape shape = space.modelShape();
        shape[0] = std::log(kScale);
        const core::Skeleton skeleton = space.shaped(shape).skeleton;
        test::RandomValues poses("measured subject");
        auto random = test::randomFor("measured subject");
        core::AnnotationSet set;
        for (int f = 0; f < 8; ++f) {
            const auto joints = core::jointPositions(skeleton, test::somePose(skeleton, poses));
            for (std::size_t b = 0; b < joints.size(); ++b)
                test::clickEverywhere(set, cameras, f, "ann", {core::Side::Left, skeleton.bones[b].name}, joints[b],
                                      0.3, &random);
        }
        return set;
    }

    test::TemporaryFolder m_folder;
    core::Dataset m_dataset;
};

TEST_F(MeasuredSubject, FindsUnitsTipsAndTheHandThatIsNotThere) {
    core::SubjectRequest request;
    request.sequences = {"one"};
    const core::MeasuredSubject measured = core::measureSubject(m_dataset, request);
    EXPECT_EQ(measured.unitMm, 10);
    EXPECT_TRUE(measured.isUnitKnown);
    EXPECT_TRUE(core::findRigFaults(measured.rigHealth).empty());
    ASSERT_EQ(measured.result.hands.size(), 2u);
    EXPECT_NEAR(measured.result.hands[0].scale.value, kScale, 0.005);
    EXPECT_EQ(measured.result.hands[1].frames, 0);
    const auto& bones = measured.dataset.hands[0].skeleton.bones;
    ASSERT_EQ(bones.size(), 5u) << "the new hand has the bones of the model alone";
    EXPECT_NEAR(bones[2].lengthMm, kScale * 32, 1);
    EXPECT_EQ(measured.result.hands[0].bones.back().to, "thumb_tip");
    core::writeSubjectFile(m_folder / "subject.json", measured);
    const nlohmann::json file = core::readJsonFile(m_folder / "subject.json");
    core::checkSchema(file, "subject", "subject.json");
    EXPECT_EQ(file["hands"][1]["frames"], 0);
    EXPECT_EQ(file["calibrationUnitMm"], 10);
    EXPECT_EQ(file["frames"].size(), 8u);
}

TEST_F(MeasuredSubject, SaysThatACameraIsOff) {
    core::Dataset turned = m_dataset;
    core::RigidMotion& motion = turned.cameras[1].cameraFromWorld;
    const Eigen::Vector3d centre = turned.cameras[1].centreInWorld();
    motion.rotation = core::rotationExp({0.004, 0.003, 0}) * motion.rotation;
    motion.translation = -(motion.rotation * centre);
    core::SubjectRequest request;
    request.sequences = {"one"};
    const core::MeasuredSubject measured = core::measureSubject(turned, request);
    const std::vector<core::RigFinding> faults = core::findRigFaults(measured.rigHealth);
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults[0].kind, core::RigFindingKind::CameraOff);
    EXPECT_TRUE(core::isOffFinding(faults[0].kind));
}

TEST_F(MeasuredSubject, CopiesAnnotationsThatAreBeingWritten) {
    auto store = core::AnnotationStore::open(core::annotationFile(m_dataset, m_dataset.sequences[0]));
    core::AnnotationSet more;
    test::clickEverywhere(more, m_dataset.cameras, 9, "ann", {core::Side::Left, "wrist"}, {0, 0, 0});
    store.commit(core::importEdit({}, more, "more"), "ann"); // in the log, with the file open
    core::writeDerivedDataset(m_dataset, m_dataset, m_folder / "copy");
    const core::Dataset copy = core::readDataset(m_folder / "copy");
    const std::filesystem::path file = core::annotationFile(copy, copy.sequences[0]);
    EXPECT_FALSE(std::filesystem::exists(file.string() + "-wal")) << "the copy needs no log";
    EXPECT_EQ(core::readAnnotations(copy, copy.sequences[0]).marks, store.annotations().marks);
    auto copied = core::AnnotationStore::open(file);
    EXPECT_EQ(copied.history().done.size(), store.history().done.size());
    EXPECT_TRUE(copied.undo());
    EXPECT_EQ(store.annotations().marks.size(), copied.annotations().marks.size() + 4) << "they are apart";
}

} // namespace
