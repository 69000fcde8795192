// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QString>

#include "core/io/derived/measured_subject.h"

namespace widgets {

/// "01: 17 annotated frames, masks"
QString subjectSourceText(const std::string& sequence, int annotatedFrames, bool hasMasks);
/// What was measured and what it rests on, one statement a line: units that were found, frames, outlines, and per hand
/// scale and girth.
QString subjectResultText(const core::MeasuredSubject& measured);

} // namespace widgets
