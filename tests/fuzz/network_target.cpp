// SPDX-License-Identifier: MIT
#include <cstdint>
#include <functional>
#include <numeric>

#include "core/detection/network.h"
#include "core/error.h"
#include "core/io/detector/tflite_file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace fuzz {

void runNetwork(std::string_view bytes) {
    constexpr std::int64_t kMostElements = 1 << 18; // larger networks only take longer
    try {
        const core::NetworkGraph graph = core::parseTflite(bytes, "network.tflite");
        std::int64_t all = 0;
        for (const core::NetworkTensor& tensor : graph.tensors)
            all += std::accumulate(tensor.shape.begin(), tensor.shape.end(), std::int64_t(1), std::multiplies<>());
        if (all > kMostElements)
            return;
        core::Network(graph, "network.tflite");
    } catch (const core::Error&) {
    }
}

} // namespace fuzz
