// SPDX-License-Identifier: MIT
#include "core/io/detector/first_pass.h"

#include <cstdlib>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/io/demo/demo_dataset.h"
#include "core/io/detector/auto_label_file.h"
#include "core/io/detector/detector_files.h"
#include "core/simulation/simulated_pictures.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

/// The demo on the disk, with recorded motion and rendered views.
class FirstPass : public testing::Test {
protected:
    void SetUp() override {
        static const core::NewDataset demo = core::makeDemoDataset(); // takes longer than most tests
        core::writeDataset(demo.dataset, demo.motions, m_folder / "demo");
        m_dataset = core::readDataset(m_folder / "demo");
        m_motion = demo.motions.front();
    }
    const core::Sequence& sequence() const { return m_dataset.sequences.front(); }
    Eigen::Vector3d truth(int frame, core::Side side, const std::string& joint) const {
        for (std::size_t h = 0; h < m_dataset.hands.size(); ++h) {
            const core::Skeleton& skeleton = m_dataset.hands[h].skeleton;
            if (m_dataset.hands[h].side == side)
                return core::jointPositions(
                    skeleton,
                    m_motion[static_cast<std::size_t>(frame)][h])[static_cast<std::size_t>(skeleton.boneIndex(joint))];
        }
        return Eigen::Vector3d::Zero();
    }
    double errorMm(int frame, const std::vector<core::AutoHand>& hands) const {
        double sum = 0;
        int count = 0;
        for (const core::AutoHand& hand : hands)
            for (const core::AutoJoint& joint : hand.joints) {
                sum += (joint.pointInWorld - truth(frame, hand.side, joint.name)).norm();
                ++count;
            }
        return sum / std::max(1, count);
    }
    core::CorrectedFrame corrected(int frame) const {
        core::CorrectedFrame corrected;
        corrected.frame = frame;
        for (const core::HandModel& hand : m_dataset.hands)
            for (const core::Bone& bone : hand.skeleton.bones) {
                core::TriangulatedPoint point;
                point.pointInWorld = truth(frame, hand.side, bone.name);
                corrected.joints[{hand.side, bone.name}] = point;
            }
        return corrected;
    }

    test::TemporaryFolder m_folder;
    core::Dataset m_dataset;
    core::Motion m_motion;
};

TEST_F(FirstPass, NeedsHandsFromSomewhere) {
    m_dataset.hands.clear();
    test::expectError([&] { core::runFirstPass(m_dataset, sequence(), {}, {0}, {}); }, core::ErrorCode::BadInput,
                      "dataset.json", "hand model");
}

TEST_F(FirstPass, TracksTheNeighboursOfACorrectedFrameWithoutADetector) {
    std::vector<int> seen;
    core::FirstPassCallbacks callbacks;
    callbacks.frame = [&](int frame, const std::vector<core::AutoHand>& hands) {
        seen.push_back(frame);
        EXPECT_LT(errorMm(frame, hands), 1) << frame;
    };
    const auto labels = core::retrackFrames(m_dataset, sequence(), m_dataset.hands, m_dataset.cameras, corrected(40),
                                            {39, 40, 41}, {41}, {}, {}, callbacks);
    EXPECT_EQ(seen, (std::vector{40, 39}));
    ASSERT_EQ(labels.size(), 2u);
    const core::Edit all = core::autoLabelEdit({}, m_dataset, labels, "anna");
    const core::Edit one = core::autoLabelEdit({}, m_dataset, labels, "anna", {{core::Side::Left, "index_pip"}});
    EXPECT_GT(one.marks.size(), 2u);
    EXPECT_LE(one.marks.size(), 2 * m_dataset.cameras.size());
    EXPECT_GT(all.marks.size(), 40 * one.marks.size() / 2);
    for (const core::MarkChange& change : one.marks) {
        EXPECT_EQ(change.key.joint.joint, "index_pip");
        EXPECT_GT(change.after->likelihood, 0.5);
    }
}

/// With the real networks, if the environment names their package.
class FirstPassWithNetworks : public FirstPass {
protected:
    void SetUp() override {
        const char* package = std::getenv("HANDLENS_DETECTOR_PACKAGE");
        if (!package)
            GTEST_SKIP() << "HANDLENS_DETECTOR_PACKAGE names no package of @mediapipe/hands";
        FirstPass::SetUp();
        core::installDetector(package, m_folder / "detector");
        m_networks = core::readDetector(m_folder / "detector");
    }
    core::DetectorNetworks m_networks;
};

TEST_F(FirstPassWithNetworks, LabelsTheDemoWithinTwoMillimetres) {
    core::FirstPassOptions options;
    options.keyEveryFrames = 2;
    options.measureHands = false;
    options.threads = 2;
    options.journal = m_folder / "journal";
    const auto result = core::runFirstPass(m_dataset, sequence(), m_networks, {40, 41, 42}, options);
    ASSERT_TRUE(result.isFinished);
    ASSERT_EQ(result.labels.size(), 3u);
    for (const auto& [frame, hands] : result.labels) {
        EXPECT_EQ(hands.size(), 2u);
        EXPECT_LT(errorMm(frame, hands), 2) << frame;
        for (const core::AutoHand& hand : hands)
            EXPECT_LT(hand.doubt, 0.5);
    }
    const auto again = core::runFirstPass(m_dataset, sequence(), m_networks, {40, 41, 42}, options);
    EXPECT_EQ(again.resumedFrames, 2);
    EXPECT_EQ(again.labels.at(41)[0].joints[5].pointInWorld, result.labels.at(41)[0].joints[5].pointInWorld);
    core::finishFirstPass(options);
    EXPECT_FALSE(std::filesystem::exists(options.journal));
}

/// The detector sees these hands too small: silhouettes must say that they are the model's.
TEST_F(FirstPassWithNetworks, MeasuresTheDemosHandsByTheirSilhouettes) {
    core::FirstPassOptions options;
    options.threads = 2;
    const std::vector<int> frames{0, 14, 42, 56};
    const auto result = core::runFirstPass(m_dataset, sequence(), m_networks, frames, options);
    ASSERT_TRUE(result.isFinished);
    ASSERT_EQ(result.labels.size(), frames.size());
    double sum = 0;
    for (const auto& [frame, hands] : result.labels) {
        sum += errorMm(frame, hands) / static_cast<double>(frames.size());
        for (const core::AutoHand& hand : hands)
            EXPECT_LT(hand.doubt, 0.5) << frame;
    }
    EXPECT_LT(sum, 2);
}

TEST_F(FirstPassWithNetworks, TheDetectorKeepsQuietWhereThereAreNoHands) {
    core::HandDetector detector(m_networks);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        cv::Mat picture = core::backgroundPicture(m_dataset.cameras.front(), seed);
        // a walking animal of lines and dots
        for (int bone = 0; bone < 8; ++bone)
            cv::line(picture, {300 + 60 * bone, 800}, {330 + 60 * bone, 1000 - 25 * (bone % 3)}, {60, 90, 130}, 14);
        cv::ellipse(picture, {520, 780}, {260, 80}, 8, 0, 360, {70, 100, 140}, -1);
        EXPECT_TRUE(detector.search(picture, true).empty()) << seed;
    }
}

} // namespace
