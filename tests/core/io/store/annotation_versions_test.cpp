// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/error.h"
#include "core/io/store/annotation_backups.h"
#include "core/io/store/annotation_store.h"
#include "tests/core/io/store/store_fixture.h"

namespace {

using core::AnnotationStore;
using core::Edit;
using core::ErrorCode;
using core::StoreAccess;
using test::bytesOf;
using test::errorOf;
using test::place;

using AnnotationVersions = test::AnnotationStoreTest;

TEST_F(AnnotationVersions, RefusesANewerFileAndLeavesItUntouched) {
    AnnotationStore::open(m_file).commit(place(1, 1), "ann");
    SQLite::Database(m_file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 4");
    const std::string before = bytesOf(m_file);
    EXPECT_EQ(errorOf([&] { AnnotationStore::open(m_file); }), ErrorCode::Newer);
    EXPECT_EQ(errorOf([&] { AnnotationStore::open(m_file, StoreAccess::ReadOnly); }), ErrorCode::Newer);
    EXPECT_EQ(bytesOf(m_file), before);
}

void dropLikelihoods(SQLite::Database& database) {
    database.exec("ALTER TABLE mark DROP COLUMN likelihood");
    database.exec("ALTER TABLE mark_change DROP COLUMN likelihood_before");
    database.exec("ALTER TABLE mark_change DROP COLUMN likelihood_after");
}

TEST_F(AnnotationVersions, LikelihoodsAreKeptAndUndone) {
    Edit guess = place(2, 7);
    guess.marks[0].after->placement = core::Placement::Proposed;
    guess.marks[0].after->likelihood = 0.003;
    Edit click = place(2, 8);
    click.marks[0].before = guess.marks[0].after;
    AnnotationStore::open(m_file).commit(guess, "ann");
    EXPECT_EQ(core::markAt(AnnotationStore::open(m_file).annotations(), guess.marks[0].key)->likelihood, 0.003);
    AnnotationStore::open(m_file).commit(click, "ann");
    auto store = AnnotationStore::open(m_file);
    EXPECT_FALSE(core::markAt(store.annotations(), guess.marks[0].key)->likelihood);
    EXPECT_EQ(store.undo(), core::inverse(click));
    EXPECT_EQ(core::markAt(store.annotations(), guess.marks[0].key), guess.marks[0].after);
    EXPECT_TRUE(store.undo());
    EXPECT_TRUE(store.annotations().marks.empty());
}

TEST_F(AnnotationVersions, AFileOfVersionTwoIsReadAndBroughtUpToDate) {
    AnnotationStore::open(m_file).commit(place(1, 1), "ann");
    {
        SQLite::Database old(m_file.string(), SQLite::OPEN_READWRITE);
        dropLikelihoods(old);
        old.exec("PRAGMA user_version = 2");
    }
    {
        auto reading = AnnotationStore::open(m_file, StoreAccess::ReadOnly);
        EXPECT_EQ(reading.annotations().marks.size(), 1u);
        EXPECT_EQ(reading.history().done.size(), 1u);
    }
    auto store = AnnotationStore::open(m_file);
    Edit guess = place(2, 7);
    guess.marks[0].after->likelihood = 0.25;
    store.commit(guess, "ann");
    EXPECT_EQ(core::markAt(store.annotations(), guess.marks[0].key)->likelihood, 0.25);
    EXPECT_EQ(store.history().done.size(), 2u);
    SQLite::Database kept(core::backupsOf(m_file).back().string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(kept.execAndGet("PRAGMA user_version").getInt(), 2) << "as an older program can read it";
}

TEST_F(AnnotationVersions, AFileOfVersionOneIsBroughtUpToDate) {
    AnnotationStore::open(m_file).commit(place(1, 1), "ann");
    {
        SQLite::Database old(m_file.string(),
                             SQLite::OPEN_READWRITE); // as version 1 was: no proposed marks, no likelihoods
        dropLikelihoods(old);
        old.exec("PRAGMA writable_schema = ON");
        old.exec("UPDATE sqlite_master SET sql = replace(sql, ', ''proposed''', '') WHERE type = 'table'");
        old.exec("PRAGMA user_version = 1");
        old.exec("PRAGMA writable_schema = RESET");
    }
    EXPECT_EQ(AnnotationStore::open(m_file, StoreAccess::ReadOnly).annotations().marks.size(), 1u);
    Edit proposal = place(2, 7);
    proposal.marks[0].after->placement = core::Placement::Proposed;
    {
        auto store = AnnotationStore::open(m_file);
        EXPECT_FALSE(store.isReadOnly()) << core::readOnlyText(store.readOnlyReason());
        store.commit(proposal, "ann");
    }
    auto store = AnnotationStore::open(m_file);
    EXPECT_EQ(core::markAt(store.annotations(), proposal.marks[0].key)->placement, core::Placement::Proposed);
    EXPECT_EQ(store.annotations().marks.size(), 2u);
    EXPECT_TRUE(store.undo());
    EXPECT_TRUE(store.undo()) << "the history of before";
    const auto backups = core::backupsOf(m_file);
    ASSERT_FALSE(backups.empty());
    SQLite::Database kept(backups.back().string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(kept.execAndGet("PRAGMA user_version").getInt(), 1) << "as an older program can read it";
}

} // namespace
