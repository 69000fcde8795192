// SPDX-License-Identifier: MIT
#include "core/io/video_file.h"

#include <ffms.h>

#include <array>
#include <mutex>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/text_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// FFMS2 reports errors as text in a buffer of the caller.
struct Failure {
    std::array<char, 1024> text{};
    FFMS_ErrorInfo info{FFMS_ERROR_SUCCESS, FFMS_ERROR_SUCCESS, static_cast<int>(text.size()), text.data()};
};

using IndexPointer = std::unique_ptr<FFMS_Index, decltype(&FFMS_DestroyIndex)>;
using SourcePointer = std::unique_ptr<FFMS_VideoSource, decltype(&FFMS_DestroyVideoSource)>;

void startLibrary() {
    static std::once_flag once;
    std::call_once(once, [] {
        FFMS_Init(0, 0);
        FFMS_SetLogLevel(FFMS_LOG_QUIET);
    });
}

Error noVideo(const fs::path& file, const Failure& failure) {
    return Error(ErrorCode::BadInput, file.string(), "", std::string("is no video that can be read (") + failure.text.data() + ")");
}

/// The kept index if it is there and of this very file.
IndexPointer readIndex(const fs::path& file, const fs::path& indexFile) {
    Failure failure;
    std::error_code ignored;
    IndexPointer index(nullptr, &FFMS_DestroyIndex);
    if (!indexFile.empty() && fs::exists(indexFile, ignored)) {
        index.reset(FFMS_ReadIndex(indexFile.c_str(), &failure.info));
    }
    if (index && FFMS_IndexBelongsToFile(index.get(), file.c_str(), &failure.info) != FFMS_ERROR_SUCCESS) {
        index.reset();
    }
    return index;
}

/// The index is a convenience: if it cannot be kept, the next run makes it again.
void keepIndex(FFMS_Index* index, const fs::path& indexFile) {
    Failure failure;
    std::uint8_t* bytes = nullptr;
    std::size_t size = 0;
    if (indexFile.empty() || FFMS_WriteIndexToBuffer(&bytes, &size, index, &failure.info) != FFMS_ERROR_SUCCESS) {
        return;
    }
    try {
        ensureFolder(indexFile.parent_path());
        writeFileAtomically(indexFile, {reinterpret_cast<const char*>(bytes), size});
    } catch (const Error&) { // a read-only dataset
    }
    FFMS_FreeIndexBuffer(&bytes);
}

IndexPointer makeIndex(const fs::path& file, const fs::path& indexFile) {
    Failure failure;
    FFMS_Indexer* indexer = FFMS_CreateIndexer(file.c_str(), &failure.info);
    if (indexer == nullptr) {
        throw noVideo(file, failure);
    }
    IndexPointer index(FFMS_DoIndexing2(indexer, FFMS_IEH_ABORT, &failure.info), &FFMS_DestroyIndex); // frees the indexer
    if (!index) {
        throw noVideo(file, failure);
    }
    keepIndex(index.get(), indexFile);
    return index;
}

} // namespace

struct VideoFile::Handle {
    SourcePointer source{nullptr, &FFMS_DestroyVideoSource};
};

VideoFile::VideoFile(fs::path file, const fs::path& indexFile) : m_file(std::move(file)), m_handle(std::make_unique<Handle>()) {
    std::error_code ignored;
    if (!fs::is_regular_file(m_file, ignored)) {
        throw Error(ErrorCode::NotFound, m_file.string(), "", "no such video");
    }
    startLibrary();
    IndexPointer index = readIndex(m_file, indexFile);
    if (!index) {
        index = makeIndex(m_file, indexFile);
    }
    Failure failure;
    const int track = FFMS_GetFirstTrackOfType(index.get(), FFMS_TYPE_VIDEO, &failure.info);
    if (track >= 0) {
        m_handle->source.reset(FFMS_CreateVideoSource(m_file.c_str(), track, index.get(), 1, FFMS_SEEK_NORMAL, &failure.info));
    }
    FFMS_VideoSource* source = m_handle->source.get();
    const FFMS_Frame* first = source ? FFMS_GetFrame(source, 0, &failure.info) : nullptr;
    if (first == nullptr) {
        throw noVideo(m_file, failure);
    }
    const FFMS_VideoProperties* properties = FFMS_GetVideoProperties(source);
    m_info.frames = properties->NumFrames;
    m_info.size = {first->EncodedWidth, first->EncodedHeight};
    m_info.framesPerSecond = properties->FPSDenominator > 0 ? static_cast<double>(properties->FPSNumerator) / properties->FPSDenominator : 0;
    const std::array<int, 2> formats{FFMS_GetPixFmt("bgr24"), -1};
    if (FFMS_SetOutputFormatV2(source, formats.data(), m_info.size.width, m_info.size.height, FFMS_RESIZER_BICUBIC, &failure.info) != FFMS_ERROR_SUCCESS) {
        throw noVideo(m_file, failure);
    }
}

VideoFile::~VideoFile() = default;

cv::Mat VideoFile::read(int frame) {
    if (frame < 0 || frame >= m_info.frames) {
        throw Error(ErrorCode::NotFound, m_file.string(), "frame " + std::to_string(frame), "the video has frames 0 to " + std::to_string(m_info.frames - 1));
    }
    Failure failure;
    const FFMS_Frame* picture = FFMS_GetFrame(m_handle->source.get(), frame, &failure.info);
    if (picture == nullptr) {
        throw Error(ErrorCode::BadInput, m_file.string(), "frame " + std::to_string(frame), std::string("cannot be decoded (") + failure.text.data() + ")");
    }
    // The library keeps the buffer for its next frame, so it is copied; it is only read here.
    return cv::Mat(m_info.size.height, m_info.size.width, CV_8UC3, const_cast<std::uint8_t*>(picture->Data[0]),
                   static_cast<std::size_t>(picture->Linesize[0]))
        .clone();
}

VideoInfo readVideoInfo(const fs::path& file) { return VideoFile(file, {}).info(); }

} // namespace core
