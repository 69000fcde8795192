// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace core {

enum class NetworkOperatorKind {
    Add,
    Concatenation,
    Convolution,
    DepthwiseConvolution,
    FullyConnected,
    Logistic,
    MaxPool,
    Mean, ///< over height and width
    Pad,
    Prelu,
    Reshape,
    ResizeBilinear ///< with half-pixel centres
};
/// As TensorFlow Lite names it: "CONV_2D".
std::string_view operatorName(NetworkOperatorKind kind);

enum class Activation { None, Relu, Relu6 };

/// An array of a network: a constant (weights), or what flows through it. Images are 1 x height x width x channels.
struct NetworkTensor {
    std::string name;
    std::vector<int> shape;
    std::vector<float> values;   ///< row-major; empty unless it is a constant of numbers
    std::vector<int> integers{}; ///< the same of whole numbers (shapes, axes, paddings)
    bool isConstant() const { return !values.empty() || !integers.empty(); }
};

/// One step. Weights of convolutions are out x height x width x in, of depthwise ones 1 x height x width x channels,
/// of fully connected ones out x in. Numbers that a kind does not use keep their defaults.
struct NetworkOperator {
    NetworkOperatorKind kind = NetworkOperatorKind::Add;
    std::vector<int> inputs, outputs; ///< indices of tensors
    Activation activation = Activation::None;
    bool samePadding = true; ///< else none; of stride 2 it pads more at the right and bottom end
    int strideX = 1, strideY = 1;
    int filterWidth = 1, filterHeight = 1; ///< of pools
    int axis = 0;                          ///< of concatenations
};

/// A feed-forward network as plain data, in the order in which it runs.
struct NetworkGraph {
    std::vector<NetworkTensor> tensors;
    std::vector<NetworkOperator> operators;
    std::vector<int> inputs, outputs; ///< indices of tensors
};

/// Pixels that "same" padding adds before and after a line of `size` pixels: the filter then has ceil(size / stride)
/// places, and the odd pixel comes after.
struct Padding {
    int before = 0, after = 0;
};
Padding paddingOf(bool same, int size, int filter, int stride);

/// Checks that every tensor is made before it is used and has the shape that its operator gives it, and that no tensor
/// is absurdly large, nor all of them together, nor the work: a graph that passes runs, in seconds. Throws
/// Error(BadInput) naming `file` and the operator.
void checkGraph(const NetworkGraph& graph, const std::string& file);

/// "1x56x56x24"
std::string shapeText(const std::vector<int>& shape);

} // namespace core
