// SPDX-License-Identifier: MIT
#include "core/io/files/atomic_file.h"

#include <gtest/gtest.h>

#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

std::size_t entries(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(AtomicFile, WritesAndReplacesWithoutLeavingAnythingBeside) {
    const test::TemporaryFolder folder;
    core::writeFileAtomically(folder / "a.json", "one");
    core::writeFileAtomically(folder / "a.json", "two");
    EXPECT_EQ(test::readText(folder / "a.json"), "two");
    EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(AtomicFile, KeepsASymbolicLinkAndWritesItsTarget) {
    const test::TemporaryFolder folder;
    core::writeFileAtomically(folder / "real", "old");
    fs::create_symlink(folder / "real", folder / "link");
    core::writeFileAtomically(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(test::readText(folder / "real"), "new");
}

TEST(AtomicFile, SaysWhichFileCannotBeWritten) {
    const test::TemporaryFolder folder;
    const auto write = [](const fs::path& file) { return [file] { core::writeFileAtomically(file, "text"); }; };
    test::expectError(write(folder / "missing/a.json"), core::ErrorCode::Io, "missing/a.json", "No such file");
    fs::create_directory(folder / "sub");
    test::expectError(write(folder / "sub"), core::ErrorCode::Io, "sub", "directory");
    test::expectError(write("/proc/nothing/a.json"), core::ErrorCode::Io, "/proc/nothing/a.json", "cannot be written");
}

TEST(AtomicFile, SaysThatTheDiskIsFull) {
    if (!fs::exists("/dev/full"))
        GTEST_SKIP() << "there is no /dev/full here";
    test::expectError([] { core::writeFileAtomically("/dev/full", "text"); }, core::ErrorCode::Io, "/dev/full",
                      "No space left");
}

TEST(PendingFolder, AppearsOnlyWhenCommitted) {
    const test::TemporaryFolder folder;
    {
        core::PendingFolder pending(folder / "dataset");
        test::writeText(pending.path() / "a", "1");
        EXPECT_FALSE(fs::exists(folder / "dataset"));
        pending.commit();
    }
    EXPECT_EQ(test::readText(folder / "dataset/a"), "1");
    EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(PendingFolder, LeavesNothingBehindWithoutCommit) {
    const test::TemporaryFolder folder;
    { test::writeText(core::PendingFolder(folder / "dataset/").path() / "a", "1"); }
    EXPECT_EQ(entries(folder.path()), 0u);
}

TEST(PendingFolder, TakesAnEmptyFolderAndRefusesAFullOne) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "dataset");
    core::PendingFolder(folder / "dataset").commit();
    test::writeText(folder / "dataset/precious", "1");
    test::expectError([&] { core::PendingFolder again(folder / "dataset"); }, core::ErrorCode::Io, "dataset",
                      "not empty");
    EXPECT_EQ(test::readText(folder / "dataset/precious"), "1");
}

} // namespace
