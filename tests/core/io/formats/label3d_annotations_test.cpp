// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <matio.h>

#include "core/error.h"
#include "tests/core/io/formats/annotation_formats_fixture.h"

namespace {

using core::Mark;
using core::MarkState;
using core::Placement;
using core::Side;

/// Variables of a MATLAB file, as Label3D writes them.
matvar_t* numbers(const char* name, std::vector<std::size_t> shape, std::vector<double> values) {
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(shape.size()), shape.data(), values.data(),
                         0);
}
matvar_t* cells(const char* name, std::vector<matvar_t*> items) {
    std::size_t shape[] = {items.size(), 1};
    matvar_t* cell = Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, shape, nullptr, 0);
    for (std::size_t i = 0; i < items.size(); ++i)
        Mat_VarSetCell(cell, static_cast<int>(i), items[i]);
    return cell;
}
matvar_t* texts(const char* name, const std::vector<std::string>& list) {
    std::vector<matvar_t*> items;
    for (const std::string& text : list) {
        std::size_t shape[] = {1, text.size()};
        items.push_back(Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UTF8, 2, shape, const_cast<char*>(text.data()), 0));
    }
    return cells(name, items);
}
matvar_t* structure(const char* name, const std::vector<std::pair<const char*, matvar_t*>>& members) {
    std::vector<const char*> names;
    for (const auto& [member, value] : members)
        names.push_back(member);
    std::size_t shape[] = {1, 1};
    matvar_t* made = Mat_VarCreateStruct(name, 2, shape, names.data(), static_cast<unsigned>(names.size()));
    for (const auto& [member, value] : members)
        Mat_VarSetStructFieldByName(made, member, 0, value);
    return made;
}

class Label3dAnnotations : public test::AnnotationFormats {
protected:
    void write(const std::vector<matvar_t*>& variables, mat_ft version = MAT_FT_MAT5) {
        std::filesystem::remove(m_file);
        mat_t* file = Mat_CreateVer(m_file.c_str(), nullptr, version);
        ASSERT_TRUE(file);
        for (matvar_t* variable : variables) {
            Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
            Mat_VarFree(variable);
        }
        Mat_Close(file);
    }
    std::string refusal() {
        try {
            import("label3d", m_file);
        } catch (const core::Error& error) {
            return error.what();
        }
        return "taken";
    }
    void writeMap() {
        std::ofstream(m_import.jointMap = m_folder / "map.json")
            << R"({"format":"handlens-joint-map","version":1,"joints":[)"
               R"({"name":"a","joint":"wrist","hand":"left"},{"name":"b","joint":"index_mcp","hand":"right"}]})";
    }
    /// Labels of two joints in pictures 0 and 7 of two cameras.
    std::vector<matvar_t*> dannceLabels() {
        std::vector<matvar_t*> labels;
        for (const double camera : {0.0, 100.0}) {
            labels.push_back(
                structure(nullptr, {{"data_2d", numbers(nullptr, {2, 4}, {camera + 1, 11, 2, 12, 3, 13, NAN, 14})},
                                    {"data_3d", numbers(nullptr, {2, 6}, std::vector<double>(12))},
                                    {"data_frame", numbers(nullptr, {1, 2}, {0, 7})},
                                    {"data_sampleID", numbers(nullptr, {2, 1}, {1, 8})}}));
        }
        return {cells("labelData", labels), texts("camnames", {"cam3", "cam1"})};
    }
    /// A session of two joints, the dataset's cameras and two pictures.
    std::vector<matvar_t*> session(bool isClicked) {
        const std::size_t cameras = m_dataset.cameras.size();
        std::vector<double> clicks(2 * cameras * 2 * 2, NAN);
        const auto click = [&](std::size_t joint, std::size_t camera, std::size_t frame, double x, double y) {
            clicks[joint + 2 * (camera + cameras * 2 * frame)] = x;
            clicks[joint + 2 * (camera + cameras * (1 + 2 * frame))] = y;
        };
        if (isClicked) {
            click(0, 1, 0, 51, 61);
            click(1, 2, 1, 52.5, 62.5);
        }
        return {numbers("handLabeled2D", {2, cameras, 2, 2}, clicks),
                numbers("data_3D", {2, 6}, {1, 2, 3, 4, 5, 6, NAN, NAN, NAN, NAN, NAN, NAN}),
                numbers("framesToLabel", {1, 2}, {2, 3}),
                cells("sync", {structure(nullptr, {{"data_frame", numbers(nullptr, {3, 1}, {0, 5, 10})}})}),
                structure("skeleton", {{"joint_names", texts(nullptr, {"left_wrist", "right_index_mcp"})}})};
    }
    const std::filesystem::path m_file = m_folder / "Label3D_dannce.mat";
};

