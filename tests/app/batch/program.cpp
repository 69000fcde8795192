// SPDX-License-Identifier: MIT
#include "tests/app/batch/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace test {

Ended runBatch(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    std::vector<std::string> words{HANDLENS_BATCH};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    const std::string out = folder / "out", err = folder / "err";
    const pid_t child = ::fork();
    if (child == 0) {
        const bool isRedirected = std::freopen(out.c_str(), "w", stdout) != nullptr && std::freopen(err.c_str(), "w", stderr) != nullptr;
        if (isRedirected) {
            ::execv(argv[0], argv.data());
        }
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readText(out), readText(err)};
}

} // namespace test
