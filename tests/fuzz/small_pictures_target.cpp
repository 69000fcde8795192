// SPDX-License-Identifier: MIT
#include <cstdint>

#include <opencv2/core.hpp>

#include "core/io/files/content_hash.h"
#include "core/io/footage/small_pictures.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/memory_file.h"

namespace fuzz {

namespace {

constexpr core::FileStamp kVideo{1000, 7};
const cv::Size kSize(64, 48);

template <typename Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A file that begins as one of that video.
std::string fileOf(std::string_view records) {
    std::string bytes = "handlens-small-pictures-1\n";
    append(bytes, kVideo.size);
    append(bytes, kVideo.time);
    append(bytes, std::int32_t(kSize.width));
    append(bytes, std::int32_t(kSize.height));
    bytes += records;
    return bytes;
}

/// One picture, with the sum that belongs to it.
std::string recordOf(int frame, std::string_view jpeg) {
    std::string content, record;
    append(content, std::int32_t(frame));
    append(content, static_cast<std::uint32_t>(jpeg.size()));
    content += jpeg;
    append(record, core::contentHash(content.data(), content.size()));
    return record + content;
}

void readAndGoOn(const std::string& bytes) {
    const MemoryFile file(bytes);
    {
        core::SmallPictures pictures(file.path(), kVideo, kSize);
        pictures.setBudget(1 << 16, 1 << 16);
        for (int frame = 0; frame < 4; ++frame)
            pictures.find(frame);
        pictures.keep(2, cv::Mat(kSize, CV_8UC3, cv::Scalar::all(7)), 2);
    }
    std::error_code ignored;
    std::filesystem::remove(file.path().string() + ".lock", ignored);
}

} // namespace

void readSmallPictures(std::string_view bytes) {
    readAndGoOn(fileOf(bytes));
    readAndGoOn(fileOf(recordOf(0, bytes) + recordOf(1, bytes.substr(bytes.size() / 2))));
}

} // namespace fuzz
