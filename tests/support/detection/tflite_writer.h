// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/detection/network_graph.h"

namespace test {

struct FlatNode;

/// A field of a FlatBuffers table: a number of 32 or 8 bits, raw bytes, whole numbers, a table, or tables.
struct FlatField {
    enum class Kind { Int, Byte, Bytes, Ints, Table, Tables } kind = Kind::Int;
    int number = 0;
    std::string bytes{};
    std::vector<int> ints{};
    std::vector<FlatNode> tables{};
};
struct FlatNode {
    std::map<int, FlatField> fields; ///< by their numbers in the schema
};

inline FlatField flatInt(int value) {
    return {FlatField::Kind::Int, value};
}
inline FlatField flatByte(int value) {
    return {FlatField::Kind::Byte, value};
}
inline FlatField flatBytes(const std::string& value) {
    return {FlatField::Kind::Bytes, 0, value};
}
inline FlatField flatInts(const std::vector<int>& value) {
    return {FlatField::Kind::Ints, 0, {}, value};
}
inline FlatField flatTable(const FlatNode& node) {
    return {FlatField::Kind::Table, 0, {}, {}, {node}};
}
inline FlatField flatTables(const std::vector<FlatNode>& nodes) {
    return {FlatField::Kind::Tables, 0, {}, {}, nodes};
}

/// Writes FlatBuffers files front to back.
class FlatWriter {
public:
    std::string write(const FlatNode& root, const std::string& identifier) {
        m_bytes.assign(4, '\0');
        m_bytes += identifier;
        refer(0, table(root));
        return m_bytes;
    }

private:
    void put32(std::uint32_t value) {
        for (int i = 0; i < 4; ++i)
            m_bytes += static_cast<char>(value >> 8 * i & 255);
    }
    void put16(std::uint32_t value) {
        m_bytes += static_cast<char>(value & 255);
        m_bytes += static_cast<char>(value >> 8 & 255);
    }
    void align() {
        while (m_bytes.size() % 4 != 0)
            m_bytes += '\0';
    }
    void refer(std::size_t from, std::size_t to) {
        for (std::size_t i = 0; i < 4; ++i)
            m_bytes[from + i] = static_cast<char>((to - from) >> 8 * i & 255);
    }

    std::size_t table(const FlatNode& node) {
        const int count = node.fields.empty() ? 0 : node.fields.rbegin()->first + 1;
        align();
        const std::size_t directory = m_bytes.size();
        put16(static_cast<std::uint32_t>(4 + 2 * count));
        put16(static_cast<std::uint32_t>(4 + 4 * count));
        for (int i = 0; i < count; ++i) // every field takes four bytes
            put16(node.fields.count(i) > 0 ? static_cast<std::uint32_t>(4 + 4 * i) : 0);
        align();
        const std::size_t position = m_bytes.size();
        put32(static_cast<std::uint32_t>(position - directory));
        for (int i = 0; i < count; ++i)
            put32(node.fields.count(i) > 0 ? static_cast<std::uint32_t>(node.fields.at(i).number) : 0);
        for (const auto& [i, field] : node.fields)
            if (field.kind != FlatField::Kind::Int && field.kind != FlatField::Kind::Byte)
                refer(position + 4 + 4 * static_cast<std::size_t>(i), content(field));
        return position;
    }

    std::size_t content(const FlatField& field) {
        if (field.kind == FlatField::Kind::Table)
            return table(field.tables[0]);
        align();
        const std::size_t position = m_bytes.size();
        if (field.kind == FlatField::Kind::Bytes) {
            put32(static_cast<std::uint32_t>(field.bytes.size()));
            m_bytes += field.bytes;
        } else if (field.kind == FlatField::Kind::Ints) {
            put32(static_cast<std::uint32_t>(field.ints.size()));
            for (const int value : field.ints)
                put32(static_cast<std::uint32_t>(value));
        } else {
            put32(static_cast<std::uint32_t>(field.tables.size()));
            for (std::size_t i = 0; i < field.tables.size(); ++i)
                put32(0);
            for (std::size_t i = 0; i < field.tables.size(); ++i)
                refer(position + 4 + 4 * i, table(field.tables[i]));
        }
        return position;
    }

