// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/io/dataset/measured_footage.h"

namespace core {

/// What a person should know about the footage of a sequence: lost frames, missing pictures, other lengths and rates.
/// The same for a new sequence and for one that is read again. `measured` by camera.
std::vector<FootageNote> footageNotes(const Sequence& sequence, const std::map<std::string, MeasuredFootage>& measured);

} // namespace core
