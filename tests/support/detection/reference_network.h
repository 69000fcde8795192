// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/detection/network_graph.h"

namespace test {

/// Runs a network by the definitions of TensorFlow Lite's operators, one number after the other.
class ReferenceNetwork {
public:
    explicit ReferenceNetwork(const core::NetworkGraph& graph)
        : m_graph(graph) {}

    std::vector<std::vector<float>> run(const std::vector<float>& input) {
        m_values.clear();
        for (const core::NetworkTensor& tensor : m_graph.tensors)
            m_values.push_back(tensor.values);
        values(m_graph.inputs[0]) = input;
        for (const core::NetworkOperator& step : m_graph.operators)
            runStep(step);
        std::vector<std::vector<float>> outputs;
        for (const int output : m_graph.outputs)
            outputs.push_back(values(output));
        return outputs;
    }

private:
    using Kind = core::NetworkOperatorKind;
    std::vector<float>& values(int tensor) { return m_values[static_cast<std::size_t>(tensor)]; }
    const core::NetworkTensor& tensor(int index) const { return m_graph.tensors[static_cast<std::size_t>(index)]; }
    /// A number of an image; zero outside it.
    float at(int image, int y, int x, int c) {
        const std::vector<int>& s = tensor(image).shape;
        if (y < 0 || x < 0 || y >= s[1] || x >= s[2])
            return 0;
        return values(image)[static_cast<std::size_t>((y * s[2] + x) * s[3] + c)];
    }

    template <typename Number>
    void fillImage(const core::NetworkOperator& step, Number number) {
        const std::vector<int>& s = tensor(step.outputs[0]).shape;
        std::vector<float> out;
        for (int y = 0; y < s[1]; ++y)
            for (int x = 0; x < s[2]; ++x)
                for (int c = 0; c < s[3]; ++c)
                    out.push_back(number(y, x, c));
        values(step.outputs[0]) = out;
    }

    /// Where a window begins before its first pixel: TensorFlow's definition of SAME.
    static int before(bool same, int size, int filter, int stride) {
        const int places = (size + stride - 1) / stride;
        return same ? std::max((places - 1) * stride + filter - size, 0) / 2 : 0;
    }

    void convolve(const core::NetworkOperator& step, bool depthwise) {
        const std::vector<int>&in = tensor(step.inputs[0]).shape, &w = tensor(step.inputs[1]).shape;
        const int top = before(step.samePadding, in[1], w[1], step.strideY);
        const int left = before(step.samePadding, in[2], w[2], step.strideX);
        fillImage(step, [&](int y, int x, int o) {
            double sum = values(step.inputs[2])[static_cast<std::size_t>(o)];
            for (int i = 0; i < w[1]; ++i)
                for (int j = 0; j < w[2]; ++j)
                    for (int c = depthwise ? o : 0; c < (depthwise ? o + 1 : in[3]); ++c) {
                        const int k = depthwise ? (i * w[2] + j) * w[3] + o : ((o * w[1] + i) * w[2] + j) * w[3] + c;
                        sum += double(values(step.inputs[1])[static_cast<std::size_t>(k)]) *
                               at(step.inputs[0], y * step.strideY - top + i, x * step.strideX - left + j, c);
                    }
            return static_cast<float>(sum);
        });
    }

    void pool(const core::NetworkOperator& step) {
        const std::vector<int>& in = tensor(step.inputs[0]).shape;
        const int top = before(step.samePadding, in[1], step.filterHeight, step.strideY);
        const int left = before(step.samePadding, in[2], step.filterWidth, step.strideX);
        fillImage(step, [&](int y, int x, int c) {
            float most = std::numeric_limits<float>::lowest();
            for (int i = 0; i < step.filterHeight; ++i)
                for (int j = 0; j < step.filterWidth; ++j) {
                    const int py = y * step.strideY - top + i, px = x * step.strideX - left + j;
                    if (py >= 0 && px >= 0 && py < in[1] && px < in[2])
                        most = std::max(most, at(step.inputs[0], py, px, c));
                }
            return most;
        });
    }

