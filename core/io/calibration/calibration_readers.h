// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/camera.h"
#include "core/io/calibration/calibration_options.h"
#include "core/io/calibration/calibration_source.h"

namespace core {

// Two functions per kind of file, for the table in calibration.cpp: whether a file or folder looks like one, and its
// cameras. Readers undo transpositions and offsets but keep the file's unit of length; cameras whose file holds no
// image size have size 0 x 0. All throw Error naming file and field.

/// cameras.json of a dataset.
bool looksLikeOwnCameras(const CalibrationSource& source);
std::vector<Camera> readOwnCameras(const CalibrationSource& source, const CalibrationOptions& options);

/// calibration.toml of Anipose.
bool looksLikeAnipose(const CalibrationSource& source);
std::vector<Camera> readAnipose(const CalibrationSource& source, const CalibrationOptions& options);
std::string formatAnipose(const std::vector<Camera>& cameras);

/// Caliscope's camera_array.toml, or config.toml of its older versions: Anipose's members, in metres. Cameras that it
/// ignores or that have no place are left out.
bool looksLikeCaliscope(const CalibrationSource& source);
std::vector<Camera> readCaliscope(const CalibrationSource& source, const CalibrationOptions& options);

/// cv::FileStorage (YAML, XML, JSON): a list `cameras`, or one camera per file; a folder of such files.
bool looksLikeOpenCv(const CalibrationSource& source);
std::vector<Camera> readOpenCv(const CalibrationSource& source, const CalibrationOptions& options);
/// `extension` (.yml, .xml, .json; in any case) chooses the syntax.
std::string formatOpenCv(const std::vector<Camera>& cameras, std::string extension);

/// Folder with intri.yml and extri.yml, or either of the two files.
bool looksLikeEasyMocap(const CalibrationSource& source);
std::vector<Camera> readEasyMocap(const CalibrationSource& source, const CalibrationOptions& options);
/// One YAML per camera, matrices transposed; a folder of them.
bool looksLikeJarvis(const CalibrationSource& source);
std::vector<Camera> readJarvis(const CalibrationSource& source, const CalibrationOptions& options);
/// MATLAB files with K (transposed, with skew, pixels from 1), r (transposed), t, RDistort, TDistort: *_params.mat with
/// one camera each, a folder of them, or a project file with a cell of such structs, `params` (DANNCE) or `camParams`
/// (Label3D), and their `camnames`.
bool looksLikeDannce(const CalibrationSource& source);
std::vector<Camera> readDannce(const CalibrationSource& source, const CalibrationOptions& options);
/// Kalibr's camchain: pinhole cameras with lens model radtan, equidistant or none; the world is that of cam0.
bool looksLikeKalibr(const CalibrationSource& source);
std::vector<Camera> readKalibr(const CalibrationSource& source, const CalibrationOptions& options);
/// COLMAP's text model: a folder with cameras.txt and images.txt, or either of the two. One image per camera.
bool looksLikeColmap(const CalibrationSource& source);
std::vector<Camera> readColmap(const CalibrationSource& source, const CalibrationOptions& options);
/// transforms.json of nerfstudio: camera to world with OpenGL's axes. One image per camera.
bool looksLikeNerfstudio(const CalibrationSource& source);
std::vector<Camera> readNerfstudio(const CalibrationSource& source, const CalibrationOptions& options);
/// Names for cameras that took these images: the files' names without extension or, if they are the same, the names of
/// their folders. Throws Error naming `file` if neither are distinct.
std::vector<std::string> cameraNamesOfImages(const std::vector<std::string>& images, const std::string& file);
/// Coefficients of the direct linear transformation, a row for each of the eleven and a column per camera, for pixels
/// that count from 1 at the upper left corner. They hold a skew and no lens.
bool looksLikeDlt(const CalibrationSource& source);
std::vector<Camera> readDlt(const CalibrationSource& source, const CalibrationOptions& options);
/// QTM's .qca.txt: video cameras, intrinsics in 1/64 px, the cameras' places in mm.
bool looksLikeQualisys(const CalibrationSource& source);
std::vector<Camera> readQualisys(const CalibrationSource& source, const CalibrationOptions& options);
/// Cameras whose views QTM shows turned.
std::vector<std::string> qualisysNotes(const CalibrationSource& source);
/// XMALab's MayaCam 2.0: a text file per camera; a folder of them.
bool looksLikeXmaLab(const CalibrationSource& source);
std::vector<Camera> readXmaLab(const CalibrationSource& source, const CalibrationOptions& options);

/// InterHand2.6M JSON: campos, camrot, focal, princpt, at the top or per capture (`section`).
bool looksLikeInterHand(const CalibrationSource& source);
std::vector<Camera> readInterHand(const CalibrationSource& source, const CalibrationOptions& options);
/// HanCo / FreiHAND JSON: K and M, lists of matrices.
bool looksLikeHanCo(const CalibrationSource& source);
std::vector<Camera> readHanCo(const CalibrationSource& source, const CalibrationOptions& options);

/// Text files of TemugeB/handpose3d, two per camera: c0.dat (intrinsic, distortion) and rot_trans_c0.dat (R, T, world
/// to camera; the first block of each), or camera0_intrinsics.dat and camera0_rot_trans.dat: their folder, or one of
/// the files, which stands for its folder.
bool looksLikeHandpose3d(const CalibrationSource& source);
std::vector<Camera> readHandpose3d(const CalibrationSource& source, const CalibrationOptions& options);

/// A camera's rotation from a Rodrigues vector or nine numbers row by row. Throws Error if it is neither.
Eigen::Matrix3d rotationOf(const std::vector<double>& numbers, const std::string& file, const std::string& field);
/// Nine numbers, row by row.
Eigen::Matrix3d rowMajorMatrix(const std::vector<double>& numbers, const std::string& file, const std::string& field);
/// Three numbers.
Eigen::Vector3d vectorOf(const std::vector<double>& numbers, const std::string& file, const std::string& field);

} // namespace core
