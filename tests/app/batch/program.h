// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace test {

/// How a program ended and what it said.
struct Ended {
    int status = -1; ///< exit status; 128 + signal if it was killed
    std::string out, err;
};

/// Runs handlens-batch with these arguments to its end.
Ended runBatch(const std::vector<std::string>& arguments);

/// Runs it, sends it `signal` as soon as `file` holds something, and waits for its end.
Ended runBatchUntil(const std::vector<std::string>& arguments, const std::filesystem::path& file, int signal);

} // namespace test
