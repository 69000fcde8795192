// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/labelling/label_pass.h"
#include "core/labelling/proposal_review.h"

namespace widgets {

/// Why a frame deserves a look, such as "L ring_tip: bone 18 % longer than usual".
QString doubtReasonText(const core::ProposedFrame& frame);

/// What the first pass does, for a progress line: "First pass, tracking: 3 of 20".
QString firstPassStageText(core::PassStage stage, int done, int total);

/// How far a review has come and what error is to be expected of the frames that are left, or why that is not known.
QString reviewProgressText(const core::ReviewProgress& progress, int reviewed);

} // namespace widgets
