// SPDX-License-Identifier: MIT
#include "core/io/calibration/calibration.h"

#include <fstream>

#include <gtest/gtest.h>
#include <matio.h>

#include "core/io/calibration/calibration_readers.h"
#include "core/io/calibration/cameras_file.h"
#include "tests/support/camera_ring.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;
using test::replaced;

/// Expects two sets of cameras to project alike, by name.
void expectSame(const std::vector<core::Camera>& read, const std::vector<core::Camera>& wanted,
                double tolerancePx = 1e-7) {
    ASSERT_EQ(read.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(read[i].name, wanted[i].name);
        EXPECT_EQ(read[i].size, wanted[i].size);
        EXPECT_EQ(read[i].fisheye, wanted[i].fisheye);
        for (const Eigen::Vector3d& point :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(90, -40, 60), Eigen::Vector3d(-70, 80, 20)}) {
            EXPECT_LT((*core::project(read[i], point) - *core::project(wanted[i], point)).norm(), tolerancePx)
                << wanted[i].name;
        }
    }
}

class Calibration : public testing::Test {
protected:
    fs::path write(const std::string& name, const std::string& text) {
        test::writeText(m_folder / name, text);
        return m_folder / name;
    }
    std::vector<core::Camera> read(const fs::path& path, core::CalibrationOptions options = {}) {
        return core::readCalibration(path, options);
    }
    void expectRefused(const fs::path& path, const std::string& word, core::ErrorCode code = BadInput) {
        test::expectError([&] { core::readCalibration(path); }, code, path.string(), word);
    }

    test::TemporaryFolder m_folder;
};

TEST_F(Calibration, RoundTripsThroughEveryKindThatCanBeWritten) {
    std::vector<core::Camera> cameras = test::cameraRing(12);
    cameras[3].fisheye = true;
    cameras[3].distortion = {0.01, -0.02, 0.003, 0.0004};
    cameras[4].distortion = {-0.1, 0.02, 0.001, -0.002, 0.01, 0.05, -0.03, 0.002};
    cameras[5].distortion = {};
    cameras[6].name = "caf\xC3\xA9 \"6\"";
    std::sort(cameras.begin(), cameras.end(),
              [](const auto& a, const auto& b) { return core::naturalLess(a.name, b.name); });
    const std::pair<const char*, const char*> kinds[] = {
        {"handlens", "a.json"}, {"anipose", "a.toml"}, {"opencv", "a.yml"}, {"opencv", "a.xml"}, {"opencv", "b.json"}};
    for (const auto& [kind, name] : kinds) {
        SCOPED_TRACE(name);
        core::writeCalibration(m_folder / name, kind, cameras);
        EXPECT_EQ(core::sniffCalibration(m_folder / name), kind);
        expectSame(read(m_folder / name), cameras);
    }
    test::expectError([&] { core::writeCalibration(m_folder / "x", "jarvis", cameras); }, Usage, "--to", "jarvis");
}

constexpr const char* kAnipose = R"([cam_0]
name = "A"
size = [ 640, 480,]
matrix = [ [ 500.0, 0.0, 320.0,], [ 0.0, 510.0, 240.0,], [ 0.0, 0.0, 1.0,],]
distortions = [ 0.1, 0.0, 0.0, 0.0, 0.0,]
rotation = [ 0.0, 0.0, 1.5707963267948966,]
translation = [ 1.0, 2.0, 500.0,]

[metadata]
adjusted = false
)";

TEST_F(Calibration, AniposeRotatesTheWorldIntoTheCamera) {
    const std::vector<core::Camera> cameras = read(write("calibration.toml", kAnipose));
    ASSERT_EQ(cameras.size(), 1u);
    EXPECT_EQ(cameras[0].name, "A");
    // A quarter turn about z takes the world's x to the camera's y.
    EXPECT_LT((cameras[0].cameraFromWorld * Eigen::Vector3d(10, 0, 0) - Eigen::Vector3d(1, 12, 500)).norm(), 1e-9);
}

TEST_F(Calibration, AniposeSectionsAreOrderedByNameNotAsText) {
    std::string text;
    for (const char* name : {"10", "2", "1"}) {
        text += replaced(replaced(kAnipose, "cam_0", std::string("cam_") + name), "\"A\"",
                         std::string("\"cam") + name + "\"");
        text = text.substr(0, text.find("[metadata]"));
    }
    const std::vector<core::Camera> cameras = read(write("calibration.toml", text));
    ASSERT_EQ(cameras.size(), 3u);
    EXPECT_EQ(cameras[1].name, "cam2");
    EXPECT_EQ(cameras[2].name, "cam10");
}

