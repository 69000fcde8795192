// SPDX-License-Identifier: MIT
#include "core/io/formats/joint_files.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace {

using core::JointId;
using core::JointMap;
using core::Side;

TEST(JointMap, BuiltInMapsHaveTheOrdersOfTheirFormats) {
    const JointMap authors = core::readJointMap("tzionas");
    ASSERT_EQ(authors.entries().size(), 28u);
    for (int i = 0; i < 28; ++i) {
        EXPECT_EQ(authors.entries()[static_cast<std::size_t>(i)].name, std::to_string(i));
        EXPECT_EQ(authors.entries()[static_cast<std::size_t>(i)].hand, i < 14 ? Side::Right : Side::Left);
    }
    EXPECT_EQ(authors.entries()[3].joint, "ring_mcp");
    EXPECT_EQ(authors.entries()[26].joint, "thumb_mcp");
    EXPECT_EQ(core::readJointMap("freihand").handList(Side::Left).front().second.joint, "wrist");
    EXPECT_EQ(core::readJointMap("freihand").handList(Side::Left)[4].second.joint, "thumb_tip");
    EXPECT_EQ(core::readJointMap("interhand").handList(Side::Left).front().second.joint, "thumb_tip");
    EXPECT_EQ(core::readJointMap("interhand").handList(Side::Left).back().second.joint, "wrist");
    EXPECT_EQ(core::readJointMap("coco").handList(Side::Right)[5].first, "forefinger1");
}

TEST(JointMap, NamesGoThereAndBack) {
    for (const JointMap& map : {JointMap(), core::readJointMap("coco"), core::readJointMap("tzionas")}) {
        for (const Side hand : {Side::Left, Side::Right}) {
            for (const std::string& joint : core::readJointList("14")) {
                const JointId id{hand, joint};
                const auto name = map.sharedName(id);
                ASSERT_TRUE(name) << joint;
                EXPECT_EQ(map.jointOf(*name), id);
            }
        }
    }
    EXPECT_EQ(JointMap().sharedName({Side::Right, "index_mcp"}), "right_index_mcp");
    EXPECT_FALSE(JointMap().jointOf("index_mcp")); // whose?
    EXPECT_FALSE(core::readJointMap("coco").sharedName({Side::Left, "forearm"}));
}

TEST(JointMap, RefusesDoubles) {
    const test::TemporaryFolder folder;
    const auto refused = [&](const std::string& joints) {
        std::ofstream(folder / "map.json")
            << R"({"format": "handlens-joint-map", "version": 1, "joints": [)" << joints << "]}";
        EXPECT_THROW(core::readJointMap(folder / "map.json"), core::Error) << joints;
    };
    refused(R"({"name": "a", "joint": "wrist"}, {"name": "a", "joint": "thumb_ip"})");
    refused(R"({"name": "a", "joint": "wrist"}, {"name": "b", "joint": "wrist", "hand": "left"})");
    refused(R"({"name": "a"})");
    refused("");
    EXPECT_THROW(core::readJointMap("no such map"), core::Error);
}

TEST(JointList, ReadsBuiltInListsAndFiles) {
    const auto twentyOne = core::readJointList("21");
    EXPECT_EQ(std::set<std::string>(twentyOne.begin(), twentyOne.end()).size(), 21u);
    EXPECT_EQ(core::readJointList("14").size(), 14u);
    const test::TemporaryFolder folder;
    std::ofstream(folder / "own.json")
        << R"({"format": "handlens-joint-list", "version": 1, "joints": ["wrist", "thumb_tip"]})";
    EXPECT_EQ(core::readJointList(folder / "own.json"), (std::vector<std::string>{"wrist", "thumb_tip"}));
}

} // namespace