TEST_F(Label3dAnnotations, DannceLabelsAreReprojectionsThatCountPixelsFromOne) {
    writeMap();
    for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
        write(dannceLabels(), version);
        const auto got = import("label3d", m_file);
        ASSERT_EQ(got.set.marks.size(), 6u);
        EXPECT_EQ(*mark(got.set, 0, {Side::Left, "wrist"}, "cam3"),
                  (Mark{{0, 1}, Placement::Proposed, MarkState::Visible}));
        EXPECT_EQ(mark(got.set, 0, {Side::Left, "wrist"}, "cam1")->px, Eigen::Vector2d(100, 1));
        EXPECT_EQ(mark(got.set, 7, {Side::Left, "wrist"}, "cam1")->px, Eigen::Vector2d(10, 11));
        EXPECT_EQ(mark(got.set, 7, {Side::Right, "index_mcp"}, "cam3")->px, Eigen::Vector2d(12, 13));
    }
    m_import.jointMap.clear();
    EXPECT_NE(refusal().find("labelData: names no joints: --map must list the 2 of them"), std::string::npos)
        << refusal();
}

TEST_F(Label3dAnnotations, ClicksOfASessionAreMarksOfItsVideosFrames) {
    write(session(true));
    const auto got = import("label3d", m_file);
    ASSERT_EQ(got.set.marks.size(), 2u);
    EXPECT_EQ(*mark(got.set, 5, {Side::Left, "wrist"}, m_dataset.cameras[1].name),
              (Mark{{50, 60}, Placement::Manual, MarkState::Visible}));
    EXPECT_EQ(mark(got.set, 10, {Side::Right, "index_mcp"}, m_dataset.cameras[2].name)->px,
              Eigen::Vector2d(51.5, 61.5));
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_NE(core::importNoteText(got.warnings[0]).find("taken in the dataset's order, cam0, cam1"),
              std::string::npos);
}

TEST_F(Label3dAnnotations, PointsWithoutClicksAreProposedInEveryViewThatSeesThem) {
    write(session(false));
    const auto got = import("label3d", m_file).set;
    ASSERT_FALSE(got.marks.empty());
    for (const auto& [key, mark] : got.marks) {
        EXPECT_EQ(mark.placement, Placement::Proposed);
        ASSERT_TRUE(key.frame == 5 || key.frame == 10) << key.frame;
        EXPECT_EQ(key.joint, (core::JointId{Side::Left, "wrist"}));
        const auto& camera = m_dataset.cameras[static_cast<std::size_t>(m_dataset.cameraIndex(key.camera))];
        const Eigen::Vector3d point = key.frame == 5 ? Eigen::Vector3d(1, 3, 5) : Eigen::Vector3d(2, 4, 6);
        EXPECT_LT((mark.px - *core::project(camera, point)).norm(), 1e-9);
    }
}

TEST_F(Label3dAnnotations, FilesThatAreWrongAreRefusedByName) {
    std::ofstream(m_file) << "no";
    EXPECT_EQ(refusal(), m_file.string() + ": is not a readable MATLAB file");
    write({numbers("K", {1, 1}, {1})});
    EXPECT_NE(refusal().find("labelData: is missing"), std::string::npos);
    auto variables = session(true);
    Mat_VarFree(variables[2]);
    variables.erase(variables.begin() + 2);
    write(variables);
    EXPECT_NE(refusal().find("framesToLabel: is missing"), std::string::npos) << refusal();
    variables = session(true);
    Mat_VarFree(variables[4]);
    variables[4] = structure("skeleton", {{"joint_names", texts(nullptr, {"left_wrist"})}});
    write(variables);
    EXPECT_NE(refusal().find("skeleton.joint_names: has 1 names, 2 are expected"), std::string::npos) << refusal();
}

} // namespace
