// SPDX-License-Identifier: MIT
#include "core/benchmark/realism_scene.h"

#include <algorithm>
#include <memory>
#include <set>

#include <Eigen/Geometry>

#include "core/annotation/sequence_points.h"
#include "core/error.h"
#include "core/rig/click_sigma_estimate.h"
#include "core/rig/rig_refinement.h"
#include "core/simulation/simulated_clicks.h"
#include "core/subject/subject_estimate.h"

namespace core {

namespace {

constexpr int kAdaptedFrames = 5;

std::string frameName(const BenchmarkSequence& sequence, int frame) {
    return sequence.name + "/" + std::to_string(frame);
}

/// Frames of the scene, evenly drawn over all of its sequences: sequence and frame.
std::vector<std::pair<std::size_t, int>> evenlyDrawn(const BenchmarkScene& scene, int count) {
    std::vector<std::pair<std::size_t, int>> all, drawn;
    for (std::size_t s = 0; s < scene.sequences.size(); ++s)
        for (int frame = 0; frame < static_cast<int>(scene.sequences[s].motion.size()); ++frame)
            all.emplace_back(s, frame);
    for (int k = 0; k < count && !all.empty(); ++k)
        drawn.push_back(all[all.size() * static_cast<std::size_t>(2 * k + 1) / static_cast<std::size_t>(2 * count)]);
    return drawn;
}

/// One simulated world and the scene that a lab would have of it.
class Simulation {
public:
    Simulation(const BenchmarkScene& clean, const RealismSetting& setting, std::uint64_t seed)
        : m_clean(clean)
        , m_setting(setting)
        , m_world(std::make_shared<SimulatedWorld>(simulatedWorld(clean.hands, clean.cameras, setting.world, seed)))
        , m_scene{clean.hands, clean.cameras, {}} {}

    BenchmarkScene scene(const std::vector<FramePair>& pairs, const std::stop_token& stop) {
        if (m_setting.isAdapted)
            adapt(stop);
        for (const BenchmarkSequence& sequence : m_clean.sequences) {
            const auto motion = std::make_shared<Motion>(sequence.motion);
            m_scene.sequences.push_back({sequence.name, sequence.motion, {}, {}});
            m_scene.sequences.back().masks = [world = m_world, motion, name = sequence.name](int frame) {
                return simulatedMasks(*world, (*motion)[static_cast<std::size_t>(frame)],
                                      name + "/" + std::to_string(frame));
            };
            for (const FramePair& pair : pairs)
                if (pair.sequence == sequence.name)
                    m_scene.sequences.back().annotatedJoints[pair.test];
        }
        if (m_setting.isClicked)
            findClickedJoints();
        else
            findTrueJoints();
        if (!m_setting.isClicked && m_setting.world.rig != RigError{})
            moveToScene();
        return std::move(m_scene);
    }

private:
    const HandPoses& poses(const BenchmarkSequence& sequence, int frame) const {
        if (frame < 0 || frame >= static_cast<int>(sequence.motion.size())) {
            throw Error(ErrorCode::BadInput, "", "pairs",
                        frameName(sequence, frame) + ": the sequence has no such frame");
        }
        return sequence.motion[static_cast<std::size_t>(frame)];
    }

    AnnotationSet clicks(const BenchmarkSequence& sequence, int frame) const {
        AnnotationSet set;
        annotateFrame(set, *m_world, poses(sequence, frame), frame, sequence.name, {});
        return set;
    }

    /// What a lab takes for the truth: points of clicks, which count by the sigmas that all of them show.
    void findClickedJoints() {
        std::vector<std::map<int, AnnotationSet>> sets;
        std::vector<RigJoint> joints;
        for (std::size_t s = 0; s < m_scene.sequences.size(); ++s) {
            sets.emplace_back();
            for (const auto& [frame, none] : m_scene.sequences[s].annotatedJoints) {
                const auto& added = sets.back()[frame] = clicks(m_scene.sequences[s], frame);
                addRigJoints(joints, added, m_scene.cameras, static_cast<int>(s));
            }
        }
        const ClickSigmas sigmas = estimateClickSigmas(m_scene.cameras, joints);
        for (std::size_t s = 0; s < sets.size(); ++s)
            for (const auto& [frame, set] : sets[s])
                m_scene.sequences[s].annotatedJoints[frame] = meanJointPoints(set, m_scene.cameras, frame, sigmas);
    }

    void findTrueJoints() {
        for (BenchmarkSequence& sequence : m_scene.sequences)
            for (auto& [frame, joints] : sequence.annotatedJoints)
                joints = trueJoints(sequence, frame);
    }

