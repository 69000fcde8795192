// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_backups.h"
#include "core/io/store/annotation_store.h"

#include <gtest/gtest.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/error.h"
#include "tests/core/io/store/store_fixture.h"
#include "tests/support/recordings/random_edits.h"

namespace {

namespace fs = std::filesystem;
using core::AnnotationSet;
using core::AnnotationStore;
using core::Edit;
using core::ErrorCode;
using core::Mark;
using core::MarkKey;
using core::StoreAccess;
using test::AnnotationStoreTest;
using test::bytesOf;
using test::errorOf;
using test::place;
using test::writeBytes;

/// What the store should hold: the plainest possible undo history.
struct Model {
    AnnotationSet set;
    std::vector<Edit> done, undone;

    void commit(const Edit& edit) {
        if (!edit.empty()) {
            core::apply(set, edit);
            done.push_back(edit);
            undone.clear();
        }
    }
    void undo() {
        if (!done.empty()) {
            core::apply(set, core::inverse(done.back()));
            undone.push_back(done.back());
            done.pop_back();
        }
    }
    void redo() {
        if (!undone.empty()) {
            core::apply(set, undone.back());
            done.push_back(undone.back());
            undone.pop_back();
        }
    }
};

std::vector<Edit> editsOf(const std::vector<core::JournalEntry>& entries) {
    std::vector<Edit> edits;
    for (const core::JournalEntry& entry : entries)
        edits.push_back(entry.edit);
    return edits;
}

void expectSame(const AnnotationStore& store, const Model& model) {
    EXPECT_EQ(store.annotations(), model.set);
    const core::AnnotationHistory history = store.history();
    EXPECT_EQ(editsOf(history.done), model.done);
    EXPECT_EQ(editsOf(history.undone), model.undone);
}

TEST_F(AnnotationStoreTest, HoldsExactlyWhatAModelHoldsThroughEditsUndoRedoAndReopening) {
    test::RandomEdits random(1);
    Model model;
    auto store = AnnotationStore::open(m_file);
    for (int step = 0; step < 400; ++step) {
        const int choice = random.draw(10);
        if (choice < 5) {
            const Edit edit = random.next(model.set);
            store.commit(edit, "ann");
            model.commit(edit);
        } else if (choice < 7) {
            EXPECT_EQ(store.undo(),
                      model.done.empty() ? std::nullopt : std::optional(core::inverse(model.done.back())));
            model.undo();
        } else if (choice < 9) {
            EXPECT_EQ(store.redo(), model.undone.empty() ? std::nullopt : std::optional(model.undone.back()));
            model.redo();
        } else if (random.draw(4) == 0) {
            store = AnnotationStore::open(m_folder / "other.sqlite"); // lets go of the file
            store = AnnotationStore::open(m_file);
            ASSERT_FALSE(store.isReadOnly()) << core::readOnlyText(store.readOnlyReason());
        }
        if (step % 20 == 0)
            expectSame(store, model);
    }
    expectSame(store, model);
}

TEST_F(AnnotationStoreTest, AllTheWayBackAndForthVisitsTheSameStatesAfterReopening) {
    test::RandomEdits random(2);
    std::vector<AnnotationSet> states{{}};
    {
        auto store = AnnotationStore::open(m_file);
        while (states.size() < 60) {
            const Edit edit = random.next(states.back());
            if (!edit.empty()) {
                store.commit(edit, "ann");
                states.push_back(states.back());
                core::apply(states.back(), edit);
            }
        }
    }
    auto store = AnnotationStore::open(m_file);
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        ASSERT_EQ(store.annotations(), states[i]);
        ASSERT_TRUE(store.undo());
    }
    EXPECT_FALSE(store.undo());
    for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        ASSERT_EQ(store.annotations(), states[i]);
        ASSERT_TRUE(store.redo());
    }
    EXPECT_FALSE(store.redo());
}

TEST_F(AnnotationStoreTest, AmendingJoinsTheNewestEntry) {
    auto store = AnnotationStore::open(m_file);
    const Edit first = place(3, 10);
    const MarkKey key = first.marks[0].key;
    const auto move = [&key](double from, double to) {
        return Edit{{.text = "move"}, {{key, Mark{{from, 2.5}}, Mark{{to, 2.5}}}}, {}};
    };
    store.commit(first, "ann");
    store.commit(move(10, 11), "ann");
    store.amend(move(11, 12), "ann");
    store.amend(move(12, 13), "ann");
    ASSERT_EQ(store.history().done.size(), 2u);
    EXPECT_EQ(store.history().done[1].edit, move(10, 13));
    store.amend(move(13, 10), "ann"); // back home: the step is gone
    EXPECT_EQ(store.history().done.size(), 1u);
    store.undo();
    store.amend(place(3, 7), "bob"); // nothing to join: a step of its own, and nothing to redo any more
    EXPECT_EQ(store.history().done.size(), 1u);
    EXPECT_TRUE(store.history().undone.empty());
    EXPECT_EQ(store.history().done[0].rater, "bob");
    EXPECT_EQ(store.annotations().marks.at(key).px.x(), 7);
}

