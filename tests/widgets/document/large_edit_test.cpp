// SPDX-License-Identifier: MIT
// Edits of a hundred thousand marks: nothing waits for them, and nothing is lost or half there.
#include <algorithm>
#include <csignal>
#include <ctime>
#include <random>

#include <QSignalSpy>
#include <QTimer>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"
#include "widgets/document/annotation_document.h"

namespace {

using core::Side;
using widgets::AnnotationDocument;

constexpr int kCameras = 8, kJoints = 14;

core::MarkKey keyOf(int frame, Side side, int joint, int camera) {
    return {frame, "ann", {side, "joint" + std::to_string(joint)}, "cam" + std::to_string(camera)};
}

/// What a first pass proposes: 14 joints of both hands in eight views of every frame, with their likelihoods.
core::Edit firstPass(int frames) {
    core::Edit edit{{.kind = core::EditKind::FirstPass, .firstFrame = 0, .lastFrame = frames - 1}, {}, {}};
    for (int frame = 0; frame < frames; ++frame)
        for (const Side side : {Side::Left, Side::Right})
            for (int joint = 0; joint < kJoints; ++joint)
                for (int camera = 0; camera < kCameras; ++camera)
                    edit.marks.push_back(
                        {keyOf(frame, side, joint, camera), std::nullopt,
                         core::Mark{Eigen::Vector2d(100 + 0.37 * frame + joint, 200 + 0.11 * joint + camera),
                                    core::Placement::Proposed, core::MarkState::Visible, 0.5 + 0.001 * frame}});
    return edit;
}

class LargeEdit : public testing::Test {
protected:
    LargeEdit() {
        document.setRater("ann");
        document.open(AnnotationDocument::read(file()));
    }
    std::filesystem::path file() const { return folder / "a.sqlite"; }
    core::AnnotationSet onDisk() const {
        return core::AnnotationStore::open(file(), core::StoreAccess::ReadOnly).annotations();
    }
    bool wait() {
        return test::waitUntil([this] { return !document.isBusy(); }, 300000);
    }