    JointPositions trueJoints(const BenchmarkSequence& sequence, int frame) const {
        const JointPositions all = namedJointPositions(m_world->hands, poses(sequence, frame));
        JointPositions joints;
        for (const JointId& id : annotatableJoints(m_world->hands))
            joints.emplace(id, all.at(id));
        return joints;
    }

    /// Where the scene's cameras place a point that the world's cameras see without noise.
    std::optional<Eigen::Vector3d> asSeen(const Eigen::Vector3d& point) const {
        std::vector<Observation> views;
        for (std::size_t c = 0; c < m_world->cameras.size(); ++c)
            if (const auto px = project(m_world->cameras[c], point))
                views.push_back({static_cast<int>(c), *px, 0});
        return refinePoint(m_scene.cameras, views, point);
    }

    /// A calibration that is off has a world of its own: the true joints are moved there as one rigid body.
    void moveToScene() {
        std::vector<Eigen::Vector3d> from, to;
        for (const BenchmarkSequence& sequence : m_scene.sequences) {
            for (const auto& [frame, joints] : sequence.annotatedJoints) {
                for (const auto& [id, point] : joints) {
                    if (const auto seen = asSeen(point)) {
                        from.push_back(point);
                        to.push_back(*seen);
                    }
                }
            }
        }
        constexpr std::size_t kLeast = 3;
        if (from.size() < kLeast)
            return;
        const auto count = static_cast<Eigen::Index>(from.size());
        const Eigen::Matrix4d move = Eigen::umeyama(Eigen::Map<const Eigen::Matrix3Xd>(from[0].data(), 3, count),
                                                    Eigen::Map<const Eigen::Matrix3Xd>(to[0].data(), 3, count), false);
        for (BenchmarkSequence& sequence : m_scene.sequences)
            for (auto& [frame, joints] : sequence.annotatedJoints)
                for (auto& [id, point] : joints)
                    point = move.topLeftCorner<3, 3>() * point + move.topRightCorner<3, 1>();
    }

    /// What a lab does with the clicks of a few frames: refines its rig, then measures the hands.
    void adapt(const std::stop_token& stop) {
        const auto frames = evenlyDrawn(m_clean, kAdaptedFrames);
        std::vector<AnnotationSet> sets;
        std::vector<RigJoint> joints;
        for (const auto& [s, frame] : frames) {
            sets.push_back(clicks(m_clean.sequences[s], frame));
            addRigJoints(joints, sets.back(), m_clean.cameras, static_cast<int>(s));
        }
        if (const auto refined = refineRig(m_clean.cameras, joints, {}, stop))
            m_scene.cameras = refined->cameras;
        const TriangulationOptions options =
            estimateClickSigmas(m_scene.cameras, joints).optionsFor(AnnotatorOptions{}.rater);
        std::vector<SubjectFrame> known;
        for (std::size_t i = 0; i < frames.size(); ++i)
            known.push_back(subjectFrame(m_clean.sequences[frames[i].first], frames[i].second, sets[i], options));
        const SubjectResult subject = estimateSubject(m_scene.hands, m_scene.cameras, known, {}, stop);
        for (std::size_t h = 0; h < subject.hands.size(); ++h)
            m_scene.hands[h] = subject.hands[h].hand;
    }

    SubjectFrame subjectFrame(const BenchmarkSequence& sequence, int frame, const AnnotationSet& set,
                              const TriangulationOptions& options) const {
        const SequencePoints points = sequencePoints(set, m_scene.cameras, AnnotatorOptions{}.rater, options);
        SubjectFrame known;
        for (const HandModel& hand : m_scene.hands) {
            auto& targets = known.targets.emplace_back();
            if (!points.contains(frame))
                continue;
            for (const auto& [id, point] : points.at(frame)) {
                const int bone = hand.skeleton.boneIndex(id.joint);
                if (id.hand == hand.side && bone >= 0)
                    targets.push_back({bone, point.pointInWorld, point.covariance});
            }
        }
        known.outlines = makeFitTargets(
            m_scene.cameras, simulatedMasks(*m_world, poses(sequence, frame), frameName(sequence, frame)), {}, 1);
        return known;
    }

    const BenchmarkScene& m_clean;
    const RealismSetting& m_setting;
    std::shared_ptr<const SimulatedWorld> m_world;
    BenchmarkScene m_scene;
};

} // namespace

BenchmarkScene realismScene(const BenchmarkScene& clean, const RealismSetting& setting,
                            const std::vector<FramePair>& pairs, std::uint64_t seed, std::stop_token stop) {
    return Simulation(clean, setting, seed).scene(pairs, stop);
}

} // namespace core
