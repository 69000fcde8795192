// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <matio.h>

#include "core/io/calibration/calibration.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;
using test::replaced;

/// Calibrations of other programs, written by hand, and where they show a point: worked out here from each format's
/// description, without the camera that was read.
class RigFormats : public testing::Test {
protected:
    fs::path write(const std::string& name, const std::string& text) {
        fs::create_directories((m_folder / name).parent_path());
        test::writeText(m_folder / name, text);
        return m_folder / name;
    }
    std::vector<core::Camera> read(const fs::path& path, const std::string& kind,
                                   core::CalibrationOptions options = {}) {
        EXPECT_EQ(core::sniffCalibration(path), kind);
        return core::readCalibration(path, options);
    }
    void expectRefused(const fs::path& path, const std::string& word, core::ErrorCode code = BadInput) {
        test::expectError([&] { core::readCalibration(path); }, code, path.string(), word);
    }

    test::TemporaryFolder m_folder;
};

void expectSees(const core::Camera& camera, const Eigen::Vector3d& pointMm, double x, double y) {
    const auto px = core::project(camera, pointMm);
    ASSERT_TRUE(px) << camera.name;
    EXPECT_NEAR(px->x(), x, 1e-6) << camera.name;
    EXPECT_NEAR(px->y(), y, 1e-6) << camera.name;
}

matvar_t* matrix(const char* name, std::size_t rows, std::size_t cols, std::vector<double> columns) {
    std::size_t dims[] = {rows, cols};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, columns.data(), 0);
}

/// A struct as DANNCE keeps it. K and r are transposed: X r + t, then K with the skew below the diagonal.
matvar_t* params(double tx) {
    const char* fields[] = {"K", "RDistort", "TDistort", "r", "t"};
    std::size_t dims[] = {1, 1};
    matvar_t* result = Mat_VarCreateStruct("params", 2, dims, fields, 5);
    // K = [500 0 0; 4 510 0; 321 241 1]
    Mat_VarSetStructFieldByName(result, "K", 0, matrix("K", 3, 3, {500, 4, 321, 0, 510, 241, 0, 0, 1}));
    Mat_VarSetStructFieldByName(result, "RDistort", 0, matrix("RDistort", 1, 2, {0.1, 0}));
    Mat_VarSetStructFieldByName(result, "TDistort", 0, matrix("TDistort", 1, 2, {0, 0}));
    // r = [0 1 0; -1 0 0; 0 0 1]
    Mat_VarSetStructFieldByName(result, "r", 0, matrix("r", 3, 3, {0, -1, 0, 1, 0, 0, 0, 0, 1}));
    Mat_VarSetStructFieldByName(result, "t", 0, matrix("t", 1, 3, {tx, 2, 500}));
    return result;
}

void writeProject(const fs::path& file, const char* listName, bool named) {
    mat_t* mat = Mat_CreateVer(file.c_str(), nullptr, MAT_FT_MAT5);
    std::size_t dims[] = {2, 1};
    matvar_t* list = Mat_VarCreate(listName, MAT_C_CELL, MAT_T_CELL, 2, dims, nullptr, 0);
    Mat_VarSetCell(list, 0, params(1));
    Mat_VarSetCell(list, 1, params(11));
    Mat_VarWrite(mat, list, MAT_COMPRESSION_NONE);
    Mat_VarFree(list);
    if (named) {
        matvar_t* names = Mat_VarCreate("camnames", MAT_C_CELL, MAT_T_CELL, 2, dims, nullptr, 0);
        for (int i = 0; i < 2; ++i) {
            std::string text = i == 0 ? "Left" : "Right";
            std::size_t size[] = {1, text.size()};
            Mat_VarSetCell(names, i, Mat_VarCreate("name", MAT_C_CHAR, MAT_T_UTF8, 2, size, text.data(), 0));
        }
        Mat_VarWrite(mat, names, MAT_COMPRESSION_NONE);
        Mat_VarFree(names);
    }
    Mat_Close(mat);
}

