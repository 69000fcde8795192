// SPDX-License-Identifier: MIT
#include "core/detection/network.h"
#include "core/error.h"
#include "core/io/detector/tflite_file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace fuzz {

void runNetwork(std::string_view bytes) {
    constexpr int kLongestSide = 64; // of the picture; larger ones only take longer
    try {
        const core::NetworkGraph graph = core::parseTflite(bytes, "network.tflite");
        for (const core::NetworkTensor& tensor : graph.tensors)
            for (const int length : tensor.shape)
                if (length > kLongestSide)
                    return;
        core::Network(graph, "network.tflite");
    } catch (const core::Error&) {
    }
}

} // namespace fuzz
