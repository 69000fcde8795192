// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/detection/network_graph.h"

namespace core {

/// The network of a TensorFlow Lite file (version 3, one subgraph, numbers of 32 or 16 bits), checked by checkGraph.
/// Weights of 16 bits are widened here. `file` is named in errors. Throws Error: BadInput if it is damaged, Unsupported
/// for what the hand detector's networks do not use.
NetworkGraph parseTflite(std::string_view bytes, const std::string& file);

} // namespace core
