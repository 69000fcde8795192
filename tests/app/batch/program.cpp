// SPDX-License-Identifier: MIT
#include "tests/app/batch/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <thread>

#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace test {

namespace {

/// In the child: becomes handlens-batch, its output in files. Does not return.
[[noreturn]] void become(const std::vector<std::string>& arguments, const std::string& out, const std::string& err) {
    std::vector<std::string> words{HANDLENS_BATCH};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    const bool isRedirected =
        std::freopen(out.c_str(), "w", stdout) != nullptr && std::freopen(err.c_str(), "w", stderr) != nullptr;
    if (isRedirected)
        ::execv(argv[0], argv.data());
    ::_exit(127);
}

/// Runs it to its end; `meanwhile` gets the process while it runs.
Ended runMeanwhile(const std::vector<std::string>& arguments, const std::function<void(pid_t)>& meanwhile) {
    const TemporaryFolder folder;
    const std::string out = folder / "out", err = folder / "err";
    const pid_t child = ::fork();
    if (child == 0)
        become(arguments, out, err);
    meanwhile(child);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readText(out), readText(err)};
}

bool holdsSomething(const std::filesystem::path& file) {
    std::error_code none;
    const auto size = std::filesystem::file_size(file, none);
    return !none && size > 0;
}

} // namespace

Ended runBatch(const std::vector<std::string>& arguments) {
    return runMeanwhile(
        arguments, [](pid_t) {});
}

Ended runBatchUntil(const std::vector<std::string>& arguments, const std::filesystem::path& file, int signal) {
    using namespace std::chrono_literals;
    return runMeanwhile(arguments, [&](pid_t child) {
        const auto end = std::chrono::steady_clock::now() + 30s;
        while (!holdsSomething(file) && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(1ms);
        ::kill(child, signal);
    });
}

} // namespace test
