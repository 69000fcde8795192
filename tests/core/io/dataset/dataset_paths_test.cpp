// SPDX-License-Identifier: MIT
#include "core/io/dataset/dataset_paths.h"

#include <gtest/gtest.h>

#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_check.h"
#include "core/io/dataset/new_sequence.h"
#include "core/io/store/annotation_store.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;

/// The small dataset in set/; whatever a test does, nothing may come into being outside of it.
class WrittenPaths : public testing::Test {
protected:
    WrittenPaths() {
        test::writeSmallDataset(m_set);
        fs::create_directories(m_outside);
    }
    ~WrittenPaths() override { EXPECT_TRUE(fs::is_empty(m_outside)); }

    /// Reading (and checking) the dataset with one text of dataset.json replaced fails, naming the file and the field.
    void expectRefused(const std::string& what, const std::string& by, const std::string& field) {
        SCOPED_TRACE(by);
        const fs::path file = m_set / "dataset.json";
        const std::string text = test::readText(file);
        test::writeText(file, test::replaced(text, what, by));
        test::expectError([&] { core::readDataset(m_set); }, BadInput, "dataset.json", field);
        const std::vector<core::CheckFinding> findings = core::checkPath(m_set);
        EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const auto& finding) { return !finding.isNote; }));
        test::writeText(file, text);
    }

    test::TemporaryFolder m_folder;
    fs::path m_set = m_folder / "set", m_outside = m_folder / "outside";
};

TEST_F(WrittenPaths, OfADatasetStayInItsFolder) {
    const std::string out = (m_outside / "x").string();
    for (const std::string& path : {std::string("../outside/x"), std::string("a/../../outside/x"), out}) {
        expectRefused("\"annotations/first.sqlite\"", "\"" + path + ".sqlite\"", "sequences[0].annotations");
        expectRefused("\"motion/first.json\"", "\"" + path + ".json\"", "sequences[0].motion");
        expectRefused("\"hands/right.json\"", "\"" + path + ".json\"", "hands[1].file");
        expectRefused("\"cameras.json\"", "\"" + path + ".json\"", "cameras");
    }
    expectRefused("\"name\": \"first\"", "\"name\": \"../first\"", "sequences[0].name");
    EXPECT_EQ(core::readDataset(m_set).sequences.size(), 2u);
}

TEST_F(WrittenPaths, DoNotLeaveThroughLinks) {
    const core::Dataset dataset = core::readDataset(m_set);
    fs::remove_all(m_set / "annotations");
    fs::create_directory_symlink(m_outside, m_set / "annotations");
    test::expectError([&] { core::readDataset(m_set); }, BadInput, "dataset.json: sequences[0].annotations",
                      "symbolic link");
    test::expectError([&] { core::annotationFile(dataset, dataset.sequences[0]); }, BadInput, "dataset.json",
                      "annotations");
    test::expectError([&] { core::annotationFile(dataset, dataset.sequences[1]); }, BadInput, "dataset.json",
                      "annotations");
    fs::remove(m_set / "annotations");
    fs::create_directory(m_set / "annotations");
    for (const char* name : {"first.sqlite", "first.sqlite-wal", ".first.sqlite.lock", "first.backups"}) {
        SCOPED_TRACE(name);
        fs::create_symlink(m_outside / "not-there-yet", m_set / "annotations" / name);
        test::expectError([&] { core::readDataset(m_set); }, BadInput, "dataset.json", "symbolic link");
        test::expectError([&] { core::annotationFile(dataset, dataset.sequences[0]); }, BadInput, "dataset.json",
                          "symbolic link");
        fs::remove(m_set / "annotations" / name);
    }
    core::AnnotationStore::open(core::annotationFile(core::readDataset(m_set), dataset.sequences[0]));
    EXPECT_TRUE(fs::exists(m_set / "annotations/first.sqlite"));
}

TEST_F(WrittenPaths, OfTheCacheAndTheDatasetFileStayInside) {
    core::Dataset dataset = core::readDataset(m_set);
    EXPECT_EQ(core::cacheFile(m_set, "a.index"), m_set / ".cache/a.index");
    fs::create_directory_symlink(m_outside, m_set / ".cache");
    EXPECT_TRUE(core::cacheFile(m_set, "a.index").empty());
    fs::rename(m_set / "dataset.json", m_folder / "elsewhere.json");
    fs::create_symlink(m_folder / "elsewhere.json", m_set / "dataset.json");
    const std::string before = test::readText(m_folder / "elsewhere.json");
    dataset.name = "other";
    test::expectError([&] { core::rewriteDatasetFile(dataset); }, BadInput, "dataset.json", "symbolic link");
    EXPECT_EQ(test::readText(m_folder / "elsewhere.json"), before);
}

TEST_F(WrittenPaths, AreCheckedBeforeADatasetIsWritten) {
    test::SmallDataset small = test::smallDataset();
    small.dataset.handFiles[0] = "../outside/left.json";
    test::expectError([&] { core::writeDataset(small.dataset, small.motions, m_folder / "new"); }, BadInput,
                      "dataset.json", "hands[0].file");
    small = test::smallDataset();
    small.dataset.sequences[0].motion = (m_outside / "m.json").string();
    test::expectError([&] { core::writeDataset(small.dataset, small.motions, m_folder / "new"); }, BadInput,
                      "dataset.json", "sequences[0].motion");
    EXPECT_FALSE(fs::exists(m_folder / "new"));
}

TEST_F(WrittenPaths, MayBeReachedThroughALinkToTheWholeDataset) {
    fs::create_directory_symlink(m_set, m_folder / "link");
    const core::Dataset dataset = core::readDataset(m_folder / "link");
    EXPECT_EQ(core::annotationFile(dataset, dataset.sequences[0]), m_folder / "link/annotations/first.sqlite");
}

TEST(PathFromDataset, LeadsThereWhateverLinksAreBetween) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "disk/deep/set");
    fs::create_directories(folder / "footage");
    test::writeText(folder / "footage/a.mp4", "a");
    fs::create_directory_symlink(folder / "disk/deep/set", folder / "set");
    EXPECT_EQ(core::pathFromDataset(folder / "disk", folder / "footage/a.mp4"), "../footage/a.mp4");
    EXPECT_EQ(core::pathFromDataset(folder / "disk", folder / "disk/in/b_{frame}.png"), "in/b_{frame}.png");
    EXPECT_EQ(test::readText(folder / "set" / core::pathFromDataset(folder / "set", folder / "footage/a.mp4")), "a");
}

} // namespace
