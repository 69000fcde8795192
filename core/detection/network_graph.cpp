// SPDX-License-Identifier: MIT
#include "core/detection/network_graph.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/error.h"

namespace core {

std::string_view operatorName(NetworkOperatorKind kind) {
    constexpr std::array<std::string_view, 12> kNames{
        "ADD",  "CONCATENATION", "CONV_2D", "DEPTHWISE_CONV_2D", "FULLY_CONNECTED", "LOGISTIC", "MAX_POOL_2D",
        "MEAN", "PAD",           "PRELU",   "RESHAPE",           "RESIZE_BILINEAR"};
    return kNames.at(static_cast<std::size_t>(kind));
}

Padding paddingOf(bool same, int size, int filter, int stride) {
    if (!same)
        return {};
    const int places = (size + stride - 1) / stride;
    const int total = std::max(0, (places - 1) * stride + filter - size);
    return {total / 2, total - total / 2};
}

std::string shapeText(const std::vector<int>& shape) {
    std::string text;
    for (const int length : shape)
        text += (text.empty() ? "" : "x") + std::to_string(length);
    return text.empty() ? "scalar" : text;
}

namespace {

using Shape = std::vector<int>;

constexpr std::int64_t kMostElements = std::int64_t(1) << 24;
constexpr std::int64_t kMostElementsInAll = std::int64_t(1) << 27;
constexpr std::int64_t kMostProducts = std::int64_t(1) << 36; ///< of one run; the hand's networks take some 2^29
constexpr int kMostSteps = 64;                                ///< strides and filters

std::int64_t elementCount(const Shape& shape) {
    std::int64_t count = 1;
    for (const int length : shape) {
        if (length < 1 || count * length > kMostElements)
            return -1;
        count *= length;
    }
    return count;
}

/// Checks one operator after the other, keeping track of the tensors that exist.
class GraphCheck {
public:
    GraphCheck(const NetworkGraph& graph, const std::string& file)
        : m_graph(graph)
        , m_file(file)
        , m_isMade(graph.tensors.size()) {}

    void run() {
        std::int64_t all = 0;
        for (std::size_t i = 0; i < m_graph.tensors.size(); ++i) {
            m_field = "tensor " + std::to_string(i);
            const NetworkTensor& tensor = m_graph.tensors[i];
            const std::int64_t count = elementCount(tensor.shape);
            require(count > 0, "a shape of " + shapeText(tensor.shape) + " is not supported");
            all += count;
            require(all <= kMostElementsInAll, "the tensors are too large together");
            const std::size_t given = std::max(tensor.values.size(), tensor.integers.size());
            require(!tensor.isConstant() || given == static_cast<std::size_t>(count),
                    std::to_string(given) + " values do not fill a shape of " + shapeText(tensor.shape));
            m_isMade[i] = tensor.isConstant();
        }
        m_field = "inputs";
        for (const int input : m_graph.inputs)
            make(input);
        for (std::size_t i = 0; i < m_graph.operators.size(); ++i) {
            m_field =
                "operator " + std::to_string(i) + " (" + std::string(operatorName(m_graph.operators[i].kind)) + ")";
            checkOperator(m_graph.operators[i]);
        }
        m_field = "outputs";
        require(!m_graph.outputs.empty(), "there are none");
        for (const int output : m_graph.outputs)
            require(!made(output).isConstant(), "one is a constant");
    }

private:
    void require(bool holds, const std::string& detail) const {
        if (!holds)
            throw Error(ErrorCode::BadInput, m_file, m_field, detail);
    }
    void make(int tensor) {
        require(tensor >= 0 && tensor < static_cast<int>(m_isMade.size()),
                "there is no tensor " + std::to_string(tensor));
        require(!m_isMade[static_cast<std::size_t>(tensor)], "tensor " + std::to_string(tensor) + " is written twice");
        m_isMade[static_cast<std::size_t>(tensor)] = true;
    }
    const NetworkTensor& made(int tensor) const {
        require(tensor >= 0 && tensor < static_cast<int>(m_isMade.size()) && m_isMade[static_cast<std::size_t>(tensor)],
                "tensor " + std::to_string(tensor) + " is not known at this point");
        return m_graph.tensors[static_cast<std::size_t>(tensor)];
    }