TEST_F(RigFormats, DannceProjectsHoldACellOfStructsWithSkew) {
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    writeProject(m_folder / "rig_dannce.mat", "params", true);
    const std::vector<core::Camera> cameras = read(m_folder / "rig_dannce.mat", "dannce", options);
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "Left");
    EXPECT_EQ(cameras[1].name, "Right");
    // (30, 40, 0) r = (-40, 30, 0); + t = (-39, 32, 500).
    const double x = -39.0 / 500, y = 32.0 / 500, bend = 1 + 0.1 * (x * x + y * y);
    expectSees(cameras[0], {30, 40, 0}, 500 * x * bend + 4 * y * bend + 320, 510 * y * bend + 240);

    writeProject(m_folder / "label3d.mat", "camParams", false);
    EXPECT_EQ(read(m_folder / "label3d.mat", "dannce", options)[1].name, "Camera2");
    expectRefused(m_folder / "label3d.mat", "--size");
}

TEST_F(RigFormats, SkewIsNotWrittenToFormatsWhoseProgramsIgnoreIt) {
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    writeProject(m_folder / "rig_dannce.mat", "params", true);
    const std::vector<core::Camera> cameras = read(m_folder / "rig_dannce.mat", "dannce", options);
    core::writeCalibration(m_folder / "own.json", "handlens", cameras);
    EXPECT_EQ(core::readCalibration(m_folder / "own.json")[0].intrinsics(0, 1), 4);
    for (const char* kind : {"anipose", "opencv"})
        test::expectError([&] { core::writeCalibration(m_folder / "x.yml", kind, cameras); }, Unsupported, "x.yml",
                          "Left.K: has a skew");
    EXPECT_FALSE(fs::exists(m_folder / "x.yml"));
}

constexpr const char* kCamchain = R"(cam0:
  cam_overlaps: [1]
  camera_model: pinhole
  distortion_coeffs: [0.1, 0.0,
    0.0, 0.0]
  distortion_model: radtan
  intrinsics: [500.0, 510.0, 320.0, 240.0]
  resolution: [640, 480]
  rostopic: /cam0/image_raw
cam1:
  T_cn_cnm1:
  - [0.0, -1.0, 0.0, 0.001]
  - [1.0, 0.0, 0.0, 0.002]
  - [0.0, 0.0, 1.0, 0.3]
  - [0.0, 0.0, 0.0, 1.0]
  cam_overlaps: [0]
  camera_model: pinhole
  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]
  distortion_model: equidistant
  intrinsics: [500.0, 510.0, 320.0, 240.0]
  resolution: [640, 480]
  rostopic: /cam1/image_raw
)";

TEST_F(RigFormats, KalibrChainsCamerasInMetres) {
    const std::vector<core::Camera> cameras = read(write("camchain.yaml", kCamchain), "kalibr");
    ASSERT_EQ(cameras.size(), 2u);
    const double x = 0.1, y = 0.05, bend = 1 + 0.1 * (x * x + y * y);
    expectSees(cameras[0], {20, 10, 200}, 500 * x * bend + 320, 510 * y * bend + 240);
    // In cam1: (-10 + 1, 20 + 2, 200 + 300) mm, through an equidistant lens.
    const double r = std::hypot(-9.0, 22.0), angle = std::atan2(r, 500.0);
    expectSees(cameras[1], {20, 10, 200}, 500 * angle * -9 / r + 320, 510 * angle * 22 / r + 240);
    const auto refuse = [&](const char* what, const char* by, const char* word, core::ErrorCode code) {
        expectRefused(write("bad.yaml", replaced(kCamchain, what, by)), word, code);
    };
    refuse("camera_model: pinhole", "camera_model: omni", "cam0.camera_model: omni", Unsupported);
    refuse("radtan", "fov", "cam0.distortion_model: fov", Unsupported);
    refuse("T_cn_cnm1", "T_cam_imu", "cam1.T_cn_cnm1: is missing", BadInput);
    refuse("500.0, 510.0", "x, 510.0", "cam0.intrinsics", BadInput);
    refuse("[640, 480]", "[640]", "cam0.resolution: 2 numbers", BadInput);
}