    test::TemporaryFolder folder;
    AnnotationDocument document;
};

double threadSeconds() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The longest that this thread has worked between two turns of the event loop, s of its own processor time: other work
/// on the machine does not count.
class TurnClock {
public:
    TurnClock() {
        QObject::connect(&m_timer, &QTimer::timeout, [this] { look(); });
        m_timer.start(0);
    }
    void look() {
        const double now = threadSeconds();
        m_longest = std::max(m_longest, now - m_last);
        m_last = now;
        ++m_turns;
    }
    double longest() const { return m_longest; }
    int turns() const { return m_turns; }

private:
    QTimer m_timer;
    double m_last = threadSeconds(), m_longest = 0;
    int m_turns = 0;
};

TEST_F(LargeEdit, FiveHundredFramesBlockNoTurnOfTheEventLoop) {
    core::Edit edit = firstPass(500);
    ASSERT_EQ(edit.marks.size(), 112000u);
    QSignalSpy saved(&document, &AnnotationDocument::saved);
    const core::Edit copy = edit;
    {
        TurnClock clock;
        document.push(std::move(edit));
        clock.look();
        ASSERT_TRUE(wait());
        RecordProperty("longest_ms", static_cast<int>(1000 * clock.longest()));
        std::printf("taken over: the longest turn of %d took %.0f ms\n", clock.turns(), 1000 * clock.longest());
        EXPECT_GT(clock.turns(), 20);
        EXPECT_LT(clock.longest(), 0.05);
    }
    EXPECT_EQ(saved.count(), 1);
    core::AnnotationSet expected;
    core::apply(expected, copy);
    EXPECT_EQ(document.annotations(), expected);
    EXPECT_EQ(onDisk(), expected);
    EXPECT_EQ(document.undoStack()->count(), 1);
    {
        TurnClock clock;
        document.undoStack()->undo();
        clock.look();
        ASSERT_TRUE(wait());
        std::printf("taken back: the longest turn of %d took %.0f ms\n", clock.turns(), 1000 * clock.longest());
        EXPECT_LT(clock.longest(), 0.05);
    }
    EXPECT_TRUE(document.annotations().marks.empty());
    EXPECT_TRUE(onDisk().marks.empty());
    document.undoStack()->redo();
    ASSERT_TRUE(wait());
    EXPECT_EQ(document.annotations(), expected);
    EXPECT_EQ(onDisk(), expected);
}

/// From nothing to all of it, in steps that a person can see.
TEST_F(LargeEdit, SaysHowFarItIs) {
    std::vector<double> shares;
    QObject::connect(&document, &AnnotationDocument::busyProgressed, [&] {
        if (document.isBusy())
            shares.push_back(document.busyShare());
    });
    document.push(firstPass(60));
    EXPECT_LT(document.busyShare(), 0.1);
    ASSERT_TRUE(wait());
    ASSERT_GT(shares.size(), 10u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_LT(shares.front(), 0.3);
    EXPECT_GT(shares.back(), 0.7);
    EXPECT_LE(shares.back(), 1);
    const auto between =
        std::count_if(shares.begin(), shares.end(), [](double share) { return share > 0.3 && share < 0.7; });
    EXPECT_GT(between, 2);
    EXPECT_EQ(document.busyShare(), 1);
}

TEST_F(LargeEdit, ClicksMeanwhileCountAndComeAfterIt) {
    document.push(firstPass(40));
    ASSERT_TRUE(document.isApplying());
    const core::MarkKey early = keyOf(0, Side::Left, 0, 0), late = keyOf(39, Side::Right, 13, 7);
    for (const core::MarkKey& key : {early, late})
        document.push(core::placeEdit(document.annotations(), key, {7, 8}));
    document.preview(core::placeEdit(document.annotations(), keyOf(38, Side::Left, 1, 1), {1, 1}));
    document.clearPreview();
    for (const core::MarkKey& key : {early, late})
        EXPECT_EQ(core::markAt(document.annotations(), key)->px, Eigen::Vector2d(7, 8));
    ASSERT_TRUE(wait());
    core::AnnotationSet expected;
    core::apply(expected, firstPass(40));
    for (const core::MarkKey& key : {early, late})
        core::apply(expected, core::placeEdit(expected, key, {7, 8}));
    EXPECT_EQ(document.annotations(), expected);
    EXPECT_EQ(onDisk(), expected);
    QUndoStack* stack = document.undoStack();
    ASSERT_EQ(stack->count(), 3);
    stack->undo();
    EXPECT_TRUE(core::markAt(document.annotations(), late)->isProposal());
    stack->undo();
    stack->undo();
    ASSERT_TRUE(wait());
    EXPECT_TRUE(document.annotations().marks.empty());
    EXPECT_TRUE(onDisk().marks.empty());
}

TEST_F(LargeEdit, UndoAtOnceAndClosingAtOnceLeaveTheFileWhole) {
    document.push(firstPass(40));
    document.undoStack()->undo();
    document.undoStack()->redo();
    document.setSetting("order", "left");
    document.close();
    EXPECT_FALSE(document.isBusy());
    core::AnnotationSet expected;
    core::apply(expected, firstPass(40));
    EXPECT_EQ(onDisk(), expected);
    document.open(AnnotationDocument::read(file()));
    EXPECT_EQ(document.annotations(), expected);
    EXPECT_EQ(document.setting("order"), "left");
    EXPECT_EQ(document.undoStack()->index(), 1);
}

/// A process that is killed while it writes: what was in the file stays, and the large edit is there as a whole or not
/// at all, in the marks as in the history.
TEST(LargeEditCrash, AKillLeavesAllOfItOrNothing) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.sqlite";
    core::AnnotationSet before;
    const core::MarkKey clicked = keyOf(3, Side::Left, 2, 1);
    {
        auto store = core::AnnotationStore::open(file);
        const core::Edit click = core::placeEdit({}, clicked, {5, 6});
        store.commit(click, "ann");
        core::apply(before, click);
    }
    core::Edit edit = firstPass(60);
    std::erase_if(edit.marks, [&](const core::MarkChange& change) { return change.key == clicked; });
    core::AnnotationSet after = before;
    core::apply(after, edit);
    std::mt19937 random(3);
    int none = 0;
    for (int round = 0; round < 12; ++round) {
        const std::filesystem::path copy = folder / (std::to_string(round) + ".sqlite");
        std::filesystem::copy_file(file, copy);
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            auto store = core::AnnotationStore::open(copy);
            const char begins = '.';
            if (::write(ends[1], &begins, 1) == 1)
                store.commit(edit, "ann");
            ::pause();
            ::_exit(0);
        }
        char begun = 0;
        ASSERT_EQ(::read(ends[0], &begun, 1), 1);
        ::usleep(static_cast<useconds_t>(random() % 60000));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        ::close(ends[0]);
        ::close(ends[1]);
        const auto store = core::AnnotationStore::open(copy);
        const core::AnnotationSet found = store.annotations();
        const std::size_t steps = store.history().done.size();
        ASSERT_TRUE((found == before && steps == 1) || (found == after && steps == 2)) << "round " << round;
        none += found == before;
    }
    EXPECT_GT(none, 0) << "no kill came while it wrote";
}

} // namespace
