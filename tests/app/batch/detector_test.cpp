// SPDX-License-Identifier: MIT
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/app/batch/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::Ended;
using test::runBatch;

/// A user's data folder in which nothing is installed.
class BatchDetector : public testing::Test {
protected:
    BatchDetector() {
        ::setenv("XDG_DATA_HOME", m_folder.path().c_str(), 1);
        test::writeSmallDataset(m_set);
    }
    ~BatchDetector() override { ::unsetenv("XDG_DATA_HOME"); }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set", m_out = m_folder / "auto.json";
};

TEST_F(BatchDetector, IsMissedInOneLineThatSaysHowToGetIt) {
    const Ended ended = runBatch({"autolabel", m_set, "--sequence", "first", "--out", m_out});
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("npm pack @mediapipe/hands"), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1);
    EXPECT_FALSE(std::filesystem::exists(m_out));
    EXPECT_FALSE(std::filesystem::exists(m_out + ".progress"));
}

TEST_F(BatchDetector, NamesAPackageThatIsNotThere) {
    const Ended ended = runBatch({"detector", "install", m_folder / "hands.tgz"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("hands.tgz: no such file"), std::string::npos) << ended.err;
    EXPECT_EQ(runBatch({"detector"}).status, 2);
}

TEST_F(BatchDetector, RefusesFramesThatAreNoRange) {
    for (const std::string range : {"1:2:3:4", "a:b", "0:10:0", "-1:4", "900000:"}) {
        const Ended ended = runBatch({"autolabel", m_set, "--sequence", "first", "--frames=" + range, "--out", m_out});
        EXPECT_EQ(ended.status, 2) << range;
        EXPECT_NE(ended.err.find("--frames"), std::string::npos) << ended.err;
    }
}

} // namespace
