// SPDX-License-Identifier: MIT
#include "core/io/detector/package_text.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"

namespace core {

namespace {

using nlohmann::json;

/// The list of packed files that the script's last line hands to loadPackage(...).
json packedFiles(std::string_view script, const std::string& file) {
    constexpr std::string_view kCall = "loadPackage({";
    const std::size_t begin = script.rfind(kCall), end = script.find("})", begin);
    if (begin == std::string_view::npos || end == std::string_view::npos)
        throw Error(ErrorCode::BadInput, file, "loadPackage", "the list of packed files is missing");
    const std::size_t first = begin + kCall.size() - 1;
    const json list = parseJson(script.substr(first, end + 1 - first), file);
    if (!list.contains("files") || !list["files"].is_array())
        throw Error(ErrorCode::BadInput, file, "files", "the list of packed files is missing");
    return list["files"];
}

std::size_t offsetOf(const json& entry, const char* field, const std::string& file) {
    if (!entry.contains(field) || !entry[field].is_number_unsigned())
        throw Error(ErrorCode::BadInput, file, std::string("files.") + field, "an offset is expected");
    return entry[field].get<std::size_t>();
}

} // namespace

PackedRange packedRange(std::string_view script, const std::string& file, const std::string& wanted, std::size_t size,
                        const std::string& packedInto) {
    for (const json& entry : packedFiles(script, file)) {
        if (!entry.is_object() || !entry.contains("filename") || !entry["filename"].is_string() ||
            std::filesystem::path(entry["filename"].get<std::string>()).filename() != wanted)
            continue;
        const PackedRange range{offsetOf(entry, "start", file), offsetOf(entry, "end", file)};
        if (range.begin > range.end || range.end > size)
            throw Error(ErrorCode::BadInput, file, "files.end",
                        wanted + " lies outside " + packedInto + " (bytes " + std::to_string(range.begin) + " to " +
                            std::to_string(range.end) + " of " + std::to_string(size) + ")");
        return range;
    }
    throw Error(ErrorCode::NotFound, file, "files", wanted + " is not among the packed files");
}

std::string packageTitle(std::string_view manifest, const std::string& file) {
    const json value = parseJson(manifest, file);
    const auto text = [&](const char* field) {
        return value.is_object() && value.contains(field) && value[field].is_string() ? value[field].get<std::string>()
                                                                                      : std::string("?");
    };
    return text("name") + " " + text("version");
}

} // namespace core
