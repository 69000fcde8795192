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

void ImportNotes::leaveOutPart(const std::string& part, const std::string& fitting) {
    ++m_parts[part];
    m_fittingPart = fitting;
}

std::vector<std::string> ImportNotes::unknownParts() const {
    std::vector<std::string> names;
    for (const auto& [part, count] : m_parts)
        names.push_back(part);
    return names;
}

std::string ImportNotes::partsText() const {
    constexpr std::size_t kMostNames = 5;
    std::size_t marks = 0, named = 0;
    std::string names;
    for (const auto& [part, count] : m_parts) {
        marks += static_cast<std::size_t>(count);
        if (named < kMostNames)
            names += (named++ > 0 ? ", " : "") + part;
    }
    if (named < m_parts.size())
        names += " and " + std::to_string(m_parts.size() - named) + " more";
    return "left out: " + std::to_string(marks) + (marks == 1 ? " mark" : " marks") +
           " of body parts that are not joints (" + names + "): a name that fits is " + m_fittingPart +
           "; --map FILE says which joint each name stands for";
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
    std::vector<std::string> texts;
    if (!m_parts.empty())
        texts.push_back(partsText());
    texts.insert(texts.end(), m_remarks.begin(), m_remarks.end());
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
