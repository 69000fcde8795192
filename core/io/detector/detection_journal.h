// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "core/detection/hand_views.h"

namespace core {

/// What was detected in the frames of a sequence so far, one line each, flushed as they come: whatever ends the
/// program, at most the frame at work is lost, and the next run of the same work goes on from there.
class DetectionJournal {
public:
    /// Opens or creates the file. `work` says what the detections are of (sequence, cameras, networks): those of other
    /// work are thrown away. A last line that was cut off is left out. Throws Error(Io).
    DetectionJournal(std::filesystem::path file, const std::string& work, std::size_t cameras);
    ~DetectionJournal();
    DetectionJournal(const DetectionJournal&) = delete;
    DetectionJournal& operator=(const DetectionJournal&) = delete;

    const std::map<int, ViewDetections>& frames() const { return m_frames; }
    /// Throws Error(Io) if the line cannot be written.
    void append(int frame, const ViewDetections& detections);
    /// The work is done: the file goes.
    void remove();

private:
    std::filesystem::path m_file;
    std::map<int, ViewDetections> m_frames;
    std::FILE* m_stream = nullptr;
};

} // namespace core
