// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_journal.h"

#include <array>
#include <chrono>
#include <ctime>

namespace core {

std::string utcTimestamp() {
    const auto now = std::chrono::system_clock::now();
    const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    std::array<char, 40> text{};
    const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &utc);
    const std::string fraction = std::to_string(1000 + ms).substr(1);
    return std::string(text.data(), size) + "." + fraction + "Z";
}

} // namespace core
