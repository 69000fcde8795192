// SPDX-License-Identifier: MIT
#include "core/io/hands/off_mesh.h"

#include <cmath>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "core/error.h"
#include "core/io/files/text_file.h"

namespace core {

namespace {

Error bad(const std::filesystem::path& file, const std::string& field, const std::string& detail) {
    return Error(ErrorCode::BadInput, file.string(), field, detail);
}

/// assimp forgives cut files and bad indices, so header and lines are checked before it sees the text.
void checkOff(const std::filesystem::path& file, const std::string& text) {
    LineReader lines(file.string(), text);
    if (lines.next("OFF") != "OFF")
        throw bad(file, "line 1", "an OFF file begins with OFF");
    const std::vector<double> counts = lines.nextNumbers(3, "vertices, faces, edges");
    if (!(counts[0] >= 3 && counts[0] < 1e7 && counts[1] >= 1 && counts[1] < 1e7))
        throw lines.errorHere("the counts of vertices and faces are not sensible");
    for (int v = 0; v < counts[0]; ++v)
        lines.nextNumbers(3, "a vertex");
    for (int f = 0; f < counts[1]; ++f) {
        const std::vector<double> face = lines.nextNumbers(4, "a triangle: 3 and its vertices");
        for (int i = 1; i < 4; ++i) {
            const double index = face[static_cast<std::size_t>(i)];
            if (face[0] != 3 || index != std::floor(index) || !(index >= 0 && index < counts[0]))
                throw lines.errorHere("is not a triangle of the file's vertices");
        }
    }
    if (!lines.atEnd())
        throw bad(file, "", "goes on after its last triangle");
}

} // namespace

TriangleMesh readOffMesh(const std::filesystem::path& file) {
    const std::string text = readTextFile(file);
    checkOff(file, text);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(text.data(), text.size(), 0, "off");
    if (scene == nullptr || scene->mNumMeshes != 1)
        throw bad(file, "", "cannot be read as a mesh: " + std::string(importer.GetErrorString()));
    const aiMesh& source = *scene->mMeshes[0];
    TriangleMesh mesh;
    for (unsigned v = 0; v < source.mNumVertices; ++v)
        mesh.vertices.emplace_back(source.mVertices[v].x, source.mVertices[v].y, source.mVertices[v].z);
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
        const aiFace& face = source.mFaces[f];
        mesh.triangles.push_back({static_cast<int>(face.mIndices[0]), static_cast<int>(face.mIndices[1]),
                                  static_cast<int>(face.mIndices[2])});
    }
    return mesh;
}

} // namespace core
