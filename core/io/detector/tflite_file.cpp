// SPDX-License-Identifier: MIT
#include "core/io/detector/tflite_file.h"

#include <cstring>
#include <map>
#include <optional>

#include <Eigen/Core>

#include "core/error.h"
#include "core/io/detector/flat_buffer.h"

// Numbers of fields, operators and types are those of tensorflow/lite/schema/schema.fbs, version 3.

namespace core {

namespace {

constexpr std::size_t kMostTables = 10'000; ///< tensors, operators, ...
constexpr std::size_t kMostArguments = 16;
constexpr std::size_t kMostNameBytes = 200;
constexpr std::size_t kMostConstantBytes = 200'000'000; ///< of all tensors together, though they may share them
constexpr int kFloat32 = 0, kFloat16 = 1, kInt32 = 2;
constexpr int kDequantize = 6;

const std::map<int, NetworkOperatorKind> kOperatorKinds{{0, NetworkOperatorKind::Add},
                                                        {2, NetworkOperatorKind::Concatenation},
                                                        {3, NetworkOperatorKind::Convolution},
                                                        {4, NetworkOperatorKind::DepthwiseConvolution},
                                                        {9, NetworkOperatorKind::FullyConnected},
                                                        {14, NetworkOperatorKind::Logistic},
                                                        {17, NetworkOperatorKind::MaxPool},
                                                        {22, NetworkOperatorKind::Reshape},
                                                        {23, NetworkOperatorKind::ResizeBilinear},
                                                        {34, NetworkOperatorKind::Pad},
                                                        {40, NetworkOperatorKind::Mean},
                                                        {54, NetworkOperatorKind::Prelu}};

template <typename T>
std::vector<T> valuesOf(std::string_view bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty())
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

std::vector<float> widened(std::string_view bytes) {
    std::vector<float> values;
    for (const std::uint16_t bits : valuesOf<std::uint16_t>(bytes))
        values.push_back(Eigen::half_impl::half_to_float(Eigen::half_impl::raw_uint16_to_half(bits)));
    return values;
}

class TfliteReader {
public:
    TfliteReader(std::string_view bytes, const std::string& file)
        : m_file(file)
        , m_root(checkedRoot(bytes)) {}

    NetworkGraph read() {
        const std::vector<FlatTable> subgraphs = tables(m_root, 2, "subgraphs");
        if (subgraphs.size() != 1)
            fail("subgraphs", "there must be one, there are " + std::to_string(subgraphs.size()));
        readTensors(tables(subgraphs[0], 0, "tensors"));
        m_graph.inputs = subgraphs[0].integers(1);
        m_graph.outputs = subgraphs[0].integers(2);
        const std::vector<FlatTable> codes = tables(m_root, 1, "operator_codes"),
                                     operators = tables(subgraphs[0], 3, "operators");
        for (std::size_t i = 0; i < operators.size(); ++i) {
            m_field = "operator " + std::to_string(i);
            const int code = operators[i].integer(0);
            if (code < 0 || code >= static_cast<int>(codes.size()))
                fail(m_field, "its code is not in the file");
            const FlatTable& entry = codes[static_cast<std::size_t>(code)];
            readOperator(operators[i], std::max(entry.integer(3), entry.byte(0)));
        }
        checkGraph(m_graph, m_file);
        return std::move(m_graph);
    }

private:
    [[noreturn]] void fail(const std::string& field, const std::string& detail,
                           ErrorCode code = ErrorCode::BadInput) const {
        throw Error(code, m_file, field, detail);
    }

    std::vector<FlatTable> tables(const FlatTable& parent, int field, const std::string& name) const {
        if (parent.count(field) > kMostTables)
            fail(name, "there are " + std::to_string(parent.count(field)) + ", at most " + std::to_string(kMostTables) +
                           " are supported");
        return parent.tables(field);
    }

    FlatTable checkedRoot(std::string_view bytes) const {
        if (bytes.size() < 8 || bytes.substr(4, 4) != "TFL3")
            fail("", "not a TensorFlow Lite file");
        FlatTable root(bytes, m_file);
        if (root.integer(0) != 3)
            fail("version", "version " + std::to_string(root.integer(0)) + " is not supported, only 3",
                 ErrorCode::Unsupported);
        return root;
    }

    void readTensors(const std::vector<FlatTable>& tensors) {
        const std::vector<FlatTable> buffers = tables(m_root, 4, "buffers");
        for (std::size_t i = 0; i < tensors.size(); ++i) {
            const std::string field = "tensor " + std::to_string(i);
            NetworkTensor& tensor = m_graph.tensors.emplace_back();
            tensor.name = tensors[i].bytes(3).substr(0, kMostNameBytes);
            tensor.shape = tensors[i].integers(0);
            if (tensor.shape.size() > 4)
                fail(field, "more than four dimensions");
            if (tensor.shape.empty())
                tensor.shape = {1};
            if (tensors[i].has(6))
                fail(field, "sparse weights are not supported", ErrorCode::Unsupported);
            const int buffer = tensors[i].integer(2);
            if (buffer < 0 || buffer >= static_cast<int>(buffers.size()))
                fail(field, "its buffer is not in the file");
            readValues(buffers[static_cast<std::size_t>(buffer)].bytes(0), tensors[i].byte(1), field, tensor);
        }
    }