TEST_F(Calibration, AniposeIsRefusedWithItsField) {
    const auto refuse = [&](const std::string& what, const std::string& by, const std::string& word) {
        expectRefused(write("calibration.toml", replaced(kAnipose, what, by)), word);
    };
    refuse("[ 0.0, 0.0, 1.0,],]", "[ 0.0, 1.0, 0.0,],]", "last row must be 0 0 1");
    refuse("500.0, 0.0, 320.0", "500.0, 320.0", "cam_0.matrix: nine numbers");
    refuse("320.0", "nan", "cam_0.matrix");
    refuse("320.0", "\"x\"", "cam_0.matrix");
    refuse("size", "sizes", "cam_0.size");
    refuse("[ 640, 480,]", "[ 0, 480,]", "cam_0.size");
    refuse("translation", "transl", "cam_0.translation");
    refuse("= \"A\"", "= \"A", "line 2: not TOML");
    expectRefused(write("calibration.toml", "[metadata]\na = 1\n"), "holds no cameras");
    expectRefused(write("calibration.toml", "x = " + std::string(100000, '[')), "not TOML");
    expectRefused(write("calibration.toml", std::string("\xff\xfe\0\x01", 4)), "not TOML");
}

constexpr const char* kRos =
    "image_width: 640\nimage_height: 480\ncamera_name: narrow\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
    "  data: [500, 0, 320, 0, 510, 240, 0, 0, 1]\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0.1, 0, 0, "
    "0, 0]\n"
    "rvec: [0, 0, 1.5707963267948966]\ntvec: [1, 2, 500]\n";

TEST_F(Calibration, OpenCvTakesPlainListsOneFilePerCameraAndFolders) {
    const std::string text = std::string("%YAML:1.0\n---\n") + kRos;
    fs::create_directory(m_folder / "rig");
    write("rig/b10.yml", replaced(text, "camera_name: narrow\n", ""));
    write("rig/b9.yml", replaced(text, "camera_name: narrow\n", ""));
    const std::vector<core::Camera> cameras = read(m_folder / "rig");
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "b9");
    EXPECT_EQ(cameras[0].size, (core::ImageSize{640, 480}));
    EXPECT_LT((cameras[1].cameraFromWorld * Eigen::Vector3d(10, 0, 0) - Eigen::Vector3d(1, 12, 500)).norm(), 1e-9);
    EXPECT_EQ(read(write("one.yaml", text))[0].name, "narrow");
}

TEST_F(Calibration, OpenCvIsRefusedWithItsField) {
    const std::string text = std::string("%YAML:1.0\n---\n") + kRos;
    expectRefused(write("a.yml", replaced(text, "tvec", "other")), "tvec: is missing");
    expectRefused(write("a.yml", replaced(text, "510, 240, 0, 0, 1", "510, 240, 0, 0")), "camera_matrix: nine numbers");
    expectRefused(write("a.yml", replaced(text, "image_width: 640", "image_width: -4")), "image_width");
    expectRefused(write("a.yml", replaced(text, "image_width: 640\n", "")), "--size");
    expectRefused(write("a.yml", replaced(text, "500, 0, 320", "500, x, 320")), "camera_matrix");
    expectRefused(write("a.yml", "%YAML:1.0\n---\ncamera_matrix: [1, 2\nfoo: ]"), "");
    expectRefused(write("a.yml", "%YAML:1.0\n---\ncamera_matrix: " + std::string(100000, '[')), "nested");
    expectRefused(write("a.xml", "<opencv_storage><camera_matrix>"), "");
}

TEST_F(Calibration, JarvisMatricesAreStoredTransposed) {
    const std::string text =
        "%YAML:1.0\n---\nT: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ 1., 2., 500. ]\n"
        "R: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 0., 1., 0., -1., 0., 0., 0., 0., 1. ]\n"
        "intrinsicMatrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 500., 0., 0., 0., 510., 0., "
        "320., 240., 1. ]\n"
        "distortionCoefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [ 0.1, 0., 0., 0., 0. ]\n";
    const fs::path file = write("Camera_T.yaml", text);
    EXPECT_EQ(core::sniffCalibration(file), "jarvis");
    expectRefused(file, "Camera_T.size");
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    const std::vector<core::Camera> cameras = read(file, options);
    EXPECT_EQ(cameras[0].name, "Camera_T");
    EXPECT_EQ(cameras[0].intrinsics(0, 2), 320);
    EXPECT_EQ(cameras[0].intrinsics(1, 2), 240);
    EXPECT_LT((cameras[0].cameraFromWorld * Eigen::Vector3d(10, 0, 0) - Eigen::Vector3d(1, 12, 500)).norm(), 1e-9);
}

