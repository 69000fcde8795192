// SPDX-License-Identifier: MIT
#include "core/detection/network.h"

#include <gtest/gtest.h>

#include "tests/support/detection/network_builder.h"
#include "tests/support/detection/reference_network.h"
#include "tests/support/expect_error.h"

namespace {

using core::Activation;
using Kind = core::NetworkOperatorKind;

TEST(Network, GivesWhatTheOperatorsDefinitionsGive) {
    const core::NetworkGraph graph = test::networkOfEverything();
    core::checkGraph(graph, "graph");
    core::Network network(graph, "graph");
    test::ReferenceNetwork reference(graph);
    test::RandomValues random("network input");
    for (int round = 0; round < 3; ++round) {
        cv::Mat image(18, 15, CV_32FC3);
        std::vector<float> input;
        for (std::size_t i = 0; i < image.total() * 3; ++i)
            input.push_back(image.ptr<float>()[i] = static_cast<float>(random.between(0, 1)));
        const auto expected = reference.run(input), outputs = network.run(image);
        ASSERT_EQ(outputs.size(), expected.size());
        for (std::size_t o = 0; o < expected.size(); ++o) {
            ASSERT_EQ(outputs[o].size(), expected[o].size()) << "output " << o;
            for (std::size_t i = 0; i < expected[o].size(); ++i)
                ASSERT_NEAR(outputs[o][i], expected[o][i], 1e-4) << "output " << o << ", number " << i;
        }
    }
}

TEST(Network, PadsTheOddPixelAtTheEnd) {
    EXPECT_EQ(core::paddingOf(true, 224, 3, 2).before, 0);
    EXPECT_EQ(core::paddingOf(true, 224, 3, 2).after, 1);
    EXPECT_EQ(core::paddingOf(true, 7, 3, 2).before, 1);
    EXPECT_EQ(core::paddingOf(true, 7, 3, 2).after, 1);
    EXPECT_EQ(core::paddingOf(true, 56, 5, 2).before, 1);
    EXPECT_EQ(core::paddingOf(true, 56, 5, 2).after, 2);
    EXPECT_EQ(core::paddingOf(false, 56, 5, 2).after, 0);
}

/// A network of one operator, spoilt by `spoil`, is refused with `word`.
template <typename Spoil>
void expectRefused(Spoil spoil, const std::string& word) {
    core::NetworkGraph graph = test::networkOfEverything();
    spoil(graph);
    test::expectError([&] { core::checkGraph(graph, "palm.tflite"); }, core::ErrorCode::BadInput, "palm.tflite", word);
}

TEST(Network, RefusesGraphsThatDoNotFitTogether) {
    expectRefused([](auto& g) { g.tensors[0].shape = {1, 0, 15, 3}; }, "tensor 0");
    expectRefused([](auto& g) { g.tensors[0].shape = {1, 100000, 100000, 3}; }, "tensor 0");
    expectRefused([](auto& g) { g.tensors[1].values.pop_back(); }, "do not fill");
    expectRefused([](auto& g) { g.operators[0].inputs[0] = 999; }, "operator 0 (CONV_2D)");
    expectRefused([](auto& g) { g.operators[0].outputs = {0}; }, "operator 0 (CONV_2D)");
    expectRefused([](auto& g) { g.operators[0].strideX = 0; }, "stride");
    expectRefused([](auto& g) { g.operators[0].strideX = 3; }, "it should be");
    expectRefused([](auto& g) { std::swap(g.operators[0], g.operators[1]); }, "not known at this point");
    expectRefused([](auto& g) { g.outputs.clear(); }, "outputs");
    expectRefused([](auto& g) { g.operators.back().inputs.clear(); }, "inputs are missing");
}

/// `count` convolutions of 64 x 64 pixels by windows of 32 x 32, one after the other.
core::NetworkGraph longWork(int count, int channels) {
    core::NetworkGraph graph;
    const auto add = [&](std::vector<int> shape, std::size_t values) {
        graph.tensors.push_back({"", std::move(shape), std::vector<float>(values)});
        return static_cast<int>(graph.tensors.size()) - 1;
    };
    const auto all = static_cast<std::size_t>(channels);
    const int weights = add({channels, 32, 32, channels}, all * 32 * 32 * all), bias = add({channels}, all);
    graph.inputs = {add({1, 64, 64, channels}, 0)};
    for (int i = 0; i < count; ++i) {
        core::NetworkOperator step;
        step.kind = Kind::Convolution;
        step.inputs = {static_cast<int>(graph.tensors.size()) - 1, weights, bias};
        step.outputs = {add({1, 64, 64, channels}, 0)};
        graph.operators.push_back(step);
    }
    graph.outputs = {static_cast<int>(graph.tensors.size()) - 1};
    return graph;
}

TEST(Network, RefusesWorkWithoutEndThatIsMadeOfSmallParts) {
    core::checkGraph(longWork(50, 16), "palm.tflite"); // 1.1e9 products each
    const auto refused = [](const core::NetworkGraph& graph, const std::string& word) {
        test::expectError([&] { core::checkGraph(graph, "palm.tflite"); }, core::ErrorCode::BadInput, "palm.tflite",
                          word);
    };
    refused(longWork(100, 16), "takes too long");
    core::NetworkGraph large = longWork(1, 1);
    for (int i = 0; i < 9; ++i)
        large.tensors.push_back({"", {1, 4096, 4096, 1}, {}});
    refused(large, "too large together");
}

} // namespace