TEST_F(RigFormats, ColmapPixelsBeginHalfAPixelEarlierAndQuaternionsAreWFirst) {
    const std::string cameras = "# Camera list\n1 OPENCV 640 480 500 510 320 240 0.1 0 0 0\n2 SIMPLE_PINHOLE 640 480 "
                                "500 320 240\n3 RADIAL_FISHEYE 640 480 500 320 240 0 0\n";
    // A quarter turn about z: w = z = sqrt(1/2). The second line of an image may be empty.
    const std::string images = "# Image list\n1 0.70710678118654752 0 0 0.70710678118654752 1 2 500 1 left.png\n\n"
                               "2 1 0 0 0 0 0 300 2 sub/right.png\n10 20 -1 30 40 -1\n3 1 0 0 0 0 0 300 3 top.png\n";
    write("sparse/cameras.txt", cameras);
    write("sparse/images.txt", images);
    for (const fs::path& path : {m_folder / "sparse", m_folder / "sparse/images.txt"}) {
        const std::vector<core::Camera> rig = read(path, "colmap");
        ASSERT_EQ(rig.size(), 3u);
        EXPECT_EQ(rig[0].name, "left");
        // The turn takes (30, 40, 0) to (-40, 30, 0).
        const double x = -39.0 / 500, y = 32.0 / 500, bend = 1 + 0.1 * (x * x + y * y);
        expectSees(rig[0], {30, 40, 0}, 500 * x * bend + 319.5, 510 * y * bend + 239.5);
        EXPECT_EQ(rig[1].name, "right");
        expectSees(rig[1], {30, 40, 0}, 500 * 0.1 + 319.5, 500 * 40.0 / 300 + 239.5);
        const double angle = std::atan(50.0 / 300);
        expectSees(rig[2], {30, 40, 0}, 500 * angle * 0.6 + 319.5, 500 * angle * 0.8 + 239.5);
    }
    write("sparse/cameras.txt", replaced(cameras, "SIMPLE_PINHOLE", "FOV"));
    test::expectError([&] { core::readCalibration(m_folder / "sparse"); }, Unsupported, "cameras.txt",
                      "camera 2: its model FOV");
    write("sparse/cameras.txt", cameras);
    write("sparse/images.txt", replaced(images, "sub/right", "left"));
    test::expectError([&] { core::readCalibration(m_folder / "sparse"); }, Unsupported, "images.txt",
                      "several images of a camera");
    write("sparse/images.txt", replaced(images, "500 1 left", "500 7 left"));
    test::expectError([&] { core::readCalibration(m_folder / "sparse"); }, BadInput, "images.txt", "image 1");
}

constexpr const char* kTransforms =
    R"({"camera_model": "OPENCV", "fl_x": 500, "fl_y": 510, "cx": 320, "cy": 240, "w": 640, "h": 480, "k1": 0.1,
 "k2": 0, "p1": 0, "p2": 0, "frames": [
 {"file_path": "images/a.png", "transform_matrix": [[1,0,0,10],[0,1,0,20],[0,0,1,400],[0,0,0,1]]},
 {"file_path": "images/b.png", "fl_x": 600, "transform_matrix": [[0,0,1,400],[0,1,0,0],[-1,0,0,0],[0,0,0,1]]}]})";

TEST_F(RigFormats, NerfstudioCamerasLookAlongMinusZWithYUp) {
    const std::vector<core::Camera> cameras = read(write("transforms.json", kTransforms), "nerfstudio");
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "a");
    // The camera at (10, 20, 400) looks down on the origin: 30 to the right and 20 up of its axis, at depth 390.
    const double x = 30.0 / 390, y = -20.0 / 390, bend = 1 + 0.1 * (x * x + y * y);
    expectSees(cameras[0], {40, 40, 10}, 500 * x * bend + 319.5, 510 * y * bend + 239.5);
    // The second one at (400, 0, 0) looks along -x; its right is -z.
    const double u = 10.0 / 390, v = -40.0 / 390, bend2 = 1 + 0.1 * (u * u + v * v);
    expectSees(cameras[1], {10, 40, -10}, 600 * u * bend2 + 319.5, 510 * v * bend2 + 239.5);
    const auto refuse = [&](const char* what, const char* by, const char* word, core::ErrorCode code) {
        expectRefused(write("bad.json", replaced(kTransforms, what, by)), word, code);
    };
    refuse("\"k2\": 0", "\"k4\": 0.1", "frames[0].k4", Unsupported);
    refuse("\"OPENCV\"", "\"EQUIRECTANGULAR\"", "frames[0].camera_model: EQUIRECTANGULAR", Unsupported);
    refuse("\"fl_x\": 500, ", "", "frames[0].fl_x: a number", BadInput);
    refuse("b.png", "a.png", "several images of a camera", Unsupported);
    refuse("[1,0,0,10]", "[1,0,0]", "frames[0].transform_matrix", BadInput);
    refuse("\"w\": 640,", "", "a.size", BadInput);
}

