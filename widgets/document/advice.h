// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/annotation/reconstruction.h"

namespace widgets {

/// A reason why there is no 3D point, in the person's language.
QString reasonText(const std::string& reason);
/// The numbers of the selected joint in one line: "left index_mcp - 3 views - 0.8 px - 0.31 mm".
QString summaryText(const core::JointId& joint, const core::JointReconstruction& found);
/// What to do next, in words: "click cam5 next (0.22 mm)".
QString adviceText(const core::JointId& joint, const core::JointReconstruction& found, int cameras);

/// The camera in which adviceText() asks for the next click; empty if it names none.
std::string advisedCamera(const core::JointReconstruction& found);

} // namespace widgets
