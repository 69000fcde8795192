// SPDX-License-Identifier: MIT
#include "core/io/files/file_pattern.h"

#include <algorithm>
#include <cstdio>

namespace core {

namespace {

constexpr std::size_t kMostDigits = 9;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

std::string padded(int value, int width) {
    char text[32];
    std::snprintf(text, sizeof text, "%0*d", width, value);
    return text;
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

} // namespace

std::string fillPattern(const std::string& pattern, const std::string& camera, int frame) {
    std::string text = pattern;
    replaceAll(text, "{camera}", camera);
    replaceAll(text, "{frame}", std::to_string(frame));
    for (int width = 1; width <= 12; ++width) {
        replaceAll(text, "{frame:" + std::to_string(width) + "}", padded(frame, width));
        replaceAll(text, "{frame:0" + std::to_string(width) + "}", padded(frame, width));
    }
    return text;
}

std::optional<int> numberIn(const std::string& pattern, const std::string& name) {
    const std::size_t at = pattern.find("{frame");
    if (at == std::string::npos)
        return pattern == name ? std::optional(-1) : std::nullopt;
    if (name.compare(0, at, pattern, 0, at) != 0)
        return std::nullopt;
    std::size_t digits = 0;
    while (digits < kMostDigits && at + digits < name.size() && isDigit(name[at + digits])) {
        ++digits;
        const int number = std::stoi(name.substr(at, digits));
        if (fillPattern(pattern, "", number) == name)
            return number;
    }
    return std::nullopt;
}

std::vector<std::string> pathParts(const std::filesystem::path& path) {
    std::vector<std::string> parts;
    for (const std::filesystem::path& part : path.relative_path())
        if (!part.empty() && part != "." && part != "..")
            parts.push_back(part.string());
    return parts;
}

std::string joinParts(const std::vector<std::string>& parts, std::size_t from) {
    std::string joined;
    for (std::size_t i = from; i < parts.size(); ++i)
        joined += (joined.empty() ? "" : "/") + parts[i];
    return joined;
}

} // namespace core
