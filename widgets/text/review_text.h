// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/labelling/proposal_review.h"

namespace widgets {

/// Why a frame deserves a look, such as "L ring_tip: bone 18 % longer than usual".
QString doubtReasonText(const core::ProposedFrame& frame);

/// How far a review has come and what error is to be expected of the frames that are left, or why that is not known.
QString reviewProgressText(const core::ReviewProgress& progress, int reviewed);

} // namespace widgets
