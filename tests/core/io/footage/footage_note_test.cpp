// SPDX-License-Identifier: MIT
#include "core/io/footage/footage_note.h"

#include <set>

#include <gtest/gtest.h>

namespace {

using Kind = core::FootageNoteKind;

constexpr int kKinds = static_cast<int>(Kind::FirstPicturesDiffer) + 1;

TEST(FootageNote, EveryKindHasANameOfItsOwnThatReadsBack) {
    std::set<std::string_view> names;
    for (int i = 0; i < kKinds; ++i) {
        const auto kind = static_cast<Kind>(i);
        EXPECT_TRUE(names.insert(core::footageNoteName(kind)).second) << core::footageNoteName(kind);
        EXPECT_EQ(core::footageNoteFromName(core::footageNoteName(kind)), kind);
    }
    EXPECT_EQ(core::footageNoteFromName("sunshine"), std::nullopt);
}

TEST(FootageNote, SaysWhereFramesAreMissing) {
    EXPECT_EQ(core::footageNoteText({Kind::LostFrames, {"cam1"}, {{500, 8}}}),
              "cam1: 8 frames missing after frame 499");
    EXPECT_EQ(core::footageNoteText({Kind::LostFrames, {"cam1"}, {{5, 1}, {9, 2}}}),
              "cam1: 3 frames missing: 1 after frame 4, 2 after frame 8");
    EXPECT_EQ(core::footageNoteText({Kind::MissingPictures, {"cam0"}, {{7, 2}, {20, 1}}}),
              "cam0: 3 pictures missing: 7-8, 20");
    const core::FootageNote many{
        Kind::MissingPictures, {"c"}, {{1, 1}, {3, 1}, {5, 1}, {7, 1}, {9, 1}, {11, 1}, {13, 1}, {15, 1}}};
    EXPECT_EQ(core::footageNoteText(many), "c: 8 pictures missing: 1, 3, 5, 7, 9, 11 and 2 more places");
}

TEST(FootageNote, SaysTheNumbersOfItsKind) {
    EXPECT_EQ(core::footageNoteText({Kind::FirstPicture, {"cam0"}, {}, {12}}), "cam0: frame 0 is picture 12");
    EXPECT_EQ(core::footageNoteText({Kind::LongerThanTheInstants, {"cam0"}, {}, {1}}),
              "cam0 goes on for 1 frame after the last instant");
    EXPECT_EQ(core::footageNoteText({Kind::OtherRate, {"cam0"}, {}, {29.97}}),
              "cam0 was recorded at another frame rate than the sequence's 29.97");
    EXPECT_EQ(core::footageNoteText({Kind::TagNotFollowed, {"cam0"}, {}, {90, 0}}),
              "cam0: the footage's orientation tag says that it is to be turned clockwise by 90 degrees, but it is "
              "turned by 0; --rotate cam0=90 follows the tag");
    EXPECT_EQ(core::footageNoteText({Kind::FirstPicturesDiffer, {"cam0", "cam1"}, {}, {0, 1}}),
              "the pictures start at different numbers (cam0 at 0, cam1 at 1): the first ones are taken as the same "
              "instant (--offset changes that)");
}

TEST(FootageNote, IsWholeOnlyWithWhatItsKindNeeds) {
    EXPECT_TRUE(core::isWhole({Kind::LostFrames, {"cam1"}, {{500, 8}}}));
    EXPECT_FALSE(core::isWhole({Kind::LostFrames, {"cam1"}}));
    EXPECT_FALSE(core::isWhole({Kind::LostFrames, {}, {{500, 8}}}));
    EXPECT_TRUE(core::isWhole({Kind::Levels, {"cam1"}, {}, {10, 200}}));
    EXPECT_FALSE(core::isWhole({Kind::Levels, {"cam1"}, {}, {10}}));
    EXPECT_FALSE(core::isWhole({Kind::Text}));
    EXPECT_TRUE(core::isWhole({Kind::Simulated}));
}

} // namespace
