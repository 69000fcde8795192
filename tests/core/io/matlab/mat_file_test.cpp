// SPDX-License-Identifier: MIT
#include <fstream>

#include <gtest/gtest.h>
#include <matio.h>

#include "core/io/calibration/calibration.h"
#include "core/io/matlab/mat_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

using core::ErrorCode::BadInput;

class MatFiles : public testing::TestWithParam<mat_ft> {
protected:
    void write(const std::vector<matvar_t*>& variables, matio_compression packing = MAT_COMPRESSION_NONE) {
        std::filesystem::remove(m_path);
        mat_t* file = Mat_CreateVer(m_path.c_str(), nullptr, GetParam());
        ASSERT_TRUE(file);
        for (matvar_t* variable : variables) {
            ASSERT_EQ(Mat_VarWrite(file, variable, packing), 0);
            Mat_VarFree(variable);
        }
        Mat_Close(file);
    }
    template <class Type>
    static matvar_t* matrix(const char* name, matio_classes kind, matio_types type, std::size_t rows,
                            std::size_t columns, std::vector<Type> values) {
        std::size_t shape[] = {rows, columns};
        return Mat_VarCreate(name, kind, type, 2, shape, values.data(), 0);
    }
    static matvar_t* doubles(const char* name, std::size_t rows, std::size_t columns, std::vector<double> values) {
        return matrix(name, MAT_C_DOUBLE, MAT_T_DOUBLE, rows, columns, std::move(values));
    }
    static matvar_t* singles(std::size_t rows, std::size_t columns, std::vector<float> values) {
        return matrix(nullptr, MAT_C_SINGLE, MAT_T_SINGLE, rows, columns, std::move(values));
    }
    /// Two cameras in an array of structures, numbers of other types and turned the other way.
    static matvar_t* structures(const char* name) {
        const char* members[] = {"K", "r", "t", "RDistort", "TDistort"};
        std::size_t shape[] = {1, 2};
        matvar_t* list = Mat_VarCreateStruct(name, 2, shape, members, 5);
        for (std::size_t i = 0; i < 2; ++i) {
            const float tx = i == 0 ? 1.0F : 11.0F;
            Mat_VarSetStructFieldByName(list, "K", i, singles(3, 3, {500, 4, 321, 0, 510, 241, 0, 0, 1}));
            Mat_VarSetStructFieldByName(list, "r", i, doubles(nullptr, 3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}));
            Mat_VarSetStructFieldByName(list, "t", i, singles(3, 1, {tx, 2, 500}));
            Mat_VarSetStructFieldByName(list, "RDistort", i, doubles(nullptr, 2, 1, {0.1, 0.2}));
            Mat_VarSetStructFieldByName(list, "TDistort", i,
                                        matrix<std::int16_t>(nullptr, MAT_C_INT16, MAT_T_INT16, 2, 1, {0, 0}));
        }
        return list;
    }
    /// Rows of letters, kept column by column.
    static matvar_t* letters(const char* name, std::size_t rows, std::size_t columns, const std::string& text) {
        std::size_t shape[] = {rows, columns};
        return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UINT8, 2, shape, const_cast<char*>(text.data()), 0);
    }
    test::TemporaryFolder m_folder;
    std::filesystem::path m_path = m_folder / "file.mat";
};

TEST_P(MatFiles, NumbersOfEveryTypeKeepTheirShape) {
    write({matrix<std::uint8_t>("bytes", MAT_C_UINT8, MAT_T_UINT8, 2, 3, {1, 2, 3, 4, 5, 6}),
           matrix<std::int64_t>("long", MAT_C_INT64, MAT_T_INT64, 1, 2, {-5, 1LL << 40}),
           letters("names", 2, 4, "Cbacma1 "), letters("name", 1, 3, "abc")});
    const core::MatFile file(m_path);
    const core::MatNumbers bytes = file.read("bytes").numbers();
    EXPECT_EQ(bytes.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(bytes.at(1, 2), 6);
    EXPECT_EQ(bytes.at(0, 1), 3);
    EXPECT_EQ(file.read("long").numbers().values, (std::vector<double>{-5, 1099511627776.0}));
    EXPECT_EQ(file.read("names").texts(), (std::vector<std::string>{"Cam1", "bca"}));
    EXPECT_EQ(file.read("name").text(), "abc");
    EXPECT_EQ(file.readShape("bytes").size(1), 3u);
    EXPECT_TRUE(file.read("nobody").isMissing());
    test::expectError([&] { file.read("nobody").numbers(); }, BadInput, "file.mat: nobody", "is missing");
    test::expectError([&] { file.read("name").numbers(); }, BadInput, "file.mat: name", "real numbers are expected");
    test::expectError([&] { file.read("bytes").texts(); }, BadInput, "file.mat: bytes", "texts is expected");
    test::expectError([&] { file.read("bytes").member("x"); }, BadInput, "file.mat: bytes", "a structure is expected");
}

TEST_P(MatFiles, CamerasMayStandInAnArrayOfStructures) {
    write({structures("params"), letters("camnames", 2, 4, "CCaamm12")});
    const core::MatFile file(m_path);
    test::expectError([&] { file.read("params").element(1).member("k").numbers(); }, BadInput, "file.mat: params(2).k",
                      "is missing");
    test::expectError([&] { file.read("params").element(2); }, BadInput, "file.mat: params", "only 2 elements");
    core::CalibrationOptions options;
    options.assumeSize = true;
    const std::vector<core::Camera> cameras = core::readCalibration(m_path, options);
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "Cam1");
    EXPECT_EQ(cameras[1].name, "Cam2");
    EXPECT_EQ(cameras[1].cameraFromWorld.translation, Eigen::Vector3d(11, 2, 500));
    EXPECT_EQ(cameras[1].intrinsics(0, 1), 4);
    EXPECT_EQ(cameras[1].distortion, (std::vector<double>{0.1, 0.2, 0, 0, 0}));
    EXPECT_EQ(cameras[0].size, (core::ImageSize{641, 481})) << "twice the principal point, plus one";
    const std::vector<std::string> notes = core::calibrationNotes(m_path, options, cameras);
    ASSERT_FALSE(notes.empty());
    EXPECT_NE(notes[0].find("641 x 481 is assumed"), std::string::npos) << notes[0];
}

