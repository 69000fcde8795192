// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// What a person should know about an import. Behind each kind: what ImportNote::names, count and number hold.
enum class ImportNoteKind {
    UnknownParts,        ///< marks of body parts that stand for no joint; names: a name that would fit, then the parts
    ShiftedFootage,      ///< pictures are numbered as frames of the sequence, not of its video; names: the camera
    CamerasByOrder,      ///< the file names none of the dataset's cameras; names: those that were taken, in order
    Reprojections,       ///< 2D data are reprojections of 3D points: proposals
    PointsWithoutClicks, ///< the file holds 3D points only: proposals
    FileOfSequence,      ///< names: the sequence that the file is of, the one that it was read for
    TableOfSequence,     ///< the same of a table
    SomeGuesses,         ///< among the marks are a program's guesses: proposals
    OnlyGuesses,         ///< the marks are a program's guesses: proposals
    OtherVideos,         ///< count: rows that were left out; names: the videos that they are of
    UnknownFrames,       ///< left out count times: a frame that the sequence does not have; names: the sequence;
                         ///< number: its last frame
    UnknownCamera,       ///< left out count times: a mark in a camera that the dataset does not have; names: the camera
    OtherCamera,         ///< left out count times: a row of the view of another camera; names: that camera
    UnlikelyGuesses,     ///< left out count times: a mark with a likelihood below `number`
    RepeatedGuesses,     ///< left out count times: a guess of a joint that has a mark in the same picture
    HiddenLabels,        ///< left out count times: a label that is marked as not visible
    UnmappedKeypoint,    ///< left out count times; names: the keypoint that the joint map lacks
    UnmappedJoint,       ///< left out count times; names: the joint that the joint map lacks
    CategoryWithoutSide, ///< left out count times: an annotation; names: its category, as JSON
    OutsidePicture       ///< kept, but not evidence; count: marks; names: the camera
};

/// One such note.
struct ImportNote {
    ImportNoteKind kind = ImportNoteKind::UnknownParts;
    std::vector<std::string> names{};
    int count = 1;
    double number = 0;
    bool operator==(const ImportNote&) const = default;
};

/// The note as an English sentence, for the command line.
std::string importNoteText(const ImportNote& note);

/// Decides what of a foreign file fits a sequence, and remembers what did not.
class ImportNotes {
public:
    ImportNotes(const Dataset& dataset, const Sequence& sequence)
        : m_dataset(dataset)
        , m_sequence(sequence) {}

    bool acceptsFrame(int frame);
    bool acceptsCamera(const std::string& camera);
    /// Both of them.
    bool accepts(const MarkKey& key) { return acceptsFrame(key.frame) && acceptsCamera(key.camera); }
    /// Something else that was left out, of a kind that is "left out count times"; equal ones are counted.
    void leaveOut(ImportNoteKind kind, const std::string& name = {}, double number = 0);

    /// A mark of a body part that stands for no joint; `fitting` is a name that would.
    void leaveOutPart(const std::string& part, const std::string& fitting);
    /// The names of such body parts, ascending.
    std::vector<std::string> unknownParts() const;
    /// A row with labels of another video's picture.
    void leaveOutVideo(const std::string& video);
    /// Something that is worth knowing though nothing was left out; once, however often it is said.
    void remark(ImportNoteKind kind, const std::vector<std::string>& names = {});
    /// The videos of such rows, ascending.
    std::vector<std::string> otherVideos() const;

    /// One note for each kind of thing that was left out, unknown body parts first.
    std::vector<ImportNote> all() const;

private:
    const Dataset& m_dataset;
    const Sequence& m_sequence;

    std::map<std::string, ImportNote> m_left; ///< by what was left out, in words, which is their order
    std::map<std::string, int> m_parts;       ///< marks of unknown body parts
    std::string m_fittingPart;
    std::map<std::string, int> m_videos; ///< rows of other videos
    std::vector<ImportNote> m_remarks;
};

} // namespace core
