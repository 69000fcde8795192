// SPDX-License-Identifier: MIT
#include "core/io/import/tzionas_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "core/error.h"
#include "core/io/files/text_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRootParent = "Root_NULL_Bone_0";
constexpr int kMostFrames = 10'000'000;

int indexOf(const std::vector<Bone>& bones, std::string_view name) {
    const auto found = std::find_if(bones.begin(), bones.end(), [&](const Bone& bone) { return bone.name == name; });
    return found == bones.end() ? -1 : static_cast<int>(found - bones.begin());
}

int knownBone(const std::vector<Bone>& bones, std::string_view name, const LineReader& lines) {
    const int index = indexOf(bones, name);
    if (index < 0)
        throw lines.errorHere("unknown bone name '" + std::string(name.substr(0, 40)) + "'");
    return index;
}

/// Names contain blanks and stand in one line: takes the longest known name at the front, again and again.
std::vector<int> splitBoneNames(std::string_view line, const std::vector<Bone>& bones, const LineReader& lines) {
    std::vector<int> order;
    while (!line.empty()) {
        int best = -1;
        for (std::size_t b = 0; b < bones.size(); ++b) {
            const std::string& name = bones[b].name;
            const bool isWord = line.starts_with(name) &&
                                (line.size() == name.size() || line[name.size()] == ' ' || line[name.size()] == '\t');
            if (isWord && (best < 0 || name.size() > bones[static_cast<std::size_t>(best)].name.size()))
                best = static_cast<int>(b);
        }
        if (best < 0 || std::find(order.begin(), order.end(), best) != order.end()) {
            throw lines.errorHere((best < 0 ? "unknown" : "repeated") + std::string(" bone name at '") +
                                  std::string(line.substr(0, 20)) + "'");
        }
        order.push_back(best);
        line.remove_prefix(bones[static_cast<std::size_t>(best)].name.size());
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    }
    return order;
}

/// Axis letters of LIMITS; Y bends, Z spreads, X twists.
constexpr std::array<const char*, 3> kAxisNames{"twist", "flexion", "abduction"};

/// One block of LIMITS after its name.
struct LimitsBlock {
    std::vector<double> flags;
    std::array<std::vector<double>, 3> axes, limits;
};

LimitsBlock readLimitsBlock(LineReader& lines) {
    LimitsBlock block;
    block.flags = lines.nextNumbers(4, "four flags");
    for (std::vector<double>& axis : block.axes)
        axis = lines.nextNumbers(3, "an axis");
    for (std::vector<double>& limit : block.limits) {
        limit = lines.nextNumbers(2, "two limits in degrees");
        if (limit[0] > limit[1])
            throw lines.errorHere("the lower limit is above the upper one");
    }
    return block;
}

void appendDofs(std::vector<DegreeOfFreedom>& dofs, const LimitsBlock& block, int bone, const std::string& jointName,
                const LineReader& lines) {
    for (std::size_t a = 0; a < 3; ++a) {
        if (block.flags[a + 1] == 0 || (block.limits[a][0] == 0 && block.limits[a][1] == 0))
            continue;
        const Eigen::Vector3d axis(block.axes[a][0], block.axes[a][1], block.axes[a][2]);
        if (axis.norm() < 1e-6)
            throw lines.errorHere("the axis of a free rotation is zero");
        constexpr double kRadPerDeg = std::numbers::pi / 180;
        dofs.push_back({jointName + "." + kAxisNames[a], bone, axis.normalized(), block.limits[a][0] * kRadPerDeg,
                        block.limits[a][1] * kRadPerDeg});
    }
}

/// The nine numbers from `first` on, row by row.
Eigen::Matrix3d rowMajor(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

} // namespace

SkelFile readSkel(const fs::path& file) {
    LineReader lines(file);
    SkelFile skel;
    skel.motionFrames = lines.nextInteger(1, kMostFrames, "the number of motion frames");
    while (!lines.atEnd()) {
        const std::string parent(lines.next("a parent's name"));
        Bone bone;
        if (parent != kRootParent)
            bone.parent = knownBone(skel.bones, parent, lines);
        if ((bone.parent < 0) != skel.bones.empty())
            throw lines.errorHere("exactly the first bone is the child of " + std::string(kRootParent));
        bone.name = lines.next("a bone's name");
        if (indexOf(skel.bones, bone.name) >= 0)
            throw lines.errorHere("the bone '" + bone.name + "' comes twice");
        bone.lengthMm = lines.nextNumbers(1, "a bone's length").front();
        if (bone.lengthMm < 0)
            throw lines.errorHere("a length is negative");
        skel.bones.push_back(bone);
    }
    if (skel.bones.empty())
        throw Error(ErrorCode::BadInput, file.string(), "", "holds no bones");
    return skel;
}

