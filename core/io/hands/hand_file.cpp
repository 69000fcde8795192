// SPDX-License-Identifier: MIT
#include "core/io/hands/hand_file.h"

#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr int kMostVertices = 10'000'000;

/// A hand file that is being read: the parsed value and the name for errors.
struct Source {
    const json& value;
    std::string file;

    Error bad(const std::string& field, const std::string& detail) const {
        return Error(ErrorCode::BadInput, file, field, detail);
    }
};

int boneNamed(const Skeleton& skeleton, const std::string& name, const Source& source, const std::string& field) {
    const int index = skeleton.boneIndex(name);
    if (index < 0)
        throw source.bad(field, "unknown bone \"" + name + "\"");
    return index;
}

std::string item(const char* list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

Skeleton readSkeleton(const Source& source) {
    Skeleton skeleton;
    for (const json& value : source.value["bones"]) {
        const std::string field = item("bones", skeleton.bones.size());
        Bone bone;
        bone.name = value["name"].get<std::string>();
        if (!value["parent"].is_null())
            bone.parent = boneNamed(skeleton, value["parent"].get<std::string>(), source, field + ".parent");
        bone.worldFromBoneAtRest.rotation = jsonMatrix(value["rotation"], source.file, field + ".rotation");
        bone.worldFromBoneAtRest.translation = jsonVector(value["translation"], source.file, field + ".translation");
        bone.lengthMm = value["lengthMm"].get<double>();
        skeleton.bones.push_back(bone);
    }
    for (const json& value : source.value["dofs"]) {
        const std::string field = item("dofs", skeleton.dofs.size());
        DegreeOfFreedom dof;
        dof.name = value["name"].get<std::string>();
        dof.bone = boneNamed(skeleton, value["bone"].get<std::string>(), source, field + ".bone");
        dof.axisInBone = jsonVector(value["axis"], source.file, field + ".axis");
        dof.minRad = value["minRad"].get<double>();
        dof.maxRad = value["maxRad"].get<double>();
        skeleton.dofs.push_back(dof);
    }
    skeleton.centreAtRest = jsonVector(source.value["centreAtRest"], source.file, "centreAtRest");
    return skeleton;
}

TriangleMesh readMesh(const Source& source) {
    const json& vertices = source.value["vertices"];
    const json& triangles = source.value["triangles"];
    if (vertices.size() % 3 != 0 || vertices.empty())
        throw source.bad("vertices", "three numbers per vertex are expected");
    if (triangles.size() % 3 != 0 || triangles.empty())
        throw source.bad("triangles", "three indices per triangle are expected");
    TriangleMesh mesh;
    const std::vector<double> flat = jsonNumbers(vertices, vertices.size(), source.file, "vertices");
    mesh.vertices.resize(flat.size() / 3);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.vertices[v] = {flat[3 * v], flat[3 * v + 1], flat[3 * v + 2]};
    const int last = static_cast<int>(mesh.vertices.size()) - 1;
    const std::vector<int> indices = jsonIntegers(triangles, triangles.size(), 0, last, source.file, "triangles");
    mesh.triangles.resize(indices.size() / 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        mesh.triangles[t] = {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
    return mesh;
}

SkinWeights readWeights(const Source& source, std::size_t vertexCount, int boneCount) {
    const json& value = source.value["weights"];
    const std::vector<int> counts =
        jsonIntegers(value["counts"], vertexCount, 1, boneCount, source.file, "weights.counts");
    SkinWeights weights;
    weights.firstEntry.push_back(0);
    for (const int count : counts)
        weights.firstEntry.push_back(weights.firstEntry.back() + count);
    const auto total = static_cast<std::size_t>(weights.firstEntry.back());
    const std::vector<int> bones = jsonIntegers(value["bones"], total, 0, boneCount - 1, source.file, "weights.bones");
    const std::vector<double> values = jsonNumbers(value["values"], total, source.file, "weights.values");
    weights.entries.resize(total);
    for (std::size_t i = 0; i < total; ++i)
        weights.entries[i] = {bones[i], values[i]};
    return weights;
}

void checkBones(const Skeleton& skeleton, const Source& source) {
    std::set<std::string> names;
    for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
        const Bone& bone = skeleton.bones[b];
        if (!names.insert(bone.name).second)
            throw source.bad(item("bones", b) + ".name", "the name \"" + bone.name + "\" is used twice");
        if ((bone.parent < 0) != (b == 0) || bone.parent >= static_cast<int>(b)) {
            throw source.bad(item("bones", b) + ".parent",
                             "the first bone and only it is the root; parents come before children");
        }
        if (!isRotation(bone.worldFromBoneAtRest.rotation))
            throw source.bad(item("bones", b) + ".rotation", "is not a rotation");
    }
}

void checkDofs(const Skeleton& skeleton, const Source& source) {
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        const DegreeOfFreedom& dof = skeleton.dofs[d];
        if (dof.bone <= 0 || (d > 0 && dof.bone < skeleton.dofs[d - 1].bone)) {
            throw source.bad(item("dofs", d) + ".bone",
                             "degrees of freedom come in the order of their bones, none at the root");
        }
        if (std::abs(dof.axisInBone.norm() - 1) > 1e-3)
            throw source.bad(item("dofs", d) + ".axis", "is not a unit vector");
        if (dof.minRad > dof.maxRad)
            throw source.bad(item("dofs", d) + ".minRad", "is larger than maxRad");
    }
}

void checkMesh(const TriangleMesh& mesh, const Source& source) {
    const int count = static_cast<int>(mesh.vertices.size());
    if (count == 0 || count > kMostVertices || mesh.triangles.empty())
        throw source.bad("vertices", "a mesh needs vertices and triangles, at most ten million");
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (!mesh.vertices[v].allFinite())
            throw source.bad(item("vertices", v), "is not finite");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= count || a == b || b == c || c == a)
            throw source.bad(item("triangles", t), "does not join three different vertices");
    }
}

