// SPDX-License-Identifier: MIT
#include "core/io/benchmark/external_estimates.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/core/benchmark/tiny_benchmark.h"
#include "tests/support/temporary_folder.h"

namespace core {
namespace {

const FramePair kPair{"one", 10, 15};

TEST(ExternalEstimates, CsvAndJsonSayTheSame) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "sequence,start,test,hand,name,x,y,z\r\none,10,15,left,forearm,1,2.5,-3e1\r\n"
                                       "\"one\",10,15,right,index_mcp,4,5,6\r\n";
    std::ofstream(folder / "a.json") << R"({"estimates": [{"sequence": "one", "start": 10, "test": 15, "joints": [
        {"hand": "left", "name": "forearm", "xyz": [1, 2.5, -30]}, {"hand": "right", "name": "index_mcp", "xyz": [4, 5, 6]}]}]})";
    const ExternalEstimates csv = readExternalEstimates("theirs", folder / "a.csv", test::tinyHands());
    EXPECT_EQ(csv.name, "theirs");
    ASSERT_EQ(csv.joints.size(), 1u);
    EXPECT_EQ(csv.joints.at(kPair).at({Side::Left, "forearm"}), Eigen::Vector3d(1, 2.5, -30));
    EXPECT_EQ(csv.joints, readExternalEstimates("theirs", folder / "a.json", test::tinyHands()).joints);
}

TEST(ExternalEstimates, SemicolonsAndDecimalCommasAreRead) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "sequence;start;test;hand;name;x;y;z\r\none;10;15;left;forearm;1,25;2,5;-30\r\n";
    EXPECT_EQ(readExternalEstimates("theirs", folder / "a.csv", {}).joints.at(kPair).at({Side::Left, "forearm"}),
              Eigen::Vector3d(1.25, 2.5, -30));
}

TEST(ExternalEstimates, PosesBecomeJoints) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "p.json") << R"({"estimates": [{"sequence": "one", "start": 10, "test": 15,
        "poses": [[1,2,3,0.1,0.2,0.3,0.4],[0,0,0,0,0,0,0.5]]}]})";
    const std::vector<HandModel> hands = test::tinyHands();
    Pose left(7);
    left << 1, 2, 3, 0.1, 0.2, 0.3, 0.4;
    Pose right = Pose::Zero(7);
    right[6] = 0.5;
    EXPECT_EQ(readExternalEstimates("x", folder / "p.json", hands).joints.at(kPair),
              namedJointPositions(hands, {left, right}));
}

TEST(ExternalEstimates, RefuseWhatMakesNoSense) {
    const test::TemporaryFolder folder;
    const std::string header = "sequence,start,test,hand,name,x,y,z\n";
    for (const std::string& text :
         {std::string(), std::string("x,y,z\n"), header + "one,10,15,left,forearm,1,2\n",
          header + "one,10,15,both,forearm,1,2,3\n", header + "one,-1,15,left,forearm,1,2,3\n",
          header + "one,10,15,left,forearm,1,nan,3\n",
          header + "one,10,15,left,forearm,1,2,3\none,10,15,left,forearm,1,2,3\n"}) {
        std::ofstream(folder / "a.csv", std::ios::trunc) << text;
        EXPECT_THROW(readExternalEstimates("x", folder / "a.csv", {}), Error) << text;
    }
    for (const char* const text : {"{}", R"({"estimates": [{"sequence": "one", "start": 1, "test": 2}]})",
                                   R"({"estimates": [{"sequence": "one", "start": 1, "test": 2, "poses": [[1]]}]})"}) {
        std::ofstream(folder / "a.json", std::ios::trunc) << text;
        EXPECT_THROW(readExternalEstimates("x", folder / "a.json", test::tinyHands()), Error) << text;
    }
}

TEST(ExternalRows, AreMeasuredLikeTheMethods) {
    const BenchmarkScene scene = test::tinyScene();
    const std::vector<FramePair> pairs = {{"one", 14, 15}, kPair, {"two", 1, 6}};
    ExternalEstimates estimates{"theirs", {}};
    estimates.joints[kPair] = namedJointPositions(scene.hands, scene.sequences[0].motion[15]);
    estimates.joints[kPair][{Side::Left, "forearm"}] += Eigen::Vector3d(0, 8, 0);
    estimates.joints[{"one", 0, 39}] = estimates.joints[kPair]; // not asked for
    const auto rows = externalRows(scene, BenchmarkSetup::Synthetic, pairs, estimates);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].pair, kPair);
    EXPECT_NEAR(rows[0].errorMm, 2, 1e-6);
    EXPECT_NEAR(rows[0].initialErrorMm,
                meanJointDistanceMm(scene.hands, scene.sequences[0].motion[10], scene.sequences[0].motion[15]), 1e-6);
    estimates.name = "best:live=1";
    EXPECT_THROW(externalRows(scene, BenchmarkSetup::Synthetic, pairs, estimates), Error) << "the name of a method";
    estimates.name = "theirs";
    EXPECT_THROW(externalRows(scene, BenchmarkSetup::Synthetic, {{"two", 1, 6}}, estimates), Error) << "no pair";
    estimates.joints[kPair][{Side::Left, "tail"}] = Eigen::Vector3d::Zero();
    EXPECT_THROW(externalRows(scene, BenchmarkSetup::Synthetic, pairs, estimates), Error) << "an unknown joint";
}

} // namespace
} // namespace core