    void resize(const core::NetworkOperator& step) {
        const std::vector<int>&in = tensor(step.inputs[0]).shape, &out = tensor(step.outputs[0]).shape;
        const auto place = [](int i, int from, int to, int& low, int& high) {
            const double p = (i + 0.5) * from / to - 0.5;
            low = std::max(0, static_cast<int>(std::floor(p)));
            high = std::min(from - 1, static_cast<int>(std::floor(p)) + 1);
            return p - std::floor(p);
        };
        fillImage(step, [&](int y, int x, int c) {
            int y0 = 0, y1 = 0, x0 = 0, x1 = 0;
            const double v = place(y, in[1], out[1], y0, y1), u = place(x, in[2], out[2], x0, x1);
            const int image = step.inputs[0];
            return static_cast<float>((1 - v) * ((1 - u) * at(image, y0, x0, c) + u * at(image, y0, x1, c)) +
                                      v * ((1 - u) * at(image, y1, x0, c) + u * at(image, y1, x1, c)));
        });
    }

    void concatenate(const core::NetworkOperator& step) {
        std::vector<float>& out = values(step.outputs[0]);
        out.clear();
        const auto lengthOf = [&](int index, std::size_t from, std::size_t to) {
            std::size_t length = 1;
            for (std::size_t k = from; k < to; ++k)
                length *= static_cast<std::size_t>(tensor(index).shape[k]);
            return length;
        };
        const auto axis = static_cast<std::size_t>(step.axis);
        for (std::size_t outer = 0; outer < lengthOf(step.inputs[0], 0, axis); ++outer)
            for (const int input : step.inputs) {
                const std::size_t run = lengthOf(input, axis, tensor(input).shape.size());
                const auto begin = values(input).begin() + static_cast<std::ptrdiff_t>(outer * run);
                out.insert(out.end(), begin, begin + static_cast<std::ptrdiff_t>(run));
            }
    }

    void runStep(const core::NetworkOperator& step) {
        const int from = step.inputs[0];
        const std::vector<int>& in = tensor(from).shape;
        std::vector<float> out = values(from);
        switch (step.kind) {
        case Kind::Convolution:
        case Kind::DepthwiseConvolution:
            convolve(step, step.kind == Kind::DepthwiseConvolution);
            break;
        case Kind::MaxPool:
            pool(step);
            break;
        case Kind::ResizeBilinear:
            resize(step);
            break;
        case Kind::Concatenation:
            concatenate(step);
            break;
        case Kind::Pad: {
            const std::vector<int>& p = tensor(step.inputs[1]).integers;
            fillImage(step, [&](int y, int x, int c) {
                return c - p[6] < 0 || c - p[6] >= in[3] ? 0.0f : at(from, y - p[2], x - p[4], c - p[6]);
            });
            break;
        }
        case Kind::Mean: {
            std::vector<float>& mean = values(step.outputs[0]);
            mean.assign(static_cast<std::size_t>(in[3]), 0);
            for (std::size_t i = 0; i < out.size(); ++i)
                mean[i % mean.size()] += out[i] / static_cast<float>(in[1] * in[2]);
            break;
        }
        case Kind::FullyConnected: {
            std::vector<float> sums = values(step.inputs[2]);
            for (std::size_t o = 0; o < sums.size(); ++o)
                for (std::size_t i = 0; i < out.size(); ++i)
                    sums[o] += values(step.inputs[1])[o * out.size() + i] * out[i];
            values(step.outputs[0]) = sums;
            break;
        }
        default:
            for (std::size_t i = 0; i < out.size(); ++i)
                if (step.kind == Kind::Add)
                    out[i] += values(step.inputs[1])[i];
                else if (step.kind == Kind::Logistic)
                    out[i] = 1 / (1 + std::exp(-out[i]));
                else if (step.kind == Kind::Prelu && out[i] < 0)
                    out[i] *= values(step.inputs[1])[i % static_cast<std::size_t>(in[3])];
            values(step.outputs[0]) = out;
        }
        for (float& value : values(step.outputs[0]))
            if (step.activation != core::Activation::None)
                value = std::clamp(value, 0.0f, step.activation == core::Activation::Relu6 ? 6.0f : 1e30f);
    }

    const core::NetworkGraph& m_graph;
    std::vector<std::vector<float>> m_values;
};

} // namespace test