TEST_F(AnnotationStoreTest, HistoryCanBeLimitedToTheNewest) {
    auto store = AnnotationStore::open(m_file);
    for (int frame = 0; frame < 10; ++frame)
        store.commit(place(frame, frame), "ann");
    for (int i = 0; i < 4; ++i)
        store.undo();
    const auto history = store.history(3);
    ASSERT_EQ(history.done.size(), 3u);
    EXPECT_EQ(history.done.back().edit, place(5, 5));
    ASSERT_EQ(history.undone.size(), 3u);
    EXPECT_EQ(history.undone.back().edit, place(6, 6)); // the next one to redo
    EXPECT_EQ(store.history(100).done.size(), 6u);
}

TEST_F(AnnotationStoreTest, EveryEntryHasRaterAndTime) {
    auto store = AnnotationStore::open(m_file);
    const std::string before = core::utcTimestamp();
    store.commit(place(1, 1), "Άννα");
    const auto entry = store.history().done.at(0);
    EXPECT_EQ(entry.rater, "Άννα");
    EXPECT_GE(entry.time, before);
    EXPECT_LE(entry.time, core::utcTimestamp());
    SQLite::Database raw(m_file.string());
    EXPECT_EQ(raw.execAndGet("SELECT author FROM mark").getString(), "Άννα");
    EXPECT_EQ(raw.execAndGet("SELECT time FROM mark").getString(), entry.time);
}

TEST_F(AnnotationStoreTest, RefusesEditsThatDoNotFitAndStaysAsItWas) {
    auto store = AnnotationStore::open(m_file);
    store.commit(place(1, 1), "ann");
    Edit wrong = place(2, 5);
    wrong.marks.push_back(place(1, 9).marks[0]); // claims that there is no mark
    EXPECT_EQ(errorOf([&] { store.commit(wrong, "ann"); }), ErrorCode::BadInput);
    EXPECT_EQ(errorOf([&] { store.commit(place(4, NAN), "ann"); }), ErrorCode::BadInput);
    EXPECT_EQ(store.annotations().marks.size(), 1u);
    EXPECT_EQ(store.history().done.size(), 1u);
    store.commit(place(2, 5), "ann");
    EXPECT_EQ(store.annotations().marks.size(), 2u);
}

TEST_F(AnnotationStoreTest, SettingsAreKept) {
    {
        auto store = AnnotationStore::open(m_file);
        EXPECT_FALSE(store.setting("joints"));
        store.setSetting("joints", "a");
        store.setSetting("joints", "wrist,index_mcp");
    }
    EXPECT_EQ(AnnotationStore::open(m_file).setting("joints"), "wrist,index_mcp");
}

TEST_F(AnnotationStoreTest, ASecondOpenerIsReadOnlyToldWhyAndSeesWhatIsWritten) {
    auto first = AnnotationStore::open(m_file);
    first.commit(place(1, 1), "ann");
    {
        auto second = AnnotationStore::open(m_file);
        EXPECT_TRUE(second.isReadOnly());
        EXPECT_NE(core::readOnlyText(second.readOnlyReason()).find("another window"), std::string::npos);
        EXPECT_NE(core::readOnlyText(second.readOnlyReason()).find("process " + std::to_string(::getpid())),
                  std::string::npos);
        EXPECT_EQ(second.annotations().marks.size(), 1u);
        EXPECT_EQ(errorOf([&] { second.commit(place(2, 2), "bob"); }), ErrorCode::Io);
        EXPECT_EQ(errorOf([&] { second.undo(); }), ErrorCode::Io);
        first.commit(place(2, 2), "ann");
        EXPECT_EQ(second.annotations().marks.size(), 2u);
    }
    first = AnnotationStore::open(m_folder / "other.sqlite");
    EXPECT_FALSE(AnnotationStore::open(m_file).isReadOnly());
}

TEST_F(AnnotationStoreTest, ReadOnlyAccessWritesNothing) {
    EXPECT_EQ(errorOf([&] { AnnotationStore::open(m_file, StoreAccess::ReadOnly); }), ErrorCode::NotFound);
    EXPECT_FALSE(fs::exists(m_folder / "annotations"));
    AnnotationStore::open(m_file).commit(place(1, 1), "ann");
    auto store = AnnotationStore::open(m_file, StoreAccess::ReadOnly);
    EXPECT_EQ(store.annotations().marks.size(), 1u);
    EXPECT_FALSE(AnnotationStore::open(m_file).isReadOnly()); // and it holds no lock
}

