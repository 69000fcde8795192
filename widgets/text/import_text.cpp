// SPDX-License-Identifier: MIT
#include "widgets/text/import_text.h"

#include "widgets/text/local_text.h"

namespace widgets {

namespace {

using ImportKind = core::ImportNoteKind;

constexpr LocalText importText{"widgets::ImportText"};
constexpr int kMostNames = 5; ///< that a note lists

/// The first few names, and how many more there are.
QString listedNames(const QStringList& names) {
    const QString list = names.mid(0, kMostNames).join(QStringLiteral(", "));
    const int more = names.size() - kMostNames;
    return more <= 0 ? list : importText(QT_TRANSLATE_N_NOOP("widgets::ImportText", "%1 and %n more"), more).arg(list);
}

QStringList namesOf(const core::ImportNote& note) {
    QStringList names;
    for (const std::string& name : note.names)
        names << toQString(name);
    return names;
}

/// Notes about the file as a whole.
QString remarkInWords(const core::ImportNote& note, const QStringList& names) {
    switch (note.kind) {
    case ImportKind::ShiftedFootage:
        return importText(QT_TRANSLATE_NOOP("widgets::ImportText",
                                            "%1: its footage is shifted against the sequence; the numbers of its "
                                            "pictures are taken as frames of the sequence, not of the video."))
            .arg(names.value(0));
    case ImportKind::CamerasByOrder:
        return importText(QT_TRANSLATE_NOOP("widgets::ImportText",
                                            "The file names none of the dataset's cameras; they are taken in the "
                                            "dataset's order: %1."))
            .arg(names.join(QStringLiteral(", ")));
    case ImportKind::Reprojections:
        return importText(QT_TRANSLATE_NOOP("widgets::ImportText",
                                            "The file holds reprojections of 3D points, not clicks (data_2d); they "
                                            "come as proposals."));
    case ImportKind::PointsWithoutClicks:
        return importText(QT_TRANSLATE_NOOP("widgets::ImportText",
                                            "The file holds 3D points without clicks; they come as proposals."));
    case ImportKind::FileOfSequence:
    case ImportKind::TableOfSequence:
        return importText(QT_TRANSLATE_NOOP("widgets::ImportText", "The file is of sequence %1, not of %2."))
            .arg(names.value(0), names.value(1));
    case ImportKind::SomeGuesses:
        return importText(QT_TRANSLATE_NOOP("widgets::ImportText",
                                            "Some marks are a program's guesses; they come as proposals, to be "
                                            "checked."));
    default:
        return importText(QT_TRANSLATE_NOOP("widgets::ImportText",
                                            "The marks are a program's guesses; they come as proposals, to be "
                                            "checked."));
    }
}

/// What marks and rows were left out because of where they are.
QString misplacedInWords(const core::ImportNote& note, const QStringList& names) {
    switch (note.kind) {
    case ImportKind::UnknownFrames:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText",
                                              "Left out: %n item(s) of frames that sequence %1 does not have (it has 0 "
                                              "to %2)."),
                          note.count)
            .arg(names.value(0), QLocale().toString(static_cast<int>(note.number)));
    case ImportKind::UnknownCamera:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText",
                                              "Left out: %n mark(s) in camera %1, which the dataset does not have."),
                          note.count)
            .arg(names.value(0));
    case ImportKind::OtherCamera:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText", "Left out: %n row(s) of the view of camera %1."),
                          note.count)
            .arg(names.value(0));
    case ImportKind::OtherVideos:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText", "Left out: %n row(s) of other videos: %1."),
                          note.count)
            .arg(listedNames(names));
    default:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText",
                                              "%n mark(s) outside the picture of %1: kept, but not used for 3D "
                                              "points."),
                          note.count)
            .arg(names.value(0));
    }
}

/// What marks were left out because of what they are.
QString unusableInWords(const core::ImportNote& note, const QStringList& names) {
    switch (note.kind) {
    case ImportKind::UnlikelyGuesses:
        return importText(
                   QT_TRANSLATE_N_NOOP("widgets::ImportText", "Left out: %n mark(s) with a likelihood below %1."),
                   note.count)
            .arg(QLocale().toString(note.number));
    case ImportKind::RepeatedGuesses:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText",
                                              "Left out: %n guess(es) of joints that are labelled or guessed in the "
                                              "same picture already."),
                          note.count);
    case ImportKind::HiddenLabels:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText", "Left out: %n label(s) marked as not visible."),
                          note.count);
    case ImportKind::UnmappedKeypoint:
    case ImportKind::UnmappedJoint:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText",
                                              "Left out: %n mark(s) of %1, which is not in the joint map."),
                          note.count)
            .arg(names.value(0));
    case ImportKind::CategoryWithoutSide:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText",
                                              "Left out: %n annotation(s) of category %1, which says neither left nor "
                                              "right."),
                          note.count)
            .arg(names.value(0));
    default:
        return importText(QT_TRANSLATE_N_NOOP("widgets::ImportText",
                                              "Left out: %n mark(s) of body parts that are not joints: %1. A name that "
                                              "fits is %2; the command line takes a map of names (annotations --map)."),
                          note.count)
            .arg(listedNames(names.mid(1)), names.value(0));
    }
}

} // namespace

QString importNoteInWords(const core::ImportNote& note) {
    const QStringList names = namesOf(note);
    switch (note.kind) {
    case ImportKind::ShiftedFootage:
    case ImportKind::CamerasByOrder:
    case ImportKind::Reprojections:
    case ImportKind::PointsWithoutClicks:
    case ImportKind::FileOfSequence:
    case ImportKind::TableOfSequence:
    case ImportKind::SomeGuesses:
    case ImportKind::OnlyGuesses:
        return remarkInWords(note, names);
    case ImportKind::OtherVideos:
    case ImportKind::UnknownFrames:
    case ImportKind::UnknownCamera:
    case ImportKind::OtherCamera:
    case ImportKind::OutsidePicture:
        return misplacedInWords(note, names);
    case ImportKind::UnknownParts:
    case ImportKind::UnlikelyGuesses:
    case ImportKind::RepeatedGuesses:
    case ImportKind::HiddenLabels:
    case ImportKind::UnmappedKeypoint:
    case ImportKind::UnmappedJoint:
    case ImportKind::CategoryWithoutSide:
        return unusableInWords(note, names);
    }
    return {};
}

QStringList importNotesInWords(const std::vector<core::ImportNote>& notes) {
    QStringList words;
    for (const core::ImportNote& note : notes)
        words << importNoteInWords(note);
    return words;
}

} // namespace widgets
