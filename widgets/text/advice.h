// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/annotation/reconstruction.h"

namespace widgets {

/// A reason why there is no 3D point, in the person's language.
QString failureInWords(core::TriangulationFailure failure);
/// How many views with a picture hold a mark of the joint: "3", or "2+6" for two clicked and six accepted.
QString placedText(const core::JointReconstruction& found);
/// The same in words: "2 clicked, 6 accepted, 0 proposed; 8 views have a picture".
QString placedInWords(const core::JointReconstruction& found);
/// "9.0 px off cam0's curve".
QString curveGapText(const core::CurveGap& gap);
/// The numbers of the selected joint in one line: "left index_mcp - 3 of 8 views - 0.8 px - 0.31 mm".
QString summaryText(const core::JointId& joint, const core::JointReconstruction& found);
/// What to do next, in words: "click cam5 next (0.22 mm)".
QString adviceText(const core::JointId& joint, const core::JointReconstruction& found);

/// The camera in which adviceText() asks for the next click; empty if it names none.
std::string advisedCamera(const core::JointReconstruction& found);

} // namespace widgets
