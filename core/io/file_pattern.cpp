// SPDX-License-Identifier: MIT
#include "core/io/file_pattern.h"

#include <algorithm>

#include "core/io/frames.h"

namespace core {

namespace {

constexpr std::size_t kMostDigits = 9;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

} // namespace

std::optional<int> numberIn(const std::string& pattern, const std::string& name) {
    const std::size_t at = pattern.find("{frame");
    if (at == std::string::npos) {
        return pattern == name ? std::optional(-1) : std::nullopt;
    }
    if (name.compare(0, at, pattern, 0, at) != 0) {
        return std::nullopt;
    }
    std::size_t digits = 0;
    while (digits < kMostDigits && at + digits < name.size() && isDigit(name[at + digits])) {
        ++digits;
        const int number = std::stoi(name.substr(at, digits));
        if (fillPattern(pattern, "", number) == name) {
            return number;
        }
    }
    return std::nullopt;
}

std::vector<std::string> pathParts(const std::filesystem::path& path) {
    std::vector<std::string> parts;
    for (const std::filesystem::path& part : path.relative_path()) {
        if (!part.empty() && part != "." && part != "..") {
            parts.push_back(part.string());
        }
    }
    return parts;
}

std::string joinParts(const std::vector<std::string>& parts, std::size_t from) {
    std::string joined;
    for (std::size_t i = from; i < parts.size(); ++i) {
        joined += (joined.empty() ? "" : "/") + parts[i];
    }
    return joined;
}

} // namespace core