TEST_P(MatFiles, SessionsOfLabel3dHoldPicturesOfTheCamerasSizes) {
    std::size_t shape[] = {1, 2}, pictures[] = {48, 64, 3, 2};
    matvar_t* videos = Mat_VarCreate("videos", MAT_C_CELL, MAT_T_CELL, 2, shape, nullptr, 0);
    std::vector<std::uint8_t> grey(48 * 64 * 3 * 2, 100);
    for (int i = 0; i < 2; ++i)
        Mat_VarSetCell(videos, i, Mat_VarCreate(nullptr, MAT_C_UINT8, MAT_T_UINT8, 4, pictures, grey.data(), 0));
    write({structures("camParams"), videos});
    const std::vector<core::Camera> cameras = core::readCalibration(m_path);
    EXPECT_EQ(cameras[1].name, "Camera2");
    EXPECT_EQ(cameras[1].size, (core::ImageSize{64, 48}));
    write({structures("camParams"), doubles("imageSize", 2, 2, {480, 1024, 640, 1152})});
    EXPECT_EQ(core::readCalibration(m_path)[0].size, (core::ImageSize{640, 480}));
    EXPECT_EQ(core::readCalibration(m_path)[1].size, (core::ImageSize{1152, 1024}));
    write({structures("camParams"), doubles("imageSize", 1, 3, {480, 1024, 640})});
    test::expectError([&] { core::readCalibration(m_path); }, BadInput, "imageSize", "rows and columns");
    write({doubles("labels", 1, 1, {1})});
    test::expectError([&] { core::readCalibration(m_path); }, BadInput, "file.mat: params", "is missing");
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_P(MatFiles, PackedVariablesAreReadAndDamagedOnesRefused) {
    write({structures("params"), letters("camnames", 2, 4, "CCaamm12"),
           doubles("many", 40, 50, std::vector<double>(2000, 0.5))},
          MAT_COMPRESSION_ZLIB);
    EXPECT_EQ(core::MatFile(m_path).read("many").numbers().values, std::vector<double>(2000, 0.5));
    EXPECT_EQ(core::MatFile(m_path).read("params").element(1).member("t").numbers().values.at(0), 11);
    if (GetParam() != MAT_FT_MAT5)
        return;
    std::string bytes = bytesOf(m_path);
    bytes[bytes.size() - 8] = static_cast<char>(bytes[bytes.size() - 8] ^ 0x40);
    test::writeText(m_path, bytes);
    test::expectError([&] { core::MatFile file(m_path); }, BadInput, "file.mat: variable 3", "is damaged");
}

/// The numbers of rows and of cells are made ten million times as large as the file: nothing makes room for them.
TEST_P(MatFiles, ClaimsThatTheFileCannotHoldAreRefused) {
    if (GetParam() != MAT_FT_MAT5)
        GTEST_SKIP() << "claims of level 7.3 are the HDF5 library's";
    const std::string row{'\x03', '\0', '\0', '\0', '\x05', '\0', '\0', '\0'}; // 3 x 5
    std::size_t shape[] = {3, 5};
    for (matvar_t* variable : {doubles("a", 3, 5, std::vector<double>(15, 1)), letters("a", 3, 5, "abcdefghijklmno"),
                               Mat_VarCreate("a", MAT_C_CELL, MAT_T_CELL, 2, shape, nullptr, 0)}) {
        write({doubles("first", 1, 1, {1}), variable});
        EXPECT_EQ(core::MatFile(m_path).readShape("a").size(1), 5u);
        std::string bytes = bytesOf(m_path);
        const std::size_t at = bytes.find(row);
        ASSERT_NE(at, std::string::npos);
        bytes[at + 3] = 3; // 3 + 3 * 2^24 rows
        test::writeText(m_path, bytes);
        test::expectError([&] { core::MatFile file(m_path); }, BadInput, "file.mat: variable 2", "claims more");
    }
}

TEST(MatFile, OfAnotherLevelIsRefused) {
    const test::TemporaryFolder folder;
    mat_t* file = Mat_CreateVer((folder / "four.mat").c_str(), nullptr, MAT_FT_MAT4);
    std::size_t shape[] = {20, 1};
    double values[20] = {};
    matvar_t* variable = Mat_VarCreate("a", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, shape, values, 0);
    Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
    Mat_Close(file);
    test::expectError([&] { core::MatFile(folder / "four.mat"); }, BadInput, "four.mat", "levels 5 and 7.3");
}

INSTANTIATE_TEST_SUITE_P(Levels, MatFiles, testing::Values(MAT_FT_MAT5, MAT_FT_MAT73),
                         [](const auto& level) { return level.param == MAT_FT_MAT5 ? "Five" : "Seven"; });

} // namespace
