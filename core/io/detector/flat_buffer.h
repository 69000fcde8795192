// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// A table of a FlatBuffers file (TensorFlow Lite's container). Every access is checked against the end of the file;
/// throws Error(BadInput) naming file and field. Fields are numbered as in the schema; those that the file leaves out
/// have the given default. Refers to the bytes, which must outlive it.
class FlatTable {
public:
    /// The root table.
    FlatTable(std::string_view bytes, const std::string& file);

    int integer(int field, int fallback = 0) const; ///< 32 bits
    int byte(int field, int fallback = 0) const;    ///< 8 bits, unsigned
    /// Raw bytes, whole numbers, a text, tables; empty where left out.
    std::string_view bytes(int field) const;
    std::vector<int> integers(int field) const;
    std::vector<FlatTable> tables(int field) const;
    /// How many elements a list has: in memory, tables take ten times the room that they take in the file.
    std::size_t count(int field) const;
    bool has(int field) const { return place(field) != 0; }
    /// One table; an empty one (every field is left out) where it is left out.
    FlatTable table(int field) const;

private:
    FlatTable(std::string_view bytes, const std::string* file, std::size_t position);
    template <typename T>
    T read(std::size_t position) const;
    std::size_t place(int field) const; ///< of a field's value; 0 if it is left out
    std::size_t follow(std::size_t position) const;
    /// Where a vector's elements begin; its bytes lie within the file.
    std::size_t vector(int field, std::size_t elementSize, std::size_t& count) const;
    [[noreturn]] void failTruncated() const;

    std::string_view m_bytes;
    const std::string* m_file;
    std::size_t m_position = 0;  ///< 0: an empty table
    std::size_t m_directory = 0; ///< the table of fields
    std::size_t m_directorySize = 0;
};

} // namespace core
