// SPDX-License-Identifier: MIT
#include "core/io/import/gltf_file.h"

#include <cstdint>

#include "core/error.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"

namespace core {

using nlohmann::json;

namespace {

std::uint32_t littleEndian32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (int k = 3; k >= 0; --k)
        value = (value << 8) | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
    return value;
}

/// Decodes base64; other characters end it.
std::string fromBase64(std::string_view text) {
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const std::size_t digit = digits.find(c);
        if (digit == std::string_view::npos)
            break;
        bits = (bits << 6) | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<char>((bits >> count) & 0xFF));
        }
    }
    return bytes;
}

class GltfFileReader {
public:
    explicit GltfFileReader(const std::filesystem::path& path)
        : m_content(readTextFile(path)) {
        m_result.path = path;
    }

    GltfFile read() {
        takeApart();
        checkVersion();
        if (m_result.root.contains("buffers")) {
            const json& buffers = m_result.root["buffers"];
            for (std::size_t b = 0; b < buffers.size(); ++b)
                addBuffer(buffers[b], "buffers[" + std::to_string(b) + "]");
        }
        return std::move(m_result);
    }

private:
    Error bad(const std::string& field, const std::string& detail, ErrorCode code = ErrorCode::BadInput) const {
        return {code, m_result.path.string(), field, detail};
    }

    void takeApart() {
        if (m_content.rfind("glTF", 0) != 0) {
            m_result.root = parseJson(m_content, m_result.path.string());
            return;
        }
        if (m_content.size() < 20 || littleEndian32(m_content, 8) != m_content.size())
            throw bad("header", "the file is cut off, or its length is not the one that its header says");
        if (littleEndian32(m_content, 4) != 2)
            throw bad("header", "only version 2 of glTF is supported", ErrorCode::Unsupported);
        const std::size_t jsonLength = littleEndian32(m_content, 12);
        if (littleEndian32(m_content, 16) != 0x4E4F534A || 20 + jsonLength > m_content.size())
            throw bad("header", "the first chunk is not JSON within the file");
        m_result.root = parseJson(std::string_view(m_content).substr(20, jsonLength), m_result.path.string());
        const std::size_t second = 20 + jsonLength;
        if (second + 8 <= m_content.size()) {
            const std::size_t length = littleEndian32(m_content, second);
            if (second + 8 + length > m_content.size())
                throw bad("header", "the second chunk does not lie within the file");
            m_binaryChunk = std::string_view(m_content).substr(second + 8, length);
        }
    }

    void checkVersion() const {
        const json& root = m_result.root;
        if (!root.is_object() || !root.contains("asset") || !root["asset"].is_object() ||
            !root["asset"].contains("version") || !root["asset"]["version"].is_string())
            throw bad("asset.version", "is missing: not a glTF file");
        if (root["asset"]["version"].get<std::string>().rfind("2.", 0) != 0)
            throw bad("asset.version", "only version 2 of glTF is supported", ErrorCode::Unsupported);
    }

    void addBuffer(const json& buffer, const std::string& field) {
        if (!buffer.is_object() || !buffer.contains("byteLength") || !buffer["byteLength"].is_number_unsigned())
            throw bad(field + ".byteLength", "is not a whole number");
        const auto length = buffer["byteLength"].get<std::size_t>();
        std::string content = bufferContent(buffer, field);
        if (content.size() < length) {
            throw bad(field + ".byteLength", std::to_string(length) + " bytes are promised, but there are only " +
                                                 std::to_string(content.size()));
        }
        content.resize(length);
        m_result.buffers.push_back(std::move(content));
    }

    std::string bufferContent(const json& buffer, const std::string& field) const {
        if (!buffer.contains("uri"))
            return std::string(m_binaryChunk);
        if (!buffer["uri"].is_string())
            throw bad(field + ".uri", "is not text");
        const std::string uri = buffer["uri"].get<std::string>();
        if (uri.rfind("data:", 0) != 0)
            return readTextFile(m_result.path.parent_path() / uri);
        const std::size_t start = uri.find(";base64,");
        if (start == std::string::npos)
            throw bad(field + ".uri", "is not base64 data", ErrorCode::Unsupported);
        return fromBase64(std::string_view(uri).substr(start + 8));
    }

    std::string m_content;
    std::string_view m_binaryChunk;
    GltfFile m_result;
};

} // namespace

GltfFile readGltfFile(const std::filesystem::path& path) {
    return GltfFileReader(path).read();
}

} // namespace core
