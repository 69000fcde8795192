// SPDX-License-Identifier: MIT
#include "core/io/footage/small_pictures.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include <opencv2/imgcodecs.hpp>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/content_hash.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMagic = "handlens-small-pictures-1\n";
constexpr int kQuality = 85; ///< of JPEG
constexpr std::uint32_t kLargest = 1 << 24;

/// What stands before the JPEG file of a picture.
struct RecordHead {
    std::uint64_t hash = 0; ///< of all that follows it
    std::int32_t frame = 0;
    std::uint32_t size = 0; ///< bytes of the JPEG file
};

template <typename Value>
void append(std::vector<unsigned char>& bytes, const Value& value) {
    const auto* begin = reinterpret_cast<const unsigned char*>(&value);
    bytes.insert(bytes.end(), begin, begin + sizeof value);
}

RecordHead headOf(const std::vector<unsigned char>& record) {
    RecordHead head;
    std::memcpy(&head, record.data(), sizeof head);
    return head;
}

std::uint64_t hashOf(const std::vector<unsigned char>& record) {
    return contentHash(record.data() + sizeof(RecordHead::hash), record.size() - sizeof(RecordHead::hash));
}

/// Head and JPEG file.
std::vector<unsigned char> recordOf(int frame, const cv::Mat& bgr) {
    std::vector<unsigned char> jpeg, record;
    cv::imencode(".jpg", bgr, jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality});
    append(record, RecordHead{0, frame, static_cast<std::uint32_t>(jpeg.size())});
    record.insert(record.end(), jpeg.begin(), jpeg.end());
    const std::uint64_t hash = hashOf(record);
    std::memcpy(record.data(), &hash, sizeof hash);
    return record;
}

/// Empty if it is damaged.
cv::Mat pictureOf(const std::vector<unsigned char>& record, int frame) {
    if (record.size() <= sizeof(RecordHead) || headOf(record).hash != hashOf(record) || headOf(record).frame != frame)
        return {};
    try {
        return cv::imdecode(std::vector<unsigned char>(record.begin() + sizeof(RecordHead), record.end()),
                            cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) { // larger than OpenCV reads
        return {};
    }
}

bool readAt(int descriptor, std::int64_t offset, void* bytes, std::size_t size) {
    return ::pread(descriptor, bytes, size, offset) == static_cast<ssize_t>(size);
}

bool writeAt(int descriptor, std::int64_t offset, const std::vector<unsigned char>& bytes) {
    return ::pwrite(descriptor, bytes.data(), bytes.size(), offset) == static_cast<ssize_t>(bytes.size());
}

} // namespace

SmallPictures::SmallPictures(fs::path file, const FileStamp& video, cv::Size size)
    : m_file(std::move(file))
    , m_size(size) {
    if (!m_file.empty())
        open(video);
}

SmallPictures::~SmallPictures() {
    if (isInFile())
        ::close(m_descriptor);
}

