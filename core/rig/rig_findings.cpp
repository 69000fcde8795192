// SPDX-License-Identifier: MIT
#include "core/rig/rig_findings.h"

#include <algorithm>
#include <cmath>

#include "core/text/number_text.h"

namespace core {

namespace {

/// When most cameras are off, no single one can be blamed.
void addWholeRig(std::vector<RigFinding>& findings, const RigHealth& health) {
    RigFinding whole{RigFindingKind::WholeRigOff};
    for (const CameraHealth& camera : health.cameras) {
        whole.judged += camera.isKnown;
        if (camera.isOff) {
            const double px = camera.meanPx.norm();
            whole.leastPx = whole.value == 0 ? px : std::min(whole.leastPx, px);
            whole.mostPx = std::max(whole.mostPx, px);
            ++whole.value;
        }
    }
    if (whole.value >= 2 && 2 * whole.value >= whole.judged)
        findings.push_back(whole);
}

void addOffInSequences(std::vector<RigFinding>& findings, const CameraHealth& camera, int index) {
    RigFinding off{RigFindingKind::CameraOffInSequence, index};
    for (const SequenceHealth& sequence : camera.sequences) {
        if (sequence.isOff) {
            off.sequences.push_back(sequence.sequence);
            off.value += sequence.meanPx.norm();
        }
    }
    if (camera.isOff || off.sequences.empty() || off.sequences.size() == camera.sequences.size())
        return;
    off.value /= static_cast<double>(off.sequences.size());
    findings.push_back(off);
}

void addChanges(std::vector<RigFinding>& findings, const CameraHealth& camera, int index) {
    for (const SequenceHealth& sequence : camera.sequences) {
        if (sequence.step) {
            findings.push_back({RigFindingKind::CameraMoved, index, sequence.step->changePx(), sequence.sequence,
                                sequence.step->frame});
        }
        if (sequence.isDrifting)
            findings.push_back({RigFindingKind::CameraDrifts, index, sequence.driftPx->norm(), sequence.sequence});
    }
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

/// What a finding's sentence is made with.
struct Words {
    const RigHealth& health;
    const std::vector<std::string>& sequences;

    std::string camera(const RigFinding& finding) const {
        return health.cameras[static_cast<std::size_t>(finding.camera)].camera;
    }
    std::string sequence(int index) const {
        const auto at = static_cast<std::size_t>(index);
        return at < sequences.size() ? sequences[at] : std::to_string(index);
    }
    /// " of sequence a" where there are several.
    std::string ofSequence(int index) const {
        return sequences.size() > 1 ? " of sequence " + sequence(index) : std::string();
    }
    std::string offInSequences(const RigFinding& finding) const {
        std::vector<std::string> names;
        for (const int index : finding.sequences)
            names.push_back(sequence(index));
        return camera(finding) + " is " + fixedText(finding.value, 1) + " px off in " +
               (names.size() == 1 ? "sequence " : "sequences ") + listed(names) + " only: it stood otherwise there";
    }
    std::string late(const RigFinding& finding) const {
        return camera(finding) + " is " + fixedText(std::abs(finding.value), 2) + " frames " +
               (finding.value > 0 ? "behind" : "ahead of") + " the others: its residuals go with the joints' motion";
    }
    std::string wholeRig(const RigFinding& finding) const {
        return fixedText(finding.value, 0) + " of " + std::to_string(finding.judged) + " cameras are " +
               fixedText(finding.leastPx, 1) + " to " + fixedText(finding.mostPx, 1) +
               " px off in every frame: the calibration as a whole does not fit the clicks";
    }
    std::string sentence(const RigFinding& finding) const {
        const std::string px = fixedText(finding.value, 1) + " px";
        switch (finding.kind) {
        case RigFindingKind::WholeRigOff:
            return wholeRig(finding);
        case RigFindingKind::CameraOff:
            return camera(finding) + " is " + px + " off in every frame: its calibration moved";
        case RigFindingKind::CameraOffInSequence:
            return offInSequences(finding);
        case RigFindingKind::CameraMoved:
            return camera(finding) + " moved before frame " + std::to_string(finding.frame) +
                   ofSequence(finding.sequence) + ": its picture lies " + px + " elsewhere from there on";
        case RigFindingKind::CameraDrifts:
            return camera(finding) + " drifts by " + px + " in 100 frames" + ofSequence(finding.sequence);
        case RigFindingKind::CameraLate:
            return late(finding);
        case RigFindingKind::CameraUnknown:
            break;
        }
        return camera(finding) + " (" + fixedText(finding.value, 0) + (finding.value == 1 ? " click)" : " clicks)");
    }
};

} // namespace

std::vector<RigFinding> findRigFaults(const RigHealth& health) {
    std::vector<RigFinding> findings;
    addWholeRig(findings, health);
    for (std::size_t c = 0; c < health.cameras.size(); ++c) {
        const CameraHealth& camera = health.cameras[c];
        const int index = static_cast<int>(c);
        if (camera.isOff)
            findings.push_back({RigFindingKind::CameraOff, index, camera.meanPx.norm()});
        addOffInSequences(findings, camera, index);
        addChanges(findings, camera, index);
        if (camera.isLate)
            findings.push_back({RigFindingKind::CameraLate, index, *camera.delayFrames});
    }
    for (std::size_t c = 0; c < health.cameras.size(); ++c) {
        if (health.isKnown && !health.cameras[c].isKnown) {
            findings.push_back(
                {RigFindingKind::CameraUnknown, static_cast<int>(c), static_cast<double>(health.cameras[c].clicks)});
        }
    }
    return findings;
}

bool isOffFinding(RigFindingKind kind) {
    return kind == RigFindingKind::WholeRigOff || kind == RigFindingKind::CameraOff ||
           kind == RigFindingKind::CameraOffInSequence;
}

std::vector<std::string> rigFindings(const RigHealth& health, const std::vector<std::string>& sequences) {
    const Words words{health, sequences};
    std::vector<std::string> sentences, unknown;
    const std::vector<RigFinding> findings = findRigFaults(health);
    const bool isWholeRig = !findings.empty() && findings.front().kind == RigFindingKind::WholeRigOff;
    for (const RigFinding& finding : findings)
        if (!isWholeRig || finding.kind != RigFindingKind::CameraOff) // the first sentence is about these
            (finding.kind == RigFindingKind::CameraUnknown ? unknown : sentences).push_back(words.sentence(finding));
    if (!unknown.empty())
        sentences.push_back("cannot be known of " + listed(unknown) + ": too few clicks that others confirm");
    return sentences;
}

} // namespace core
