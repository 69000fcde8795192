// SPDX-License-Identifier: MIT
#include "core/detection/network_layers.h"

#include <array>

namespace core {

namespace {

using cv::dnn::DictValue;
using cv::dnn::LayerParams;

/// Weights of a convolution, out x height x width x in, in OpenCV's order: out x in x height x width.
cv::Mat planarWeights(const NetworkTensor& weights, bool depthwise) {
    const std::vector<int>& shape = weights.shape;
    const int out = depthwise ? shape[3] : shape[0], in = depthwise ? 1 : shape[3];
    const int height = shape[1], width = shape[2];
    cv::Mat planar(std::vector<int>{out, in, height, width}, CV_32F);
    float* target = planar.ptr<float>();
    for (int o = 0; o < out; ++o)
        for (int i = 0; i < in; ++i)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const int at = depthwise ? (y * width + x) * out + o : ((o * height + y) * width + x) * in + i;
                    *target++ = weights.values[static_cast<std::size_t>(at)];
                }
    return planar;
}

cv::Mat row(const std::vector<float>& values) {
    return cv::Mat(1, static_cast<int>(values.size()), CV_32F, const_cast<float*>(values.data())).clone();
}

DictValue list(const std::vector<int>& numbers) {
    return DictValue::arrayInt(numbers.data(), static_cast<int>(numbers.size()));
}

/// Builds a net of planar images layer by layer.
class LayerBuilder {
public:
    LayerBuilder(const NetworkGraph& graph, cv::dnn::Net& net)
        : m_graph(graph)
        , m_net(net)
        , m_layerOf(graph.tensors.size(), -1) {}

    std::vector<cv::String> build() {
        m_layerOf[static_cast<std::size_t>(m_graph.inputs.at(0))] = 0;
        for (const NetworkOperator& step : m_graph.operators)
            addOperator(step);
        std::vector<cv::String> names;
        for (const int output : m_graph.outputs) {
            const int last = channelsLast(layer(output), tensor(output).shape);
            LayerParams params;
            names.push_back("output" + std::to_string(names.size()));
            const int id = m_net.addLayer(names.back(), "Identity", params);
            m_net.connect(last, 0, id, 0);
        }
        return names;
    }

private:
    const NetworkTensor& tensor(int index) const { return m_graph.tensors[static_cast<std::size_t>(index)]; }
    int layer(int index) const { return m_layerOf[static_cast<std::size_t>(index)]; }

    int add(const std::string& type, LayerParams params, const std::vector<int>& from) {
        const int id = m_net.addLayer("layer" + std::to_string(m_count++), type, params);
        for (std::size_t i = 0; i < from.size(); ++i)
            m_net.connect(from[i], 0, id, static_cast<int>(i));
        return id;
    }

    /// An image as height x width x channels; other arrays as they are.
    int channelsLast(int from, const std::vector<int>& shape) {
        if (shape.size() != 4)
            return from;
        LayerParams params;
        params.set("order", list({0, 2, 3, 1}));
        return add("Permute", params, {from});
    }

    int activated(int from, Activation activation) {
        LayerParams params;
        if (activation == Activation::Relu)
            return add("ReLU", params, {from});
        if (activation != Activation::Relu6)
            return from;
        params.set("min_value", 0.0);
        params.set("max_value", 6.0);
        return add("ReLU6", params, {from});
    }

    void addOperator(const NetworkOperator& step) {
        std::vector<int> from;
        for (const int input : step.inputs)
            if (layer(input) >= 0)
                from.push_back(layer(input));
        LayerParams params;
        const std::string type = describe(step, params, from);
        m_layerOf[static_cast<std::size_t>(step.outputs[0])] = activated(add(type, params, from), step.activation);
    }

    struct WindowPadding {
        Padding y, x;
    };
    WindowPadding windowPadding(const NetworkOperator& step, int height, int width) const {
        const std::vector<int>& in = tensor(step.inputs[0]).shape;
        return {paddingOf(step.samePadding, in[1], height, step.strideY),
                paddingOf(step.samePadding, in[2], width, step.strideX)};
    }

    static void setWindow(const NetworkOperator& step, int height, int width, const WindowPadding& padding,
                          LayerParams& params) {
        const auto& [y, x] = padding;
        params.set("kernel_h", height);
        params.set("kernel_w", width);
        params.set("stride_h", step.strideY);
        params.set("stride_w", step.strideX);
        params.set("pad_t", y.before);
        params.set("pad_b", y.after);
        params.set("pad_l", x.before);
        params.set("pad_r", x.after);
    }

