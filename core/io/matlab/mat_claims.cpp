// SPDX-License-Identifier: MIT
#include "core/io/matlab/mat_claims.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <zlib.h>

#include "core/error.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kHeaderBytes = 128;
constexpr int kDeepest = 32;                  ///< cells within cells
constexpr std::uint64_t kMostPacking = 1100;  ///< deflate's is 1032
constexpr std::uint64_t kLongBytes = 1 << 26; ///< packed variables that are longer take seconds to unpack: not followed

/// What the format calls its types of elements and classes of arrays.
enum ElementType : std::uint32_t { kInt8 = 1, kInt32 = 5, kUint32 = 6, kMatrix = 14, kCompressed = 15 };
enum ArrayClass : std::uint32_t { kCell = 1, kStruct = 2, kObject = 3, kSparse = 5, kChar = 4, kLastNumeric = 15 };

/// The claims do not fit.
struct Damaged {};

/// Bytes of the file, or those that a part of it unpacks to, one after another.
class Bytes {
public:
    explicit Bytes(std::ifstream& file)
        : m_file(file) {}
    /// Unpacks the `packed` bytes that come next.
    Bytes(std::ifstream& file, std::uint64_t packed)
        : m_file(file)
        , m_packedLeft(packed)
        , m_isPacked(true) {
        if (inflateInit(&m_stream) != Z_OK)
            throw Damaged();
    }
    ~Bytes() {
        if (m_isPacked)
            inflateEnd(&m_stream);
    }
    Bytes(const Bytes&) = delete;
    Bytes& operator=(const Bytes&) = delete;

    void read(char* to, std::uint64_t count) {
        if (!m_isPacked) {
            if (!m_file.read(to, static_cast<std::streamsize>(count)))
                throw Damaged();
            return;
        }
        if (unpack(to, count) < count)
            throw Damaged();
    }
    void skip(std::uint64_t count) {
        if (!m_isPacked) {
            m_file.seekg(static_cast<std::streamoff>(count), std::ios::cur);
            return;
        }
        std::array<char, 1 << 14> unused;
        for (std::uint64_t part = 0; count > 0; count -= part) {
            part = std::min<std::uint64_t>(count, unused.size());
            if (unpack(unused.data(), part) < part)
                return; // matio packs texts that are 8 bytes shorter than it says
        }
    }
    /// Unpacks what is left, so that its checksum is looked at.
    void drain() {
        std::array<char, 1 << 14> unused;
        while (m_isPacked && unpack(unused.data(), unused.size()) == unused.size()) {
        }
    }

private:
    std::uint64_t unpack(char* to, std::uint64_t count) {
        m_stream.next_out = reinterpret_cast<Bytef*>(to);
        m_stream.avail_out = static_cast<uInt>(count);
        while (m_stream.avail_out > 0 && !m_isAtEnd) {
            if (m_stream.avail_in == 0 && m_packedLeft > 0) {
                const std::uint64_t part = std::min<std::uint64_t>(m_packedLeft, m_input.size());
                if (!m_file.read(m_input.data(), static_cast<std::streamsize>(part)))
                    throw Damaged();
                m_packedLeft -= part;
                m_stream.next_in = reinterpret_cast<Bytef*>(m_input.data());
                m_stream.avail_in = static_cast<uInt>(part);
            }
            const int state = inflate(&m_stream, Z_NO_FLUSH);
            m_isAtEnd = state == Z_STREAM_END || (state == Z_BUF_ERROR && m_packedLeft == 0 && m_stream.avail_in == 0);
            if (state != Z_OK && !m_isAtEnd)
                throw Damaged();
        }
        return count - m_stream.avail_out;
    }

    std::ifstream& m_file;
    std::uint64_t m_packedLeft = 0;
    bool m_isPacked = false, m_isAtEnd = false;
    z_stream m_stream{};
    std::array<char, 1 << 14> m_input{};
};

/// An element's type and length; short ones hold their data in the tag.
struct Tag {
    std::uint32_t type = 0;
    std::uint64_t bytes = 0;
    bool isShort = false;
    std::array<char, 4> data{};
};

