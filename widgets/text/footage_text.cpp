// SPDX-License-Identifier: MIT
#include "widgets/text/footage_text.h"

#include <algorithm>

#include "widgets/text/local_text.h"

namespace widgets {

namespace {

using core::FootageNote;
using NoteKind = core::FootageNoteKind;

constexpr LocalText footageText{"widgets::FootageText"};
constexpr std::size_t kMostPlaces = 6; ///< that a note lists

int countOf(const std::vector<core::InstantRange>& ranges) {
    int count = 0;
    for (const core::InstantRange& range : ranges)
        count += range.count;
    return count;
}

/// The first few places, and how many more there are.
template <typename Words>
QString listed(const std::vector<core::InstantRange>& ranges, const Words& words) {
    QStringList places;
    for (std::size_t i = 0; i < std::min(ranges.size(), kMostPlaces); ++i)
        places << words(ranges[i]);
    const int more = static_cast<int>(ranges.size()) - places.size();
    const QString list = places.join(QStringLiteral(", "));
    return more == 0
               ? list
               : footageText(QT_TRANSLATE_N_NOOP("widgets::FootageText", "%1 and %n more place(s)"), more).arg(list);
}

QString number(double value) {
    return QLocale().toString(value, 'g', 10);
}

/// As a file name holds it: without marks between thousands.
QString pictureNumber(int value) {
    return QString::number(value);
}

QString lostFrames(const FootageNote& note, const QString& camera) {
    if (note.ranges.size() == 1) {
        return footageText(QT_TRANSLATE_N_NOOP("widgets::FootageText", "%1: %n frame(s) missing after frame %2."),
                           countOf(note.ranges))
            .arg(camera, QLocale().toString(note.ranges.front().first - 1));
    }
    const QString places = listed(note.ranges, [](const core::InstantRange& range) {
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "%1 after frame %2"))
            .arg(QLocale().toString(range.count), QLocale().toString(range.first - 1));
    });
    return footageText(QT_TRANSLATE_N_NOOP("widgets::FootageText", "%1: %n frame(s) missing: %2."),
                       countOf(note.ranges))
        .arg(camera, places);
}

QString missingPictures(const FootageNote& note, const QString& camera) {
    const QString places = listed(note.ranges, [](const core::InstantRange& range) {
        const QString first = pictureNumber(range.first);
        return range.count == 1 ? first : first + QChar(0x2013) + pictureNumber(range.first + range.count - 1);
    });
    return footageText(QT_TRANSLATE_N_NOOP("widgets::FootageText", "%1: %n picture(s) missing: %2."),
                       countOf(note.ranges))
        .arg(camera, places);
}

QString firstPictures(const FootageNote& note) {
    QStringList starts;
    for (std::size_t i = 0; i < note.cameras.size(); ++i)
        starts << QStringLiteral("%1: %2").arg(QString::fromStdString(note.cameras[i]), number(note.numbers[i]));
    return footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                         "The pictures start at different numbers (%1); the first ones are taken as "
                                         "the same instant."))
        .arg(starts.join(QStringLiteral(", ")));
}

/// Notes that lost frames do not matter to: of one camera with at most two numbers.
QString plainSentence(const FootageNote& note, const QString& camera) {
    const double first = note.numbers.empty() ? 0 : note.numbers.front();
    const QString second = note.numbers.size() > 1 ? number(note.numbers[1]) : QString();
    switch (note.kind) {
    case NoteKind::UnevenTimes:
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                             "%1: its time stamps are uneven or missing, so lost frames cannot be "
                                             "told; its frames are taken by number."))
            .arg(camera);
    case NoteKind::FirstPicture:
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "%1: frame 0 is picture %2."))
            .arg(camera, pictureNumber(static_cast<int>(first)));
    case NoteKind::LongerThanTheInstants:
        return footageText(
                   QT_TRANSLATE_N_NOOP("widgets::FootageText", "%1 goes on for %n frame(s) after the last instant."),
                   static_cast<int>(first))
            .arg(camera);
    case NoteKind::LongerThanTheShortest:
        return footageText(QT_TRANSLATE_N_NOOP("widgets::FootageText",
                                               "%1 has %n frame(s) more than the shortest footage: are they all of "
                                               "the same instants?"),
                           static_cast<int>(first))
            .arg(camera);
    case NoteKind::OtherRate:
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                             "%1 was recorded at another frame rate than the sequence's %2."))
            .arg(camera, number(first));
    default:
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                             "%1: its pictures have more than 8 bits; level %2 is shown black, %3 "
                                             "white."))
            .arg(camera, number(first), second);
    }
}

