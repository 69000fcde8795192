// SPDX-License-Identifier: MIT
#include "core/io/detector/flat_buffer.h"

#include "core/error.h"

namespace core {

FlatTable::FlatTable(std::string_view bytes, const std::string& file)
    : FlatTable(bytes, &file, 0) {
    *this = FlatTable(bytes, &file, follow(0));
}

FlatTable::FlatTable(std::string_view bytes, const std::string* file, std::size_t position)
    : m_bytes(bytes)
    , m_file(file)
    , m_position(position) {
    if (position == 0)
        return;
    const std::int64_t directory = static_cast<std::int64_t>(position) - read<std::int32_t>(position);
    if (directory < 0)
        failTruncated();
    m_directory = static_cast<std::size_t>(directory);
    m_directorySize = read<std::uint16_t>(m_directory);
    if (m_directorySize > 0)
        read<std::uint8_t>(m_directory + m_directorySize - 1);
}

void FlatTable::failTruncated() const {
    throw Error(ErrorCode::BadInput, *m_file, "", "the file is truncated or damaged (an offset leads out of it)");
}

template <typename T>
T FlatTable::read(std::size_t position) const {
    if (position > m_bytes.size() || m_bytes.size() - position < sizeof(T))
        failTruncated();
    T value;
    std::memcpy(&value, m_bytes.data() + position, sizeof(T));
    return value;
}

std::size_t FlatTable::follow(std::size_t position) const {
    return position + read<std::uint32_t>(position);
}

std::size_t FlatTable::place(int field) const {
    const std::size_t entry = 4 + 2 * static_cast<std::size_t>(field);
    if (m_position == 0 || entry + 2 > m_directorySize)
        return 0;
    const std::size_t offset = read<std::uint16_t>(m_directory + entry);
    return offset == 0 ? 0 : m_position + offset;
}

int FlatTable::integer(int field, int fallback) const {
    const std::size_t at = place(field);
    return at == 0 ? fallback : read<std::int32_t>(at);
}

int FlatTable::byte(int field, int fallback) const {
    const std::size_t at = place(field);
    return at == 0 ? fallback : read<std::uint8_t>(at);
}

std::size_t FlatTable::vector(int field, std::size_t elementSize, std::size_t& count) const {
    count = 0;
    const std::size_t at = place(field);
    if (at == 0)
        return 0;
    const std::size_t begin = follow(at);
    count = read<std::uint32_t>(begin);
    if (count > (m_bytes.size() - begin - 4) / elementSize)
        failTruncated();
    return begin + 4;
}

std::size_t FlatTable::count(int field) const {
    std::size_t count = 0;
    vector(field, 1, count);
    return count;
}

std::string_view FlatTable::bytes(int field) const {
    std::size_t count = 0;
    const std::size_t begin = vector(field, 1, count);
    return m_bytes.substr(begin, count);
}

std::vector<int> FlatTable::integers(int field) const {
    std::size_t count = 0;
    const std::size_t begin = vector(field, 4, count);
    std::vector<int> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = read<std::int32_t>(begin + 4 * i);
    return values;
}

std::vector<FlatTable> FlatTable::tables(int field) const {
    std::size_t count = 0;
    const std::size_t begin = vector(field, 4, count);
    std::vector<FlatTable> list;
    for (std::size_t i = 0; i < count; ++i)
        list.push_back(FlatTable(m_bytes, m_file, follow(begin + 4 * i)));
    return list;
}

FlatTable FlatTable::table(int field) const {
    const std::size_t at = place(field);
    return FlatTable(m_bytes, m_file, at == 0 ? 0 : follow(at));
}

} // namespace core
