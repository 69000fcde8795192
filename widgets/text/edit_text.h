// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/annotation/edit.h"

namespace widgets {

/// "left index_mcp" in the person's language (the joint's name stays as it is in the files).
QString jointText(const core::JointId& joint);
/// The same with one letter for the hand: "L index_mcp", for narrow columns.
QString shortJointText(const core::JointId& joint);
/// "left" or "right" in the person's language.
QString sideText(core::Side side);
/// What an edit does, in the person's language, as the end of "Undo ...": "move left index_mcp in cam3".
QString editText(const core::Edit& edit);

} // namespace widgets
