// SPDX-License-Identifier: MIT
#include "widgets/document/annotation_document.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "tests/support/recordings/random_edits.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace widgets;

const core::MarkKey kKey{3, "ann", {core::Side::Left, "index_mcp"}, "cam0"};

class AnnotationDocumentTest : public testing::Test {
protected:
    AnnotationDocumentTest() {
        document.setRater("ann");
        reopen();
    }
    void reopen() {
        document.close();
        document.open(AnnotationDocument::read(file()));
    }
    std::filesystem::path file() const { return folder / "a.sqlite"; }
    core::AnnotationSet onDisk() const {
        return core::AnnotationStore::open(file(), core::StoreAccess::ReadOnly).annotations();
    }
    void place(double x) { document.push(core::placeEdit(document.annotations(), kKey, {x, 1})); }

    test::TemporaryFolder folder;
    AnnotationDocument document;
};

/// Every state that the document was in is met again on the way back and on the way forth, in memory and on disk.
TEST_F(AnnotationDocumentTest, UndoAndRedoVisitEveryState) {
    test::RandomEdits random(17);
    std::vector<core::AnnotationSet> states{document.annotations()};
    for (int i = 0; i < 80; ++i) {
        const core::Edit edit = random.next(document.annotations());
        if (edit.empty())
            continue;
        document.push(edit);
        states.push_back(document.annotations());
        ASSERT_EQ(onDisk(), states.back());
    }
    QUndoStack* stack = document.undoStack();
    ASSERT_EQ(stack->count(), static_cast<int>(states.size()) - 1);
    for (std::size_t i = states.size() - 1; i-- > 0;) {
        stack->undo();
        ASSERT_EQ(document.annotations(), states[i]);
        ASSERT_EQ(onDisk(), states[i]);
    }
    EXPECT_FALSE(stack->canUndo());
    for (std::size_t i = 1; i < states.size(); ++i) {
        stack->redo();
        ASSERT_EQ(document.annotations(), states[i]);
        ASSERT_EQ(onDisk(), states[i]);
    }
    EXPECT_FALSE(stack->canRedo());
}

TEST_F(AnnotationDocumentTest, HistorySurvivesReopening) {
    test::RandomEdits random(23);
    std::vector<core::AnnotationSet> states{document.annotations()};
    while (states.size() < 30) {
        const core::Edit edit = random.next(document.annotations());
        if (edit.empty())
            continue;
        document.push(edit);
        states.push_back(document.annotations());
    }
    for (int i = 0; i < 9; ++i)
        document.undoStack()->undo();
    reopen();
    ASSERT_EQ(document.annotations(), states[20]);
    ASSERT_EQ(document.undoStack()->index(), 20);
    ASSERT_EQ(document.undoStack()->count(), 29);
    for (std::size_t i = 21; i < 30; ++i) {
        document.undoStack()->redo();
        ASSERT_EQ(document.annotations(), states[i]);
    }
    for (std::size_t i = 29; i-- > 0;) {
        document.undoStack()->undo();
        ASSERT_EQ(document.annotations(), states[i]);
    }
    EXPECT_EQ(onDisk(), states.front());
}

TEST_F(AnnotationDocumentTest, PreviewIsShownButNotMade) {
    place(10);
    document.preview(core::placeEdit(document.annotations(), kKey, {20, 1}));
    document.preview(core::placeEdit(document.annotations(), kKey, {30, 1}));
    EXPECT_EQ(core::markAt(document.annotations(), kKey)->px.x(), 30);
    EXPECT_EQ(core::markAt(onDisk(), kKey)->px.x(), 10);
    EXPECT_EQ(document.undoStack()->count(), 1);
    document.clearPreview();
    EXPECT_EQ(core::markAt(document.annotations(), kKey)->px.x(), 10);
}

TEST_F(AnnotationDocumentTest, UndoDuringAPreviewEndsThePreview) {
    place(10);
    document.preview(core::placeEdit(document.annotations(), kKey, {20, 1}));
    document.undoStack()->undo();
    EXPECT_TRUE(document.annotations().marks.empty());
    EXPECT_TRUE(onDisk().marks.empty());
}

TEST_F(AnnotationDocumentTest, NudgesBecomeOneStep) {
    place(10);
    for (int i = 1; i <= 5; ++i)
        document.amend(core::placeEdit(document.annotations(), kKey, {10 + 0.25 * i, 1}), 7);
    EXPECT_EQ(document.undoStack()->count(), 2);
    EXPECT_EQ(core::markAt(onDisk(), kKey)->px.x(), 11.25);
    document.undoStack()->undo();
    EXPECT_EQ(core::markAt(document.annotations(), kKey)->px.x(), 10);
    EXPECT_EQ(core::markAt(onDisk(), kKey)->px.x(), 10);
    reopen();
    EXPECT_EQ(document.undoStack()->count(), 2);
    document.undoStack()->redo();
    EXPECT_EQ(core::markAt(document.annotations(), kKey)->px.x(), 11.25);
}

TEST_F(AnnotationDocumentTest, StepThatComesBackToItsStartVanishes) {
    place(10);
    document.amend(core::placeEdit(document.annotations(), kKey, {11, 1}), 7);
    document.amend(core::placeEdit(document.annotations(), kKey, {10, 1}), 7);
    EXPECT_EQ(document.undoStack()->count(), 1);
    reopen();
    EXPECT_EQ(document.undoStack()->count(), 1);
}

TEST_F(AnnotationDocumentTest, SecondDocumentIsReadOnlyAndSaysSo) {
    place(10);
    AnnotationDocument second;
    second.open(AnnotationDocument::read(file()));
    ASSERT_TRUE(second.isReadOnly());
    QSignalSpy refused(&second, &AnnotationDocument::refused);
    second.push(core::placeEdit(second.annotations(), kKey, {99, 1}));
    EXPECT_EQ(refused.count(), 1);
    EXPECT_EQ(core::markAt(second.annotations(), kKey)->px.x(), 10);
    EXPECT_EQ(second.undoStack()->index(), 1);
    EXPECT_EQ(core::markAt(onDisk(), kKey)->px.x(), 10);
}

TEST_F(AnnotationDocumentTest, UndoTextSaysWhatItUndoes) {
    place(10);
    EXPECT_EQ(document.undoStack()->undoText(), QStringLiteral("place left index_mcp in cam0"));
    place(12);
    EXPECT_EQ(document.undoStack()->undoText(), QStringLiteral("move left index_mcp in cam0"));
    document.push(core::stateEdit(document.annotations(), kKey, core::MarkState::Occluded));
    EXPECT_EQ(document.undoStack()->undoText(), QStringLiteral("mark left index_mcp as occluded in cam0"));
    document.push(core::removeEdit(document.annotations(), kKey));
    EXPECT_EQ(document.undoStack()->undoText(), QStringLiteral("delete left index_mcp in cam0"));
    document.push(core::noteEdit(document.annotations(), 5, "blurred"));
    EXPECT_EQ(document.undoStack()->undoText(), QStringLiteral("note on frame 5"));
    EXPECT_EQ(document.lastEditedFrame(), 5);
}

TEST_F(AnnotationDocumentTest, SettingsAreKept) {
    document.setSetting("joints", "left index_mcp");
    reopen();
    EXPECT_EQ(document.setting("joints"), "left index_mcp");
    EXPECT_EQ(document.setting("cameras"), std::nullopt);
}

} // namespace
