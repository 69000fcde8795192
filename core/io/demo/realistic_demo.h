// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>

#include "core/simulation/imperfection.h"

namespace core {

/// Studio: a good rig that was left alone, a hand much like the model's, quiet pictures. Casual: a rig that people walk
/// around, another hand, motion blur and noise.
enum class RealismLevel { Studio, Casual };

/// What the level's world differs in from the dataset that is written.
Imperfection imperfectionOf(RealismLevel level);

struct RealisticDemoOptions {
    RealismLevel level = RealismLevel::Casual;
    std::uint64_t seed = 1;
    int framesPerSequence = 5; ///< with pictures, masks and clicks
    int threads = 1;           ///< pictures that are drawn side by side; the result does not depend on it
};

struct RealisticDemoSummary {
    int frames = 0;
    int pictures = 0;
    int clicks = 0;
    int wrongClicks = 0;
    bool stopped = false; ///< nothing was written
};

/// Writes the demo as a real rig would have given it (simulated): pictures of another person's hands and arms, seen by
/// cameras with lenses that are not quite where cameras.json has them, before a cluttered background, blurred by motion
/// and noisy; masks that are the difference of those pictures to the empty room; clicks of the rater "sim" with noise,
/// hidden joints and 1 % wrong clicks, made and kept as the window does. What it was drawn from is the dataset
/// `folder`/truth, with the true joints in truth.json. All at once or nothing: `folder` may not exist or must be empty.
/// The same for a seed. Throws Error.
RealisticDemoSummary writeRealisticDemo(const std::filesystem::path& folder, const RealisticDemoOptions& options,
                                        const std::function<void(int finished, int total)>& progress = {},
                                        std::stop_token stop = {});

} // namespace core
