// SPDX-License-Identifier: MIT
#include "widgets/views/private_display.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/error.h"

namespace {

using widgets::PrivateDisplay;

bool isRunning(int process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string id, program, state;
    status >> id >> program >> state;
    return status && state != "Z";
}

bool endsWithinSeconds(int process, int seconds) {
    for (int i = 0; i < 20 * seconds && isRunning(process); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return !isRunning(process);
}

/// Keeps what a display changes in the environment.
class PrivateDisplayTest : public testing::Test {
protected:
    void SetUp() override { m_display = std::getenv("DISPLAY") ? std::getenv("DISPLAY") : ""; }
    void TearDown() override { setenv("DISPLAY", m_display.c_str(), 1); }
    std::string m_display;
};

TEST_F(PrivateDisplayTest, SeveralRunAtOnceAndEndWithTheirObjects) {
    int first = 0, second = 0;
    {
        const PrivateDisplay one(640, 480);
        const PrivateDisplay two(800, 600);
        EXPECT_NE(one.name(), two.name());
        EXPECT_EQ(std::getenv("DISPLAY"), two.name());
        EXPECT_STREQ(std::getenv("QT_QPA_PLATFORM"), "xcb");
        first = one.processId();
        second = two.processId();
        EXPECT_TRUE(isRunning(first));
        EXPECT_TRUE(isRunning(second));
    }
    EXPECT_TRUE(endsWithinSeconds(first, 5));
    EXPECT_TRUE(endsWithinSeconds(second, 5));
}

TEST_F(PrivateDisplayTest, NoServerOutlivesAKilledProgram) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t program = fork();
    if (program == 0) {
        const PrivateDisplay display(640, 480);
        const int server = display.processId();
        if (write(ends[1], &server, sizeof server) != sizeof server)
            _exit(1);
        raise(SIGKILL);
    }
    int server = 0;
    ASSERT_EQ(read(ends[0], &server, sizeof server), static_cast<ssize_t>(sizeof server));
    waitpid(program, nullptr, 0);
    EXPECT_GT(server, 0);
    EXPECT_TRUE(endsWithinSeconds(server, 5));
}

TEST_F(PrivateDisplayTest, SaysWhatIsMissing) {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    try {
        const PrivateDisplay display;
        ADD_FAILURE() << "there was no Xvfb to start";
    } catch (const core::Error& error) {
        EXPECT_EQ(error.code(), core::ErrorCode::NotFound);
        EXPECT_NE(std::string(error.what()).find("install"), std::string::npos);
    }
    setenv("PATH", path.c_str(), 1);
}

} // namespace
