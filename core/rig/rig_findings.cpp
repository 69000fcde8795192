// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/rig/rig_health.h"
#include "core/text/number_text.h"

namespace core {

namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

std::string offSentence(const CameraHealth& camera) {
    return camera.camera + " is " + fixedText(camera.meanPx.norm(), 1) +
           " px off in every frame: its calibration moved";
}

/// When most cameras are off, no single one can be blamed.
std::string wholeRigSentence(const std::vector<const CameraHealth*>& off, std::size_t judged) {
    double least = off.front()->meanPx.norm(), most = least;
    for (const CameraHealth* camera : off) {
        least = std::min(least, camera->meanPx.norm());
        most = std::max(most, camera->meanPx.norm());
    }
    return std::to_string(off.size()) + " of " + std::to_string(judged) + " cameras are " + fixedText(least, 1) +
           " to " + fixedText(most, 1) + " px off in every frame: the calibration as a whole does not fit the clicks";
}

void addOff(std::vector<std::string>& sentences, const RigHealth& health) {
    std::vector<const CameraHealth*> off;
    std::size_t judged = 0;
    for (const CameraHealth& camera : health.cameras) {
        judged += camera.isKnown;
        if (camera.isOff)
            off.push_back(&camera);
    }
    if (off.size() >= 2 && 2 * off.size() >= judged)
        sentences.push_back(wholeRigSentence(off, judged));
    for (const CameraHealth* camera : off)
        sentences.push_back(offSentence(*camera));
}

void addOther(std::vector<std::string>& sentences, const CameraHealth& camera) {
    if (camera.isLate) {
        sentences.push_back(camera.camera + " is " + fixedText(std::abs(*camera.delayFrames), 2) + " frames " +
                            (*camera.delayFrames > 0 ? "behind" : "ahead of") +
                            " the others: its residuals go with the joints' motion");
    }
    if (camera.isDrifting)
        sentences.push_back(camera.camera + " drifts by " + fixedText(camera.driftPx->norm(), 1) + " px in 100 frames");
}

} // namespace

std::vector<std::string> rigFindings(const RigHealth& health) {
    std::vector<std::string> sentences, unknown;
    addOff(sentences, health);
    for (const CameraHealth& camera : health.cameras) {
        addOther(sentences, camera);
        if (!camera.isKnown && health.isKnown)
            unknown.push_back(camera.camera + " (" + std::to_string(camera.clicks) +
                              (camera.clicks == 1 ? " click)" : " clicks)"));
    }
    if (!unknown.empty())
        sentences.push_back("cannot be known of " + listed(unknown) + ": too few clicks that others confirm");
    return sentences;
}

} // namespace core
