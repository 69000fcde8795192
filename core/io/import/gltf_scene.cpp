// SPDX-License-Identifier: MIT
#include "core/io/import/gltf_scene.h"

#include <algorithm>
#include <map>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "core/error.h"
#include "core/io/import/gltf_check.h"

namespace core {

namespace {

constexpr double kMmPerMetre = 1000;

Eigen::Affine3d affine(const aiMatrix4x4& m) {
    Eigen::Affine3d result;
    result.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
    return result;
}

/// Turns assimp's scene into ours.
class SceneReader {
public:
    SceneReader(const aiScene& source, std::string file)
        : m_source(source)
        , m_file(std::move(file)) {}

    GltfScene read() {
        m_scene.surface.weights.firstEntry = {0};
        addNode(*m_source.mRootNode, -1, Eigen::Affine3d(Eigen::Scaling(kMmPerMetre)));
        for (unsigned m = 0; m < m_source.mNumMeshes; ++m)
            if (m_source.mMeshes[m]->HasBones())
                addMesh(*m_source.mMeshes[m]);
        if (m_scene.surface.mesh.triangles.empty())
            throw Error(ErrorCode::BadInput, m_file, "skins", "the file holds no skinned mesh");
        return std::move(m_scene);
    }

private:
    void addNode(const aiNode& node, int parent, const Eigen::Affine3d& worldFromParent) {
        const int index = static_cast<int>(m_scene.nodes.size());
        const Eigen::Affine3d worldFromNode = worldFromParent * affine(node.mTransformation);
        m_scene.nodes.push_back({node.mName.C_Str(), parent, worldFromNode});
        m_nodeByName.try_emplace(node.mName.C_Str(), index);
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            addNode(*node.mChildren[c], index, worldFromNode);
    }

    /// The mesh as the file shows it: every vertex carried by its joints from the bind pose to their place in the tree.
    /// The place of the mesh's own node does not count (glTF 2.0, section 3.7.3.3).
    void addMesh(const aiMesh& mesh) {
        std::vector<std::vector<SkinWeight>> rows(mesh.mNumVertices);
        std::vector<Eigen::Vector3d> posed(mesh.mNumVertices, Eigen::Vector3d::Zero());
        for (unsigned b = 0; b < mesh.mNumBones; ++b)
            addBone(mesh, *mesh.mBones[b], rows, posed);
        const int first = static_cast<int>(m_scene.surface.mesh.vertices.size());
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            addVertex(rows[v], posed[v]);
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices == 3) { // lines and points are not surfaces
                m_scene.surface.mesh.triangles.push_back({first + static_cast<int>(face.mIndices[0]),
                                                          first + static_cast<int>(face.mIndices[1]),
                                                          first + static_cast<int>(face.mIndices[2])});
            }
        }
    }

    void addBone(const aiMesh& mesh, const aiBone& bone, std::vector<std::vector<SkinWeight>>& rows,
                 std::vector<Eigen::Vector3d>& posed) const {
        const auto node = m_nodeByName.find(bone.mName.C_Str());
        if (node == m_nodeByName.end()) {
            throw Error(ErrorCode::BadInput, m_file, "skins",
                        std::string("no node is named '") + bone.mName.C_Str() + "'");
        }
        const Eigen::Affine3d worldFromMesh =
            m_scene.nodes[static_cast<std::size_t>(node->second)].worldFromNode * affine(bone.mOffsetMatrix);
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const aiVertexWeight& weight = bone.mWeights[w];
            if (weight.mVertexId < mesh.mNumVertices && weight.mWeight > 0) {
                const aiVector3D& place = mesh.mVertices[weight.mVertexId];
                rows[weight.mVertexId].push_back({node->second, weight.mWeight});
                posed[weight.mVertexId] +=
                    static_cast<double>(weight.mWeight) * (worldFromMesh * Eigen::Vector3d(place.x, place.y, place.z));
            }
        }
    }

    void addVertex(std::vector<SkinWeight>& row, const Eigen::Vector3d& posedSum) {
        double sum = 0;
        for (const SkinWeight& w : row)
            sum += w.weight;
        if (!(sum > 0.5 && sum < 1.5) || !posedSum.allFinite()) {
            throw Error(ErrorCode::BadInput, m_file, "WEIGHTS_0",
                        "the weights of vertex " + std::to_string(m_scene.surface.mesh.vertices.size()) + " sum to " +
                            std::to_string(sum) + ", not to 1, or lead nowhere");
        }
        SkinWeights& weights = m_scene.surface.weights;
        for (const SkinWeight& w : row)
            weights.entries.push_back({w.bone, w.weight / sum});
        weights.firstEntry.push_back(static_cast<int>(weights.entries.size()));
        m_scene.surface.mesh.vertices.push_back(posedSum / sum);
    }

    const aiScene& m_source;
    std::string m_file;
    GltfScene m_scene;
    std::map<std::string, int> m_nodeByName;
};

} // namespace

GltfScene readGltfScene(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    checkGltfFile(file);
    if (extension != ".gltf" && extension != ".glb")
        throw Error(ErrorCode::Unsupported, file.string(), "", "the file's name must end in .gltf or .glb");
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr) {
        throw Error(ErrorCode::BadInput, file.string(), "",
                    std::string("cannot be read: ") + importer.GetErrorString());
    }
    return SceneReader(*scene, file.string()).read();
}

} // namespace core
