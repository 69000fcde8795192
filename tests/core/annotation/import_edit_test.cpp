// SPDX-License-Identifier: MIT
#include "core/annotation/import_edit.h"

#include <gtest/gtest.h>

#include "tests/support/clicks.h"

namespace {

using core::AnnotationSet;
using core::ImportMode;
using core::JointId;
using core::Mark;
using core::MarkState;
using core::Placement;
using core::Side;

using test::kIndex;
using test::kWrist;

core::MarkKey key(int frame, const JointId& joint, int camera, const std::string& rater = "anna") {
    return {frame, rater, joint, "cam" + std::to_string(camera)};
}
Mark proposal(double x) {
    return {{x, 1}, Placement::Proposed, MarkState::Visible};
}

/// Anna has clicked the index in cam0 and cam1 of frames 5 and 6 and noted something; the file says otherwise of frame
/// 5, and has her wrist and another rater's index, too.
class ImportEdit : public testing::Test {
protected:
    ImportEdit() {
        for (const int frame : {5, 6})
            for (const int camera : {0, 1})
                m_set.marks[key(frame, kIndex, camera)] = Mark{{10.0 + camera, 20}};
        m_set.notes[5] = "hers";
        m_file.marks[key(5, kIndex, 1)] = Mark{{50, 60}};
        m_file.marks[key(5, kIndex, 2)] = Mark{{52, 60}};
        m_file.marks[key(5, kWrist, 0)] = Mark{{70, 80}};
        m_file.marks[key(5, kIndex, 0, "bob")] = Mark{{90, 80}};
        m_file.marks[key(6, kIndex, 0)] = m_set.marks[key(6, kIndex, 0)];
        m_file.marks[key(6, kIndex, 1)] = m_set.marks[key(6, kIndex, 1)];
        m_file.notes[5] = "of the file";
        m_file.notes[7] = "new";
    }
    AnnotationSet after(ImportMode mode) {
        AnnotationSet set = m_set;
        const core::Edit edit = core::importEdit(m_set, m_file, "x", mode);
        core::apply(set, edit);
        AnnotationSet back = set;
        core::apply(back, core::inverse(edit));
        EXPECT_EQ(back, m_set) << "one step takes it back";
        return set;
    }

    AnnotationSet m_set, m_file;
};

TEST_F(ImportEdit, CountsTheMarksAndNotesInTheWay) {
    const core::ImportConflicts conflicts = core::importConflicts(m_set, m_file);
    EXPECT_EQ(conflicts.marks, 2) << "cam0 would go, cam1 would move";
    EXPECT_EQ(conflicts.notes, 1);
    EXPECT_EQ(conflicts.raters, std::set<std::string>{"anna"});
    EXPECT_EQ(conflicts.frames, std::set<int>{5});
    EXPECT_EQ(core::conflictText(conflicts), "2 marks of anna and 1 note in 1 frame");
    EXPECT_TRUE(core::importConflicts(m_set, m_set).empty());
    EXPECT_TRUE(core::importConflicts({}, m_file).empty());
}

TEST_F(ImportEdit, ReplaceTakesTheJointOverAsAWhole) {
    const AnnotationSet set = after(ImportMode::Replace);
    EXPECT_FALSE(core::markAt(set, key(5, kIndex, 0))) << "no joint of two people";
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 1))->px.x(), 50);
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 2))->px.x(), 52);
    EXPECT_TRUE(core::markAt(set, key(5, kWrist, 0)));
    EXPECT_TRUE(core::markAt(set, key(5, kIndex, 0, "bob")));
    EXPECT_EQ(set.notes.at(5), "of the file");
    EXPECT_EQ(set.notes.at(7), "new");
    EXPECT_TRUE(core::importEdit(set, m_file, "again").empty());
}

TEST_F(ImportEdit, KeepLeavesTheJointAloneAsAWhole) {
    const AnnotationSet set = after(ImportMode::Keep);
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 0))->px.x(), 10);
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 1))->px.x(), 11);
    EXPECT_FALSE(core::markAt(set, key(5, kIndex, 2)));
    EXPECT_TRUE(core::markAt(set, key(5, kWrist, 0)));
    EXPECT_TRUE(core::markAt(set, key(5, kIndex, 0, "bob")));
    EXPECT_EQ(set.notes.at(5), "hers");
    EXPECT_EQ(set.notes.at(7), "new");
}

TEST_F(ImportEdit, AddMarksOnlyViewsWithoutAMark) {
    const AnnotationSet set = after(ImportMode::Add);
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 1))->px.x(), 11);
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 2))->px.x(), 52);
    EXPECT_EQ(set.notes.at(5), "hers");
}

TEST_F(ImportEdit, ALaterFileOfTheSamePersonMayHoldMoreViews) {
    m_file = {};
    m_file.marks[key(6, kIndex, 0)] = m_set.marks[key(6, kIndex, 0)];
    m_file.marks[key(6, kIndex, 1)] = m_set.marks[key(6, kIndex, 1)];
    m_file.marks[key(6, kIndex, 2)] = Mark{{12, 20}};
    EXPECT_TRUE(core::importConflicts(m_set, m_file).empty());
    EXPECT_EQ(after(ImportMode::Keep).marks.size(), 5u);
}

TEST_F(ImportEdit, ProposalsNeverReplaceSettledMarksAndAreReplacedByThem) {
    m_set.marks[key(5, kWrist, 0)] = proposal(1);
    m_file = {};
    for (const int camera : {0, 1, 2})
        m_file.marks[key(5, kIndex, camera)] = proposal(7);
    m_file.marks[key(5, kWrist, 0)] = Mark{{9, 9}};
    EXPECT_TRUE(core::importConflicts(m_set, m_file).empty());
    const AnnotationSet set = after(ImportMode::Replace);
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 0))->px.x(), 10);
    EXPECT_EQ(core::markAt(set, key(5, kIndex, 2))->px.x(), 7);
    EXPECT_EQ(core::markAt(set, key(5, kWrist, 0))->px.x(), 9);
}

} // namespace
