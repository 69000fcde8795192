// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/benchmark/benchmark_run.h"

namespace core {

/// A short text (16 hexadecimal digits) that differs if hands, cameras, motions, annotated joints or the methods'
/// revision differ: results of equal fingerprints may be brought together. Not meant against forgery.
std::string sceneFingerprint(const BenchmarkScene& scene);

} // namespace core
