// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "core/detection/hand_views.h"
#include "core/labelling/frame_fitter.h"

namespace core {

/// What a journal's entries are of: those of other work are thrown away.
struct JournalWork {
    std::string detections; ///< of what the detections are: sequence, cameras, networks
    std::string fits;       ///< of what the fits are besides: frames, hands, silhouettes
};

/// What was detected and fitted in the frames of a sequence so far, one line each, flushed as they come: whatever ends
/// the program, at most the frame at work is lost, and the next run of the same work goes on from there.
class DetectionJournal {
public:
    using StepKey = std::pair<std::string, int>; ///< name of the step, frame

    /// Opens or creates the file. A last line that was cut off is left out, and so is a file of an earlier version of
    /// the program. Throws Error(Io).
    DetectionJournal(std::filesystem::path file, const JournalWork& work, std::size_t cameras);
    ~DetectionJournal();
    DetectionJournal(const DetectionJournal&) = delete;
    DetectionJournal& operator=(const DetectionJournal&) = delete;

    const std::map<int, ViewDetections>& frames() const { return m_frames; }
    const std::map<StepKey, FrameFit>& fits() const { return m_fits; }
    /// Throw Error(Io) if the line cannot be written.
    void append(int frame, const ViewDetections& detections);
    void append(const StepKey& step, const FrameFit& fit);
    /// The work is done: the file goes.
    void remove();

private:
    void write(const std::string& line);

    std::filesystem::path m_file;
    std::map<int, ViewDetections> m_frames;
    std::map<StepKey, FrameFit> m_fits;
    std::FILE* m_stream = nullptr;
};

} // namespace core
