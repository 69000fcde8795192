// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/detection/network_graph.h"

namespace core {

/// A network of one image input that is ready to run (OpenCV's dnn, on the processor). Not for two threads at once:
/// each has its own.
class Network {
public:
    /// `graph` has passed checkGraph; `file` is named in errors. Throws Error(BadInput) if the network has not exactly
    /// one image input, or OpenCV cannot run it.
    Network(const NetworkGraph& graph, const std::string& file);
    ~Network();
    Network(Network&&) noexcept;
    Network& operator=(Network&&) noexcept;

    /// Outputs in the graph's order, each as one row of numbers in the order that the graph gives them (images: height
    /// x width x channels). `image`: CV_32FC3 of the input's size.
    std::vector<std::vector<float>> run(const cv::Mat& image);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace core
