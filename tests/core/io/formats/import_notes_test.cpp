// SPDX-License-Identifier: MIT
#include "core/io/formats/import_notes.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/tiny_dataset.h"

namespace {

using core::ImportNote;
using core::ImportNoteKind;

struct Said {
    ImportNote note;
    const char* sentence;
};

const Said kSentences[] = {
    {{ImportNoteKind::UnknownParts, {"left_index_mcp", "nose", "tail"}, 3},
     "left out: 3 marks of body parts that are not joints (nose, tail): a name that fits is left_index_mcp; --map FILE "
     "says which joint each name stands for"},
    {{ImportNoteKind::UnknownParts, {"left_wrist", "a", "b", "c", "d", "e", "f", "g"}, 1},
     "left out: 1 mark of body parts that are not joints (a, b, c, d, e and 2 more): a name that fits is left_wrist; "
     "--map FILE says which joint each name stands for"},
    {{ImportNoteKind::ShiftedFootage, {"cam0"}},
     "the footage of cam0 is shifted against the sequence: the numbers of its pictures are taken as frames of the "
     "sequence, not of the video"},
    {{ImportNoteKind::CamerasByOrder, {"cam0", "cam1"}},
     "the file names none of the dataset's cameras: they are taken in the dataset's order, cam0, cam1"},
    {{ImportNoteKind::Reprojections}, "data_2d are reprojections of 3D points, not clicks: they come as proposals"},
    {{ImportNoteKind::PointsWithoutClicks}, "the file holds 3D points without clicks: they come as proposals"},
    {{ImportNoteKind::FileOfSequence, {"01", "02"}}, "the file is of sequence \"01\", not of \"02\""},
    {{ImportNoteKind::TableOfSequence, {"01", "02"}}, "the table is of sequence \"01\", not of \"02\""},
    {{ImportNoteKind::SomeGuesses}, "marks that are a program's guesses come as proposals, to be checked"},
    {{ImportNoteKind::OnlyGuesses}, "the marks are a program's guesses: they come as proposals, to be checked"},
    {{ImportNoteKind::OtherVideos, {"monday", "tuesday"}, 1},
     "1 row of other videos left out: monday, tuesday; choose a video with --video"},
    {{ImportNoteKind::UnknownFrames, {"a"}, 2, 1000000},
     "left out: frames that sequence a does not have (0 to 1000000) (2 times)"},
    {{ImportNoteKind::UnknownCamera, {"cam9"}, 2},
     "left out: marks in camera \"cam9\", which the dataset does not have (2 times)"},
    {{ImportNoteKind::OtherCamera, {"cam1"}, 2}, "left out: rows of the view of camera \"cam1\" (2 times)"},
    {{ImportNoteKind::UnlikelyGuesses, {}, 2, 0.5}, "left out: marks with a likelihood below 0.5 (2 times)"},
    {{ImportNoteKind::RepeatedGuesses, {}, 2},
     "left out: guesses of joints that are labelled or guessed in the same picture already (2 times)"},
    {{ImportNoteKind::HiddenLabels, {}, 1}, "left out: labels that are marked as not visible (1 times)"},
    {{ImportNoteKind::UnmappedKeypoint, {"nose"}, 2}, "left out: keypoint \"nose\", which is not in the map (2 times)"},
    {{ImportNoteKind::UnmappedJoint, {"nose"}, 2}, "left out: joint \"nose\", which is not in the map (2 times)"},
    {{ImportNoteKind::CategoryWithoutSide, {"\"hand\""}, 2},
     "left out: annotations of category \"hand\", which says neither left nor right (2 times)"},
    {{ImportNoteKind::OutsidePicture, {"cam1"}, 1},
     "1 mark lies outside the picture of cam1: kept, but not used for 3D points"},
    {{ImportNoteKind::OutsidePicture, {"cam1"}, 2},
     "2 marks lie outside the picture of cam1: kept, but not used for 3D points"},
};

TEST(ImportNotes, EveryKindKeepsItsSentence) {
    std::set<ImportNoteKind> kinds;
    for (const Said& said : kSentences) {
        EXPECT_EQ(core::importNoteText(said.note), said.sentence);
        kinds.insert(said.note.kind);
    }
    EXPECT_EQ(kinds.size(), static_cast<std::size_t>(ImportNoteKind::OutsidePicture) + 1) << "a kind is not tried";
}

TEST(ImportNotes, EqualOnesAreCountedAndStandInAFixedOrder) {
    const core::Dataset dataset = test::tinyDataset();
    core::ImportNotes notes(dataset, dataset.sequences.front());
    notes.leaveOut(ImportNoteKind::HiddenLabels);
    EXPECT_FALSE(notes.acceptsCamera("cam9"));
    EXPECT_FALSE(notes.acceptsFrame(-1));
    EXPECT_FALSE(notes.acceptsFrame(-2));
    EXPECT_TRUE(notes.acceptsFrame(0));
    notes.leaveOutVideo("monday");
    notes.remark(ImportNoteKind::SomeGuesses);
    notes.remark(ImportNoteKind::SomeGuesses);
    notes.leaveOutPart("tail", "left_wrist");
    const std::vector<ImportNote> all = notes.all();
    ASSERT_EQ(all.size(), 6u);
    EXPECT_EQ(all[0], (ImportNote{ImportNoteKind::UnknownParts, {"left_wrist", "tail"}, 1}));
    EXPECT_EQ(all[1], (ImportNote{ImportNoteKind::SomeGuesses}));
    EXPECT_EQ(all[2], (ImportNote{ImportNoteKind::OtherVideos, {"monday"}, 1}));
    EXPECT_EQ(all[3].kind, ImportNoteKind::UnknownFrames);
    EXPECT_EQ(all[3].count, 2);
    EXPECT_EQ(all[4].kind, ImportNoteKind::HiddenLabels);
    EXPECT_EQ(all[5].kind, ImportNoteKind::UnknownCamera);
}

} // namespace
