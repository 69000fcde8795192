// SPDX-License-Identifier: MIT
#include "core/io/hands/rig_file.h"

#include <fstream>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace {

using nlohmann::json;

json smallRig() {
    return json::parse(R"({
        "format": "handlens-rig", "version": 1, "name": "small",
        "jointAxes": {"forward": [0, 0, -1], "dorsal": [0, 1, 0]},
        "joints": [{"name": "wrist", "parent": null}, {"name": "index_mcp", "parent": "wrist", "namesInFile": ["b01_{side}"]}],
        "dofs": [{"joint": "index_mcp", "name": "flexion", "axis": [0, 1, 0], "limitsDeg": [-20, 90]}]})");
}

/// Reads the rig after a change, and gives the field that the error names.
std::string fieldAtFault(const std::function<void(json&)>& change) {
    const test::TemporaryFolder folder;
    json value = smallRig();
    change(value);
    const std::filesystem::path file = folder.path() / "rig.json";
    std::ofstream(file) << value;
    try {
        core::readRig(file);
    } catch (const core::Error& error) {
        EXPECT_EQ(error.file(), file.string());
        return error.field();
    }
    return "no error";
}

TEST(RigFile, ReadsJointsNamesAxesAndLimits) {
    const core::Rig rig = core::rigFromJson(smallRig(), "rig.json");
    EXPECT_EQ(rig.name, "small");
    ASSERT_EQ(rig.joints.size(), 2U);
    EXPECT_EQ(rig.joints[1].parent, "wrist");
    EXPECT_EQ(rig.joints[1].namesInFile, std::vector<std::string>{"b01_{side}"});
    EXPECT_EQ(rig.forwardInJoint, Eigen::Vector3d(0, 0, -1));
    ASSERT_EQ(rig.dofs.size(), 1U);
    EXPECT_EQ(rig.dofs[0].maxDeg, 90);
}

TEST(RigFile, NamesTheFieldAtFault) {
    EXPECT_EQ(fieldAtFault([](json&) {}), "no error");
    EXPECT_EQ(fieldAtFault([](json& r) { r["joints"][1]["name"] = "wrist"; }), "joints[1].name");
    EXPECT_EQ(fieldAtFault([](json& r) { r["joints"][1]["parent"] = "elbow"; }), "joints[1].parent");
    EXPECT_EQ(fieldAtFault([](json& r) { r["joints"][1]["parent"] = nullptr; }), "joints[1].parent");
    EXPECT_EQ(fieldAtFault([](json& r) { r["joints"][0]["parent"] = "wrist"; }), "joints[0].parent");
    EXPECT_EQ(fieldAtFault([](json& r) { r["dofs"][0]["joint"] = "thumb"; }), "dofs[0].joint");
    EXPECT_EQ(fieldAtFault([](json& r) { r["dofs"][0]["joint"] = "wrist"; }), "dofs[0].joint");
    EXPECT_EQ(fieldAtFault([](json& r) { r["dofs"].push_back(r["dofs"][0]); }), "dofs[1].name");
    EXPECT_EQ(fieldAtFault([](json& r) { r["dofs"][0]["axis"] = {0, 0, 0}; }), "dofs[0].axis");
    EXPECT_EQ(fieldAtFault([](json& r) { r["dofs"][0]["axis"] = {0, 0}; }), "dofs[0].axis");
    EXPECT_EQ(fieldAtFault([](json& r) { r["dofs"][0]["limitsDeg"] = {10, 90}; }), "dofs[0].limitsDeg");
    EXPECT_EQ(fieldAtFault([](json& r) { r["jointAxes"]["dorsal"] = {0, 0, 2}; }), "jointAxes");
    EXPECT_EQ(fieldAtFault([](json& r) { r["version"] = 2; }), "version");
    EXPECT_EQ(fieldAtFault([](json& r) { r["format"] = "handlens-hand"; }), "format");
}

TEST(RigFile, TheDefaultsHave35DegreesOfFreedom) {
    for (const char* name : {"handlens", "webxr"}) {
        const core::Rig rig = core::defaultRig(name);
        EXPECT_EQ(rig.dofs.size(), 29U) << name;
        EXPECT_EQ(rig.joints.size(), 25U) << name;
    }
}

} // namespace
