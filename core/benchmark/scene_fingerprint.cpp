// SPDX-License-Identifier: MIT
#include "core/benchmark/scene_fingerprint.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>

#include "core/fitting/fit_result.h"
#include "core/numeric/random.h"

namespace core {

namespace {

class Fingerprint {
public:
    void add(std::uint64_t value) { m_state = RandomGenerator(m_state ^ value).next(); }
    void add(int value) { add(static_cast<std::uint64_t>(value)); }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const std::string& text) { add(stableHash(text)); }

    template <typename Derived>
    void add(const Eigen::DenseBase<Derived>& values) {
        add(static_cast<int>(values.size()));
        for (Eigen::Index row = 0; row < values.rows(); ++row)
            for (Eigen::Index col = 0; col < values.cols(); ++col)
                add(static_cast<double>(values(row, col)));
    }

    std::string text() const {
        std::array<char, 17> digits{};
        std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(m_state));
        return digits.data();
    }

private:
    std::uint64_t m_state = 0;
};

void addHand(Fingerprint& fingerprint, const HandModel& hand) {
    fingerprint.add(std::string(sideName(hand.side)));
    for (const Eigen::Vector3d& vertex : hand.mesh.vertices)
        fingerprint.add(vertex);
    for (const Bone& bone : hand.skeleton.bones) {
        fingerprint.add(bone.name);
        fingerprint.add(bone.worldFromBoneAtRest.translation);
    }
    fingerprint.add(hand.skeleton.poseSize());
}

void addCamera(Fingerprint& fingerprint, const Camera& camera) {
    fingerprint.add(camera.name);
    fingerprint.add(camera.size.width);
    fingerprint.add(camera.size.height);
    fingerprint.add(camera.intrinsics);
    fingerprint.add(camera.cameraFromWorld.rotation);
    fingerprint.add(camera.cameraFromWorld.translation);
    for (const double coefficient : camera.distortion)
        fingerprint.add(coefficient);
}

void addSequence(Fingerprint& fingerprint, const BenchmarkSequence& sequence) {
    fingerprint.add(sequence.name);
    for (const HandPoses& poses : sequence.motion)
        for (const Pose& pose : poses)
            fingerprint.add(pose);
    for (const auto& [frame, joints] : sequence.annotatedJoints) {
        fingerprint.add(frame);
        for (const auto& [id, position] : joints) {
            fingerprint.add(id.joint);
            fingerprint.add(position);
        }
    }
}

} // namespace

std::string sceneFingerprint(const BenchmarkScene& scene) {
    Fingerprint fingerprint;
    for (const HandModel& hand : scene.hands)
        addHand(fingerprint, hand);
    for (const Camera& camera : scene.cameras)
        addCamera(fingerprint, camera);
    for (const BenchmarkSequence& sequence : scene.sequences)
        addSequence(fingerprint, sequence);
    fingerprint.add(kEstimatorRevision);
    return fingerprint.text();
}

} // namespace core
