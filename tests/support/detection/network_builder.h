// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/detection/network_graph.h"
#include "tests/support/random_values.h"

namespace test {

/// Puts networks together, with random weights that numbers of 16 bits hold exactly.
class NetworkBuilder {
public:
    using Kind = core::NetworkOperatorKind;
    using Shape = std::vector<int>;

    NetworkBuilder(const std::string& name, const Shape& input)
        : m_random(name) {
        graph.inputs = {tensor(input)};
    }

    core::NetworkGraph graph;

    int input() const { return graph.inputs[0]; }
    Shape shape(int index) const { return graph.tensors[static_cast<std::size_t>(index)].shape; }

    int weights(const Shape& shape) {
        const int index = tensor(shape);
        std::size_t count = 1;
        for (const int length : shape)
            count *= static_cast<std::size_t>(length);
        for (std::size_t i = 0; i < count; ++i)
            graph.tensors.back().values.push_back(static_cast<float>(m_random.below(129) - 64) / 128);
        return index;
    }
    int numbers(const std::vector<int>& values) {
        const int index = tensor({static_cast<int>(values.size())});
        graph.tensors.back().integers = values;
        return index;
    }

    /// Adds an operator; its output has this shape.
    int add(core::NetworkOperator step, const Shape& output) {
        step.outputs = {tensor(output)};
        graph.operators.push_back(step);
        return step.outputs[0];
    }
    int convolution(int from, int channels, int filter, int stride, bool same, core::Activation activation) {
        const Shape in = shape(from);
        core::NetworkOperator step = window(Kind::Convolution, stride, same, activation);
        step.inputs = {from, weights({channels, filter, filter, in[3]}), weights({channels})};
        return add(step, reduced(in, channels, filter, stride, same));
    }
    int depthwise(int from, int filter, int stride, core::Activation activation) {
        const Shape in = shape(from);
        core::NetworkOperator step = window(Kind::DepthwiseConvolution, stride, true, activation);
        step.inputs = {from, weights({1, filter, filter, in[3]}), weights({in[3]})};
        return add(step, reduced(in, in[3], filter, stride, true));
    }
    int pool(int from, int filter, int stride, bool same) {
        core::NetworkOperator step = window(Kind::MaxPool, stride, same, core::Activation::None);
        step.filterWidth = step.filterHeight = filter;
        step.inputs = {from};
        return add(step, reduced(shape(from), shape(from)[3], filter, stride, same));
    }
    int simple(Kind kind, const std::vector<int>& from, const Shape& output, int axis = 0) {
        core::NetworkOperator step;
        step.kind = kind;
        step.inputs = from;
        step.axis = axis;
        return add(step, output);
    }
    int connected(int from, int outputs) {
        return simple(Kind::FullyConnected, {from, weights({outputs, shape(from)[1]}), weights({outputs})},
                      {1, outputs});
    }
    int mean(int from) { return simple(Kind::Mean, {from, numbers({1, 2})}, {1, shape(from)[3]}); }
    int reshape(int from, const Shape& to) { return simple(Kind::Reshape, {from, numbers(to)}, to); }

private:
    int tensor(const Shape& shape) {
        graph.tensors.push_back({"t" + std::to_string(graph.tensors.size()), shape, {}, {}});
        return static_cast<int>(graph.tensors.size()) - 1;
    }
    static core::NetworkOperator window(Kind kind, int stride, bool same, core::Activation activation) {
        core::NetworkOperator step;
        step.kind = kind;
        step.strideX = step.strideY = stride;
        step.samePadding = same;
        step.activation = activation;
        return step;
    }
    static Shape reduced(const Shape& in, int channels, int filter, int stride, bool same) {
        const auto places = [&](int size) {
            return same ? (size + stride - 1) / stride : (size - filter) / stride + 1;
        };
        return {1, places(in[1]), places(in[2]), channels};
    }

    RandomValues m_random;
};

/// Every kind of operator, images with even and odd sides, strides that pad more at one end; five outputs.
inline core::NetworkGraph networkOfEverything() {
    using core::Activation;
    using Kind = core::NetworkOperatorKind;
    NetworkBuilder b("network of everything", {1, 18, 15, 3});
    const int first = b.convolution(b.input(), 4, 3, 2, true, Activation::Relu6); // 9 x 8
    const int deep = b.depthwise(first, 5, 2, Activation::Relu);                  // 5 x 4
    const int wide = b.depthwise(first, 3, 1, Activation::None);                  // 9 x 8
    const int sum = b.simple(Kind::Add, {first, wide}, b.shape(first));
    const int sharp = b.simple(Kind::Prelu, {sum, b.weights({1, 1, 4})}, b.shape(sum));
    const int pooled = b.pool(sharp, 2, 2, true); // 5 x 4, odd side
    const int padded = b.simple(Kind::Pad, {pooled, b.numbers({0, 0, 0, 0, 0, 0, 0, 2})}, {1, 5, 4, 6});
    const int point = b.convolution(deep, 6, 1, 1, true, Activation::None);
    const int both = b.simple(Kind::Add, {padded, point}, {1, 5, 4, 6});
    const int large = b.simple(Kind::ResizeBilinear, {both, b.numbers({10, 8})}, {1, 10, 8, 6});
    const int valid = b.convolution(large, 5, 3, 1, false, Activation::None); // 8 x 6
    const int joined = b.simple(Kind::Concatenation, {valid, valid}, {1, 8, 6, 10}, 3);
    const int rowsA = b.reshape(valid, {1, 48, 5}), rowsB = b.reshape(joined, {1, 96, 5});
    const int rows = b.simple(Kind::Concatenation, {rowsA, rowsB}, {1, 144, 5}, 1);
    const int features = b.mean(joined);
    const int numbers = b.connected(features, 7);
    const int chance = b.simple(Kind::Logistic, {numbers}, {1, 7});
    b.graph.outputs = {rows, numbers, chance, large, pooled};
    return b.graph;
}

} // namespace test