constexpr const char* kCaliscope = R"([cameras.0]
cam_id = 0
rotation_count = 0
error = 0.5
ignore = false
size = [640, 480]
matrix = [[500.0, 0.0, 320.0], [0.0, 510.0, 240.0], [0.0, 0.0, 1.0]]
distortions = [0.1, 0.0, 0.0, 0.0, 0.0]
translation = [0.001, 0.002, 0.5]
rotation = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]

[cameras.1]
cam_id = 1
rotation_count = 1
ignore = false
size = [640, 480]
matrix = [[500.0, 0.0, 320.0], [0.0, 510.0, 240.0], [0.0, 0.0, 1.0]]
distortions = [0.0, 0.0, 0.0, 0.0, 0.0]
translation = "null"
rotation = "null"
)";

TEST_F(RigFormats, CaliscopeIsInMetresAndLeavesOutCamerasWithoutAPlace) {
    const std::vector<core::Camera> cameras = read(write("camera_array.toml", kCaliscope), "caliscope");
    ASSERT_EQ(cameras.size(), 1u);
    EXPECT_EQ(cameras[0].name, "cam_0");
    const double x = -39.0 / 500, y = 32.0 / 500, bend = 1 + 0.1 * (x * x + y * y);
    expectSees(cameras[0], {30, 40, 0}, 500 * x * bend + 320, 510 * y * bend + 240);
    // Older versions: sections of their own beside others, rotation vectors.
    const std::string older =
        "camera_count = 1\n\n[charuco]\ncolumns = 4\n\n" +
        replaced(replaced(std::string(kCaliscope).substr(0, std::string(kCaliscope).find("[cameras.1]")), "[cameras.0]",
                          "[cam_3]"),
                 "[[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]", "[0.0, 0.0, 1.5707963267948966]");
    const std::vector<core::Camera> old = read(write("config.toml", older), "caliscope");
    ASSERT_EQ(old.size(), 1u);
    EXPECT_EQ(old[0].name, "cam_3");
    expectSees(old[0], {30, 40, 0}, 500 * x * bend + 320, 510 * y * bend + 240);
}

TEST_F(RigFormats, Pose2SimIsAniposeInMetres) {
    const fs::path file =
        write("Calib.toml", "[cam_01]\nname = \"cam_01\"\nsize = [ 640.0, 480.0,]\nmatrix = [ [ 500.0, 0.0, "
                            "320.0,], [ 0.0, 510.0, 240.0,], [ 0.0, 0.0, 1.0,],]\ndistortions = [ 0.1, "
                            "0.0, 0.0, 0.0,]\nrotation = [ 0.0, 0.0, 1.5707963267948966,]\ntranslation = "
                            "[ 0.001, 0.002, 0.5,]\nfisheye = false\n");
    core::CalibrationOptions options;
    options.kind = "pose2sim";
    const double x = -39.0 / 500, y = 32.0 / 500, bend = 1 + 0.1 * (x * x + y * y);
    expectSees(core::readCalibration(file, options).at(0), {30, 40, 0}, 500 * x * bend + 320, 510 * y * bend + 240);
}

TEST_F(RigFormats, DltCoefficientsHoldSkewAndCountPixelsFromOne) {
    // K = [500 4 321; 0 510 241; 0 0 1] in pixels that count from 1, quarter turn about z, t = (1, 2, 500): P = K
    // [R|t].
    const double p[3][4] = {
        {4, -500, 321, 500 * 1 + 4 * 2 + 321 * 500.0}, {510, 0, 241, 510 * 2 + 241 * 500.0}, {0, 0, 1, 500}};
    std::string text;
    for (int i = 0; i < 11; ++i) {
        char line[100];
        const double value = p[i / 4][i % 4] / 500;
        std::snprintf(line, sizeof line, "%.17g,%.17g\n", value, value);
        text += line;
    }
    core::CalibrationOptions options;
    options.size = core::ImageSize{640, 480};
    const std::vector<core::Camera> cameras = read(write("dlt.csv", text), "dlt", options);
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[1].name, "cam2");
    EXPECT_NEAR(cameras[0].intrinsics(0, 1), 4, 1e-9);
    const double x = -39.0 / 500, y = 32.0 / 500;
    expectSees(cameras[0], {30, 40, 0}, 500 * x + 4 * y + 320, 510 * y + 240);
    // The other corner: rows 5 to 8 upside down.
    std::string flipped;
    for (int i = 0; i < 11; ++i) {
        char line[100];
        std::snprintf(line, sizeof line, "%.17g\n",
                      (i / 4 == 1 ? 480 * p[2][i % 4] - p[1][i % 4] : p[i / 4][i % 4]) / 500);
        flipped += line;
    }
    expectRefused(write("flipped.csv", flipped), "cam1: counts pixels from the lower left corner", Unsupported);
    expectRefused(write("short.csv", "1,2\n3,4\n"), "not a calibration of a known kind", Unsupported);
}

