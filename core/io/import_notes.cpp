// SPDX-License-Identifier: MIT
#include "core/io/import_notes.h"

namespace core {

bool ImportNotes::acceptsFrame(int frame) {
    if (frame >= 0 && frame < m_sequence.frameCount) {
        return true;
    }
    leaveOut("frames that sequence " + m_sequence.name + " does not have (0 to " + std::to_string(m_sequence.frameCount - 1) + ")");
    return false;
}

bool ImportNotes::acceptsCamera(const std::string& camera) {
    if (m_dataset.cameraIndex(camera) >= 0) {
        return true;
    }
    leaveOut("marks in camera \"" + camera + "\", which the dataset does not have");
    return false;
}

void ImportNotes::leaveOut(const std::string& what) { ++m_left[what]; }

std::vector<std::string> ImportNotes::warnings() const {
    std::vector<std::string> texts;
    for (const auto& [what, count] : m_left) {
        texts.push_back("left out: " + what + " (" + std::to_string(count) + " times)");
    }
    return texts;
}

} // namespace core
