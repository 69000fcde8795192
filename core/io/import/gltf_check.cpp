// SPDX-License-Identifier: MIT
#include "core/io/import/gltf_check.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/io/files/json_file.h"
#include "core/io/import/gltf_file.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

const std::map<std::string, std::size_t> kComponents{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                     {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
const std::map<int, std::size_t> kComponentBytes{{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

std::string item(const std::string& list, std::size_t index) {
    return list + "[" + std::to_string(index) + "]";
}

class GltfChecker {
public:
    explicit GltfChecker(const GltfFile& source)
        : m_source(source) {}

    void run() const {
        checkRoot();
        checkBufferViews();
        checkAccessors();
        checkNodes();
        checkSkins();
        checkMeshes();
        checkJointsOfVertices();
    }

private:
    Error bad(const std::string& field, const std::string& detail, ErrorCode code = ErrorCode::BadInput) const {
        return {code, m_source.path.string(), field, detail};
    }

    /// A list of the root object; empty if there is none.
    const json& list(const char* name) const {
        static const json kNone = json::array();
        return m_source.root.contains(name) ? m_source.root[name] : kNone;
    }

    /// A whole number >= 0; `fallback` if it is not there.
    std::size_t number(const json& object, const char* name, const std::string& field, std::size_t fallback = 0) const {
        if (!object.contains(name))
            return fallback;
        if (!object[name].is_number_unsigned() || object[name].get<std::uint64_t>() > 4'000'000'000U)
            throw bad(field + "." + name, "is not a whole number of a sensible size");
        return object[name].get<std::size_t>();
    }

    /// An index into a list of the root object.
    std::size_t index(const json& value, const char* listName, const std::string& field) const {
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= list(listName).size())
            throw bad(field, std::string("refers to nothing in ") + listName);
        return value.get<std::size_t>();
    }

    void checkRoot() const {
        for (const char* name :
             {"buffers", "bufferViews", "accessors", "nodes", "skins", "meshes", "scenes", "extensionsRequired"}) {
            if (!list(name).is_array())
                throw bad(name, "is not a list");
            for (std::size_t i = 0; i < list(name).size(); ++i)
                if (!list(name)[i].is_object() && std::string_view(name) != "extensionsRequired")
                    throw bad(item(name, i), "is not an object");
        }
        if (!list("extensionsRequired").empty()) {
            throw bad("extensionsRequired", list("extensionsRequired")[0].dump() + " is not supported",
                      ErrorCode::Unsupported);
        }
    }

    void checkBufferViews() const {
        for (std::size_t v = 0; v < list("bufferViews").size(); ++v) {
            const json& view = list("bufferViews")[v];
            const std::string field = item("bufferViews", v);
            const std::size_t buffer = index(view.value("buffer", json()), "buffers", field + ".buffer");
            if (number(view, "byteOffset", field) + number(view, "byteLength", field) > m_source.buffers[buffer].size())
                throw bad(field, "reaches beyond the end of its buffer");
        }
    }

    void checkAccessors() const {
        for (std::size_t a = 0; a < list("accessors").size(); ++a) {
            const json& accessor = list("accessors")[a];
            const std::string field = item("accessors", a);
            if (accessor.contains("sparse"))
                throw bad(field + ".sparse", "sparse accessors are not supported", ErrorCode::Unsupported);
            if (!accessor.contains("type") || !accessor["type"].is_string() ||
                !kComponents.count(accessor["type"].get<std::string>()))
                throw bad(field + ".type", "is not a glTF type");
            if (!kComponentBytes.count(static_cast<int>(number(accessor, "componentType", field))))
                throw bad(field + ".componentType", "is not a glTF type");
            if (!accessor.contains("bufferView"))
                continue; // all zero
            const std::size_t v = index(accessor["bufferView"], "bufferViews", field + ".bufferView");
            const json& view = list("bufferViews")[v];
            const std::size_t count = number(accessor, "count", field);
            const std::size_t stride = number(view, "byteStride", item("bufferViews", v), elementBytes(accessor));
            if (count == 0 || stride < elementBytes(accessor) ||
                number(accessor, "byteOffset", field) + (count - 1) * stride + elementBytes(accessor) >
                    number(view, "byteLength", field))
                throw bad(field + ".count", "reaches beyond the end of its buffer view");
        }
    }

    static std::size_t elementBytes(const json& accessor) {
        return kComponents.at(accessor["type"].get<std::string>()) *
               kComponentBytes.at(accessor["componentType"].get<int>());
    }

    void checkNodes() const {
        std::vector<int> parents(list("nodes").size(), 0);
        for (std::size_t n = 0; n < list("nodes").size(); ++n) {
            const json& node = list("nodes")[n];
            const std::string field = item("nodes", n);
            for (const auto& [name, length] :
                 std::map<std::string, std::size_t>{{"translation", 3}, {"rotation", 4}, {"scale", 3}, {"matrix", 16}})
                if (node.contains(name))
                    jsonNumbers(node[name], length, m_source.path.string(), field + "." + name);
            if (node.contains("mesh"))
                index(node["mesh"], "meshes", field + ".mesh");
            if (node.contains("skin"))
                index(node["skin"], "skins", field + ".skin");
            for (const json& child : node.value("children", json::array())) {
                // A node below itself, or below two parents, would be walked without end.
                if (++parents[index(child, "nodes", field + ".children")] > 1 || child.get<std::size_t>() == n)
                    throw bad(field + ".children", "a node has two parents");
            }
        }
        checkReachable();
    }

    /// With one parent at most, what is not below a root goes in a circle.
    void checkReachable() const {
        std::vector<bool> isChild(list("nodes").size(), false);
        for (const json& node : list("nodes"))
            for (const json& child : node.value("children", json::array()))
                isChild[child.get<std::size_t>()] = true;
        std::vector<std::size_t> open;
        for (std::size_t n = 0; n < isChild.size(); ++n)
            if (!isChild[n])
                open.push_back(n);
        std::size_t reached = 0;
        while (!open.empty()) {
            const json& node = list("nodes")[open.back()];
            open.pop_back();
            ++reached;
            for (const json& child : node.value("children", json::array()))
                open.push_back(child.get<std::size_t>());
        }
        if (reached != isChild.size())
            throw bad("nodes", "some nodes are their own ancestors");
        for (std::size_t s = 0; s < list("scenes").size(); ++s)
            for (const json& node : list("scenes")[s].value("nodes", json::array()))
                index(node, "nodes", item("scenes", s) + ".nodes");
    }

    void checkSkins() const {
        for (std::size_t s = 0; s < list("skins").size(); ++s) {
            const json& skin = list("skins")[s];
            const std::string field = item("skins", s);
            const json joints = skin.value("joints", json::array());
            for (const json& joint : joints)
                index(joint, "nodes", field + ".joints");
            if (!skin.contains("inverseBindMatrices")) {
                throw bad(field + ".inverseBindMatrices", "skins without them are not supported",
                          ErrorCode::Unsupported);
            }
            const json& accessor =
                accessorOf(skin["inverseBindMatrices"], "MAT4", {kFloat}, field + ".inverseBindMatrices");
            if (joints.empty() || number(accessor, "count", field) < joints.size())
                throw bad(field + ".inverseBindMatrices", "there must be one per joint");
        }
    }

    const json& accessorOf(const json& value, const std::string& type, const std::vector<int>& componentTypes,
                           const std::string& field) const {
        const json& accessor = list("accessors")[index(value, "accessors", field)];
        const int component = accessor["componentType"].get<int>();
        bool isOne = false;
        for (const int wanted : componentTypes)
            isOne = isOne || wanted == component;
        if (accessor["type"] != type || !isOne)
            throw bad(field, "is of another type than " + type + " in a usual component type");
        return accessor;
    }

    void checkMeshes() const {
        for (std::size_t m = 0; m < list("meshes").size(); ++m) {
            const json primitives = list("meshes")[m].value("primitives", json::array());
            for (std::size_t p = 0; p < primitives.size(); ++p)
                checkPrimitive(primitives[p], item(item("meshes", m) + ".primitives", p));
        }
    }

    void checkPrimitive(const json& primitive, const std::string& field) const {
        const json attributes = primitive.value("attributes", json::object());
        if (!attributes.contains("POSITION"))
            throw bad(field + ".attributes", "there is no POSITION");
        const json& positions = accessorOf(attributes["POSITION"], "VEC3", {kFloat}, field + ".attributes.POSITION");
        for (const auto& [name, value] : attributes.items()) {
            const std::string here = field + ".attributes." + name;
            const json& accessor = list("accessors")[index(value, "accessors", here)];
            if (number(accessor, "count", here) != number(positions, "count", here))
                throw bad(here, "has another count than POSITION");
            if (name.rfind("JOINTS_", 0) == 0)
                accessorOf(value, "VEC4", {kUnsignedByte, kUnsignedShort}, here);
            else if (name.rfind("WEIGHTS_", 0) == 0)
                accessorOf(value, "VEC4", {kFloat, kUnsignedByte, kUnsignedShort}, here);
        }
        if (primitive.contains("indices")) {
            accessorOf(primitive["indices"], "SCALAR", {kUnsignedByte, kUnsignedShort, kUnsignedInt},
                       field + ".indices");
            checkIndices(primitive, number(positions, "count", field), field + ".indices");
        }
    }

    /// Element `i`, component `c` of an accessor of whole numbers.
    std::uint32_t wholeNumber(const json& accessor, std::size_t i, std::size_t c) const {
        const json& view = list("bufferViews")[accessor["bufferView"].get<std::size_t>()];
        const std::size_t size = kComponentBytes.at(accessor["componentType"].get<int>());
        const std::size_t stride = number(view, "byteStride", "", elementBytes(accessor));
        const std::size_t at =
            number(view, "byteOffset", "") + number(accessor, "byteOffset", "") + i * stride + c * size;
        const std::string& buffer = m_source.buffers[view["buffer"].get<std::size_t>()];
        std::uint32_t value = 0;
        for (std::size_t k = size; k-- > 0;)
            value = (value << 8) | static_cast<unsigned char>(buffer[at + k]);
        return value;
    }

    void checkIndices(const json& primitive, std::size_t vertexCount, const std::string& field) const {
        const json& accessor = list("accessors")[primitive["indices"].get<std::size_t>()];
        for (std::size_t i = 0; accessor.contains("bufferView") && i < number(accessor, "count", field); ++i)
            if (wholeNumber(accessor, i, 0) >= vertexCount)
                throw bad(field, "triangle index " + std::to_string(i) + " refers to no vertex");
    }

    void checkJointsOfVertices() const {
        for (std::size_t n = 0; n < list("nodes").size(); ++n) {
            const json& node = list("nodes")[n];
            if (!node.contains("mesh") || !node.contains("skin"))
                continue;
            const std::size_t jointCount = list("skins")[node["skin"].get<std::size_t>()]["joints"].size();
            const std::size_t mesh = node["mesh"].get<std::size_t>();
            const json primitives = list("meshes")[mesh].value("primitives", json::array());
            for (std::size_t p = 0; p < primitives.size(); ++p) {
                for (const auto& [name, value] : primitives[p]["attributes"].items()) {
                    if (name.rfind("JOINTS_", 0) == 0) {
                        checkJoints(list("accessors")[value.get<std::size_t>()], jointCount,
                                    item(item("meshes", mesh) + ".primitives", p) + ".attributes." + name);
                    }
                }
            }
        }
    }

    void checkJoints(const json& accessor, std::size_t jointCount, const std::string& field) const {
        for (std::size_t i = 0; accessor.contains("bufferView") && i < number(accessor, "count", field); ++i) {
            for (std::size_t c = 0; c < 4; ++c)
                if (wholeNumber(accessor, i, c) >= jointCount)
                    throw bad(field, "vertex " + std::to_string(i) + " refers to no joint of the skin");
        }
    }

    const GltfFile& m_source;
};

} // namespace

void checkGltfFile(const fs::path& file) {
    try {
        const GltfFile source = readGltfFile(file);
        GltfChecker(source).run();
    } catch (const json::exception& failure) { // a member of another type than glTF says
        throw Error(ErrorCode::BadInput, file.string(), "", std::string("is not a valid glTF file: ") + failure.what());
    }
}

} // namespace core