constexpr const char* kQca = R"(<?xml version="1.0"?>
<calibration calibrated="now" type="regular">
<results std-dev="0.4" min-max-diff="0.1"/>
<cameras>
<camera active="1" serial="100" model="Miqus M3" viewrotation="0"><fov_marker left="0" top="0" right="1823" bottom="1087"/></camera>
<camera active="1" serial="200" model="Miqus Video" viewrotation="0">
<fov_video left="10" top="20" right="1919" bottom="1087"/>
<transform x="400" y="0" z="0" r11="0" r12="1" r13="0" r21="0" r22="0" r23="1" r31="1" r32="0" r33="0"/>
<intrinsic focallength="9.27" sensorMinU="0.0" sensorMaxU="122879.0" sensorMinV="0.0" sensorMaxV="69631.0"
 focalLengthU="64000" focalLengthV="65280" centerPointU="61440" centerPointV="34560" skew="0"
 radialDistortion1="-0.05" radialDistortion2="0.1" radialDistortion3="0"
 tangentalDistortion1="0" tangentalDistortion2="0"/>
</camera></cameras></calibration>)";

TEST_F(RigFormats, QualisysCountsIn64thsOfPixelsAndTurnsYAndZ) {
    const std::vector<core::Camera> cameras = read(write("rig.qca.txt", kQca), "qualisys");
    ASSERT_EQ(cameras.size(), 1u) << "marker cameras have no pictures";
    EXPECT_EQ(cameras[0].name, "200");
    EXPECT_EQ(cameras[0].size, (core::ImageSize{1910, 1068}));
    // It stands at x = 400 and looks along -x with z up, y to its right.
    const double x = 20.0 / 390, y = -30.0 / 390, r2 = x * x + y * y, bend = 1 - 0.05 * r2 + 0.1 * r2 * r2;
    // QTM counts the sub-pixels 0 to 64 W - 1: the first pixel's centre is 31.5.
    constexpr double kFirst = 31.5 / 64;
    expectSees(cameras[0], {10, 20, 30}, 1000 * x * bend + 960 - kFirst - 10, 1020 * y * bend + 540 - kFirst - 20);
    const core::Camera half =
        read(write("half.qca.txt", replaced(kQca, "\"Miqus Video\"", "\"Miqus Video\" video_resolution=\"540p\"")),
             "qualisys")[0];
    EXPECT_EQ(half.size, (core::ImageSize{955, 534}));
    expectSees(half, {10, 20, 30}, (1000 * x * bend + 960 - kFirst - 10 + 0.5) / 2 - 0.5,
               (1020 * y * bend + 540 - kFirst - 20 + 0.5) / 2 - 0.5);
    EXPECT_EQ(read(write("quotes.qca.txt", replaced(kQca, "\"Miqus Video\"", "'Miqus Video'")), "qualisys").size(), 1u);
    expectRefused(write("odd.qca.txt", replaced(kQca, "\"Miqus Video\"", "\"Miqus Video\" video_resolution=\"4k\"")),
                  "200.video_resolution: 4k", Unsupported);
    expectRefused(write("off.qca.txt", replaced(kQca, "\"Miqus Video\"", "\"Miqus Video\" calibrated=\"false\"")),
                  "none of its video cameras is calibrated");
    expectRefused(write("bad.qca.txt", replaced(kQca, "r23=\"1\"", "r23=\"x\"")), "200.transform.r23");
    expectRefused(write("cut.qca.txt", std::string(kQca).substr(0, std::string(kQca).find("radialDistortion2"))),
                  "ends within a tag");
}

