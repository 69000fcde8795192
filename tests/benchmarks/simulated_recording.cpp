// SPDX-License-Identifier: MIT
#include "tests/benchmarks/simulated_recording.h"

#include <algorithm>
#include <ctime>

#include "core/contour/rasteriser.h"
#include "core/contour/shaded_image.h"
#include "core/simulation/simulated_clicks.h"

namespace trial {

namespace {

constexpr std::size_t kKeptFrames = 20; ///< pictures of so many frames are kept

double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

core::Dataset withCameras(core::Dataset dataset, const RecordingOptions& options) {
    std::vector<core::Camera> chosen;
    const int count = options.views.empty() ? options.cameras : static_cast<int>(options.views.size());
    for (int i = 0; i < count; ++i) {
        const int index = options.views.empty() ? i * static_cast<int>(dataset.cameras.size()) / count
                                                : options.views[static_cast<std::size_t>(i)];
        core::Camera& camera = chosen.emplace_back(dataset.cameras.at(static_cast<std::size_t>(index)));
        if (i % 2 == 1)
            camera.intrinsics(0, 2) += options.asideShare * camera.size.width;
    }
    dataset.cameras = std::move(chosen);
    return dataset;
}

} // namespace

Recording::Recording(core::Dataset dataset, const std::string& sequence, const core::DetectorNetworks& networks,
                     const RecordingOptions& options)
    : m_dataset(withCameras(std::move(dataset), options))
    , m_options(options)
    , m_motion(core::readMotion(m_dataset, m_dataset.sequence(sequence)))
    , m_world(core::simulatedWorld(m_dataset.hands, m_dataset.cameras, options.imperfection, options.seed))
    , m_joints(core::annotatableJoints(m_dataset.hands))
    , m_detector(networks, m_dataset.cameras) {
    for (int frame = options.firstFrame;
         frame + 1 < static_cast<int>(m_motion.size()) && static_cast<int>(m_frames.size()) < options.mostFrames;
         frame += options.every)
        if (options.leastHidden <= 0 || std::max(hiddenShare(frame, core::Side::Left),
                                                 hiddenShare(frame, core::Side::Right)) >= options.leastHidden)
            m_frames.push_back(frame);
    for (const core::Camera& camera : m_world.cameras)
        m_rooms.push_back(options.hasClutter ? core::backgroundPicture(camera, options.seed)
                                             : core::renderShaded(camera, {}));
}

const std::vector<cv::Mat>& Recording::pictures(int frame) {
    if (const auto known = m_pictures.find(frame); known != m_pictures.end())
        return known->second;
    const double start = processorSeconds();
    core::PictureOptions take;
    take.exposureFrames = m_options.exposureFrames;
    take.exposures = m_options.exposureFrames > 0 ? 5 : 1;
    take.defocusPx = m_options.defocusPx;
    if (!m_options.hasClutter)
        take.readNoise = take.shotNoise = 0;
    std::vector<cv::Mat> pictures;
    for (std::size_t c = 0; c < m_world.cameras.size(); ++c)
        pictures.push_back(
            core::simulatedPicture(m_world, c, m_motion, frame, m_rooms[c], take, std::to_string(frame)));
    if (m_pictures.size() >= kKeptFrames)
        m_pictures.clear();
    m_drawingSeconds += processorSeconds() - start;
    return m_pictures[frame] = std::move(pictures);
}

core::FrameEvidence Recording::evidence(int frame) {
    core::FrameEvidence evidence;
    evidence.pictures = pictures(frame);
    return evidence;
}

core::ViewDetections Recording::detect(int frame, const core::KnownHands& known) {
    return m_detector.detect(pictures(frame), known);
}

Eigen::Vector3d Recording::truth(int frame, const core::JointId& joint) const {
    for (std::size_t h = 0; h < m_world.hands.size(); ++h) {
        const core::Skeleton& skeleton = m_world.hands[h].skeleton;
        if (m_world.hands[h].side == joint.hand)
            return core::jointPositions(skeleton,
                                        m_motion[static_cast<std::size_t>(frame)]
                                                [h])[static_cast<std::size_t>(skeleton.boneIndex(joint.joint))];
    }
    return Eigen::Vector3d::Zero();
}

double Recording::hiddenShare(int frame, core::Side side) const {
    const std::vector<core::HandModel>& hands = m_world.hands;
    const core::HandPoses& poses = m_motion[static_cast<std::size_t>(frame)];
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    std::vector<core::PosedSurface> surfaces;
    for (std::size_t h = 0; h < hands.size(); ++h)
        vertices.push_back(core::posedVertices(hands[h], poses[h]));
    for (std::size_t h = 0; h < hands.size(); ++h)
        surfaces.push_back({&vertices[h], &hands[h].mesh.triangles});
    if (hands.size() != 2)
        return 0;
    const std::size_t own = hands[0].side == side ? 0 : 1;
    const int left = static_cast<int>(hands[0].mesh.triangles.size());
    double sum = 0;
    int views = 0;
    for (const core::Camera& camera : m_world.cameras) {
        const int whole = cv::countNonZero(core::renderMask(camera, {surfaces[own]}));
        if (whole == 0)
            continue;
        const cv::Mat triangle = core::renderDepthWindow(camera, surfaces).image.triangle;
        const cv::Mat seen = own == 0 ? cv::Mat((triangle >= 0) & (triangle < left)) : cv::Mat(triangle >= left);
        sum += 1 - cv::countNonZero(seen) / static_cast<double>(whole);
        ++views;
    }
    return views > 0 ? sum / views : 0;
}

std::optional<Eigen::Vector2d> Recording::truePx(int frame, const core::JointId& joint, std::size_t camera) const {
    const auto px = core::project(m_world.cameras[camera], truth(frame, joint));
    return px && core::isInside(m_world.cameras[camera].size, *px) ? px : std::nullopt;
}

} // namespace trial
