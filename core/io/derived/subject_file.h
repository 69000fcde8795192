// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/io/derived/measured_subject.h"

namespace core {

/// Writes a measurement as JSON (schema "subject"): scale, girth and every length with standard deviations, from which
/// frames they are, and the faults of the calibration. Throws Error(Io).
void writeSubjectFile(const std::filesystem::path& file, const MeasuredSubject& measured);

} // namespace core
