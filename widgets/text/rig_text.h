// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/annotation/click_sigmas.h"
#include "core/rig/refinement_advice.h"
#include "core/rig/rig_findings.h"

namespace widgets {

/// What the clicks say of the calibration, a sentence per finding: "cam5 is 9.1 px off in every frame: its calibration
/// moved"; one for all where most cameras are off. Empty if all is well. `sequences` holds the sequences' names.
QStringList rigFindingTexts(const core::RigHealth& health, const std::vector<std::string>& sequences);
/// The first of them that says that something is wrong, for one line.
QString rigNoticeText(const core::RigHealth& health, const std::vector<std::string>& sequences);
/// How a camera stands, in a word or two: "fits", "off", "late", "drifts", "too few clicks".
QString cameraStateText(const core::CameraHealth& camera);
/// How far each rater's clicks scatter, or that 1 px is assumed, and what the calibration's error adds.
QString clickSigmaText(const core::ClickSigmas& sigmas);
/// Whether refining is worth it, and what it still needs.
QString refinementNeedsText(const core::RigHealth& health, const core::RefinementNeeds& needs);

} // namespace widgets
