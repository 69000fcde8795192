// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_scene_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>

#include "core/geometry/camera.h"
#include "core/hand/skeleton.h"
#include "widgets/presenters/inspect/inspect_uncertainty.h"
#include "widgets/presenters/inspect/inspected_poses.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr double kRayPieceMm = 12;        ///< drawn of a viewing ray, to both sides of the place next to the hand
constexpr std::size_t kMostMatches = 160; ///< drawn per camera: more of them cannot be told apart
const QColor kRayColour(0x9A, 0xA0, 0xA6);

/// From the joints of the truth to those of the method.
void addDisplacements(const InspectOverlays::Scene& scene, const MethodOutcome& method, std::vector<SceneBone>& lines) {
    const core::HandPoses& poses = inspectedPosesAt(*scene.outcome, method, scene.iteration);
    const core::JointPositions& truth = scene.outcome->reference;
    for (const auto& [joint, estimate] : core::namedJointPositions(scene.dataset->hands, poses))
        if (const auto found = truth.find(joint); found != truth.end())
            lines.push_back({found->second, estimate, scaleColour((estimate - found->second).norm() / kErrorScaleMm)});
}

/// The vertex of the rim point's hand that lies nearest to its viewing ray: where it stands on the hand. Empty without
/// vertices.
std::optional<Eigen::Vector3d> nearestVertex(const MeshLayer& posed, core::Side hand, const core::PlueckerLine& ray) {
    std::optional<Eigen::Vector3d> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const ViewSurfacePtr& surface : posed.surfaces) {
        if (surface->side != hand)
            continue;
        for (const Eigen::Vector3d& vertex : surface->verticesInWorld) {
            const double distance = ray.offset(vertex).squaredNorm();
            if (distance < least) {
                least = distance;
                nearest = vertex;
            }
        }
    }
    return nearest;
}

void addMatchRays(const core::Camera& camera, const std::vector<core::HandModel>& hands, const ShownMatches& shown,
                  const MeshLayer& posed, std::vector<SceneBone>& lines) {
    std::vector<const core::MatchRecord*> kept;
    for (std::size_t i = 0; shown.matches && i < shown.matches->size(); ++i)
        if (const core::MatchRecord& match = (*shown.matches)[i];
            match.verdict == core::MatchVerdict::Kept && match.contourPoint >= 0 && match.hand < hands.size())
            kept.push_back(&match);
    const std::size_t step = std::max<std::size_t>(1, (kept.size() + kMostMatches - 1) / kMostMatches);
    for (std::size_t i = 0; i < kept.size(); i += step) {
        const core::MatchGeometry geometry = core::matchGeometry(*kept[i], shown.target->contour);
        const auto ofRim = core::viewingRay(camera, kept[i]->rimPx.cast<double>());
        const auto ofContour = core::viewingRay(camera, geometry.contourPx.cast<double>());
        const auto vertex = ofRim && ofContour ? nearestVertex(posed, hands[kept[i]->hand].side, *ofRim) : std::nullopt;
        if (!vertex)
            continue;
        const Eigen::Vector3d& along = ofContour->direction;
        const Eigen::Vector3d foot = ofContour->pointNearestOrigin() + vertex->dot(along) * along;
        lines.push_back({foot - kRayPieceMm * along, foot + kRayPieceMm * along, kRayColour});
        lines.push_back({*vertex, foot, scaleColour(static_cast<double>(geometry.residualPx) / kResidualScalePx)});
    }
}

void addEllipsoidAxes(const InspectOverlays::Scene& scene, const MethodOutcome& method, std::vector<SceneBone>& lines) {
    static const double kQuantile95 = std::sqrt(7.814728); // of chi squared with three degrees of freedom
    for (const JointUncertainty& joint : jointUncertainties(*scene.dataset, method)) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(joint.covarianceInWorld);
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d reach =
                kQuantile95 * std::sqrt(std::max(0.0, axes.eigenvalues()[axis])) * axes.eigenvectors().col(axis);
            lines.push_back({joint.pointInWorld - reach, joint.pointInWorld + reach, fingerColour(joint.joint.joint)});
        }
    }
}

} // namespace

std::vector<SceneBone> inspectSceneLines(const InspectOverlays::Scene& scene, std::size_t method,
                                         const std::set<InspectLayer>& shown) {
    std::vector<SceneBone> lines;
    if (!scene.outcome || !scene.dataset || !scene.poses || method >= scene.outcome->methods.size() ||
        method >= scene.poses->methods.size())
        return lines;
    const MethodOutcome& outcome = scene.outcome->methods[method];
    if (shown.count(InspectLayer::Error))
        addDisplacements(scene, outcome, lines);
    if (shown.count(InspectLayer::Matches))
        for (const int camera : scene.rowCameras)
            addMatchRays(scene.dataset->cameras[static_cast<std::size_t>(camera)], scene.dataset->hands,
                         shownMatches(outcome, camera, scene.iteration), scene.poses->methods[method], lines);
    if (shown.count(InspectLayer::Uncertainty) && isAtResult(outcome, scene.iteration))
        addEllipsoidAxes(scene, outcome, lines);
    return lines;
}

InspectSceneLines::InspectSceneLines(const InspectOverlays& overlays, const LayerPresenter& layers, SceneView& scene,
                                     JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_overlays(overlays)
    , m_layers(layers)
    , m_scene(scene)
    , m_job(pool) {
    connect(&overlays, &InspectOverlays::drawn, this, &InspectSceneLines::refresh);
    connect(&layers, &LayerPresenter::sceneChoicesChanged, this, &InspectSceneLines::refresh);
}

void InspectSceneLines::refresh() {
    const InspectOverlays::Scene& scene = m_overlays.scene();
    std::size_t method = 0;
    const std::size_t count = scene.outcome && m_layers.showsInspected() ? scene.outcome->methods.size() : 0;
    while (method < count && QString::fromStdString(scene.outcome->methods[method].method) != m_layers.sceneChoice())
        ++method;
    Source source{scene.outcome, scene.poses, scene.rowCameras, scene.iteration, method, {}};
    for (const InspectLayer layer : {InspectLayer::Error, InspectLayer::Matches, InspectLayer::Uncertainty})
        if (m_overlays.isShown(layer))
            source.shown.insert(layer);
    if (method == count || source.shown.empty())
        source = {};
    if (source == m_source)
        return;
    m_source = source;
    if (!source.outcome) {
        m_job.stop();
        setLines({});
        return;
    }
    m_job.start([this, scene, method, shown = source.shown](const JobContext&) -> Job::Delivery {
        return [this, lines = inspectSceneLines(scene, method, shown)] { setLines(lines); };
    });
}

/// The scene is drawn again only if something changes.
void InspectSceneLines::setLines(const std::vector<SceneBone>& lines) {
    if (lines.empty() && !m_hasLines)
        return;
    m_hasLines = !lines.empty();
    m_scene.setLayerLines(lines);
}

} // namespace widgets