    void checkOperator(const NetworkOperator& step) {
        require(step.inputs.size() >= least(step.kind), "inputs are missing");
        require(step.outputs.size() == 1, "it must have one output");
        require(step.strideX >= 1 && step.strideX <= kMostSteps && step.strideY >= 1 && step.strideY <= kMostSteps &&
                    step.filterWidth >= 1 && step.filterWidth <= kMostSteps && step.filterHeight >= 1 &&
                    step.filterHeight <= kMostSteps,
                "stride or filter size is out of range");
        for (const int input : step.inputs)
            made(input);
        require(!made(step.inputs[0]).isConstant(), "its first input is a constant");
        const Shape expected = shapeOf(step);
        make(step.outputs[0]);
        const Shape& stated = made(step.outputs[0]).shape;
        require(expected == stated, "the output is " + shapeText(stated) + ", it should be " + shapeText(expected));
        m_products += elementCount(stated) * productsOf(step);
        require(m_products <= kMostProducts, "the network takes too long to run");
    }

    /// How many numbers an element of the output is made of.
    std::int64_t productsOf(const NetworkOperator& step) const {
        if (step.kind == NetworkOperatorKind::MaxPool)
            return std::int64_t(step.filterHeight) * step.filterWidth;
        if (step.kind != NetworkOperatorKind::Convolution && step.kind != NetworkOperatorKind::DepthwiseConvolution)
            return 1;
        const Shape& weights = input(step, 1).shape;
        const bool depthwise = step.kind == NetworkOperatorKind::DepthwiseConvolution;
        return std::int64_t(weights[1]) * weights[2] * (depthwise ? 1 : weights[3]);
    }

    static std::size_t least(NetworkOperatorKind kind) {
        switch (kind) {
        case NetworkOperatorKind::Logistic:
        case NetworkOperatorKind::MaxPool:
        case NetworkOperatorKind::Concatenation:
            return 1;
        case NetworkOperatorKind::Convolution:
        case NetworkOperatorKind::DepthwiseConvolution:
        case NetworkOperatorKind::FullyConnected:
            return 3;
        default:
            return 2;
        }
    }

    const NetworkTensor& input(const NetworkOperator& step, std::size_t i) const { return made(step.inputs[i]); }
    const std::vector<int>& integers(const NetworkOperator& step, std::size_t count) const {
        const std::vector<int>& values = input(step, 1).integers;
        require(values.size() == count, "its second input must be " + std::to_string(count) + " whole numbers");
        return values;
    }
    void requireWeights(const NetworkTensor& tensor, const Shape& shape) const {
        require(tensor.shape == shape && !tensor.values.empty(),
                "weights are " + shapeText(tensor.shape) + ", they should be " + shapeText(shape));
    }
    void requireImage(const NetworkTensor& tensor) const {
        require(tensor.shape.size() == 4 && tensor.shape[0] == 1,
                "the input is not an image: " + shapeText(tensor.shape));
    }

    Shape shapeOf(const NetworkOperator& step) const;
    Shape windowed(const NetworkOperator& step, int filterHeight, int filterWidth, int channels) const;
    Shape convolved(const NetworkOperator& step) const;
    Shape connected(const NetworkOperator& step) const;
    Shape concatenated(const NetworkOperator& step) const;
    Shape padded(const NetworkOperator& step) const;
    Shape reshaped(const NetworkOperator& step) const;
    Shape averaged(const NetworkOperator& step) const;

