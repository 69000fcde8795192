// SPDX-License-Identifier: MIT
#include "core/simulation/simulated_clicks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/annotation/edits.h"
#include "core/contour/rasteriser.h"
#include "core/numeric/normal.h"

namespace core {

namespace {

constexpr double kNearestWrongPx = 20, kFarthestWrongPx = 80;

/// A joint as the annotator looks for it.
struct TrueJoint {
    JointId id;
    Eigen::Vector3d pointInWorld;
    double depthInHandMm = 0; ///< how far below the skin it lies
};

/// Which joints of a frame cannot be seen from a camera: something lies farther before them than their own finger is
/// thick.
class Occlusion {
public:
    Occlusion(const SimulatedWorld& world, const std::vector<std::vector<Eigen::Vector3d>>& vertices) {
        std::vector<PosedSurface> surfaces;
        for (std::size_t h = 0; h < world.hands.size(); ++h)
            surfaces.push_back({&vertices[h], &world.hands[h].mesh.triangles});
        for (const Camera& camera : world.cameras)
            m_depth.push_back(renderDepthWindow(camera, surfaces));
    }

    bool hides(const Camera& camera, std::size_t index, const TrueJoint& joint, const Eigen::Vector2d& px) const {
        const DepthWindow& depth = m_depth[index];
        const cv::Point at(static_cast<int>(std::lround(px.x())), static_cast<int>(std::lround(px.y())));
        if (!depth.window.contains(at))
            return false;
        const double before =
            (camera.cameraFromWorld * joint.pointInWorld).z() - depth.image.depthMm.at<float>(at - depth.window.tl());
        constexpr double kSlackMm = 4;
        return before > 2 * joint.depthInHandMm + kSlackMm;
    }

private:
    std::vector<DepthWindow> m_depth;
};

double depthBelow(const std::vector<Eigen::Vector3d>& vertices, const Eigen::Vector3d& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& v : vertices)
        nearest = std::min(nearest, (v - point).squaredNorm());
    return std::sqrt(nearest);
}

/// Applies an edit and keeps it.
void keep(AnnotationSet& set, SimulatedClicks& clicks, Edit edit) {
    apply(set, edit);
    clicks.edits.push_back(std::move(edit));
}

/// One annotator at one frame.
class Annotator {
public:
    Annotator(AnnotationSet& set, const AnnotatorOptions& options, std::uint64_t seed)
        : m_set(set)
        , m_options(options)
        , m_random(seed) {}

    void click(const MarkKey& key, const Eigen::Vector2d& px, bool isHidden) {
        if (isHidden && m_random.uniform() >= m_options.guessedShare) {
            cannotPlace(key);
            return;
        }
        const double sigma = isHidden ? m_options.guessNoisePx : m_options.noisePx;
        Eigen::Vector2d clicked = px;
        clicked.x() += sigma * standardNormal(m_random);
        clicked.y() += sigma * standardNormal(m_random);
        if (m_options.wrongShare > 0 && m_random.uniform() < m_options.wrongShare) {
            const double angle = 2 * std::numbers::pi * m_random.uniform();
            const double farPx = kNearestWrongPx + (kFarthestWrongPx - kNearestWrongPx) * m_random.uniform();
            clicked += farPx * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            m_clicks.wrong.push_back(key);
        }
        keep(m_set, m_clicks, placeEdit(m_set, key, clicked));
        ++m_clicks.placed;
        if (isHidden) {
            keep(m_set, m_clicks, stateEdit(m_set, key, MarkState::Occluded));
            ++m_clicks.occluded;
        }
    }

    void cannotPlace(const MarkKey& key) {
        keep(m_set, m_clicks, stateEdit(m_set, key, MarkState::Unplaceable));
        ++m_clicks.unplaceable;
    }

    SimulatedClicks result() { return std::move(m_clicks); }

private:
    AnnotationSet& m_set;
    const AnnotatorOptions& m_options;
    RandomGenerator m_random;
    SimulatedClicks m_clicks;
};

} // namespace

std::vector<JointId> annotatableJoints(const std::vector<HandModel>& hands) {
    std::vector<JointId> joints;
    const auto collect = [&](const HandModel& hand, bool all) {
        for (const Bone& bone : hand.skeleton.bones) {
            const auto ends = [&](const char* suffix) { return bone.name.ends_with(suffix); };
            if (all || ends("_mcp") || ends("_pip") || ends("_dip") || ends("_ip"))
                joints.push_back({hand.side, bone.name});
        }
    };
    for (const HandModel& hand : hands) {
        const std::size_t before = joints.size();
        collect(hand, false);
        if (joints.size() == before)
            collect(hand, true);
    }
    return joints;
}

SimulatedClicks annotateFrame(AnnotationSet& set, const SimulatedWorld& world, const HandPoses& poses, int frame,
                              const std::string& sequence, const AnnotatorOptions& options) {
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    std::vector<TrueJoint> joints;
    for (std::size_t h = 0; h < world.hands.size(); ++h) {
        const HandModel& hand = world.hands[h];
        const std::vector<Eigen::Vector3d> points = jointPositions(hand.skeleton, poses[h]);
        vertices.push_back(posedVertices(hand, poses[h]));
        for (const JointId& id : annotatableJoints({hand})) {
            const Eigen::Vector3d& point = points[static_cast<std::size_t>(hand.skeleton.boneIndex(id.joint))];
            joints.push_back({id, point, options.seesOcclusion ? depthBelow(vertices.back(), point) : 0});
        }
    }
    std::optional<Occlusion> occlusion;
    if (options.seesOcclusion)
        occlusion.emplace(world, vertices);
    Annotator annotator(set, options, drawSeed(world.seed, "clicks/" + sequence + "/" + std::to_string(frame)));
    for (const TrueJoint& joint : joints) {
        for (std::size_t c = 0; c < world.cameras.size(); ++c) {
            const Camera& camera = world.cameras[c];
            const MarkKey key{frame, options.rater, joint.id, camera.name};
            const auto px = project(camera, joint.pointInWorld);
            if (!px || !isInside(camera.size, *px))
                annotator.cannotPlace(key);
            else
                annotator.click(key, *px, occlusion && occlusion->hides(camera, c, joint, *px));
        }
    }
    return annotator.result();
}

} // namespace core
