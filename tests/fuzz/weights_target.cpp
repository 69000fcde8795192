// SPDX-License-Identifier: MIT
#include <algorithm>

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
    const MemoryFile file(bytes);
    try {
        core::readPackage(
            file.path(), [](const std::string& name) { return name.size() % 2 == 0; });
    } catch (const core::Error&) {
    }
}

} // namespace fuzz