    /// OpenCV's convolutions pad both ends alike; where they differ, a layer of its own pads with zeros.
    std::string convolution(const NetworkOperator& step, LayerParams& params, std::vector<int>& from) {
        const bool depthwise = step.kind == NetworkOperatorKind::DepthwiseConvolution;
        const NetworkTensor &weights = tensor(step.inputs[1]), &bias = tensor(step.inputs[2]);
        WindowPadding padding = windowPadding(step, weights.shape[1], weights.shape[2]);
        if (padding.y.before != padding.y.after || padding.x.before != padding.x.after) {
            LayerParams zeros;
            zeros.set("paddings",
                      list({0, 0, 0, 0, padding.y.before, padding.y.after, padding.x.before, padding.x.after}));
            from[0] = add("Padding", zeros, {from[0]});
            padding = {};
        }
        setWindow(step, weights.shape[1], weights.shape[2], padding, params);
        const int channels = bias.shape[0];
        params.set("num_output", channels);
        params.set("group", depthwise ? channels : 1);
        params.set("bias_term", true);
        params.blobs = {planarWeights(weights, depthwise), row(bias.values)};
        return "Convolution";
    }

    std::string fullyConnected(const NetworkOperator& step, LayerParams& params) const {
        const NetworkTensor &weights = tensor(step.inputs[1]), &bias = tensor(step.inputs[2]);
        params.set("num_output", weights.shape[0]);
        params.set("bias_term", true);
        params.set("axis", 1);
        params.blobs = {row(weights.values).reshape(1, weights.shape[0]), row(bias.values)};
        return "InnerProduct";
    }

    std::string pool(const NetworkOperator& step, LayerParams& params) const {
        const bool isMean = step.kind == NetworkOperatorKind::Mean;
        params.set("pool", isMean ? "ave" : "max");
        if (isMean)
            params.set("global_pooling", true);
        else
            setWindow(step, step.filterHeight, step.filterWidth,
                      windowPadding(step, step.filterHeight, step.filterWidth), params);
        params.set("ceil_mode", false);
        return "Pooling";
    }

    std::string reshape(const NetworkOperator& step, LayerParams& params, std::vector<int>& from) {
        from[0] = channelsLast(from[0], tensor(step.inputs[0]).shape);
        params.set("dim", list(tensor(step.outputs[0]).shape));
        return "Reshape";
    }

    /// The place of an axis of height x width x channels among planar images' axes.
    static int planarAxis(int axis, std::size_t rank) {
        constexpr std::array<int, 4> kPlanar{0, 2, 3, 1};
        const int positive = axis < 0 ? axis + static_cast<int>(rank) : axis;
        return rank == 4 ? kPlanar.at(static_cast<std::size_t>(positive)) : positive;
    }

    /// The type of an operator's layer, its parameters, and the layers that it really starts from.
    std::string describe(const NetworkOperator& step, LayerParams& params, std::vector<int>& from) {
        switch (step.kind) {
        case NetworkOperatorKind::Add:
            params.set("operation", "sum");
            return "Eltwise";
        case NetworkOperatorKind::Concatenation:
            params.set("axis", planarAxis(step.axis, tensor(step.inputs[0]).shape.size()));
            return "Concat";
        case NetworkOperatorKind::Convolution:
        case NetworkOperatorKind::DepthwiseConvolution:
            return convolution(step, params, from);
        case NetworkOperatorKind::FullyConnected:
            return fullyConnected(step, params);
        case NetworkOperatorKind::Logistic:
            return "Sigmoid";
        case NetworkOperatorKind::MaxPool:
        case NetworkOperatorKind::Mean:
            return pool(step, params);
        case NetworkOperatorKind::Pad: {
            const std::vector<int>& p = tensor(step.inputs[1]).integers; // batch, height, width, channels
            params.set("paddings", list({p[0], p[1], p[6], p[7], p[2], p[3], p[4], p[5]}));
            return "Padding";
        }
        case NetworkOperatorKind::Prelu:
            params.blobs = {row(tensor(step.inputs[1]).values)};
            return "PReLU";
        case NetworkOperatorKind::Reshape:
            return reshape(step, params, from);
        case NetworkOperatorKind::ResizeBilinear: {
            const std::vector<int>& size = tensor(step.inputs[1]).integers;
            params.set("height", size[0]);
            params.set("width", size[1]);
            params.set("interpolation", "opencv_linear"); // half-pixel centres
            return "Resize";
        }
        }
        return "";
    }

    const NetworkGraph& m_graph;
    cv::dnn::Net& m_net;
    std::vector<int> m_layerOf; ///< per tensor; -1 for constants
    int m_count = 0;
};

} // namespace

std::vector<cv::String> addLayers(const NetworkGraph& graph, cv::dnn::Net& net) {
    return LayerBuilder(graph, net).build();
}

} // namespace core