/// Reads elements in the file's order of bytes; `left` is what their parent still holds.
class Elements {
public:
    Elements(Bytes& bytes, bool isSwapped)
        : m_bytes(bytes)
        , m_isSwapped(isSwapped) {}

    Tag tag(std::uint64_t& left) {
        std::array<char, 8> raw;
        take(raw.data(), raw.size(), left);
        Tag tag;
        tag.type = number(raw.data());
        tag.bytes = number(raw.data() + 4);
        if (tag.type >> 16 != 0) {
            tag.isShort = true;
            tag.bytes = tag.type >> 16;
            tag.type &= 0xFFFF;
            std::copy(raw.begin() + 4, raw.end(), tag.data.begin());
            if (tag.bytes > tag.data.size())
                throw Damaged();
        } else if (tag.bytes > left) {
            throw Damaged();
        }
        return tag;
    }
    /// The numbers of a small element, such as the dimensions.
    std::vector<std::uint32_t> numbers(std::uint32_t type, std::uint64_t& left) {
        constexpr std::uint64_t kMostBytes = 1024;
        const Tag head = tag(left);
        if (head.type != type || head.bytes > kMostBytes)
            throw Damaged();
        std::vector<char> raw(head.bytes);
        if (head.isShort)
            std::copy_n(head.data.begin(), head.bytes, raw.begin());
        else
            take(raw.data(), head.bytes, left), pass(padding(head.bytes), left);
        std::vector<std::uint32_t> values;
        for (std::size_t i = 0; i + 4 <= raw.size(); i += 4)
            values.push_back(number(raw.data() + i));
        return values;
    }
    /// Goes over what an element holds.
    void passElement(const Tag& head, std::uint64_t& left) {
        if (!head.isShort)
            pass(std::min(head.bytes + padding(head.bytes), left), left);
    }
    void pass(std::uint64_t count, std::uint64_t& left) {
        count = std::min(count, left);
        m_bytes.skip(count);
        left -= count;
    }

private:
    static std::uint64_t padding(std::uint64_t bytes) { return (8 - bytes % 8) % 8; }
    void take(char* to, std::uint64_t count, std::uint64_t& left) {
        if (count > left)
            throw Damaged();
        m_bytes.read(to, count);
        left -= count;
    }
    std::uint32_t number(const char* raw) const {
        std::uint32_t value = 0;
        for (int i = 0; i < 4; ++i)
            value |= std::uint32_t(static_cast<unsigned char>(raw[m_isSwapped ? 3 - i : i])) << (8 * i);
        return value;
    }
    Bytes& m_bytes;
    bool m_isSwapped;
};

/// Bytes of a number of that type of element, at least.
std::uint64_t widthOf(std::uint32_t type) {
    switch (type) {
    case 3:
    case 4:
    case 17: // UTF-16
        return 2;
    case kInt32:
    case kUint32:
    case 7:
    case 18: // UTF-32
        return 4;
    case 9:
    case 12:
    case 13:
        return 8;
    default:
        return 1;
    }
}

std::uint64_t countOf(const std::vector<std::uint32_t>& dims) {
    std::uint64_t count = dims.empty() ? 0 : 1;
    for (const std::uint32_t length : dims) {
        if (length != 0 && count > (std::uint64_t(1) << 40) / length)
            throw Damaged();
        count *= length;
    }
    return count;
}

void checkMatrix(Elements& elements, std::uint64_t bytes, int depth);

/// So many arrays, one after another.
void checkParts(Elements& elements, std::uint64_t count, std::uint64_t& left, int depth) {
    constexpr std::uint64_t kLeastBytes = 8, kMostLeftOut = 10000;
    if (left == 0 && count <= kMostLeftOut)
        return; // matio writes nothing for cells that are all empty
    if (count > left / kLeastBytes)
        throw Damaged();
    for (std::uint64_t i = 0; i < count; ++i) {
        const Tag head = elements.tag(left);
        if (head.type != kMatrix || head.bytes > left)
            throw Damaged();
        checkMatrix(elements, head.bytes, depth + 1);
        left -= head.bytes;
    }
}

