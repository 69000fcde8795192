// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include <zlib.h>

#include "core/error.h"
#include "core/io/detector/flat_buffer.h"
#include "core/io/detector/package_archive.h"
#include "core/io/detector/tflite_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/memory_file.h"

namespace fuzz {

namespace {

/// Follows every field of a table; what cannot be a table says so.
void walk(const core::FlatTable& table, int depth) {
    constexpr int kFields = 8, kDepth = 3;
    constexpr std::size_t kSiblings = 3;
    const auto attempt = [](const auto& read) {
        try {
            read();
        } catch (const core::Error&) {
        }
    };
    for (int field = 0; field < kFields; ++field) {
        attempt([&] { table.integer(field); });
        attempt([&] { table.byte(field); });
        attempt([&] { table.bytes(field); });
        attempt([&] { table.integers(field); });
        if (depth == kDepth)
            continue;
        attempt([&] { walk(table.table(field), depth + 1); });
        attempt([&] {
            const std::vector<core::FlatTable> tables = table.tables(field);
            for (std::size_t i = 0; i < std::min(tables.size(), kSiblings); ++i)
                walk(tables[i], depth + 1);
        });
    }
}

/// As gzip packs it: a damaged sum would hide what is in the archive.
std::string packed(std::string_view bytes) {
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    std::string result(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    deflate(&stream, Z_FINISH);
    result.resize(stream.total_out);
    deflateEnd(&stream);
    return result;
}

} // namespace

void readNetwork(std::string_view bytes) {
    try {
        core::parseTflite(bytes, "network.tflite");
    } catch (const core::Error&) {
    }
}

void readFlatBuffer(std::string_view bytes) {
    const std::string name = "buffer";
    try {
        walk(core::FlatTable(bytes, name), 0);
    } catch (const core::Error&) {
    }
}

void readArchive(std::string_view bytes) {
    const MemoryFile file(bytes.starts_with("\x1f\x8b") ? std::string(bytes) : packed(bytes));
    try {
        core::readPackage(
            file.path(), [](const std::string& name) { return name.size() % 2 == 0; });
    } catch (const core::Error&) {
    }
}

} // namespace fuzz