QString orientationSentence(const FootageNote& note, const QString& camera) {
    const QString first = number(note.numbers.front());
    if (note.kind == NoteKind::Mirrored) {
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                             "%1: the orientation tag of its pictures says that they are mirrored; "
                                             "they are not mirrored here, but turned by %2\u00b0."))
            .arg(camera, first);
    }
    if (note.kind == NoteKind::TagFollowed) {
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                             "%1: turned clockwise by %2\u00b0, as its orientation tag says."))
            .arg(camera, first);
    }
    return footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                         "%1: its orientation tag says that it is to be turned clockwise by %2\u00b0, "
                                         "but it is turned by %3\u00b0."))
        .arg(camera, first, number(note.numbers[1]));
}

} // namespace

QString footageNoteInWords(const FootageNote& note) {
    const QString camera = note.cameras.empty() ? QString() : QString::fromStdString(note.cameras.front());
    switch (note.kind) {
    case NoteKind::Text:
        return QString::fromStdString(note.text);
    case NoteKind::Simulated:
        return footageText(QT_TRANSLATE_NOOP(
            "widgets::FootageText",
            "Simulated. Masks are the difference of each picture to the empty room; only the annotated frames have "
            "pictures. The recorded motion is that of the person in the pictures, played by the model's hand. What it "
            "was drawn from is in the folder truth."));
    case NoteKind::FirstPicturesDiffer:
        return firstPictures(note);
    case NoteKind::MissingPictures:
        return missingPictures(note, camera);
    case NoteKind::LostFrames:
        return lostFrames(note, camera);
    case NoteKind::LostFramesByChoice:
    case NoteKind::LostFramesByNumber:
        return lostFrames(note, camera) + QLatin1Char(' ') +
               footageText(QT_TRANSLATE_NOOP("widgets::FootageText",
                                             "Its frames are taken by number, so the later ones are not of the other "
                                             "cameras' instants."));
    case NoteKind::TagFollowed:
    case NoteKind::TagNotFollowed:
    case NoteKind::Mirrored:
        return orientationSentence(note, camera);
    default:
        return plainSentence(note, camera);
    }
}

QStringList footageNotesInWords(const std::vector<FootageNote>& notes) {
    QStringList words;
    for (const FootageNote& note : notes)
        words << footageNoteInWords(note);
    return words;
}

QString maskNoteInWords(const core::MaskNote& note) {
    const QString camera = QString::fromStdString(note.camera);
    if (note.kind == core::MaskNoteKind::Count) {
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "%1: %2 of %3 frames have a mask."))
            .arg(camera, QLocale().toString(note.count), QLocale().toString(note.frameCount));
    }
    return footageText(QT_TRANSLATE_N_NOOP("widgets::FootageText",
                                           "%1: %n mask(s) of no frame of the sequence: its frames need the numbers %2 "
                                           "to %3, the masks have %4 to %5."),
                       note.count)
        .arg(camera, pictureNumber(note.offset), pictureNumber(note.offset + note.frameCount - 1),
             pictureNumber(note.firstNumber), pictureNumber(note.lastNumber));
}

QString footageProblemInWords(const core::FootageProblem& problem) {
    const auto size = [](core::ImageSize s) { return QStringLiteral("%1 x %2").arg(s.width).arg(s.height); };
    switch (problem.kind) {
    case core::FootageProblemKind::None:
        return {};
    case core::FootageProblemKind::TooFewFrames:
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "it has %1 frames, but the sequence needs %2"))
            .arg(QLocale().toString(problem.count), QLocale().toString(problem.needed));
    case core::FootageProblemKind::TooFewPictures:
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "it has %1 pictures, but the sequence needs %2"))
            .arg(QLocale().toString(problem.count), QLocale().toString(problem.needed));
    case core::FootageProblemKind::OtherSize:
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "it is %1, but its camera is calibrated for %2"))
            .arg(size(problem.size), size(problem.calibrated));
    case core::FootageProblemKind::Unreadable:
        break;
    }
    return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "it cannot be read (%1)"))
        .arg(QString::fromStdString(problem.detail));
}

QString relinkNoteInWords(const core::RelinkFinding& finding) {
    switch (finding.reason) {
    case core::RelinkReason::None:
        break;
    case core::RelinkReason::SeveralFit: {
        QStringList places;
        for (const std::string& place : finding.places)
            places << QString::fromStdString(place);
        return footageText(QT_TRANSLATE_NOOP("widgets::FootageText", "several fit: %1"))
            .arg(places.join(QStringLiteral(", ")));
    }
    case core::RelinkReason::OtherFootage:
        return footageText(
                   QT_TRANSLATE_NOOP("widgets::FootageText", "%1 has that name, but is other footage of this dataset"))
            .arg(QString::fromStdString(finding.places.front()));
    }
    return footageProblemInWords(finding.problem);
}

} // namespace widgets
