// SPDX-License-Identifier: MIT
#include "core/detection/network.h"

#include <opencv2/dnn.hpp>

#include "core/detection/network_layers.h"
#include "core/error.h"

namespace core {

struct Network::Impl {
    cv::dnn::Net net;
    std::string file;
    cv::Size size;
    std::vector<cv::String> outputs;
};

namespace {

Error cannotRun(const std::string& file, const cv::Exception& error) {
    return {ErrorCode::BadInput, file, "", "OpenCV cannot run this network: " + error.err};
}

} // namespace

Network::Network(const NetworkGraph& graph, const std::string& file)
    : m_impl(std::make_unique<Impl>()) {
    const auto inputShape = [&] {
        return graph.inputs.size() == 1 ? graph.tensors[static_cast<std::size_t>(graph.inputs[0])].shape
                                        : std::vector<int>{};
    }();
    if (inputShape.size() != 4 || inputShape[3] != 3)
        throw Error(ErrorCode::BadInput, file, "inputs", "the network must have one input, an image of three channels");
    m_impl->file = file;
    m_impl->size = {inputShape[2], inputShape[1]};
    try {
        m_impl->outputs = addLayers(graph, m_impl->net);
        m_impl->net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
        m_impl->net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
        run(cv::Mat::zeros(m_impl->size, CV_32FC3)); // what cannot run is refused here
    } catch (const cv::Exception& error) {
        throw cannotRun(file, error);
    }
}

Network::~Network() = default;
Network::Network(Network&&) noexcept = default;
Network& Network::operator=(Network&&) noexcept = default;

std::vector<std::vector<float>> Network::run(const cv::Mat& image) {
    try {
        m_impl->net.setInput(cv::dnn::blobFromImage(image, 1, m_impl->size));
        std::vector<cv::Mat> blobs;
        m_impl->net.forward(blobs, m_impl->outputs);
        std::vector<std::vector<float>> outputs;
        for (const cv::Mat& blob : blobs)
            outputs.emplace_back(blob.ptr<float>(), blob.ptr<float>() + blob.total());
        return outputs;
    } catch (const cv::Exception& error) {
        throw cannotRun(m_impl->file, error);
    }
}

} // namespace core