TEST_F(AnnotationStoreTest, RefusesDamagedFilesNamesTheBackupAndLeavesThemUntouched) {
    {
        auto store = AnnotationStore::open(m_file);
        for (int frame = 0; frame < 300; ++frame)
            store.commit(place(frame, frame), "ann");
        store.backup();
    }
    const std::string whole = bytesOf(m_file);
    {
        SQLite::Database raw(m_file.string(), SQLite::OPEN_READWRITE);
        raw.exec("PRAGMA ignore_check_constraints = ON");
        raw.exec("UPDATE mark SET placement = 'somehow' WHERE frame = 100");
    }
    const std::string value = bytesOf(m_file);
    ASSERT_GT(whole.size(), 20000u);
    std::string holes = whole, foreign = whole;
    std::fill(holes.begin() + 8192, holes.begin() + 12288, 'x');
    foreign.replace(68, 4, "ABCD");
    const std::map<std::string, std::string> cases{{"empty", ""},
                                                   {"header only", whole.substr(0, 60)},
                                                   {"half", whole.substr(0, whole.size() / 2)},
                                                   {"a page short", whole.substr(0, whole.size() - 4096)},
                                                   {"a hole", holes},
                                                   {"text", "this is text, not annotations"},
                                                   {"another program's", foreign},
                                                   {"a value", value}};
    for (const auto& [name, bytes] : cases) {
        writeBytes(m_file, bytes);
        try {
            AnnotationStore::open(m_file);
            ADD_FAILURE() << name << " was opened";
        } catch (const core::Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::BadInput) << name;
            if (name != "another program's") {
                EXPECT_NE(std::string(error.what()).find(core::backupsOf(m_file).front().string()), std::string::npos)
                    << error.what();
            }
        }
        EXPECT_TRUE(bytesOf(m_file) == bytes) << name;
    }
    fs::copy_file(core::backupsOf(m_file).front(), m_file, fs::copy_options::overwrite_existing);
    EXPECT_EQ(AnnotationStore::open(m_file).annotations().marks.size(), 300u);
}

TEST_F(AnnotationStoreTest, RefusesToStartAnewBesideTheLogOfALostFile) {
    fs::create_directories(m_file.parent_path());
    writeBytes(m_file.string() + "-wal", "a log that may hold edits");
    EXPECT_EQ(errorOf([&] { AnnotationStore::open(m_file); }), ErrorCode::BadInput);
    EXPECT_FALSE(fs::exists(m_file));
}

TEST_F(AnnotationStoreTest, WarnsWhenNoBackupCanBeMade) {
    AnnotationStore::open(m_file).commit(place(0, 0), "ann");
    const fs::path folder = m_file.parent_path() / (m_file.stem().string() + ".backups");
    fs::remove_all(folder);
    writeBytes(folder.string(), "a file in the place of the folder");
    const auto store = AnnotationStore::open(m_file);
    ASSERT_EQ(store.warnings().size(), 1u);
    EXPECT_EQ(store.warnings().front().kind, core::StoreWarning::Kind::NoBackup);
    EXPECT_NE(store.warnings().front().problem.file().find(".backups"), std::string::npos);
    EXPECT_EQ(store.annotations().marks.size(), 1u);
}

TEST_F(AnnotationStoreTest, KeepsTheTenNewestStatesAndCopiesOnlyWhatChanged) {
    for (int i = 0; i < 14; ++i) {
        auto store = AnnotationStore::open(m_file);
        EXPECT_TRUE(store.warnings().empty());
        store.commit(place(i, i), "ann");
    }
    AnnotationStore::open(m_file);
    AnnotationStore::open(m_file);
    const auto backups = core::backupsOf(m_file);
    ASSERT_EQ(backups.size(), 10u);
    EXPECT_EQ(AnnotationStore::open(backups.front(), StoreAccess::ReadOnly).annotations().marks.size(), 14u);
    EXPECT_EQ(AnnotationStore::open(backups.back(), StoreAccess::ReadOnly).annotations().marks.size(), 5u);
}

TEST_F(AnnotationStoreTest, NoticesThatTheFileWasReplacedWhileOpen) {
    auto store = AnnotationStore::open(m_file);
    store.commit(place(1, 1), "ann");
    fs::rename(m_file, m_folder / "moved.sqlite");
    EXPECT_EQ(errorOf([&] { store.commit(place(2, 2), "ann"); }), ErrorCode::Io);
    fs::rename(m_folder / "moved.sqlite", m_file);
    store.commit(place(2, 2), "ann");
    EXPECT_EQ(store.annotations().marks.size(), 2u);
}

TEST_F(AnnotationStoreTest, TellsHowFarALargeCallIs) {
    auto store = AnnotationStore::open(m_file);
    core::Edit edit = place(0, 0);
    for (int frame = 1; frame < 700; ++frame)
        edit.marks.push_back(place(frame, frame).marks.front());
    std::vector<double> shares;
    const auto told = [&](const std::function<void()>& call) {
        shares.clear();
        store.setWriteProgress([&shares](double share) { shares.push_back(share); });
        call();
        store.setWriteProgress({});
        return shares.size() > 50 && shares.size() <= 100 && shares.front() <= 0.02 && shares.back() == 1 &&
               std::is_sorted(shares.begin(), shares.end());
    };
    EXPECT_TRUE(told([&] { store.commit(edit, "ann"); }));
    EXPECT_TRUE(told([&] { store.undo(); }));
    EXPECT_TRUE(told([&] { store.redo(); }));
    shares.clear();
    store.commit(place(1000, 1), "ann");
    EXPECT_TRUE(shares.empty());
    EXPECT_EQ(store.annotations().marks.size(), 701u);
}

} // namespace