SkinWeights readSkin(const fs::path& file, const std::vector<Bone>& bones, std::size_t vertexCount) {
    LineReader lines(file);
    const int count = lines.nextInteger(1, 1000, "the number of bones");
    const std::vector<int> order = splitBoneNames(lines.next("the bones' names"), bones, lines);
    if (static_cast<int>(order.size()) != count || order.size() != bones.size()) {
        throw lines.errorHere(std::to_string(order.size()) + " names, but " + std::to_string(count) +
                              " announced and " + std::to_string(bones.size()) + " in the skeleton");
    }
    SkinWeights weights;
    weights.firstEntry.push_back(0);
    for (std::size_t v = 0; v < vertexCount; ++v) {
        const std::vector<double> row = lines.nextNumbers(order.size(), "the weights of vertex " + std::to_string(v));
        double sum = 0;
        for (const double weight : row)
            sum += weight;
        if (*std::min_element(row.begin(), row.end()) < 0 || std::abs(sum - 1) > 0.01) {
            throw lines.errorHere("the weights of a vertex must be positive and sum to 1, not to " +
                                  std::to_string(sum));
        }
        for (std::size_t i = 0; i < row.size(); ++i)
            if (row[i] > 0)
                weights.entries.push_back({order[i], row[i] / sum});
        weights.firstEntry.push_back(static_cast<int>(weights.entries.size()));
    }
    if (!lines.atEnd()) {
        throw Error(ErrorCode::BadInput, file.string(), "",
                    "holds more rows than the mesh has vertices (" + std::to_string(vertexCount) + ")");
    }
    return weights;
}

std::vector<DegreeOfFreedom> readLimits(const fs::path& file, const std::vector<Bone>& bones) {
    LineReader lines(file);
    std::vector<DegreeOfFreedom> dofs;
    std::set<int> seen;
    while (!lines.atEnd()) {
        const int bone = knownBone(bones, lines.next("a bone's name"), lines);
        if (!seen.insert(bone).second)
            throw lines.errorHere("the bone comes twice");
        const LimitsBlock block = readLimitsBlock(lines);
        const std::string& name = bones[static_cast<std::size_t>(bone)].name;
        if (bone > 0) // the root's block stands for the six rigid ones
            appendDofs(dofs, block, bone, standardJointName(name).value_or(name), lines);
    }
    if (seen.size() != bones.size()) {
        throw Error(ErrorCode::BadInput, file.string(), "",
                    std::to_string(seen.size()) + " bones, but the skeleton has " + std::to_string(bones.size()));
    }
    std::stable_sort(dofs.begin(), dofs.end(),
                     [](const DegreeOfFreedom& a, const DegreeOfFreedom& b) { return a.bone < b.bone; });
    return dofs;
}

std::vector<std::vector<RigidMotion>> readMotionTable(const fs::path& file, const std::vector<Bone>& bones,
                                                      int frames) {
    LineReader lines(file);
    const auto frameCount = static_cast<std::size_t>(frames);
    std::vector<std::vector<RigidMotion>> worldFromBone(frameCount, std::vector<RigidMotion>(bones.size()));
    std::set<int> seen;
    while (!lines.atEnd()) {
        const int bone = knownBone(bones, lines.next("a bone's name"), lines);
        if (!seen.insert(bone).second)
            throw lines.errorHere("the bone comes twice");
        for (std::size_t f = 0; f < frameCount; ++f) {
            const std::vector<double> row =
                lines.nextNumbers(12, "a pose of " + bones[static_cast<std::size_t>(bone)].name);
            const std::optional<Eigen::Matrix3d> rotation = nearestRotation(rowMajor(row), 1e-2);
            if (!rotation)
                throw lines.errorHere("the first nine numbers are not a rotation");
            worldFromBone[f][static_cast<std::size_t>(bone)] = {*rotation, {row[9], row[10], row[11]}};
        }
    }
    if (seen.size() != bones.size()) {
        throw Error(ErrorCode::BadInput, file.string(), "",
                    std::to_string(seen.size()) + " bones, but the skeleton has " + std::to_string(bones.size()));
    }
    return worldFromBone;
}

std::optional<std::string> standardJointName(std::string_view boneName) {
    if (boneName == "Lower Arm L" || boneName == "Lower Arm R")
        return "forearm";
    static constexpr std::array<const char*, 5> kFingers{"little", "ring", "middle", "index", "thumb"};
    static constexpr std::array<std::string_view, 4> kParts{"Hand", "0", "1", "2"};
    static constexpr std::array<const char*, 4> kFingerJoints{"cmc", "mcp", "pip", "dip"},
        kThumbJoints{"cmc", "mcp", "ip", nullptr};
    const bool isFinger =
        (boneName.starts_with("LFing.") || boneName.starts_with("RFing.")) && boneName.size() > 8 && boneName[7] == '_';
    const int finger = isFinger ? boneName[6] - '0' : -1;
    if (finger < 0 || finger > 4)
        return std::nullopt;
    const auto part = std::find(kParts.begin(), kParts.end(), boneName.substr(8));
    const auto& joints = finger == 4 ? kThumbJoints : kFingerJoints;
    const char* joint = part == kParts.end() ? nullptr : joints[static_cast<std::size_t>(part - kParts.begin())];
    return joint == nullptr ? std::nullopt
                            : std::optional(std::string(kFingers[static_cast<std::size_t>(finger)]) + "_" + joint);
}

} // namespace core