/// The same camera with another range and unit; x and y of the middle of the sensor in the picture.
std::string qcaOf(const std::string& maxU, const std::string& maxV, const std::string& fov) {
    std::string text = replaced(kQca, "<fov_video left=\"10\" top=\"20\" right=\"1919\" bottom=\"1087\"/>", fov);
    text = replaced(replaced(text, "122879.0", maxU), "69631.0", maxV);
    return replaced(replaced(text, "radialDistortion1=\"-0.05\"", "radialDistortion1=\"0\""),
                    "radialDistortion2=\"0.1\"", "radialDistortion2=\"0\"");
}

TEST_F(RigFormats, QualisysSaysByItsRangeWhereTheFirstPixelIs) {
    const std::string fov = "<fov_video left=\"0\" top=\"0\" right=\"1919\" bottom=\"1087\"/>";
    const double x = 1000 * 20.0 / 390 + 960, y = -1020 * 30.0 / 390 + 540;
    // From centre to centre, as programs write it that count from 0 at the first centre.
    const core::Camera centres = read(write("centres.qca.txt", qcaOf("122816", "69568", fov)), "qualisys")[0];
    EXPECT_EQ(centres.size, (core::ImageSize{1920, 1088}));
    expectSees(centres, {10, 20, 30}, x, y);
    const core::Camera subPixels = read(write("sub.qca.txt", qcaOf("122879.0", "69631.0", fov)), "qualisys")[0];
    expectSees(subPixels, {10, 20, 30}, x - 31.5 / 64, y - 31.5 / 64);
    // From edge to edge in whole pixels.
    std::string edges =
        replaced(replaced(qcaOf("1920", "1088", fov), "\"64000\"", "\"1000\""), "\"65280\"", "\"1020\"");
    edges = replaced(replaced(edges, "\"61440\"", "\"960\""), "\"34560\"", "\"540\"");
    const core::Camera whole = read(write("whole.qca.txt", edges), "qualisys")[0];
    EXPECT_EQ(whole.size, (core::ImageSize{1920, 1088}));
    expectSees(whole, {10, 20, 30}, x - 0.5, y - 0.5);
    expectRefused(write("other.qca.txt", qcaOf("100000", "69631.0", fov)), "200.intrinsic.sensorMaxU", Unsupported);
    expectRefused(write("bare.qca.txt", qcaOf("1920", "1088", "")), "200.fov_video: is missing", Unsupported);
}

TEST_F(RigFormats, QualisysViewsThatAreShownTurnedAreNoted) {
    const std::filesystem::path file =
        write("turned.qca.txt",
              replaced(kQca, "model=\"Miqus Video\" viewrotation=\"0\"", "model=\"Miqus Video\" viewrotation=\"90\""));
    const std::vector<core::Camera> cameras = read(file, "qualisys");
    EXPECT_EQ(cameras[0].size, (core::ImageSize{1910, 1068})) << "as the sensor records it";
    const std::vector<std::string> notes = core::calibrationNotes(file, {}, cameras);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("200"), std::string::npos) << notes[0];
    EXPECT_NE(notes[0].find("90"), std::string::npos) << notes[0];
}

constexpr const char* kMayaCam = "image size\n640,480\n\ncamera matrix\n500,0,320\n0,510,240\n0,0,1\n\nrotation\n"
                                 "0,-1,0\n1,0,0\n0,0,1\n\ntranslation\n1\n2\n500\n";

TEST_F(RigFormats, XmaLabHasAFilePerCamera) {
    write("maya/c2.txt", kMayaCam);
    write("maya/c10.txt", kMayaCam);
    const std::vector<core::Camera> cameras = read(m_folder / "maya", "xmalab");
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "c2");
    EXPECT_EQ(cameras[0].size, (core::ImageSize{640, 480}));
    expectSees(cameras[0], {30, 40, 0}, 500 * -39.0 / 500 + 320, 510 * 32.0 / 500 + 240);
    EXPECT_EQ(read(m_folder / "maya/c10.txt", "xmalab").size(), 1u);
    expectRefused(write("bad.txt", replaced(kMayaCam, "0,510,240", "0,x,240")), "'x' is not a finite number");
    expectRefused(write("lens.txt", std::string(kMayaCam) + "\ndistortion\n0.1\n"), "distortion", Unsupported);
}

} // namespace
