// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/io/files/file_lock.h"
#include "core/io/footage/video_index.h"

namespace core {

/// By how much small pictures are smaller than whole ones; sides are rounded up.
inline constexpr int kGlanceShrink = 4;

/// Small pictures of a video, by frame, as JPEG: for looking only. They are kept in a file between runs, each from the
/// moment it is written; in memory where there is no such file, it cannot be written or another program has it.
class SmallPictures {
public:
    /// `file` may be empty or not there yet. One that is of another video than `video`, of another size or damaged is
    /// begun anew; one that breaks off is used up to there. `size`: of the small pictures.
    SmallPictures(std::filesystem::path file, const FileStamp& video, cv::Size size);
    ~SmallPictures();
    SmallPictures(const SmallPictures&) = delete;
    SmallPictures& operator=(const SmallPictures&) = delete;

    /// How many bytes may be taken in memory, or of the disk.
    void setBudget(std::int64_t inMemory, std::int64_t onDisk);
    bool has(int frame) const { return m_places.contains(frame); }
    /// CV_8UC3 BGR; empty if it is not kept.
    cv::Mat find(int frame);
    /// Nothing happens if it is kept already. Beyond the budget, pictures far from `focus` go.
    void keep(int frame, const cv::Mat& bgr, int focus);
    /// Whether keeping that frame would not cost any that are as near to `focus`.
    bool hasRoomFor(int frame, int focus) const;

private:
    using Bytes = std::vector<unsigned char>;
    struct Place {
        std::int64_t offset = 0; ///< of the record in the file
        std::uint32_t size = 0;  ///< bytes of the record
        Bytes record{};          ///< in memory
    };

    void open(const FileStamp& video);
    void readPlaces();
    bool isInFile() const { return m_descriptor >= 0; }
    std::int64_t budget() const { return isInFile() ? m_diskBudget : m_memoryBudget; }
    void leaveFile();
    Bytes recordAt(const Place& place) const;
    void append(int frame, Bytes record);
    void makeRoom(int focus);
    void replaceFile();

    std::filesystem::path m_file;
    cv::Size m_size;
    Bytes m_header;
    FileLock m_lock;
    int m_descriptor = -1; ///< of the file
    std::int64_t m_end = 0;
    std::map<int, Place> m_places;
    std::int64_t m_bytes = 0, m_memoryBudget = 0, m_diskBudget = 0;
};

} // namespace core
