// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/annotation/reconstruction.h"
#include "core/io/dataset/dataset.h"
#include "core/io/formats/annotation_exchange.h"
#include "core/io/formats/import_notes.h"
#include "core/io/formats/joint_files.h"

/// What the writers and readers of the single formats share. One pair of functions per format, one file per program.
namespace core {

/// Everything that a writer needs.
struct ExportRequest {
    const Dataset& dataset;
    const Sequence& sequence;
    const AnnotationSet& set;
    const std::string& rater; ///< whose marks are written; empty: those of all raters, for formats that name them
    const JointMap& map;
    const AnnotationExportOptions& options;
    const std::filesystem::path& path;
};

/// The placed mark of the job's rater, or nothing.
std::optional<Mark> placedMark(const ExportRequest& job, int frame, const JointId& joint, const std::string& camera);
/// True if the joint can be seen at the mark: not hidden, and within the picture.
bool isSeen(const Mark& mark, const Camera& camera);
/// Joints that the rater has marked in any frame, ascending.
std::vector<JointId> markedJoints(const ExportRequest& job);
/// Joints of a frame with a 3D point.
std::map<JointId, JointReconstruction> pointsOf(const ExportRequest& job, int frame);

/// Everything that a reader needs; it fills `set`.
struct ImportRequest {
    const Dataset& dataset;
    const Sequence& sequence;
    const AnnotationImportOptions& options;
    const JointMap& map;
    const std::filesystem::path& path;
    ImportNotes& notes;
    AnnotationSet& set;
};

/// Adds a mark if frame and camera are known, of the options' rater unless another is named. Throws Error(BadInput) if
/// there is one already. A guess below the options' likelihood is left out.
void addMark(ImportRequest& job, int frame, const JointId& joint, const std::string& camera, const Mark& mark,
             const std::string& rater = {});
/// A 3D point becomes proposed marks in all views that see it: it may be shown and moved, but is not evidence.
void addPoint(ImportRequest& job, int frame, const JointId& joint, const Eigen::Vector3d& pointInWorld,
              const std::optional<double>& likelihood = std::nullopt);

/// Leaves out a mark of a body part that stands for no joint.
void leaveOutPart(ImportRequest& job, const std::string& part);

/// Likelihoods in tables of labels, such as our own: a mark whose place is estimated is half as likely as one that is
/// seen.
inline constexpr double kVisibleLikelihood = 1.0;
inline constexpr double kOccludedLikelihood = 0.5;

/// Whose view the labels of a video are of; nothing, and it is counted, if it is not of this sequence. A video without
/// a camera's name is that of `file`'s camera; an empty name, too.
std::optional<std::string> cameraOfVideo(ImportRequest& job, const std::string& video,
                                         const std::filesystem::path& file);
/// The joint of a body part; where its name does not say the hand, the track's name may.
std::optional<JointId> jointOfPart(const ImportRequest& job, const std::string& part, const std::string& track);

/// Files of one view each: the given file, or those in the given folder and its folders with that extension, in order.
std::vector<std::filesystem::path> viewFiles(const std::filesystem::path& path, const std::string& extension);
/// True if it is a folder that holds a file with that extension, itself or in its folders.
bool holdsFiles(const std::filesystem::path& path, const std::string& extension);
/// The camera that a file is for: the one of the options; else the only one whose name its stem is or contains as a
/// word; else that of its folder. Throws Error(BadInput) if that does not tell.
std::string cameraOfFile(const ImportRequest& job, const std::filesystem::path& file);
/// The camera that is named in a text, as a word; the longest name wins, so that "front_left" is not taken for "left".
std::optional<std::string> cameraIn(const Dataset& dataset, const std::string& text);
/// The number at the end of a file's stem, such as 41 in img041.png; empty if there is none.
std::optional<int> trailingNumber(const std::string& name);

void writeTzionasAnnotations(const ExportRequest& job);
void readTzionasAnnotations(ImportRequest& job);
void writeCocoAnnotations(const ExportRequest& job);
void readCocoAnnotations(ImportRequest& job);
void writeAnipose2d(const ExportRequest& job);
void writeAnipose3d(const ExportRequest& job);
void readAnipose3d(ImportRequest& job);
void writeDeepLabCut(const ExportRequest& job);
/// Reads tables with the three header rows scorer, bodyparts, coords: DeepLabCut, Lightning Pose and Anipose 2D.
void readPoseTables(ImportRequest& job);
/// Reads SLEAP projects and their analysis exports (HDF5).
void readSleap(ImportRequest& job);
/// Reads what Label3D saves and what it exports for DANNCE (MATLAB).
void readLabel3d(ImportRequest& job);
void writeTrc(const ExportRequest& job);
void writeInterHand(const ExportRequest& job);
void writeFreiHand(const ExportRequest& job);
void writePointCsv(const ExportRequest& job);
void writeMarkCsv(const ExportRequest& job);
void readMarkCsv(ImportRequest& job);

} // namespace core