void SmallPictures::open(const FileStamp& video) {
    m_lock = FileLock(m_file.string() + ".lock");
    if (m_lock.state() != FileLock::State::Held)
        return;
    m_descriptor = ::open(m_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (!isInFile())
        return;
    m_header.assign(kMagic.begin(), kMagic.end());
    core::append(m_header, video.size);
    core::append(m_header, video.time);
    core::append(m_header, std::int32_t(m_size.width));
    core::append(m_header, std::int32_t(m_size.height));
    Bytes there(m_header.size());
    m_end = static_cast<std::int64_t>(m_header.size());
    if (readAt(m_descriptor, 0, there.data(), there.size()) && there == m_header)
        readPlaces();
    else if (!writeAt(m_descriptor, 0, m_header))
        leaveFile();
    if (isInFile() && ::ftruncate(m_descriptor, m_end) != 0)
        leaveFile();
}

void SmallPictures::readPlaces() {
    struct stat status {};
    if (::fstat(m_descriptor, &status) != 0)
        return;
    RecordHead head;
    while (readAt(m_descriptor, m_end, &head, sizeof head)) {
        const auto size = static_cast<std::uint32_t>(sizeof head) + head.size;
        if (head.frame < 0 || head.size == 0 || head.size > kLargest || m_end + size > status.st_size)
            return;
        m_places[head.frame] = {m_end, size, {}};
        m_bytes += size;
        m_end += size;
    }
}

/// What is kept from now on is kept in memory.
void SmallPictures::leaveFile() {
    ::close(std::exchange(m_descriptor, -1));
    m_places.clear();
    m_bytes = 0;
}

void SmallPictures::setBudget(std::int64_t inMemory, std::int64_t onDisk) {
    m_memoryBudget = inMemory;
    m_diskBudget = onDisk;
}

SmallPictures::Bytes SmallPictures::recordAt(const Place& place) const {
    if (!isInFile())
        return place.record;
    Bytes record(place.size);
    if (!readAt(m_descriptor, place.offset, record.data(), record.size()))
        record.clear();
    return record;
}

cv::Mat SmallPictures::find(int frame) {
    const auto found = m_places.find(frame);
    if (found == m_places.end())
        return {};
    const cv::Mat picture = pictureOf(recordAt(found->second), frame);
    if (picture.size() == m_size)
        return picture;
    m_places.erase(found); // damaged; its bytes stay until room is made
    return {};
}

void SmallPictures::keep(int frame, const cv::Mat& bgr, int focus) {
    if (has(frame) || budget() <= 0 || bgr.size() != m_size)
        return;
    Bytes record = recordOf(frame, bgr);
    if (m_bytes + static_cast<std::int64_t>(record.size()) > budget())
        makeRoom(focus);
    append(frame, std::move(record));
}

void SmallPictures::append(int frame, Bytes record) {
    Place place{m_end, static_cast<std::uint32_t>(record.size()), {}};
    if (!isInFile()) {
        place.record = std::move(record);
    } else if (!writeAt(m_descriptor, m_end, record)) { // the disk is full
        leaveFile();
        return;
    }
    m_end += place.size;
    m_bytes += place.size;
    m_places[frame] = std::move(place);
}

bool SmallPictures::hasRoomFor(int frame, int focus) const {
    if (10 * m_bytes < 9 * budget())
        return true;
    if (m_places.empty() || budget() <= 0)
        return false;
    const int farthest =
        std::max(std::abs(m_places.begin()->first - focus), std::abs(m_places.rbegin()->first - focus));
    return 2 * std::abs(frame - focus) < farthest;
}

/// Keeps the nearest ones, half of what may be kept: that is done seldom, since a file is written anew for it.
void SmallPictures::makeRoom(int focus) {
    std::vector<int> frames;
    for (const auto& [frame, place] : m_places)
        frames.push_back(frame);
    std::sort(frames.begin(), frames.end(), [&](int a, int b) { return std::abs(a - focus) < std::abs(b - focus); });
    std::int64_t bytes = 0;
    for (const int frame : frames)
        if ((bytes += m_places[frame].size) > budget() / 2)
            m_places.erase(frame);
    m_bytes = 0;
    for (const auto& [frame, place] : m_places)
        m_bytes += place.size;
    if (isInFile())
        replaceFile();
}

void SmallPictures::replaceFile() {
    std::string content(m_header.begin(), m_header.end());
    for (auto& [frame, place] : m_places) {
        Bytes record = recordAt(place);
        record.resize(place.size); // what cannot be read is found damaged
        place.offset = static_cast<std::int64_t>(content.size());
        content.append(record.begin(), record.end());
    }
    int replaced = -1;
    try {
        writeFileAtomically(m_file, content);
        replaced = ::open(m_file.c_str(), O_RDWR | O_CLOEXEC);
    } catch (const Error&) { // the disk is full
    }
    if (replaced < 0) {
        leaveFile();
        return;
    }
    ::close(std::exchange(m_descriptor, replaced));
    m_end = static_cast<std::int64_t>(content.size());
}

} // namespace core
