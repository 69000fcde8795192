// SPDX-License-Identifier: MIT
#include "core/io/formats/import_notes.h"

#include <algorithm>

#include "core/text/number_text.h"

namespace core {

namespace {

using Kind = ImportNoteKind;

std::string joinedNames(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::string plural(int count, const std::string& one, const std::string& more) {
    return std::to_string(count) + " " + (count == 1 ? one : more);
}

std::vector<std::string> keysOf(const std::map<std::string, int>& counts) {
    std::vector<std::string> names;
    for (const auto& [name, count] : counts)
        names.push_back(name);
    return names;
}

int sumOf(const std::map<std::string, int>& counts) {
    int sum = 0;
    for (const auto& [name, count] : counts)
        sum += count;
    return sum;
}

std::string partsText(const ImportNote& note) {
    constexpr std::size_t kMostNames = 5;
    std::vector<std::string> names(note.names.begin() + 1, note.names.end());
    const std::size_t more = names.size() - std::min(names.size(), kMostNames);
    names.resize(names.size() - more);
    return "left out: " + plural(note.count, "mark", "marks") + " of body parts that are not joints (" +
           joinedNames(names) + (more > 0 ? " and " + std::to_string(more) + " more" : "") + "): a name that fits is " +
           note.names.front() + "; --map FILE says which joint each name stands for";
}

/// What was left out, without how often; empty for kinds of another form.
std::string leftOutText(const ImportNote& note) {
    const std::string name = note.names.empty() ? std::string() : note.names.front();
    switch (note.kind) {
    case Kind::UnknownFrames:
        return "frames that sequence " + name + " does not have (0 to " +
               std::to_string(static_cast<int>(note.number)) + ")";
    case Kind::UnknownCamera:
        return "marks in camera \"" + name + "\", which the dataset does not have";
    case Kind::OtherCamera:
        return "rows of the view of camera \"" + name + "\"";
    case Kind::UnlikelyGuesses:
        return "marks with a likelihood below " + exactText(note.number);
    case Kind::RepeatedGuesses:
        return "guesses of joints that are labelled or guessed in the same picture already";
    case Kind::HiddenLabels:
        return "labels that are marked as not visible";
    case Kind::UnmappedKeypoint:
        return "keypoint \"" + name + "\", which is not in the map";
    case Kind::UnmappedJoint:
        return "joint \"" + name + "\", which is not in the map";
    case Kind::CategoryWithoutSide:
        return "annotations of category " + name + ", which says neither left nor right";
    default:
        return {};
    }
}

} // namespace

std::string importNoteText(const ImportNote& note) {
    switch (note.kind) {
    case Kind::UnknownParts:
        return partsText(note);
    case Kind::ShiftedFootage:
        return "the footage of " + note.names.front() +
               " is shifted against the sequence: the numbers of its pictures are taken as frames of the sequence, "
               "not of the video";
    case Kind::CamerasByOrder:
        return "the file names none of the dataset's cameras: they are taken in the dataset's order, " +
               joinedNames(note.names);
    case Kind::Reprojections:
        return "data_2d are reprojections of 3D points, not clicks: they come as proposals";
    case Kind::PointsWithoutClicks:
        return "the file holds 3D points without clicks: they come as proposals";
    case Kind::FileOfSequence:
    case Kind::TableOfSequence:
        return (note.kind == Kind::FileOfSequence ? "the file is of sequence \"" : "the table is of sequence \"") +
               note.names[0] + "\", not of \"" + note.names[1] + "\"";
    case Kind::SomeGuesses:
        return "marks that are a program's guesses come as proposals, to be checked";
    case Kind::OnlyGuesses:
        return "the marks are a program's guesses: they come as proposals, to be checked";
    case Kind::OtherVideos:
        return plural(note.count, "row", "rows") + " of other videos left out: " + joinedNames(note.names) +
               "; choose a video with --video";
    case Kind::OutsidePicture:
        return plural(note.count, "mark lies", "marks lie") + " outside the picture of " + note.names.front() +
               ": kept, but not used for 3D points";
    default:
        return "left out: " + leftOutText(note) + " (" + std::to_string(note.count) + " times)";
    }
}

bool ImportNotes::acceptsFrame(int frame) {
    if (frame >= 0 && frame < m_sequence.frameCount)
        return true;
    leaveOut(Kind::UnknownFrames, m_sequence.name, m_sequence.frameCount - 1);
    return false;
}

bool ImportNotes::acceptsCamera(const std::string& camera) {
    if (m_dataset.cameraIndex(camera) >= 0)
        return true;
    leaveOut(Kind::UnknownCamera, camera);
    return false;
}

void ImportNotes::leaveOut(ImportNoteKind kind, const std::string& name, double number) {
    ImportNote note{kind, {}, 0, number};
    if (!name.empty())
        note.names.push_back(name);
    ++m_left.try_emplace(leftOutText(note), note).first->second.count;
}

void ImportNotes::leaveOutPart(const std::string& part, const std::string& fitting) {
    ++m_parts[part];
    m_fittingPart = fitting;
}

std::vector<std::string> ImportNotes::unknownParts() const {
    return keysOf(m_parts);
}

void ImportNotes::leaveOutVideo(const std::string& video) {
    ++m_videos[video];
}

void ImportNotes::remark(ImportNoteKind kind, const std::vector<std::string>& names) {
    const ImportNote note{kind, names};
    if (std::find(m_remarks.begin(), m_remarks.end(), note) == m_remarks.end())
        m_remarks.push_back(note);
}

std::vector<std::string> ImportNotes::otherVideos() const {
    return keysOf(m_videos);
}

std::vector<ImportNote> ImportNotes::all() const {
    std::vector<ImportNote> notes;
    if (!m_parts.empty()) {
        notes.push_back({Kind::UnknownParts, keysOf(m_parts), sumOf(m_parts)});
        notes.back().names.insert(notes.back().names.begin(), m_fittingPart);
    }
    notes.insert(notes.end(), m_remarks.begin(), m_remarks.end());
    if (!m_videos.empty())
        notes.push_back({Kind::OtherVideos, keysOf(m_videos), sumOf(m_videos)});
    for (const auto& [words, note] : m_left)
        notes.push_back(note);
    return notes;
}

} // namespace core
