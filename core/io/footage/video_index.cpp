// SPDX-License-Identifier: MIT
#include "core/io/footage/video_index.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/content_hash.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr char kMagic[] = "handlens-video-index-1\n";

/// Appends plain values to a text of bytes (of this machine's order: an index stays on it, or is made anew).
class Writer {
public:
    template <typename Value>
    void put(const Value& value) {
        static_assert(std::is_arithmetic_v<Value>);
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <typename Value>
    void put(const std::vector<Value>& values) {
        put(static_cast<std::uint64_t>(values.size()));
        for (const Value& value : values)
            put(value);
    }
    void put(const VideoPacket& packet) {
        put(packet.pts), put(packet.dts), put(packet.position), put(packet.size), put(packet.hash), put(packet.isKey),
            put(packet.picture);
    }
    const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes = kMagic;
};

/// Reads what Writer wrote. After a value that is not there everything is zero and `isWhole` is false.
class Reader {
public:
    explicit Reader(const std::string& bytes)
        : m_bytes(bytes) {}

    template <typename Value>
    void get(Value& value) {
        static_assert(std::is_arithmetic_v<Value>);
        if (m_at + sizeof value > m_bytes.size()) {
            m_isWhole = false;
            return;
        }
        std::memcpy(&value, m_bytes.data() + m_at, sizeof value);
        m_at += sizeof value;
    }
    void get(bool& value) {
        std::uint8_t byte = 0;
        get(byte);
        value = byte != 0;
        m_isWhole = m_isWhole && byte <= 1;
    }
    /// Grows as values come: a wrong count takes no memory.
    template <typename Value>
    void get(std::vector<Value>& values) {
        std::uint64_t count = 0;
        get(count);
        for (; count > 0 && m_isWhole; --count)
            get(values.emplace_back());
    }
    void get(VideoPacket& packet) {
        get(packet.pts), get(packet.dts), get(packet.position), get(packet.size), get(packet.hash), get(packet.isKey),
            get(packet.picture);
    }
    bool isWhole() const { return m_isWhole && m_at == m_bytes.size(); }

private:
    const std::string& m_bytes;
    std::size_t m_at = std::strlen(kMagic);
    bool m_isWhole = true;
};

template <typename Stream, typename Index>
void visit(Stream&& visitField, Index& index) {
    visitField(index.fileSize), visitField(index.fileTime), visitField(index.size.width), visitField(index.size.height);
    visitField(index.framesPerSecond), visitField(index.rotationDegrees), visitField(index.isCounted);
    visitField(index.packets), visitField(index.packetOfPicture), visitField(index.timesSec);
}

/// Pictures and packets name each other, or are not told apart at all.
bool isConsistent(const VideoIndex& index) {
    const int packets = static_cast<int>(index.packets.size());
    for (int picture = 0; picture < index.pictures(); ++picture) {
        const int packet = index.packetOfPicture[static_cast<std::size_t>(picture)];
        if (packet < 0 || packet >= packets ||
            (index.isCounted ? packet != 0 : index.packets[static_cast<std::size_t>(packet)].picture != picture))
            return false;
    }
    return std::all_of(index.packets.begin(), index.packets.end(), [&](const VideoPacket& packet) {
        return packet.picture >= -1 && packet.picture < index.pictures();
    });
}

/// None earlier than the one before.
bool areTimes(const std::vector<double>& timesSec) {
    for (std::size_t i = 0; i < timesSec.size(); ++i)
        if (!std::isfinite(timesSec[i]) || (i > 0 && timesSec[i] < timesSec[i - 1]))
            return false;
    return true;
}

/// What indexing can yield: the index lies in the dataset's folder, and may come from a stranger.
bool isSound(const VideoIndex& index) {
    constexpr std::size_t kMost = INT_MAX;
    constexpr int kLongest = 1 << 20; ///< pixels
    return !index.packets.empty() && index.packets.size() < kMost && !index.packetOfPicture.empty() &&
           index.packetOfPicture.size() < kMost && index.size.width > 0 && index.size.width < kLongest &&
           index.size.height > 0 && index.size.height < kLongest && std::isfinite(index.framesPerSecond) &&
           index.framesPerSecond >= 0 && index.rotationDegrees >= 0 && index.rotationDegrees < 360 &&
           index.rotationDegrees % 90 == 0 && isConsistent(index) &&
           (index.timesSec.empty() || index.timesSec.size() == index.packetOfPicture.size()) &&
           areTimes(index.timesSec);
}

} // namespace

int VideoIndex::startFor(int picture, int before) const {
    if (isCounted)
        return 0;
    for (int p = std::min(packetOfPicture[static_cast<std::size_t>(picture)], before); p > 0; --p) {
        const VideoPacket& packet = packets[static_cast<std::size_t>(p)];
        // A picture shown before the key picture leans on the group before it.
        if (packet.isKey && packet.picture >= 0 && packet.picture <= picture)
            return p;
    }
    return 0;
}

FileStamp stampOf(const fs::path& file) {
    std::error_code ignored;
    return {fs::file_size(file, ignored),
            static_cast<std::int64_t>(fs::last_write_time(file, ignored).time_since_epoch().count())};
}

std::optional<VideoIndex> readVideoIndex(const fs::path& indexFile, const fs::path& video) {
    constexpr std::uintmax_t kMostBytes = 1 << 30; // of a video of months
    std::error_code missing;
    if (const std::uintmax_t size = fs::file_size(indexFile, missing); missing || size > kMostBytes)
        return std::nullopt;
    std::ifstream stream(indexFile, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    std::uint64_t hash = 0;
    if (!bytes.starts_with(kMagic) || bytes.size() < std::strlen(kMagic) + sizeof hash)
        return std::nullopt;
    std::memcpy(&hash, bytes.data() + bytes.size() - sizeof hash, sizeof hash);
    bytes.resize(bytes.size() - sizeof hash);
    if (hash != contentHash(bytes.data(), bytes.size()))
        return std::nullopt;
    VideoIndex index;
    Reader reader(bytes);
    visit([&](auto& field) { reader.get(field); }, index);
    const FileStamp stamp = stampOf(video);
    if (!reader.isWhole() || !isSound(index) || index.fileSize != stamp.size || index.fileTime != stamp.time)
        return std::nullopt;
    return index;
}

void keepVideoIndex(const VideoIndex& index, const fs::path& indexFile) {
    Writer writer;
    visit([&](const auto& field) { writer.put(field); }, index);
    writer.put(contentHash(writer.bytes().data(), writer.bytes().size()));
    try {
        ensureFolder(indexFile.parent_path());
        writeFileAtomically(indexFile, writer.bytes());
    } catch (const Error&) { // a dataset that cannot be written: the next run makes the index again
    }
}

} // namespace core
