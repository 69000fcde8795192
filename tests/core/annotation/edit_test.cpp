// SPDX-License-Identifier: MIT
#include "core/annotation/edit.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/clicks.h"

namespace {

using core::AnnotationSet;
using core::Edit;
using core::Mark;
using core::MarkKey;

/// Draws keys from a small world, so that edits often meet.
class EditProperties : public testing::Test {
protected:
    int draw(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }

    MarkKey randomKey() {
        return {draw(3),
                draw(2) ? "ann" : "bob",
                {draw(2) ? core::Side::Left : core::Side::Right, draw(2) ? "wrist" : "thumb_ip"},
                "cam" + std::to_string(draw(2))};
    }
    std::optional<Mark> randomMark() {
        if (draw(3) == 0)
            return std::nullopt;
        return Mark{{draw(4) * 0.25, 1.5 * draw(4)},
                    static_cast<core::Placement>(draw(2)),
                    static_cast<core::MarkState>(draw(3))};
    }
    Edit randomEdit(const AnnotationSet& set) {
        std::map<MarkKey, std::optional<Mark>> wanted;
        for (int i = draw(5); i >= 0; --i)
            wanted[randomKey()] = randomMark();
        Edit edit{{.text = "random " + std::to_string(draw(1000))}, {}, {}};
        for (const auto& [key, mark] : wanted)
            edit.marks.push_back({key, core::markAt(set, key), mark});
        if (draw(2)) {
            const int frame = draw(3);
            const auto note = set.notes.find(frame);
            edit.notes.push_back(
                {frame, note == set.notes.end() ? "" : note->second, draw(2) ? "" : "note " + std::to_string(draw(9))});
        }
        return edit;
    }

    std::mt19937_64 m_random = test::randomFor("EditProperties");
};

TEST_F(EditProperties, InverseTakesBackExactly) {
    AnnotationSet set;
    for (int trial = 0; trial < 500; ++trial) {
        const AnnotationSet before = set;
        const Edit edit = randomEdit(set);
        core::apply(set, edit);
        AnnotationSet back = set;
        core::apply(back, core::inverse(edit));
        ASSERT_EQ(back, before);
        ASSERT_EQ(core::inverse(core::inverse(edit)), edit);
    }
}

TEST_F(EditProperties, MergedDoesBothAndUndoesBoth) {
    AnnotationSet set;
    for (int trial = 0; trial < 500; ++trial) {
        const AnnotationSet before = set;
        const Edit first = randomEdit(set);
        core::apply(set, first);
        const Edit second = randomEdit(set);
        core::apply(set, second);
        const Edit both = core::merged(first, second);
        AnnotationSet direct = before;
        core::apply(direct, both);
        ASSERT_EQ(direct, set);
        core::apply(direct, core::inverse(both));
        ASSERT_EQ(direct, before);
        ASSERT_EQ(both.description, first.description);
        ASSERT_TRUE(core::merged(first, core::inverse(first)).empty());
    }
}

TEST_F(EditProperties, UndoAllTheWayAndRedoAllTheWayVisitTheSameStates) {
    AnnotationSet set;
    std::vector<AnnotationSet> states{set};
    std::vector<Edit> edits;
    for (int i = 0; i < 100; ++i) {
        edits.push_back(randomEdit(set));
        core::apply(set, edits.back());
        states.push_back(set);
    }
    for (int i = 99; i >= 0; --i) {
        core::apply(set, core::inverse(edits[i]));
        ASSERT_EQ(set, states[i]);
    }
    for (int i = 0; i < 100; ++i) {
        core::apply(set, edits[i]);
        ASSERT_EQ(set, states[i + 1]);
    }
}

TEST(Edit, RefusesAWrongStartAndChangesNothing) {
    const MarkKey a{1, "ann", {core::Side::Left, "wrist"}, "cam0"}, b{1, "ann", {core::Side::Left, "wrist"}, "cam1"};
    AnnotationSet set;
    set.marks[b] = Mark{{5, 5}};
    const AnnotationSet before = set;
    const Edit edit{{.text = "two"}, {{a, std::nullopt, Mark{{1, 1}}}, {b, std::nullopt, Mark{{2, 2}}}}, {}};
    EXPECT_THROW(core::apply(set, edit), core::Error);
    EXPECT_EQ(set, before);
    const Edit twice{{.text = "twice"}, {{a, std::nullopt, Mark{{1, 1}}}, {a, std::nullopt, Mark{{2, 2}}}}, {}};
    EXPECT_THROW(core::apply(set, twice), core::Error);
    const Edit note{{.text = "note"}, {}, {{1, "something", ""}}};
    EXPECT_THROW(core::apply(set, note), core::Error);
    EXPECT_EQ(set, before);
    EXPECT_THROW(core::merged({{}, {{a, {}, Mark{{1, 1}}}}, {}}, {{}, {{a, Mark{{2, 2}}, {}}}, {}}), core::Error);
}

} // namespace
