// SPDX-License-Identifier: MIT
#include "core/annotation/quality_checker.h"

#include <algorithm>
#include <cmath>

#include "core/annotation/bone_lengths.h"
#include "core/annotation/shape_checks.h"
#include "core/fitting/joint_fit.h"
#include "core/text/number_text.h"

namespace core {

namespace {

constexpr int kNearFrames = 10; ///< so far back the annotated frame before tells whether hands were exchanged

/// What one frame is checked with.
struct FrameCheck {
    const AnnotationSet& set;
    int frame;
    const std::string& rater;
    const std::map<JointId, JointReconstruction>& joints;
    const JointPoints& points;
    const QualityOptions& options;
    std::vector<QualityFinding>& findings;

    void report(const JointId& joint, QualityKind kind, double value, const std::string& text,
                const std::string& camera = "") const {
        findings.push_back({frame, joint, kind, value, text, camera});
    }
};

/// Clicks that give no point: how far they are off each other's curves, if that can be said.
void reportNoPoint(const FrameCheck& check, const JointId& id, const JointReconstruction& joint) {
    const std::string text = jointLabel(id) + ": no point from " + std::to_string(joint.manualViews) + " views: ";
    if (joint.gaps.empty()) {
        check.report(id, QualityKind::Disagreement, 0, text + std::string(failureText(joint.result.failure)));
        return;
    }
    const CurveGap& gap = joint.gaps.front();
    check.report(id, QualityKind::Disagreement, gap.px,
                 text + "the click in " + gap.camera + " is " + fixedText(gap.px, 1) + " px off " + gap.curveOf +
                     "'s curve",
                 gap.camera);
    check.findings.back().curveOf = gap.curveOf;
}

void checkDisagreement(const FrameCheck& check) {
    for (const auto& [id, joint] : check.joints) {
        if (!joint.hasPoint() && joint.manualViews >= 2)
            reportNoPoint(check, id, joint);
        for (const ViewReconstruction& view : joint.views) {
            if (view.outlier) {
                const double error = view.errorPx.value_or(0);
                check.report(id, QualityKind::Disagreement, error,
                             jointLabel(id) + ": the click in " + view.camera + " is " + fixedText(error, 1) +
                                 " px off the other views",
                             view.camera);
            }
        }
    }
}

/// Where the joint's point lies in a view.
std::optional<Eigen::Vector2d> reprojection(const FrameCheck& check, const JointId& joint, const std::string& camera) {
    for (const ViewReconstruction& view : check.joints.at(joint).views)
        if (view.camera == camera)
            return view.reprojectionPx;
    return std::nullopt;
}

/// True if two joints lie behind each other in that view, going by all views: then one pixel is right for both.
bool coverEachOther(const FrameCheck& check, const JointId& a, const JointId& b, const std::string& camera) {
    const auto pxA = reprojection(check, a, camera), pxB = reprojection(check, b, camera);
    double sigmaPx = check.options.triangulation.sigmaPx;
    for (const double ofCamera : check.options.triangulation.sigmaPxByCamera)
        sigmaPx = std::max(sigmaPx, ofCamera);
    const double gate = check.options.sharedPixelPx + check.options.triangulation.outlierFactor * sigmaPx;
    return pxA && pxB && (*pxA - *pxB).norm() < gate;
}

/// Marks that lie where no picture is: proposals are none of the rater's.
void checkOutside(const FrameCheck& check, const std::vector<Camera>& cameras) {
    for (const auto& [id, joint] : check.joints) {
        for (std::size_t i = 0; i < joint.views.size(); ++i) {
            const ViewReconstruction& view = joint.views[i];
            if (!view.outside || view.mark->isProposal())
                continue;
            const Eigen::Vector2d last(cameras[i].size.width - 1.0, cameras[i].size.height - 1.0);
            const double distance = (view.mark->px - view.mark->px.cwiseMax(0).cwiseMin(last)).norm();
            check.report(id, QualityKind::OutsidePicture, distance,
                         jointLabel(id) + ": the mark in " + view.camera + " lies " + fixedText(distance, 0) +
                             " px outside the picture",
                         view.camera);
        }
    }
}

bool isOutsideItsView(const FrameCheck& check, const MarkKey& key) {
    const std::vector<ViewReconstruction>& views = check.joints.at(key.joint).views;
    return std::any_of(views.begin(), views.end(),
                       [&](const ViewReconstruction& view) { return view.camera == key.camera && view.outside; });
}

void checkSharedPixels(const FrameCheck& check) {
    std::map<std::string, std::vector<std::pair<JointId, Eigen::Vector2d>>> byCamera;
    for (const auto& [key, mark] : marksOfFrame(check.set, check.frame, check.rater))
        if (mark.isEvidence() && !isOutsideItsView(check, key))
            byCamera[key.camera].emplace_back(key.joint, mark.px);
    for (const auto& [camera, marks] : byCamera) {
        for (std::size_t i = 0; i < marks.size(); ++i) {
            for (std::size_t j = i + 1; j < marks.size(); ++j) {
                const double distance = (marks[i].second - marks[j].second).norm();
                if (distance < check.options.sharedPixelPx &&
                    !coverEachOther(check, marks[i].first, marks[j].first, camera)) {
                    check.report(marks[j].first, QualityKind::SharedPixel, distance,
                                 jointLabel(marks[j].first) + " and " + jointLabel(marks[i].first) +
                                     " are on one pixel in " + camera,
                                 camera);
                }
            }
        }
    }
}

/// Bends a hand model without limits onto the joints and compares.
void checkAngles(const FrameCheck& check, const HandModel& hand) {
    std::vector<JointTarget> targets;
    for (const auto& [id, point] : check.points) {
        const int bone = id.hand == hand.side ? hand.skeleton.boneIndex(id.joint) : -1;
        if (bone >= 0)
            targets.push_back({bone, point.pointInWorld, point.covariance});
    }
    JointFitOptions free;
    free.withLimits = false;
    Pose start = hand.skeleton.restPose();
    for (std::size_t d = 0; d < hand.skeleton.dofs.size(); ++d) {
        start[kRigidDofs + static_cast<Eigen::Index>(d)] =
            std::clamp(0.0, hand.skeleton.dofs[d].minRad, hand.skeleton.dofs[d].maxRad);
    }
    const auto fit = fitPoseToJoints(hand.skeleton, targets, start, free);
    for (std::size_t d = 0; fit && d < hand.skeleton.dofs.size(); ++d) {
        const DegreeOfFreedom& dof = hand.skeleton.dofs[d];
        const double angle = fit->pose[kRigidDofs + static_cast<Eigen::Index>(d)];
        const double beyondDeg = std::max(dof.minRad - angle, angle - dof.maxRad) * 180 / M_PI;
        if (beyondDeg > check.options.angleToleranceDeg) {
            const std::string joint = hand.skeleton.bones[static_cast<std::size_t>(dof.bone)].name;
            check.report({hand.side, joint}, QualityKind::JointAngle, beyondDeg,
                         dof.name + " would be " + fixedText(angle * 180 / M_PI, 0) + " degrees, " +
                             fixedText(beyondDeg, 0) + " beyond its limit");
        }
    }
}

/// Joints of a frame with a 3D point.
JointPoints pointsOf(const std::map<JointId, JointReconstruction>& joints) {
    JointPoints points;
    for (const auto& [id, joint] : joints)
        if (joint.hasPoint())
            points.emplace(id, *joint.result.point);
    return points;
}

} // namespace

QualityChecker::QualityChecker(std::vector<Camera> cameras, std::vector<HandModel> hands, std::string rater,
                               QualityOptions options)
    : m_cameras(std::move(cameras))
    , m_hands(std::move(hands))
    , m_rater(std::move(rater))
    , m_options(std::move(options)) {}

void QualityChecker::check(const AnnotationSet& set, int frame) {
    m_points.erase(frame);
    m_markFindings.erase(frame);
    if (marksOfFrame(set, frame, m_rater).empty())
        return;
    const auto joints =
        reconstructFrame(set, m_cameras, frame, m_rater, {m_options.triangulation, false, std::nullopt});
    const JointPoints points = pointsOf(joints);
    std::vector<QualityFinding>& findings = m_markFindings[frame];
    const FrameCheck check{set, frame, m_rater, joints, points, m_options, findings};
    checkDisagreement(check);
    checkOutside(check, m_cameras);
    checkSharedPixels(check);
    for (const HandModel& hand : m_hands)
        checkAngles(check, hand);
    if (!points.empty())
        m_points[frame] = points;
}

std::vector<QualityFinding> QualityChecker::findings() const {
    const BoneLengths lengths = medianBoneLengths(m_points, m_options.leastFramesForMedian);
    std::vector<QualityFinding> all;
    for (const auto& [frame, findings] : m_markFindings) {
        all.insert(all.end(), findings.begin(), findings.end());
        const auto here = m_points.find(frame);
        if (here != m_points.end()) {
            const bool hasNear = here != m_points.begin() && frame - std::prev(here)->first <= kNearFrames;
            checkShape(frame, here->second, lengths, hasNear ? &std::prev(here)->second : nullptr, m_options, all);
        }
    }
    return all;
}

std::vector<QualityFinding> checkSequence(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                          const std::string& rater, const std::vector<HandModel>& hands,
                                          const QualityOptions& options) {
    QualityChecker checker(cameras, hands, rater, options);
    for (const int frame : annotatedFrames(set))
        checker.check(set, frame);
    return checker.findings();
}

} // namespace core
