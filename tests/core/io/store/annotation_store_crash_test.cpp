// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_store.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "tests/support/recordings/random_edits.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using core::AnnotationSet;
using core::AnnotationStore;
using core::Edit;

/// A history and the next step of a writer, both drawn from a seed: the writer and its judge make the same ones.
class Script {
public:
    Script(unsigned seed, AnnotationSet set, core::AnnotationHistory history)
        : m_random(seed)
        , m_set(std::move(set)) {
        for (const auto& entry : history.done)
            m_done.push_back(entry.edit);
        for (const auto& entry : history.undone)
            m_undone.push_back(entry.edit);
    }

    /// Makes one step here and, if given, in the store.
    void step(AnnotationStore* store) {
        const int choice = m_random.draw(8);
        if (choice == 0 && !m_done.empty()) {
            core::apply(m_set, core::inverse(m_done.back()));
            m_undone.push_back(m_done.back());
            m_done.pop_back();
            if (store)
                store->undo();
        } else if (choice == 1 && !m_undone.empty()) {
            core::apply(m_set, m_undone.back());
            m_done.push_back(m_undone.back());
            m_undone.pop_back();
            if (store)
                store->redo();
        } else {
            const Edit edit = m_random.next(m_set);
            if (edit.empty())
                return;
            core::apply(m_set, edit);
            m_done.push_back(edit);
            m_undone.clear();
            if (store)
                store->commit(edit, "ann");
        }
    }

    bool agrees(const AnnotationStore& store) const {
        const auto history = store.history();
        const auto same = [](const std::vector<core::JournalEntry>& a, const std::vector<Edit>& b) {
            return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                              [](const auto& entry, const Edit& edit) { return entry.edit == edit; });
        };
        return store.annotations() == m_set && same(history.done, m_done) && same(history.undone, m_undone);
    }

private:
    test::RandomEdits m_random;
    AnnotationSet m_set;
    std::vector<Edit> m_done, m_undone;
};

/// Edits without end and says so on the pipe after each; never returns.
[[noreturn]] void writeUntilKilled(const fs::path& file, unsigned seed, int pipe) {
    auto store = AnnotationStore::open(file);
    Script script(seed, store.annotations(), store.history());
    for (;;) {
        script.step(&store);
        const char acknowledged = '.';
        if (::write(pipe, &acknowledged, 1) != 1)
            ::_exit(1);
    }
}

int drain(int pipe) {
    int count = 0;
    char buffer[256];
    for (ssize_t n; (n = ::read(pipe, buffer, sizeof buffer)) > 0;)
        count += static_cast<int>(n);
    return count;
}

TEST(AnnotationStoreCrash, AKillAtAnyMomentLosesNothingThatWasAcknowledged) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "01.sqlite";
    std::mt19937 random(7);
    int landedInFlight = 0, acknowledgedInAll = 0;
    for (unsigned round = 0; round < 200; ++round) {
        AnnotationSet set;
        core::AnnotationHistory history;
        {
            auto store = AnnotationStore::open(file);
            ASSERT_FALSE(store.isReadOnly());
            set = store.annotations();
            history = store.history();
        }
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            ::close(ends[0]);
            writeUntilKilled(file, round, ends[1]);
        }
        ::close(ends[1]);
        const bool isSlow = acknowledgedInAll < 2 * static_cast<int>(round);       // a busy machine, or sanitizers
        ::usleep(static_cast<useconds_t>(random() % (isSlow ? 160'000 : 40'000))); // also while it opens the file
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const int acknowledged = drain(ends[0]);
        ::close(ends[0]);
        acknowledgedInAll += acknowledged;

        Script judge(round, set, history);
        for (int i = 0; i < acknowledged; ++i)
            judge.step(nullptr);
        const auto store = AnnotationStore::open(file);
        ASSERT_FALSE(store.isReadOnly()) << core::readOnlyText(store.readOnlyReason());
        if (!judge.agrees(store)) {
            judge.step(nullptr); // the edit in flight may have been written but not yet acknowledged
            ++landedInFlight;
            ASSERT_TRUE(judge.agrees(store)) << "round " << round << ", after " << acknowledged << " edits";
        }
    }
    RecordProperty("acknowledged", acknowledgedInAll);
    RecordProperty("landed_in_flight", landedInFlight);
    EXPECT_GT(acknowledgedInAll, 200);
}