void checkWeights(const HandModel& hand, const Source& source) {
    if (hand.weights.firstEntry.size() != hand.mesh.vertices.size() + 1)
        throw source.bad("weights", "one row per vertex is expected");
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v) {
        double sum = 0;
        for (int e = hand.weights.firstEntry[v]; e < hand.weights.firstEntry[v + 1]; ++e) {
            const SkinWeight& entry = hand.weights.entries[static_cast<std::size_t>(e)];
            if (!(entry.weight >= 0) || entry.bone < 0 || entry.bone >= static_cast<int>(hand.skeleton.bones.size()))
                throw source.bad("weights of vertex " + std::to_string(v), "are negative or of no bone");
            sum += entry.weight;
        }
        if (!(std::abs(sum - 1) <= 1e-6))
            throw source.bad("weights of vertex " + std::to_string(v), "sum to " + std::to_string(sum) + ", not to 1");
    }
}

ordered_json skeletonToJson(const Skeleton& skeleton, ordered_json document) {
    document["bones"] = ordered_json::array();
    for (const Bone& bone : skeleton.bones) {
        const ordered_json parent =
            bone.parent < 0 ? ordered_json(nullptr) : ordered_json(skeleton.bones[bone.parent].name);
        document["bones"].push_back({{"name", bone.name},
                                     {"parent", parent},
                                     {"rotation", jsonOf(bone.worldFromBoneAtRest.rotation)},
                                     {"translation", jsonOf(bone.worldFromBoneAtRest.translation)},
                                     {"lengthMm", bone.lengthMm}});
    }
    document["dofs"] = ordered_json::array();
    for (const DegreeOfFreedom& dof : skeleton.dofs) {
        document["dofs"].push_back({{"name", dof.name},
                                    {"bone", skeleton.bones[dof.bone].name},
                                    {"axis", jsonOf(dof.axisInBone)},
                                    {"minRad", dof.minRad},
                                    {"maxRad", dof.maxRad}});
    }
    document["centreAtRest"] = jsonOf(skeleton.centreAtRest);
    return document;
}

} // namespace

void checkHandModel(const HandModel& hand, const std::string& file) {
    const Source source{json(), file};
    checkBones(hand.skeleton, source);
    checkDofs(hand.skeleton, source);
    checkMesh(hand.mesh, source);
    checkWeights(hand, source);
}

HandModel readHandModel(const std::filesystem::path& file) {
    const json value = readOwnFile(file, "hand");
    const Source source{value, file.string()};
    HandModel hand;
    hand.side = *sideFromName(value["side"].get<std::string>());
    hand.skeleton = readSkeleton(source);
    hand.mesh = readMesh(source);
    hand.weights = readWeights(source, hand.mesh.vertices.size(), static_cast<int>(hand.skeleton.bones.size()));
    checkHandModel(hand, file.string());
    return hand;
}

void writeHandModel(const std::filesystem::path& file, const HandModel& hand) {
    checkHandModel(hand, file.string());
    ordered_json document{{"format", "handlens-hand"}, {"version", 1}, {"units", "mm"}, {"side", sideName(hand.side)}};
    document = skeletonToJson(hand.skeleton, std::move(document));
    std::vector<double> vertices, weights;
    for (const Eigen::Vector3d& v : hand.mesh.vertices)
        vertices.insert(vertices.end(), v.data(), v.data() + 3);
    std::vector<int> triangles, counts, bones;
    for (const auto& triangle : hand.mesh.triangles)
        triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v)
        counts.push_back(hand.weights.firstEntry[v + 1] - hand.weights.firstEntry[v]);
    for (const SkinWeight& entry : hand.weights.entries) {
        bones.push_back(entry.bone);
        weights.push_back(entry.weight);
    }
    document["vertices"] = vertices;
    document["triangles"] = triangles;
    document["weights"] = {{"counts", counts}, {"bones", bones}, {"values", weights}};
    writeJsonFile(file, document);
}

} // namespace core
