// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/annotation/annotation_set.h"
#include "core/annotation/curve_gap.h"
#include "core/annotation/picture_gaps.h"
#include "core/geometry/camera.h"
#include "core/geometry/triangulation.h"

namespace core {

/// How far a joint is annotated. Done: every view is placed or unplaceable. Partial: some are. None: no view is.
/// Proposals do not count, and views without a picture need no mark.
enum class JointStatus { None, Partial, Done };
std::string_view statusName(JointStatus status); ///< "none", "partial", "done"

/// An ellipse in the image: half axes in px (long one first) and the long axis' angle from x towards y (down), rad.
struct PixelEllipse {
    Eigen::Vector2d centrePx = Eigen::Vector2d::Zero();
    Eigen::Vector2d halfAxesPx = Eigen::Vector2d::Zero();
    double angleRad = 0;
};

/// What one view says of a joint. Residuals exist for manual placed marks only: an accepted reprojection is not
/// evidence.
struct ViewReconstruction {
    std::string camera;
    std::optional<Mark> mark; ///< nothing, or a proposal: not done yet
    bool outside = false;     ///< the mark lies outside the image: it cannot have been seen there and does not count
    std::optional<Eigen::Vector2d> reprojectionPx; ///< the joint's point in this view, recorded pixels; may lie outside
    bool reprojectionInside = false;               ///< the reprojection lies within the image
    std::optional<double> errorPx;                 ///< manual mark to reprojection
    bool outlier = false;                          ///< errorPx is above outlierFactor * sigmaPx: not used
    std::optional<double> leaveOneOutPx;   ///< manual mark to the point found without it; needs two other inliers
    std::optional<PixelEllipse> ellipse95; ///< projection of the 95 % ellipsoid of the covariance
    bool hasPicture = true;                ///< false where the camera has no picture: no mark is expected
};

/// A view worth clicking next.
struct NextView {
    std::string camera;
    double predictedSigmaMm = 0; ///< sigmaMm of the covariance after one more click of sigmaPx there
};

/// True if the mark has a place and that place lies outside the camera's image.
bool isOutside(const Mark& mark, const Camera& camera);
/// A manual mark within the camera's image: what may enter triangulation and residuals.
bool isEvidenceIn(const Mark& mark, const Camera& camera);

/// One joint of one frame from the marks of one rater.
struct JointReconstruction {
    /// From the manual marks only; `reason` when there is no point. A joint without any that was proposed by a program
    /// and accepted as it stood has the point that was accepted (isAccepted).
    TriangulationResult result;
    std::vector<ViewReconstruction> views; ///< one per camera, in the cameras' order
    JointStatus status = JointStatus::None;
    std::vector<NextView> nextViews; ///< views without a click that would see the point, the most useful one first
    std::string suspect;             ///< camera of the manual mark that contradicts the others (p < 0.001), or empty
    /// Where auto and proposed marks put the joint while manual ones give no point; never exported.
    std::optional<Eigen::Vector3d> proposal;
    /// Nobody clicked the joint: the point is that of accepted proposals. No residuals and no inliers; the covariance
    /// is that of one look, since all views show the same point.
    bool isAccepted = false;
    int manualViews = 0;
    int placedViews = 0;  ///< manual and auto
    int countedViews = 0; ///< views with a picture: those that a mark is expected in
    /// Where the views disagree so that there is no point: the two clicks that lie farthest off each other's curves,
    /// the larger distance first; empty if no view sees the ray of another one's click.
    std::vector<CurveGap> gaps;
    double systematicPx = 0; ///< what the calibration's error adds to a residual, per axis (TriangulationOptions)

    bool hasPoint() const { return result.point.has_value(); }
};

struct ReconstructionOptions {
    TriangulationOptions triangulation;
    bool details = true; ///< leave-one-out, ellipses, next views, suspect; without them several times faster
    /// Roughly where the joint is (such as the mean of its hand), mm: ranks the next view when only one is clicked.
    std::optional<Eigen::Vector3d> nearInWorld;
    /// Cameras that have no picture of the frame: they need no mark, and none is asked for there.
    std::set<std::string> withoutPicture{};
};

/// Expected distance of a point from its true place, mm: the square root of the covariance's trace.
double sigmaMm(const Eigen::Matrix3d& covariance);

/// The projection of the 95 % ellipsoid of a point's covariance, to first order; empty if the point is behind the
/// camera.
std::optional<PixelEllipse> projectedEllipse(const Camera& camera, const Eigen::Vector3d& pointInWorld,
                                             const Eigen::Matrix3d& covariance);

/// Triangulates one joint of one frame from one rater's marks and looks at it from every camera.
JointReconstruction reconstruct(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                                const std::string& rater, const JointId& joint,
                                const ReconstructionOptions& options = {});
/// It deserves a look: rmsPx above the threshold, an outlier, or no point from two or more manual views. What the
/// calibration's error adds to rmsPx is said once, of the rig, and raises the threshold.
bool isBad(const JointReconstruction& joint, double badRmsPx);
/// Every joint that has at least one mark of that rater in that frame.
std::map<JointId, JointReconstruction> reconstructFrame(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                                        int frame, const std::string& rater,
                                                        const ReconstructionOptions& options = {});

/// Raters that have marks in a frame (or, without a frame, anywhere), ascending.
std::vector<std::string> ratersOf(const AnnotationSet& set, std::optional<int> frame = std::nullopt);

/// How many joints of one hand in one frame are in which state, for timelines. A joint with settled marks is exactly
/// one of done, partial and bad.
struct HandCoverage {
    int done = 0;
    int partial = 0;
    int bad = 0;      ///< isBad, whether done or partial
    int occluded = 0; ///< among all of them: a mark whose place is estimated
    int badDone = 0;  ///< among the bad ones: every view is placed or unplaceable
    int finished() const { return done + badDone; }
    int marked() const { return done + partial + bad; }
    bool operator==(const HandCoverage&) const = default;
};
std::map<Side, HandCoverage> coverageOf(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                                        const std::string& rater, double badRmsPx,
                                        const TriangulationOptions& options = {}, const PictureGaps& gaps = {});

} // namespace core
