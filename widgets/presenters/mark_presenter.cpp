// SPDX-License-Identifier: MIT
#include "widgets/presenters/mark_presenter.h"

#include <utility>

#include <algorithm>
#include <map>

#include <QLocale>

#include "core/geometry/epipolar_curve.h"
#include "widgets/presenters/camera_colours.h"
#include "widgets/presenters/joint_bones.h"
#include "widgets/text/advice.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

QPointF toPoint(const Eigen::Vector2d& px) {
    return {px.x(), px.y()};
}

bool isPlaced(const core::ViewReconstruction& view) {
    return view.mark && view.mark->isPlaced();
}

/// What a view draws of one joint, or nothing.
std::optional<ViewMark> markOf(const core::JointId& joint, const core::ViewReconstruction& view, bool proposals) {
    ViewMark mark;
    mark.joint = joint;
    mark.outlier = view.outlier;
    if (view.mark && view.mark->isProposal() && !view.reprojectionPx) { // a guess, as long as nothing better is known
        mark.px = toPoint(view.mark->px);
        mark.origin = MarkOrigin::Proposed;
        return proposals ? std::optional(mark) : std::nullopt;
    }
    if (isPlaced(view)) {
        mark.px = toPoint(view.mark->px);
        mark.origin = view.mark->placement == core::Placement::Manual ? MarkOrigin::Manual : MarkOrigin::Auto;
        mark.occluded = view.mark->state == core::MarkState::Occluded;
        if (view.reprojectionPx)
            mark.reprojectionPx = toPoint(*view.reprojectionPx);
        return mark;
    }
    const bool isUnplaceable = view.mark && !view.mark->hasPlace();
    if (isUnplaceable || !proposals || !view.reprojectionPx || !view.reprojectionInside)
        return std::nullopt;
    mark.px = toPoint(*view.reprojectionPx);
    mark.origin = MarkOrigin::Proposed;
    return mark;
}

/// How far the click in that camera is off another one's curve, where clicks give no point; else null.
const core::CurveGap* gapIn(const core::JointReconstruction& found, const std::string& camera) {
    const auto gap = std::find_if(found.gaps.begin(), found.gaps.end(),
                                  [&](const core::CurveGap& one) { return one.camera == camera; });
    return gap == found.gaps.end() ? nullptr : &*gap;
}

std::vector<SkeletonLine> skeletonOf(const std::vector<ViewMark>& marks) {
    std::vector<SkeletonLine> lines;
    for (const core::Side hand : {core::Side::Left, core::Side::Right}) {
        std::map<std::string, QPointF> places;
        std::vector<std::string> names;
        for (const ViewMark& mark : marks) {
            if (mark.joint.hand == hand) {
                places[mark.joint.joint] = mark.px;
                names.push_back(mark.joint.joint);
            }
        }
        for (const auto& [from, to] : jointBones(names))
            lines.push_back({places[from], places[to], fingerColour(to)});
    }
    return lines;
}

} // namespace

MarkPresenter::MarkPresenter(const JointList& joints, const Reconstructions& reconstructions,
                             const Selection& selection, CameraGrid& grid, SceneView* scene, QObject* parent)
    : QObject(parent)
    , m_joints(joints)
    , m_reconstructions(reconstructions)
    , m_selection(selection)
    , m_grid(grid)
    , m_scene(scene) {
    connect(&reconstructions, &Reconstructions::changed, this, &MarkPresenter::refresh);
    connect(&selection, &Selection::cameraChanged, this, &MarkPresenter::moveName);
}

void MarkPresenter::setDataset(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence) {
    m_dataset = std::move(dataset);
    m_sequence = sequence;
    refresh();
}

void MarkPresenter::setSkeletonShown(bool shown) {
    m_skeletonShown = shown;
    refresh();
}

void MarkPresenter::setGuidesShown(bool shown) {
    m_guidesShown = shown;
    refresh();
}

void MarkPresenter::setProposalsShown(bool shown) {
    m_proposalsShown = shown;
    refresh();
}

void MarkPresenter::setHandShown(core::Side hand, bool shown) {
    m_handShown[hand == core::Side::Left ? 0 : 1] = shown;
    refresh();
}

bool MarkPresenter::isShown(const core::JointId& joint) const {
    return m_handShown[joint.hand == core::Side::Left ? 0 : 1] || joint == m_selection.joint();
}

void MarkPresenter::refresh() {
    m_namedCamera = m_selection.camera();
    if (!m_dataset)
        return;
    for (int camera = 0; camera < m_grid.count(); ++camera)
        refreshView(camera);
    if (m_scene)
        refreshScene();
}

/// The selected joint is named beside its mark in the current view only.
void MarkPresenter::moveName() {
    const std::string before = std::exchange(m_namedCamera, m_selection.camera());
    for (int camera = 0; m_dataset && camera < m_grid.count(); ++camera) {
        const std::string& name = m_grid.view(camera)->camera().name;
        if (name == before || name == m_namedCamera)
            m_grid.view(camera)->setMarks(marksIn(camera));
    }
}

