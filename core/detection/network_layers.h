// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/dnn.hpp>

#include "core/detection/network_graph.h"

namespace core {

/// Adds the layers of a graph (checkGraph has passed it) to an empty net, whose input is 1 x channels x height x width,
/// and returns the names of the outputs' layers. Outputs that are images come as 1 x height x width x channels.
std::vector<cv::String> addLayers(const NetworkGraph& graph, cv::dnn::Net& net);

} // namespace core
