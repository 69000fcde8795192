// SPDX-License-Identifier: MIT
#include "core/io/formats/import_notes.h"

#include <algorithm>

namespace core {

bool ImportNotes::acceptsFrame(int frame) {
    if (frame >= 0 && frame < m_sequence.frameCount)
        return true;
    leaveOut("frames that sequence " + m_sequence.name + " does not have (0 to " +
             std::to_string(m_sequence.frameCount - 1) + ")");
    return false;
}

bool ImportNotes::acceptsCamera(const std::string& camera) {
    if (m_dataset.cameraIndex(camera) >= 0)
        return true;
    leaveOut("marks in camera \"" + camera + "\", which the dataset does not have");
    return false;
}

void ImportNotes::leaveOut(const std::string& what) {
    ++m_left[what];
}

void ImportNotes::leaveOutVideo(const std::string& video) {
    ++m_videos[video];
}

void ImportNotes::remark(const std::string& what) {
    if (std::find(m_remarks.begin(), m_remarks.end(), what) == m_remarks.end())
        m_remarks.push_back(what);
}

std::vector<std::string> ImportNotes::otherVideos() const {
    std::vector<std::string> names;
    for (const auto& [video, count] : m_videos)
        names.push_back(video);
    return names;
}

std::vector<std::string> ImportNotes::warnings() const {
    std::vector<std::string> texts = m_remarks;
    if (!m_videos.empty()) {
        int rows = 0;
        std::string names;
        for (const auto& [video, count] : m_videos) {
            rows += count;
            names += (names.empty() ? "" : ", ") + video;
        }
        texts.push_back(std::to_string(rows) + (rows == 1 ? " row" : " rows") + " of other videos left out: " + names +
                        "; choose a video with --video");
    }
    for (const auto& [what, count] : m_left)
        texts.push_back("left out: " + what + " (" + std::to_string(count) + " times)");
    return texts;
}

} // namespace core