    const NetworkGraph& m_graph;
    const std::string& m_file;
    std::vector<bool> m_isMade;
    std::string m_field;
    std::int64_t m_products = 0;
};

/// The shape of what a window of that size leaves of the image.
Shape GraphCheck::windowed(const NetworkOperator& step, int filterHeight, int filterWidth, int channels) const {
    const Shape& in = input(step, 0).shape;
    const auto places = [&](int size, int filter, int stride) {
        require(step.samePadding || size >= filter, "the window is larger than the image");
        return step.samePadding ? (size + stride - 1) / stride : (size - filter) / stride + 1;
    };
    return {1, places(in[1], filterHeight, step.strideY), places(in[2], filterWidth, step.strideX), channels};
}

Shape GraphCheck::convolved(const NetworkOperator& step) const {
    requireImage(input(step, 0));
    const Shape &in = input(step, 0).shape, &weights = input(step, 1).shape;
    require(weights.size() == 4 && weights[1] <= kMostSteps && weights[2] <= kMostSteps, "weights of another shape");
    const bool depthwise = step.kind == NetworkOperatorKind::DepthwiseConvolution;
    const int channels = depthwise ? weights[3] : weights[0];
    requireWeights(input(step, 1), depthwise ? Shape{1, weights[1], weights[2], in[3]}
                                             : Shape{channels, weights[1], weights[2], in[3]});
    requireWeights(input(step, 2), {channels});
    return windowed(step, weights[1], weights[2], channels);
}

Shape GraphCheck::connected(const NetworkOperator& step) const {
    const Shape &in = input(step, 0).shape, &weights = input(step, 1).shape;
    require(in.size() == 2 && in[0] == 1 && weights.size() == 2, "inputs of another shape");
    requireWeights(input(step, 1), {weights[0], in[1]});
    requireWeights(input(step, 2), {weights[0]});
    return {1, weights[0]};
}

Shape GraphCheck::concatenated(const NetworkOperator& step) const {
    Shape shape = input(step, 0).shape;
    const int axis = step.axis < 0 ? step.axis + static_cast<int>(shape.size()) : step.axis;
    require(axis >= 1 && axis < static_cast<int>(shape.size()), "there is no axis " + std::to_string(step.axis));
    const auto at = static_cast<std::size_t>(axis);
    for (std::size_t i = 1; i < step.inputs.size(); ++i) {
        Shape other = input(step, i).shape;
        require(!input(step, i).isConstant() && other.size() == shape.size(), "inputs of different shapes");
        const std::int64_t sum = std::int64_t(shape[at]) + other[at];
        require(sum <= kMostElements, "the output is too large");
        shape[at] = other[at] = static_cast<int>(sum);
        require(shape == other, "inputs of different shapes");
    }
    return shape;
}

Shape GraphCheck::padded(const NetworkOperator& step) const {
    requireImage(input(step, 0));
    Shape shape = input(step, 0).shape;
    const std::vector<int>& paddings = integers(step, 2 * shape.size());
    for (std::size_t i = 0; i < paddings.size(); ++i) {
        require(paddings[i] >= 0 && paddings[i] <= 4096, "a padding is out of range");
        shape[i / 2] += paddings[i];
    }
    require(shape[0] == 1, "a padding of the batch is not supported");
    return shape;
}

Shape GraphCheck::reshaped(const NetworkOperator& step) const {
    const int output = step.outputs[0];
    require(output >= 0 && output < static_cast<int>(m_graph.tensors.size()), "there is no such output");
    const Shape& stated = m_graph.tensors[static_cast<std::size_t>(output)].shape; // its second input says the same
    require(elementCount(stated) == elementCount(input(step, 0).shape), "the number of elements changes");
    require(stated.size() < 4 && stated[0] == 1, "a shape of " + shapeText(stated) + " is not supported");
    return stated;
}

Shape GraphCheck::averaged(const NetworkOperator& step) const {
    requireImage(input(step, 0));
    std::vector<int> axes = integers(step, 2);
    std::sort(axes.begin(), axes.end());
    require(axes == Shape{1, 2}, "only means over height and width are supported");
    return {1, input(step, 0).shape[3]};
}

Shape GraphCheck::shapeOf(const NetworkOperator& step) const {
    const Shape& in = input(step, 0).shape;
    switch (step.kind) {
    case NetworkOperatorKind::Add:
        require(step.inputs.size() == 2 && input(step, 1).shape == in && !input(step, 1).isConstant(),
                "inputs of different shapes");
        return in;
    case NetworkOperatorKind::Concatenation:
        return concatenated(step);
    case NetworkOperatorKind::Convolution:
    case NetworkOperatorKind::DepthwiseConvolution:
        return convolved(step);
    case NetworkOperatorKind::FullyConnected:
        return connected(step);
    case NetworkOperatorKind::Logistic:
        return in;
    case NetworkOperatorKind::MaxPool:
        requireImage(input(step, 0));
        return windowed(step, step.filterHeight, step.filterWidth, in[3]);
    case NetworkOperatorKind::Mean:
        return averaged(step);
    case NetworkOperatorKind::Pad:
        return padded(step);
    case NetworkOperatorKind::Prelu:
        requireImage(input(step, 0));
        requireWeights(input(step, 1), {1, 1, in[3]});
        return in;
    case NetworkOperatorKind::Reshape:
        return reshaped(step);
    case NetworkOperatorKind::ResizeBilinear: {
        requireImage(input(step, 0));
        const std::vector<int>& size = integers(step, 2);
        require(size[0] >= 1 && size[0] <= 4096 && size[1] >= 1 && size[1] <= 4096, "the new size is out of range");
        return {1, size[0], size[1], in[3]};
    }
    }
    return {};
}

} // namespace

void checkGraph(const NetworkGraph& graph, const std::string& file) {
    GraphCheck(graph, file).run();
}

} // namespace core
