// SPDX-License-Identifier: MIT
#include "core/io/footage/footage_note.h"

#include <algorithm>
#include <functional>

#include "core/text/number_text.h"

namespace core {

namespace {

/// What a kind is called in files, and what its notes hold.
struct KindRow {
    FootageNoteKind kind;
    std::string_view name;
    bool hasRanges;
    std::size_t numbers;
};

using Kind = FootageNoteKind;
constexpr KindRow kKinds[] = {{Kind::Text, "text", false, 0},
                              {Kind::Simulated, "simulated", false, 0},
                              {Kind::LostFrames, "lostFrames", true, 0},
                              {Kind::LostFramesByChoice, "lostFramesByChoice", true, 0},
                              {Kind::LostFramesByNumber, "lostFramesByNumber", true, 0},
                              {Kind::UnevenTimes, "unevenTimes", false, 0},
                              {Kind::MissingPictures, "missingPictures", true, 0},
                              {Kind::FirstPicture, "firstPicture", false, 1},
                              {Kind::LongerThanTheInstants, "longerThanTheInstants", false, 1},
                              {Kind::LongerThanTheShortest, "longerThanTheShortest", false, 1},
                              {Kind::OtherRate, "otherRate", false, 1},
                              {Kind::TagFollowed, "tagFollowed", false, 1},
                              {Kind::TagNotFollowed, "tagNotFollowed", false, 2},
                              {Kind::Mirrored, "mirrored", false, 1},
                              {Kind::Levels, "levels", false, 2},
                              {Kind::FirstPicturesDiffer, "firstPicturesDiffer", false, 0}};

constexpr std::size_t kMostPlaces = 6; ///< that a note lists

std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

int countOf(const std::vector<InstantRange>& ranges) {
    int count = 0;
    for (const InstantRange& range : ranges)
        count += range.count;
    return count;
}

/// The first few ranges, each in the words of `text`, and how many more there are.
std::string listed(const std::vector<InstantRange>& ranges,
                   const std::function<std::string(const InstantRange&)>& text) {
    std::string list;
    for (std::size_t i = 0; i < std::min(ranges.size(), kMostPlaces); ++i)
        list += (list.empty() ? "" : ", ") + text(ranges[i]);
    const std::size_t more = ranges.size() - std::min(ranges.size(), kMostPlaces);
    return list + (more > 0 ? " and " + std::to_string(more) + " more places" : "");
}

/// "cam1: 8 frames missing after frame 499"
std::string lostFrames(const FootageNote& note, const std::string& camera) {
    const std::string start = camera + ": " + counted(countOf(note.ranges), "frame") + " missing";
    if (note.ranges.size() == 1)
        return start + " after frame " + std::to_string(note.ranges.front().first - 1);
    return start + ": " + listed(note.ranges, [](const InstantRange& range) {
               return std::to_string(range.count) + " after frame " + std::to_string(range.first - 1);
           });
}

/// "cam0: 2 pictures missing: 7-8"
std::string missingPictures(const FootageNote& note, const std::string& camera) {
    return camera + ": " + counted(countOf(note.ranges), "picture") + " missing: " +
           listed(
               note.ranges,
               [](const InstantRange& range) {
                   const int first = range.first, last = first + range.count - 1;
                   return std::to_string(first) + (last > first ? "-" + std::to_string(last) : "");
               });
}

std::string orientation(const FootageNote& note, const std::string& camera) {
    const std::string first = exactText(note.numbers.front());
    if (note.kind == Kind::Mirrored) {
        return camera +
               ": the orientation tag of its pictures says that they are mirrored; they are not mirrored here, but "
               "turned by " +
               first + " degrees (--rotate " + camera + "=DEGREES)";
    }
    const std::string said =
        camera + ": the footage's orientation tag says that it is to be turned clockwise by " + first + " degrees";
    return note.kind == Kind::TagFollowed ? said + ", and it is; --rotate " + camera + "=0 leaves it as recorded"
                                          : said + ", but it is turned by " + exactText(note.numbers[1]) +
                                                "; --rotate " + camera + "=" + first + " follows the tag";
}

std::string firstPictures(const FootageNote& note) {
    std::string starts;
    for (std::size_t i = 0; i < note.cameras.size(); ++i)
        starts += (i == 0 ? "" : ", ") + note.cameras[i] + " at " + exactText(note.numbers[i]);
    return "the pictures start at different numbers (" + starts +
           "): the first ones are taken as the same instant (--offset changes that)";
}

/// A note of one camera with at most a number.
std::string plainText(const FootageNote& note, const std::string& camera) {
    const double number = note.numbers.empty() ? 0 : note.numbers.front();
    switch (note.kind) {
    case Kind::UnevenTimes:
        return camera + ": its time stamps are uneven or missing, so lost frames cannot be told; its frames are taken "
                        "by number";
    case Kind::FirstPicture:
        return camera + ": frame 0 is picture " + exactText(number);
    case Kind::LongerThanTheInstants:
        return camera + " goes on for " + counted(static_cast<int>(number), "frame") + " after the last instant";
    case Kind::LongerThanTheShortest:
        return camera + " has " + counted(static_cast<int>(number), "frame") +
               " more than the shortest footage: are they all of the same instants?";
    case Kind::OtherRate:
        return camera + " was recorded at another frame rate than the sequence's " + exactText(number);
    default:
        return camera + ": its pictures have more than 8 bits; level " + exactText(number) + " is shown black, " +
               exactText(note.numbers[1]) + " white (--levels " + camera + "=BLACK,WHITE)";
    }
}

} // namespace

std::string_view footageNoteName(FootageNoteKind kind) {
    return kKinds[static_cast<std::size_t>(kind)].name;
}

std::optional<FootageNoteKind> footageNoteFromName(std::string_view name) {
    for (const KindRow& row : kKinds)
        if (row.name == name)
            return row.kind;
    return std::nullopt;
}

bool isWhole(const FootageNote& note) {
    const KindRow& row = kKinds[static_cast<std::size_t>(note.kind)];
    if (note.kind == Kind::Text)
        return !note.text.empty();
    if (note.kind == Kind::Simulated)
        return note.cameras.empty();
    if (note.kind == Kind::FirstPicturesDiffer)
        return !note.cameras.empty() && note.numbers.size() == note.cameras.size();
    return note.cameras.size() == 1 && note.ranges.empty() != row.hasRanges && note.numbers.size() == row.numbers;
}

std::string footageNoteText(const FootageNote& note) {
    const std::string camera = note.cameras.empty() ? "" : note.cameras.front();
    switch (note.kind) {
    case Kind::Text:
        return note.text;
    case Kind::Simulated:
        return "Simulated. Masks are the difference of each picture to the empty room; only the annotated frames have "
               "pictures. The recorded motion is that of the person in the pictures, played by the model's hand. What "
               "it was drawn from is in the folder truth.";
    case Kind::FirstPicturesDiffer:
        return firstPictures(note);
    case Kind::MissingPictures:
        return missingPictures(note, camera);
    case Kind::LostFrames:
        return lostFrames(note, camera);
    case Kind::LostFramesByChoice:
    case Kind::LostFramesByNumber:
        return lostFrames(note, camera) +
               " (its time stamps say so); its frames are taken by number, so the later ones are not of the other "
               "cameras' instants" +
               (note.kind == Kind::LostFramesByChoice ? " (new --sync time maps them by time)" : "");
    case Kind::TagFollowed:
    case Kind::TagNotFollowed:
    case Kind::Mirrored:
        return orientation(note, camera);
    default:
        return plainText(note, camera);
    }
}

} // namespace core
