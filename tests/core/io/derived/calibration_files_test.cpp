// SPDX-License-Identifier: MIT
#include "core/io/derived/calibration_files.h"

#include <gtest/gtest.h>

#include "core/io/calibration/cameras_file.h"
#include "core/io/files/text_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

class CalibrationFiles : public testing::Test {
protected:
    CalibrationFiles() {
        test::writeSmallDataset(set);
        refined = core::readDataset(set).cameras;
        for (core::Camera& camera : refined)
            camera.cameraFromWorld.translation.x() += 3;
    }
    test::TemporaryFolder folder;
    std::filesystem::path set = folder / "set";
    std::vector<core::Camera> refined;
};

TEST_F(CalibrationFiles, ANewOneIsUsedAndTheOldOneIsKept) {
    const std::string before = core::readTextFile(set / "cameras.json");
    const core::Dataset changed = core::addCalibration(set, refined);
    EXPECT_EQ(changed.camerasFile, "cameras-refined-1.json");
    EXPECT_EQ(core::readTextFile(set / "cameras.json"), before);
    const core::Dataset read = core::readDataset(set);
    EXPECT_EQ(read.camerasFile, "cameras-refined-1.json");
    EXPECT_EQ(read.cameras[0].cameraFromWorld.translation, refined[0].cameraFromWorld.translation);
    EXPECT_EQ(read.sequences.size(), 2u);
    EXPECT_EQ(core::addCalibration(set, refined).camerasFile, "cameras-refined-2.json") << "counted on";
}

TEST_F(CalibrationFiles, TheOldOneIsUsedAgain) {
    const core::Dataset original = core::readDataset(set);
    core::addCalibration(set, refined);
    const core::Dataset back = core::useCalibration(set, "cameras.json");
    EXPECT_EQ(back.cameras[1].cameraFromWorld.translation, original.cameras[1].cameraFromWorld.translation);
    EXPECT_EQ(core::readDataset(set).camerasFile, "cameras.json");
    EXPECT_TRUE(std::filesystem::exists(set / "cameras-refined-1.json"));
}

TEST_F(CalibrationFiles, OnlyThoseOfTheSameCamerasAreListed) {
    core::addCalibration(set, refined);
    std::vector<core::Camera> others = refined;
    others[0].name = "other";
    core::writeCameras(set / "others.json", others);
    others = refined;
    others[0].size.width += 1;
    core::writeCameras(set / "larger.json", others);
    test::writeText(set / "notes.json", "{}");
    EXPECT_EQ(core::calibrationFiles(core::readDataset(set)),
              (std::vector<std::string>{"cameras-refined-1.json", "cameras.json"}));
}

TEST_F(CalibrationFiles, WhatIsNotTheDatasetsIsRefusedAndNothingChanges) {
    const std::string before = core::readTextFile(set / "dataset.json");
    std::vector<core::Camera> fewer = refined;
    fewer.pop_back();
    test::expectError([&] { core::addCalibration(set, fewer); }, core::ErrorCode::BadInput, "cameras.json",
                      "same names");
    core::writeCameras(folder / "outside.json", refined);
    test::expectError([&] { core::useCalibration(set, "../outside.json"); }, core::ErrorCode::BadInput, "dataset.json",
                      "cameras");
    test::expectError([&] { core::useCalibration(set, "missing.json"); }, core::ErrorCode::NotFound, "missing.json",
                      "");
    EXPECT_EQ(core::readTextFile(set / "dataset.json"), before);
    EXPECT_FALSE(std::filesystem::exists(set / "cameras-refined-1.json"));
}

TEST_F(CalibrationFiles, AFailedChangeLeavesNoNewFile) {
    std::filesystem::remove(set / "dataset.json");
    std::filesystem::create_directory(set / "dataset.json");
    EXPECT_THROW(core::addCalibration(set, refined), core::Error);
    EXPECT_FALSE(std::filesystem::exists(set / "cameras-refined-1.json"));
}

} // namespace