std::uint64_t fieldCount(Elements& elements, std::uint64_t& left) {
    const auto lengths = elements.numbers(kInt32, left);
    const Tag names = elements.tag(left);
    if (names.type != kInt8 || lengths.size() != 1 || (lengths[0] == 0 && names.bytes > 0))
        throw Damaged();
    elements.passElement(names, left);
    return lengths[0] == 0 ? 0 : names.bytes / lengths[0];
}

/// What an array holds after its head.
void checkData(Elements& elements, std::uint32_t kind, std::uint64_t count, std::uint64_t& left, int depth) {
    if (kind == kCell)
        checkParts(elements, count, left, depth);
    if (kind == kObject)
        elements.passElement(elements.tag(left), left); // name of its class
    if (kind == kStruct || kind == kObject) {
        const std::uint64_t fields = fieldCount(elements, left);
        if (fields > 0 && count > left / fields)
            throw Damaged();
        checkParts(elements, fields * count, left, depth);
    }
    const bool isNumeric = kind == kChar || (kind > kSparse && kind <= kLastNumeric);
    if (!isNumeric || count == 0)
        return;
    const Tag data = elements.tag(left);
    if (count > data.bytes / widthOf(data.type))
        throw Damaged();
    elements.passElement(data, left);
}

void checkMatrix(Elements& elements, std::uint64_t bytes, int depth) {
    if (depth > kDeepest)
        throw Damaged();
    std::uint64_t left = bytes;
    if (left > 0) { // else: an empty cell
        const auto flags = elements.numbers(kUint32, left);
        if (flags.size() != 2)
            throw Damaged();
        const std::uint32_t kind = flags[0] & 0xFF;
        if (kind == 0 || kind > kLastNumeric)
            return elements.pass(left, left); // functions and the like: never read
        if (kind == kSparse && flags[1] > bytes)
            throw Damaged();
        const std::uint64_t count = countOf(elements.numbers(kInt32, left));
        const Tag name = elements.tag(left);
        if (name.type != kInt8)
            throw Damaged();
        elements.passElement(name, left);
        checkData(elements, kind, count, left, depth);
    }
    elements.pass(left, left);
}

/// One variable.
void checkVariable(std::ifstream& file, const Tag& head, bool isSwapped) {
    if (head.type == kMatrix) {
        Bytes bytes(file);
        Elements elements(bytes, isSwapped);
        checkMatrix(elements, head.bytes, 0);
    } else if (head.type == kCompressed) {
        Bytes bytes(file, head.bytes);
        Elements elements(bytes, isSwapped);
        std::uint64_t left = std::uint64_t(1) << 40;
        const Tag inner = elements.tag(left);
        if (inner.bytes / kMostPacking > head.bytes)
            throw Damaged();
        if (head.bytes > kLongBytes)
            return;
        if (inner.type == kMatrix)
            checkMatrix(elements, inner.bytes, 0);
        bytes.drain();
    } else {
        throw Damaged();
    }
}

} // namespace

void checkMatClaims(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::array<char, kHeaderBytes> header{};
    stream.read(header.data(), header.size());
    const bool isSwapped = header[126] == 'M' && header[127] == 'I';
    std::error_code ignored;
    const std::uint64_t size = fs::file_size(file, ignored);
    std::uint64_t at = kHeaderBytes;
    for (int variable = 1; at + 8 <= size; ++variable) {
        try {
            stream.clear();
            stream.seekg(static_cast<std::streamoff>(at));
            std::uint64_t left = size - at;
            Bytes bytes(stream);
            const Tag head = Elements(bytes, isSwapped).tag(left);
            checkVariable(stream, head, isSwapped);
            at += 8 + (head.isShort ? 0 : head.bytes);
        } catch (const Damaged&) {
            throw Error(ErrorCode::BadInput, file.string(), "variable " + std::to_string(variable),
                        "is damaged: it claims more than the file holds");
        }
    }
}

} // namespace core
