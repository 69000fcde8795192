// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "core/io/detector/package_text.h"
#include "tests/fuzz/fuzz_targets.h"

namespace fuzz {

void readPackageText(std::string_view bytes) {
    constexpr std::size_t kSize = 4326731; // of what the real one packs
    try {
        const core::PackedRange range =
            core::packedRange(bytes, "loader.js", "palm_detection_full.tflite", kSize, "assets.data");
        if (range.begin > range.end || range.end > kSize)
            std::abort(); // whoever cuts this out reads beyond the end
    } catch (const core::Error&) {
    }
    try {
        core::packageTitle(bytes, "package.json");
    } catch (const core::Error&) {
    }
}

} // namespace fuzz
