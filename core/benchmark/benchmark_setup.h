// SPDX-License-Identifier: MIT
#pragma once

namespace core {

/// Synthetic: targets are rendered from the recorded pose of the test frame, the error is over all joints.
/// Realistic: targets come from the pictures, the error is over the annotated joints.
enum class BenchmarkSetup { Synthetic, Realistic };

} // namespace core
