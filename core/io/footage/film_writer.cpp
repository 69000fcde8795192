// SPDX-License-Identifier: MIT
#include "core/io/footage/film_writer.h"

#include <array>
#include <string>

#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "core/error.h"

namespace core {

namespace {

bool isAvi(const std::filesystem::path& path) {
    return path.extension() == ".avi";
}

} // namespace

struct FilmWriter::Stream {
    cv::VideoWriter writer;
    cv::Size size;
};

FilmWriter::FilmWriter(std::filesystem::path path, double framesPerSecond)
    : m_path(std::move(path))
    , m_framesPerSecond(framesPerSecond) {
    if (m_path.extension() != ".mp4" && !isAvi(m_path))
        throw Error(ErrorCode::Usage, m_path.string(), "", "is not the name of a film: expected .mp4 or .avi");
}

FilmWriter::~FilmWriter() {
    if (m_stream) {
        m_stream->writer.release();
        std::error_code ignored;
        std::filesystem::remove(beside(), ignored);
    }
}

std::filesystem::path FilmWriter::beside() const { // the suffix says which container
    return m_path.parent_path() / (m_path.stem().string() + ".part" + m_path.extension().string());
}

void FilmWriter::open(cv::Size size) {
    auto stream = std::make_unique<Stream>();
    stream->size = {size.width / 2 * 2, size.height / 2 * 2};
    const std::array<std::array<char, 4>, 2> inMp4{{{'a', 'v', 'c', '1'}, {'m', 'p', '4', 'v'}}};
    const std::array<std::array<char, 4>, 2> inAvi{{{'M', 'J', 'P', 'G'}, {'M', 'J', 'P', 'G'}}};
    if (!std::filesystem::is_directory(std::filesystem::absolute(m_path).parent_path()))
        throw Error(ErrorCode::Io, m_path.string(), "", "cannot be written");
    for (const auto& [a, b, c, d] : isAvi(m_path) ? inAvi : inMp4)
        if (stream->writer.open(beside().string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc(a, b, c, d),
                                m_framesPerSecond, stream->size))
            break;
    if (!stream->writer.isOpened()) {
        std::error_code ignored;
        std::filesystem::remove(beside(), ignored);
        throw Error(ErrorCode::Unsupported, m_path.string(), "",
                    "no encoder can write it here; another suffix may work");
    }
    m_stream = std::move(stream);
}

void FilmWriter::add(const cv::Mat& picture) {
    if (!m_stream)
        open(picture.size());
    cv::Mat fitting = picture;
    if (picture.size() != m_stream->size)
        cv::resize(picture, fitting, m_stream->size, 0, 0, cv::INTER_AREA);
    m_stream->writer.write(fitting);
}

void FilmWriter::finish() {
    if (!m_stream)
        throw Error(ErrorCode::Usage, m_path.string(), "", "a film needs pictures");
    m_stream->writer.release();
    std::error_code problem;
    std::filesystem::rename(beside(), m_path, problem);
    if (problem)
        throw Error(ErrorCode::Io, m_path.string(), "", "cannot be written");
    m_stream.reset();
}

} // namespace core
