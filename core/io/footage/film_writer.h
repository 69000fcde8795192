// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include <opencv2/core/mat.hpp>

namespace core {

/// Writes pictures as a film: MP4 (H.264 where the system has an encoder, else MPEG-4) or AVI (Motion JPEG), by the
/// path's suffix. It is written beside and renamed by finish(); without that, nothing is left.
class FilmWriter {
public:
    /// Throws Error(Usage) for another suffix.
    FilmWriter(std::filesystem::path path, double framesPerSecond);
    ~FilmWriter();
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    /// BGR, 8 bit. The first picture decides the film's size, its sides rounded down to even numbers; others are
    /// brought to it. Throws Error(Io) if nothing can be written there, Error(Unsupported) if there is no encoder.
    void add(const cv::Mat& picture);
    /// Throws Error(Io). A film without pictures is an Error(Usage).
    void finish();

private:
    struct Stream;
    void open(cv::Size size);
    std::filesystem::path beside() const;

    std::filesystem::path m_path;
    double m_framesPerSecond;
    std::unique_ptr<Stream> m_stream;
};

} // namespace core
