// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/camera.h"

namespace core {

// One function per kind of file, for calibration.cpp. They undo transpositions and offsets but keep the file's unit of
// length; cameras whose file holds no image size have size 0 x 0. All throw Error naming file and field.

/// calibration.toml of Anipose.
std::vector<Camera> readAnipose(const std::filesystem::path& file);
std::string formatAnipose(const std::vector<Camera>& cameras);

/// cv::FileStorage (YAML, XML, JSON): a list `cameras`, or one camera per file; a folder of such files.
std::vector<Camera> readOpenCv(const std::filesystem::path& path);
/// `extension` (.yml, .xml, .json) chooses the syntax.
std::string formatOpenCv(const std::vector<Camera>& cameras, const std::string& extension);

/// Folder with intri.yml and extri.yml, or either of the two files.
std::vector<Camera> readEasyMocap(const std::filesystem::path& path);
/// One YAML per camera, matrices transposed; a folder of them.
std::vector<Camera> readJarvis(const std::filesystem::path& path);
/// MATLAB files *_params.mat with K, r (both transposed), t, RDistort, TDistort, pixels from 1; a folder of them.
std::vector<Camera> readDannce(const std::filesystem::path& path);
/// InterHand2.6M JSON: campos, camrot, focal, princpt, at the top or per capture (`section`).
std::vector<Camera> readInterHand(const std::filesystem::path& file, const std::string& section);
/// HanCo / FreiHAND JSON: K and M, lists of matrices.
std::vector<Camera> readHanCo(const std::filesystem::path& file);

/// Text files of TemugeB/handpose3d, two per camera: c0.dat (intrinsic, distortion) and rot_trans_c0.dat (R, T, world
/// to camera; the first block of each), or camera0_intrinsics.dat and camera0_rot_trans.dat. `path`: their folder, or
/// one of the files, which stands for its folder.
std::vector<Camera> readHandpose3d(const std::filesystem::path& path);
/// True if there is such a pair.
bool isHandpose3d(const std::filesystem::path& path);

/// Files of a folder with one of these extensions, sorted by natural order; the path itself if it is a file.
std::vector<std::filesystem::path> calibrationFiles(const std::filesystem::path& path,
                                                    const std::vector<std::string>& extensions);

/// cam_2 before cam_10.
bool naturalLess(std::string_view a, std::string_view b);

/// A camera's rotation from a Rodrigues vector or nine numbers row by row. Throws Error if it is neither.
Eigen::Matrix3d rotationOf(const std::vector<double>& numbers, const std::string& file, const std::string& field);
/// Nine numbers, row by row.
Eigen::Matrix3d rowMajorMatrix(const std::vector<double>& numbers, const std::string& file, const std::string& field);
/// Three numbers.
Eigen::Vector3d vectorOf(const std::vector<double>& numbers, const std::string& file, const std::string& field);

} // namespace core