/// Runs `work` in a child, so that limits and identities of this process stay; its exit status.
template <typename Work>
int inChild(Work&& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        int status = 99;
        try {
            status = work();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "child: %s\n", error.what());
        }
        ::_exit(status);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

Edit place(int frame) {
    return {{.text = "place"},
            {{core::MarkKey{frame, "ann", {core::Side::Left, "wrist"}, "cam0"}, std::nullopt, core::Mark{{1, 2}}}},
            {}};
}

TEST(AnnotationStoreCrash, AFullDiskIsReportedAndLosesNoEdit) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "01.sqlite";
    const int status = inChild([&] {
        auto store = AnnotationStore::open(file);
        for (int frame = 0; frame < 50; ++frame)
            store.commit(place(frame), "ann");
        ::signal(SIGXFSZ, SIG_IGN);
        rlimit limit{};
        ::getrlimit(RLIMIT_FSIZE, &limit);
        const rlim_t before = limit.rlim_cur;
        limit.rlim_cur = fs::file_size(file.string() + "-wal");
        ::setrlimit(RLIMIT_FSIZE, &limit);
        int written = 50;
        try {
            for (; written < 2000; ++written)
                store.commit(place(written), "ann");
            return 1; // no error
        } catch (const core::Error& error) {
            if (error.code() != core::ErrorCode::Io)
                return 2;
        }
        if (static_cast<int>(store.annotations().marks.size()) != written ||
            static_cast<int>(store.history().done.size()) != written)
            return 3;
        limit.rlim_cur = before; // room again: the same edit goes through
        ::setrlimit(RLIMIT_FSIZE, &limit);
        store.commit(place(written), "ann");
        return static_cast<int>(store.annotations().marks.size()) == written + 1 ? 0 : 4;
    });
    EXPECT_EQ(status, 0);
    EXPECT_GE(AnnotationStore::open(file).annotations().marks.size(), 51u);
}

/// As a user who may not write there; root may write everywhere.
template <typename Work>
int asUserWithoutRights(Work&& work) {
    return inChild([&] {
        if (::geteuid() == 0 && (::setegid(65534) != 0 || ::seteuid(65534) != 0))
            return 77;
        return work();
    });
}

TEST(AnnotationStoreCrash, AReadOnlyFolderIsReadAndSaidToBeReadOnly) {
    const test::TemporaryFolder folder;
    const fs::path place01 = folder / "annotations";
    const fs::path file = place01 / "01.sqlite";
    fs::permissions(folder.path(), fs::perms::all);
    // A writer that was killed leaves its log behind: the reader must see what is in there too.
    ASSERT_EQ(inChild([&] {
                  auto store = AnnotationStore::open(file);
                  store.commit(place(1), "ann");
                  ::kill(::getpid(), SIGKILL);
                  return 0;
              }),
              -SIGKILL);
    const auto allow = [&](fs::perms perms) { fs::permissions(place01, perms); };
    const auto readOnly = fs::perms::owner_read | fs::perms::owner_exec | fs::perms::group_read |
                          fs::perms::group_exec | fs::perms::others_read | fs::perms::others_exec;
    const auto look = [&](std::size_t expectedMarks) {
        return asUserWithoutRights([&] {
            auto store = AnnotationStore::open(file);
            if (!store.isReadOnly() || core::readOnlyText(store.readOnlyReason()) != "the folder is read-only") {
                return 1;
            }
            if (store.annotations().marks.size() != expectedMarks) {
                return 2;
            }
            try {
                store.commit(place(5), "ann");
                return 3;
            } catch (const core::Error& error) {
                return error.code() == core::ErrorCode::Io ? 0 : 4;
            }
        });
    };
    allow(readOnly);
    ASSERT_GT(fs::file_size(file.string() + "-wal"), 0u);
    EXPECT_EQ(look(1), 0);
    allow(fs::perms::all);
    AnnotationStore::open(file).commit(place(2), "ann"); // closed: no log any more
    allow(readOnly);
    EXPECT_EQ(look(2), 0);
    const int status = asUserWithoutRights([&] {
        try {
            AnnotationStore::open(place01 / "new.sqlite");
            return 1;
        } catch (const core::Error& error) {
            return error.code() == core::ErrorCode::Io ? 0 : 2;
        }
    });
    EXPECT_EQ(status, 0);
    allow(fs::perms::all);
}

} // namespace