TEST_F(Calibration, EasyMocapIsInMetresAndNamesLookLikeNumbers) {
    const std::string head = "%YAML:1.0\n---\nnames:\n  - \"10\"\n  - \"2\"\n";
    std::string intri = head, extri = head;
    for (const char* name : {"10", "2"}) {
        const std::string n(name);
        intri += "K_" + n +
                 ": !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n  data: [500.0, 0.0, 320.0, 0.0, 510.0, 240.0, "
                 "0.0, 0.0, 1.0]\n";
        intri += "dist_" + n + ": !!opencv-matrix\n  rows: 1\n  cols: 5\n  dt: d\n  data: [0.1, 0.0, 0.0, 0.0, 0.0]\n";
        extri +=
            "R_" + n + ": !!opencv-matrix\n  rows: 3\n  cols: 1\n  dt: d\n  data: [0.0, 0.0, 1.5707963267948966]\n";
        extri += "T_" + n + ": !!opencv-matrix\n  rows: 3\n  cols: 1\n  dt: d\n  data: [0.001, 0.002, 0.5]\n";
    }
    write("intri.yml", intri);
    write("extri.yml", extri);
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    for (const fs::path& path : {m_folder.path(), m_folder / "intri.yml"}) {
        const std::vector<core::Camera> cameras = read(path, options);
        ASSERT_EQ(cameras.size(), 2u);
        EXPECT_EQ(cameras[0].name, "2");
        EXPECT_LT((cameras[1].cameraFromWorld * Eigen::Vector3d(10, 0, 0) - Eigen::Vector3d(1, 12, 500)).norm(), 1e-9);
    }
    options.mmPerUnit = 1;
    EXPECT_NEAR(read(m_folder.path(), options)[0].cameraFromWorld.translation.z(), 0.5, 1e-12);
    write("extri.yml", replaced(extri, "T_2", "T_3"));
    test::expectError([&] { read(m_folder.path(), options); }, BadInput, "extri.yml", "T_2");
}

/// Writes a matrix as MATLAB would keep it: column by column.
void writeVariable(mat_t* file, const char* name, std::size_t rows, std::size_t cols, std::vector<double> columns) {
    std::size_t dims[] = {rows, cols};
    matvar_t* variable = Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, columns.data(), 0);
    Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
}

TEST_F(Calibration, DannceMatricesAreTransposedAndPixelsStartAtOne) {
    const fs::path file = m_folder / "hires_cam1_params.mat";
    mat_t* mat = Mat_CreateVer(file.c_str(), nullptr, MAT_FT_MAT5);
    ASSERT_NE(mat, nullptr);
    // K' = [500 0 0; 0 510 0; 321 241 1] and r = R' = [0 1 0; -1 0 0; 0 0 1], columns one after the other.
    writeVariable(mat, "K", 3, 3, {500, 0, 321, 0, 510, 241, 0, 0, 1});
    writeVariable(mat, "r", 3, 3, {0, -1, 0, 1, 0, 0, 0, 0, 1});
    writeVariable(mat, "t", 1, 3, {1, 2, 500});
    writeVariable(mat, "RDistort", 1, 3, {0.1, 0.2, 0.5});
    writeVariable(mat, "TDistort", 1, 2, {0.3, 0.4});
    Mat_Close(mat);
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    const std::vector<core::Camera> cameras = read(m_folder.path(), options);
    ASSERT_EQ(cameras.size(), 1u);
    EXPECT_EQ(cameras[0].name, "hires_cam1");
    EXPECT_EQ(cameras[0].intrinsics(0, 2), 320);
    EXPECT_EQ(cameras[0].intrinsics(1, 2), 240);
    EXPECT_EQ(cameras[0].distortion, (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
    EXPECT_LT((cameras[0].cameraFromWorld * Eigen::Vector3d(10, 0, 0) - Eigen::Vector3d(1, 12, 500)).norm(), 1e-9);
    expectRefused(write("bad_params.mat", "not one"), "not a readable MATLAB file");
    expectRefused(write("empty_params.mat", ""), "not a readable MATLAB file");
}

constexpr const char* kInterHand =
    R"({"0": {"campos": {"400": [100, 0, 0], "50": [1, 2, 3]}, "camrot": {"400": [[0,-1,0],[1,0,0],[0,0,1]], "50": [[1,0,0],[0,1,0],[0,0,1]]},
  "focal": {"400": [500, 510], "50": [500, 510]}, "princpt": {"400": [320, 240], "50": [320, 240]}}})";