void MarkPresenter::refreshView(int camera) {
    CameraView* view = m_grid.view(camera);
    const std::vector<ViewMark> marks = marksIn(camera);
    view->setMarks(marks);
    view->setSkeleton(m_skeletonShown ? skeletonOf(marks) : std::vector<SkeletonLine>{});
    view->setEpipolarGuides(m_guidesShown ? guidesIn(camera) : std::vector<EpipolarGuide>{});
    view->setTitle(titleOf(camera));
    std::optional<UncertaintyEllipse> ellipse;
    std::optional<QPointF> focus;
    const auto& views = m_reconstructions.selected().views;
    if (camera < static_cast<int>(views.size())) {
        const core::ViewReconstruction& selected = views[static_cast<std::size_t>(camera)];
        if (selected.ellipse95)
            ellipse = UncertaintyEllipse{toPoint(selected.ellipse95->centrePx), selected.ellipse95->halfAxesPx.x(),
                                         selected.ellipse95->halfAxesPx.y(), selected.ellipse95->angleRad,
                                         fingerColour(m_selection.joint().joint)};
        if (selected.reprojectionPx)
            focus = toPoint(*selected.reprojectionPx);
    }
    view->setEllipse(ellipse);
    view->setGuideFocus(focus);
}

std::vector<ViewMark> MarkPresenter::marksIn(int camera) const {
    std::vector<ViewMark> marks;
    const auto add = [&](const core::JointId& joint, const core::JointReconstruction& found) {
        const bool isSelected = joint == m_selection.joint();
        const auto mark = markOf(joint, found.views[static_cast<std::size_t>(camera)], m_proposalsShown);
        if (!mark)
            return;
        marks.push_back(*mark);
        if (const core::CurveGap* gap = gapIn(found, found.views[static_cast<std::size_t>(camera)].camera)) {
            marks.back().curvePx = toPoint(gap->nearestPx);
            marks.back().outlier = true;
        }
        marks.back().selected = isSelected;
        marks.back().label = QString::fromStdString(joint.joint);
        marks.back().named = isSelected && m_grid.view(camera)->camera().name == m_selection.camera();
    };
    for (const auto& [joint, found] : m_reconstructions.joints())
        if (camera < static_cast<int>(found.views.size()) && isShown(joint))
            add(joint, found);
    return marks;
}

std::vector<EpipolarGuide> MarkPresenter::guidesIn(int camera) const {
    std::vector<EpipolarGuide> guides;
    const core::JointReconstruction& selected = m_reconstructions.selected();
    for (std::size_t other = 0; other < selected.views.size(); ++other) {
        const core::ViewReconstruction& view = selected.views[other];
        if (static_cast<int>(other) == camera || !isPlaced(view) || view.mark->placement != core::Placement::Manual)
            continue;
        EpipolarGuide guide;
        for (const Eigen::Vector2d& px : core::epipolarCurve(m_dataset->cameras[other], view.mark->px,
                                                             m_dataset->cameras[static_cast<std::size_t>(camera)]))
            guide.pointsPx.push_back(toPoint(px));
        guide.colour = cameraColour(static_cast<int>(other));
        if (guide.pointsPx.size() > 1)
            guides.push_back(std::move(guide));
    }
    return guides;
}

QString MarkPresenter::offsetText(const std::string& camera) const {
    if (!m_sequence)
        return {};
    const auto& views = m_sequence->views;
    const auto at = std::find_if(views.begin(), views.end(), [&](const auto& view) { return view.camera == camera; });
    if (at == views.end() || at->offsetFrames == 0)
        return {};
    return tr("%1%2 frames").arg(at->offsetFrames > 0 ? QStringLiteral("+") : QString()).arg(at->offsetFrames);
}

ViewTitle MarkPresenter::titleOf(int camera) const {
    const std::string& name = m_dataset->cameras[static_cast<std::size_t>(camera)].name;
    ViewTitle title;
    title.name = QString::fromStdString(name);
    title.detail = offsetText(name);
    title.colour = cameraColour(camera);
    const core::JointReconstruction& selected = m_reconstructions.selected();
    if (camera >= static_cast<int>(selected.views.size()))
        return title;
    const core::ViewReconstruction& view = selected.views[static_cast<std::size_t>(camera)];
    if (!view.hasPicture)
        title.detail = tr("no picture");
    const core::CurveGap* gap = gapIn(selected, name);
    if (view.mark && view.mark->state == core::MarkState::Unplaceable)
        title.error = tr("cannot be placed");
    else if (view.errorPx)
        title.error = tr("%1 px").arg(QLocale().toString(*view.errorPx, 'f', 1));
    else if (gap) {
        title.error = tr("%1 px").arg(QLocale().toString(gap->px, 'f', 1));
        title.detail = tr("off %1's curve").arg(QString::fromStdString(gap->curveOf));
    } else if (view.mark && view.mark->placement != core::Placement::Manual)
        title.error = view.mark->isPlaced() ? tr("accepted") : tr("proposed");
    title.warning = view.outlier || gap || (!selected.suspect.empty() && selected.suspect == name);
    if (advisedCamera(selected) == name)
        title.next = tr("click here next");
    return title;
}

void MarkPresenter::refreshScene() {
    std::vector<SceneJoint> joints;
    std::vector<SceneBone> bones;
    for (const core::Side hand : {core::Side::Left, core::Side::Right}) {
        std::map<std::string, Eigen::Vector3d> places;
        std::vector<std::string> names;
        for (const auto& [joint, found] : m_reconstructions.joints()) {
            if (joint.hand != hand || !found.hasPoint() || !isShown(joint))
                continue;
            const auto& point = *found.result.point;
            joints.push_back(
                {joint, point.pointInWorld, point.covariance, fingerColour(joint.joint), joint == m_selection.joint()});
            places[joint.joint] = point.pointInWorld;
            names.push_back(joint.joint);
        }
        for (const auto& [from, to] : jointBones(names))
            bones.push_back({places[from], places[to], fingerColour(to)});
    }
    m_scene->setJoints(joints);
    m_scene->setBones(m_skeletonShown ? bones : std::vector<SceneBone>{});
}

} // namespace widgets
