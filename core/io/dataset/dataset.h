// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"
#include "core/hand/motion.h"
#include "core/io/footage/footage_note.h"
#include "core/io/footage/view_source.h"

namespace core {

/// One recording: all cameras at the same instants. Frames count from 0.
struct Sequence {
    std::string name;
    int frameCount = 0;
    double framesPerSecond = 50;
    std::vector<ViewSource> views;
    std::string masks;       ///< pattern with {camera} and {frame}; empty if there are none (or each view has its own)
    std::string motion;      ///< relative path of the recorded poses; empty if there are none
    std::string annotations; ///< relative path of the SQLite file; it may not exist yet
    std::vector<FootageNote> notes{}; ///< what a person should know about the footage, said when the sequence was made
    std::string masksMadeBy{};        ///< how the masks were made, in one line for people; empty if that is not known
};

/// A dataset folder, opened: cameras and hands are read, motions and pictures are read on demand.
struct Dataset {
    std::filesystem::path folder;
    std::string name;
    std::vector<Camera> cameras;
    std::vector<HandModel> hands;       ///< none, one, or left and right
    std::vector<std::string> handFiles; ///< relative, parallel to hands
    std::vector<Sequence> sequences;
    std::string camerasFile = "cameras.json"; ///< relative

    /// Throws Error(NotFound) naming the dataset and the sequence.
    const Sequence& sequence(const std::string& sequenceName) const;
    /// Index of the camera, or -1.
    int cameraIndex(const std::string& cameraName) const;
};

/// The pattern of this camera's masks: the view's own, else the sequence's; empty if there are none.
std::string maskPattern(const Sequence& sequence, const std::string& camera);
/// True if any camera has a mask pattern.
bool hasMasks(const Sequence& sequence);
/// The notes about its footage as English sentences.
std::vector<std::string> notesInWords(const Sequence& sequence);
/// How many cameras have a picture: a video, images or a rendered view.
int countViews(const Sequence& sequence);

/// Reads dataset.json, cameras.json and the hand models. Throws Error.
Dataset readDataset(const std::filesystem::path& folder);
/// Writes a whole dataset: into a temporary folder beside it, then renamed. `motions` is parallel to dataset.sequences
/// (an empty motion is not written). `folder` may not exist or must be empty.
void writeDataset(const Dataset& dataset, const std::vector<Motion>& motions, const std::filesystem::path& folder);
/// Rewrites dataset.json of a dataset that is there (dataset.folder), atomically; all its other files stay as they are.
void rewriteDatasetFile(const Dataset& dataset);
/// The recorded poses of a sequence; empty if it has none. Throws Error if the file does not fit the hands.
Motion readMotion(const Dataset& dataset, const Sequence& sequence);

} // namespace core