TEST_F(Calibration, InterHandStoresTheCamerasPlace) {
    core::CalibrationOptions options;
    options.size = core::ImageSize{334, 512};
    const fs::path file = write("InterHand_camera.json", kInterHand);
    EXPECT_EQ(core::sniffCalibration(file), "interhand");
    const std::vector<core::Camera> cameras = read(file, options);
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "50");
    EXPECT_LT((cameras[1].centreInWorld() - Eigen::Vector3d(100, 0, 0)).norm(), 1e-9);
    EXPECT_LT((cameras[1].cameraFromWorld * Eigen::Vector3d(110, 0, 0) - Eigen::Vector3d(0, 10, 0)).norm(), 1e-9);
    const std::string two = replaced(kInterHand, "{\"0\"", "{\"1\": {\"campos\": {}}, \"0\"");
    test::expectError([&] { read(write("two.json", two), options); }, BadInput, "two.json", "several captures");
    options.section = "0";
    EXPECT_EQ(read(m_folder / "two.json", options).size(), 2u);
    test::expectError(
        [&] { read(write("bad.json", replaced(kInterHand, "\"focal\": {\"400\"", "\"focal\": {\"401\"")), options); },
        BadInput, "bad.json", "focal.400");
}

TEST_F(Calibration, HanCoIsInMetres) {
    const std::string text =
        R"({"K": [[[500,0,320],[0,510,240],[0,0,1]]], "M": [[[0,-1,0,0.001],[1,0,0,0.002],[0,0,1,0.5],[0,0,0,1]]]})";
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    const std::vector<core::Camera> cameras = read(write("00000000.json", text), options);
    EXPECT_EQ(cameras[0].name, "cam0");
    EXPECT_LT((cameras[0].cameraFromWorld * Eigen::Vector3d(10, 0, 0) - Eigen::Vector3d(1, 12, 500)).norm(), 1e-9);
    expectRefused(write("bad.json", replaced(text, "[[[0,-1,0,0.001]", "[[[0,-1,0]")), "M[0]");
    expectRefused(write("few.json", R"({"K": [1], "M": []})"), "as many");
}

TEST_F(Calibration, ReflectionsAreRefusedWhateverTheKind) {
    const std::string text =
        R"({"K": [[[500,0,320],[0,510,240],[0,0,1]]], "M": [[[0,1,0,0],[1,0,0,0],[0,0,1,0.5],[0,0,0,1]]]})";
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    test::expectError([&] { read(write("mirror.json", text), options); }, BadInput, "mirror.json: cameras[0].R",
                      "reflection");
}

TEST_F(Calibration, UnknownAndMissingFilesAreNamed) {
    expectRefused(write("a.json", "{\"a\": 1}"), "not a calibration of a known kind", Unsupported);
    std::string names;
    for (const core::CalibrationKind& kind : core::calibrationKinds())
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    expectRefused(write("a.json", "{\"a\": 1}"), "tried " + names + " (", Unsupported);
    expectRefused(write("a.yml", "a: 1"), "not a calibration of a known kind", Unsupported);
    expectRefused(write("a.xyz", "1"), "not a calibration of a known kind", Unsupported);
    expectRefused(m_folder / "none.toml", "no such file", NotFound);
    fs::create_directory(m_folder / "void");
    expectRefused(m_folder / "void", "not a calibration of a known kind", Unsupported);
}

TEST(NaturalLess, CountsNumbersByValue) {
    EXPECT_TRUE(core::naturalLess("cam_2", "cam_10"));
    EXPECT_FALSE(core::naturalLess("cam_10", "cam_2"));
    EXPECT_TRUE(core::naturalLess("a", "a1"));
    EXPECT_TRUE(core::naturalLess("a1b2", "a1b10"));
    EXPECT_TRUE(core::naturalLess("a01", "a2"));
    EXPECT_FALSE(core::naturalLess("a", "a"));
    EXPECT_TRUE(core::naturalLess("a1", "a01") != core::naturalLess("a01", "a1"));
}

TEST(CalibrationEndings, TellWhichFilesNeedNotBeOpened) {
    for (const core::CalibrationKind& kind : core::calibrationKinds())
        EXPECT_FALSE(kind.endings.empty()) << kind.name;
    for (const char* file :
         {"a/cameras.json", "Calib.TOML", "x.yml", "x.yaml", "c0.dat", "x.mat", "dlt.csv", "r.qca.txt"})
        EXPECT_TRUE(core::mayBeCalibration(file)) << file;
    for (const char* file : {"a/film.mp4", "picture.png", "json", "a.json/readme", "x.", "x.json yaml", ".json", ""})
        EXPECT_FALSE(core::mayBeCalibration(file)) << file;
}

} // namespace
