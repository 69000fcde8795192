// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/footage/view_source.h"

namespace core {

/// What a person should know about the footage of a sequence. Behind each kind: what FootageNote::ranges and
/// FootageNote::numbers hold.
enum class FootageNoteKind {
    Text,                  ///< a sentence of a dataset that was made before notes were data
    Simulated,             ///< pictures and masks are simulated; of no camera
    LostFrames,            ///< ranges: instants that the camera lost
    LostFramesByChoice,    ///< the same of a video whose frames are taken by number, though its time stamps are sound
    LostFramesByNumber,    ///< the same where the time stamps of all videos together cannot map them
    UnevenTimes,           ///< time stamps are uneven or missing, so that lost frames cannot be told
    MissingPictures,       ///< ranges: numbers of the images
    FirstPicture,          ///< numbers: that of the image at frame 0
    LongerThanTheInstants, ///< numbers: how many frames come after the last instant
    LongerThanTheShortest, ///< numbers: how many frames it has more than the shortest footage
    OtherRate,             ///< numbers: frames per second of the sequence
    TagFollowed,           ///< numbers: degrees clockwise that its orientation tag asks for, and gets
    TagNotFollowed,        ///< numbers: degrees clockwise that its orientation tag asks for, and those it is turned by
    Mirrored,              ///< its tag says mirrored, which is not followed; numbers: degrees clockwise it is turned by
    Levels,                ///< pictures of more than 8 bits; numbers: the levels shown black and white
    FirstPicturesDiffer    ///< numbers: of each camera's first image; they are taken as the same instant
};

/// One such note. `numbers` has as many values as its kind says.
struct FootageNote {
    FootageNoteKind kind = FootageNoteKind::Text;
    std::vector<std::string>
        cameras{}; ///< one; none for Text and Simulated; those with a number for FirstPicturesDiffer
    std::vector<InstantRange> ranges{};
    std::vector<double> numbers{};
    std::string text{}; ///< of Text
    bool operator==(const FootageNote&) const = default;
};

/// The kind's name in dataset.json, such as "lostFrames".
std::string_view footageNoteName(FootageNoteKind kind);
/// Reads such a name; empty if it is unknown.
std::optional<FootageNoteKind> footageNoteFromName(std::string_view name);
/// Whether the note has the cameras, ranges and numbers that its kind needs.
bool isWhole(const FootageNote& note);

/// The note as an English sentence, for the command line.
std::string footageNoteText(const FootageNote& note);

} // namespace core