    void readValues(std::string_view bytes, int type, const std::string& field, NetworkTensor& tensor) {
        if (type != kFloat32 && type != kFloat16 && type != kInt32)
            fail(field, "only numbers of type float32, float16 and int32 are supported", ErrorCode::Unsupported);
        if (bytes.size() % (type == kFloat16 ? 2 : 4) != 0)
            fail(field, "its buffer holds no whole number of values");
        count(type == kFloat16 ? 2 * bytes.size() : bytes.size(), field);
        if (type == kInt32)
            tensor.integers = valuesOf<int>(bytes);
        else
            tensor.values = type == kFloat16 ? widened(bytes) : valuesOf<float>(bytes);
    }

    /// Tensors may share what lies in the file once, each with a copy in memory.
    void count(std::size_t bytes, const std::string& field) {
        m_constantBytes += bytes;
        if (m_constantBytes > kMostConstantBytes)
            fail(field, "the constants are too large");
    }

    /// The value of a constant of 16 bits is that of what DEQUANTIZE makes of it.
    void dequantize(const NetworkOperator& step) {
        const auto known = [&](const std::vector<int>& list) {
            return list.size() == 1 && list[0] >= 0 && list[0] < static_cast<int>(m_graph.tensors.size());
        };
        if (!known(step.inputs) || !known(step.outputs))
            fail(m_field, "its input or output is not in the file");
        const NetworkTensor& from = m_graph.tensors[static_cast<std::size_t>(step.inputs[0])];
        NetworkTensor& to = m_graph.tensors[static_cast<std::size_t>(step.outputs[0])];
        if (from.values.empty() || from.shape != to.shape || to.isConstant())
            fail(m_field, "DEQUANTIZE is supported for constants only", ErrorCode::Unsupported);
        count(from.values.size() * sizeof(float), m_field);
        to.values = from.values;
    }

    Activation activation(const FlatTable& options, int field) const {
        switch (options.byte(field)) {
        case 0:
            return Activation::None;
        case 1:
            return Activation::Relu;
        case 3:
            return Activation::Relu6;
        default:
            fail(m_field, "its activation is not supported", ErrorCode::Unsupported);
        }
    }

    void readOperator(const FlatTable& table, int code) {
        NetworkOperator step;
        step.inputs = table.integers(1);
        step.outputs = table.integers(2);
        if (step.inputs.size() > kMostArguments || step.outputs.size() > kMostArguments)
            fail(m_field, "it has too many inputs or outputs");
        if (code == kDequantize)
            return dequantize(step);
        const auto kind = kOperatorKinds.find(code);
        if (kind == kOperatorKinds.end())
            fail(m_field, "operators of kind " + std::to_string(code) + " are not supported", ErrorCode::Unsupported);
        step.kind = kind->second;
        readOptions(table.table(4), step);
        m_graph.operators.push_back(std::move(step));
    }

    void readWindow(const FlatTable& options, int activationField, NetworkOperator& step) const {
        step.samePadding = options.byte(0) == 0;
        step.strideX = options.integer(1);
        step.strideY = options.integer(2);
        step.activation = activation(options, activationField);
    }
    void requireUndilated(const FlatTable& options, int field) const {
        if (options.integer(field, 1) != 1 || options.integer(field + 1, 1) != 1)
            fail(m_field, "dilated convolutions are not supported", ErrorCode::Unsupported);
    }

    void readOptions(const FlatTable& options, NetworkOperator& step) const {
        switch (step.kind) {
        case NetworkOperatorKind::Convolution:
            readWindow(options, 3, step);
            return requireUndilated(options, 4);
        case NetworkOperatorKind::DepthwiseConvolution:
            readWindow(options, 4, step);
            return requireUndilated(options, 5);
        case NetworkOperatorKind::MaxPool:
            readWindow(options, 5, step);
            step.filterWidth = options.integer(3);
            step.filterHeight = options.integer(4);
            return;
        case NetworkOperatorKind::Add:
        case NetworkOperatorKind::FullyConnected:
            step.activation = activation(options, 0);
            return;
        case NetworkOperatorKind::Concatenation:
            step.axis = options.integer(0);
            step.activation = activation(options, 1);
            return;
        case NetworkOperatorKind::ResizeBilinear:
            if (options.byte(2) != 0 || options.byte(3) != 1)
                fail(m_field, "only resizing with half-pixel centres is supported", ErrorCode::Unsupported);
            return;
        default:
            return;
        }
    }

    const std::string& m_file;
    FlatTable m_root;
    NetworkGraph m_graph;
    std::string m_field;
    std::size_t m_constantBytes = 0;
};

} // namespace

NetworkGraph parseTflite(std::string_view bytes, const std::string& file) {
    return TfliteReader(bytes, file).read();
}

} // namespace core