    std::string m_bytes;
};

/// Codes of the operators in TensorFlow Lite's schema.
inline int tfliteCode(core::NetworkOperatorKind kind) {
    using Kind = core::NetworkOperatorKind;
    static const std::map<Kind, int> kCodes{{Kind::Add, 0},
                                            {Kind::Concatenation, 2},
                                            {Kind::Convolution, 3},
                                            {Kind::DepthwiseConvolution, 4},
                                            {Kind::Logistic, 14},
                                            {Kind::FullyConnected, 9},
                                            {Kind::MaxPool, 17},
                                            {Kind::Reshape, 22},
                                            {Kind::ResizeBilinear, 23},
                                            {Kind::Pad, 34},
                                            {Kind::Mean, 40},
                                            {Kind::Prelu, 54}};
    return kCodes.at(kind);
}

inline FlatNode tfliteOptions(const core::NetworkOperator& step) {
    using Kind = core::NetworkOperatorKind;
    const FlatField activation = flatByte(step.activation == core::Activation::Relu6  ? 3
                                          : step.activation == core::Activation::Relu ? 1
                                                                                      : 0);
    const FlatField padding = flatByte(step.samePadding ? 0 : 1), x = flatInt(step.strideX), y = flatInt(step.strideY);
    switch (step.kind) {
    case Kind::Convolution:
        return {{{0, padding}, {1, x}, {2, y}, {3, activation}}};
    case Kind::DepthwiseConvolution:
        return {{{0, padding}, {1, x}, {2, y}, {3, flatInt(1)}, {4, activation}}};
    case Kind::MaxPool:
        return {{{0, padding},
                 {1, x},
                 {2, y},
                 {3, flatInt(step.filterWidth)},
                 {4, flatInt(step.filterHeight)},
                 {5, activation}}};
    case Kind::Concatenation:
        return {{{0, flatInt(step.axis)}, {1, activation}}};
    case Kind::ResizeBilinear:
        return {{{3, flatByte(1)}}};
    default:
        return {{{0, activation}}};
    }
}

/// A network as a TensorFlow Lite file; with `halves` its weights are numbers of 16 bits that the file widens itself.
inline std::string tfliteBytes(const core::NetworkGraph& graph, bool halves = false) {
    std::vector<FlatNode> tensors, buffers{{}}, operators, halfTensors, dequantize;
    const auto raw = [](const auto& values) {
        return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    };
    const auto addBuffer = [&](const std::string& bytes) {
        buffers.push_back({{{0, flatBytes(bytes)}}});
        return flatInt(static_cast<int>(buffers.size()) - 1);
    };
    for (std::size_t i = 0; i < graph.tensors.size(); ++i) {
        const core::NetworkTensor& tensor = graph.tensors[i];
        FlatNode node{{{0, flatInts(tensor.shape)}, {3, flatBytes(tensor.name)}}};
        if (!tensor.integers.empty()) {
            node.fields[1] = flatByte(2);
            node.fields[2] = addBuffer(raw(tensor.integers));
        } else if (!tensor.values.empty() && !halves) {
            node.fields[2] = addBuffer(raw(tensor.values));
        } else if (!tensor.values.empty()) {
            std::vector<Eigen::half> narrow;
            for (const float value : tensor.values)
                narrow.push_back(Eigen::half(value));
            halfTensors.push_back({{{0, flatInts(tensor.shape)}, {1, flatByte(1)}, {2, addBuffer(raw(narrow))}}});
            const int half = static_cast<int>(graph.tensors.size() + halfTensors.size()) - 1;
            dequantize.push_back({{{0, flatInt(1)}, {1, flatInts({half})}, {2, flatInts({static_cast<int>(i)})}}});
        }
        tensors.push_back(node);
    }
    tensors.insert(tensors.end(), halfTensors.begin(), halfTensors.end());
    std::vector<FlatNode> codes{{{{0, flatByte(0)}}}, {{{0, flatByte(6)}, {3, flatInt(6)}}}};
    for (const core::NetworkOperator& step : graph.operators) {
        codes.push_back({{{0, flatByte(tfliteCode(step.kind))}}});
        operators.push_back({{{0, flatInt(static_cast<int>(codes.size()) - 1)},
                              {1, flatInts(step.inputs)},
                              {2, flatInts(step.outputs)},
                              {4, flatTable(tfliteOptions(step))}}});
    }
    operators.insert(operators.begin(), dequantize.begin(), dequantize.end());
    const FlatNode subgraph{{{0, flatTables(tensors)},
                             {1, flatInts(graph.inputs)},
                             {2, flatInts(graph.outputs)},
                             {3, flatTables(operators)}}};
    const FlatNode model{
        {{0, flatInt(3)}, {1, flatTables(codes)}, {2, flatTables({subgraph})}, {4, flatTables(buffers)}}};
    return FlatWriter().write(model, "TFL3");
}

} // namespace test
