// SPDX-License-Identifier: MIT
#include "core/annotation/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace core {

std::string_view statusName(JointStatus status) {
    switch (status) {
    case JointStatus::None:
        return "none";
    case JointStatus::Partial:
        return "partial";
    case JointStatus::Done:
        break;
    }
    return "done";
}

bool isOutside(const Mark& mark, const Camera& camera) {
    return mark.hasPlace() && !isInside(camera.size, mark.px);
}
bool isEvidenceIn(const Mark& mark, const Camera& camera) {
    return mark.isEvidence() && !isOutside(mark, camera);
}

double sigmaMm(const Eigen::Matrix3d& covariance) {
    return std::sqrt(covariance.trace());
}

std::optional<PixelEllipse> projectedEllipse(const Camera& camera, const Eigen::Vector3d& pointInWorld,
                                             const Eigen::Matrix3d& covariance) {
    const auto projection = projectWithJacobian(camera, pointInWorld);
    if (!projection)
        return std::nullopt;
    const Matrix23d& jacobian = projection->pxByPointInWorld;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(jacobian * covariance * jacobian.transpose());
    constexpr double kChiSquare95 = 5.991464547107979; // two degrees of freedom: -2 ln 0.05
    PixelEllipse ellipse;
    ellipse.centrePx = projection->px;
    ellipse.halfAxesPx = (kChiSquare95 * axes.eigenvalues().reverse().cwiseMax(0)).cwiseSqrt();
    ellipse.angleRad = std::atan2(axes.eigenvectors()(1, 1), axes.eigenvectors()(0, 1));
    return ellipse;
}

namespace {

/// The marks of one joint as observations, and which view each came from.
struct Evidence {
    std::vector<Observation> observations; ///< camera = index of the view
    std::vector<std::size_t> views;
};

Evidence collect(const std::vector<ViewReconstruction>& views, bool withGuesses) {
    Evidence evidence;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const auto& mark = views[i].mark;
        if (mark && !views[i].outside && (mark->isEvidence() || (withGuesses && mark->hasPlace()))) {
            evidence.observations.push_back({static_cast<int>(i), mark->px});
            evidence.views.push_back(i);
        }
    }
    return evidence;
}

/// How far off a proposal may be that looks right, px.
constexpr double kLookSigmaPx = 3;

/// The point that accepted proposals show, if two views do. The views repeat one point, so they are worth one look.
std::optional<TriangulatedPoint> acceptedPoint(const std::vector<ViewReconstruction>& views,
                                               const std::vector<Camera>& cameras, TriangulationOptions options) {
    std::vector<Observation> guesses;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (views[i].mark && !views[i].outside && views[i].mark->isAcceptedGuess())
            guesses.push_back({static_cast<int>(i), views[i].mark->px, kLookSigmaPx});
    options.isSigmaAssumed = false;
    auto point = triangulate(cameras, guesses, options).point;
    if (!point)
        return std::nullopt;
    point->covariance *= static_cast<double>(guesses.size());
    point->rmsPx = 0;
    point->residualPx.clear();
    point->inlier.clear();
    return point;
}

std::vector<ViewReconstruction> viewsOf(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                                        const std::string& rater, const JointId& joint) {
    std::vector<ViewReconstruction> views(cameras.size());
    for (std::size_t i = 0; i < cameras.size(); ++i)
        views[i].camera = cameras[i].name;
    for (const auto& [key, mark] : marksOfJoint(set, frame, rater, joint)) {
        const auto view = std::find_if(views.begin(), views.end(), [&camera = key.camera](const ViewReconstruction& v) {
            return v.camera == camera;
        });
        if (view != views.end()) {
            view->mark = mark;
            view->outside = isOutside(mark, cameras[static_cast<std::size_t>(view - views.begin())]);
        }
    }
    return views;
}

void findPictures(std::vector<ViewReconstruction>& views, const std::set<std::string>& withoutPicture) {
    for (ViewReconstruction& view : views)
        view.hasPicture = !withoutPicture.contains(view.camera);
}

void countViews(JointReconstruction& joint) {
    bool isBegun = false, isOpen = false;
    for (const ViewReconstruction& view : joint.views) {
        const bool isSettled = view.mark && view.mark->isSettled(); // placed, or known not to be placeable
        isBegun |= isSettled;
        isOpen |= view.hasPicture && !isSettled;
        joint.countedViews += view.hasPicture;
        if (view.mark) {
            joint.placedViews += view.mark->isPlaced();
            joint.manualViews += view.mark->isEvidence() && !view.outside;
        }
    }
    joint.status = !isBegun ? JointStatus::None : isOpen ? JointStatus::Partial : JointStatus::Done;
}

void lookFromEveryView(JointReconstruction& joint, const std::vector<Camera>& cameras, const Evidence& evidence) {
    const TriangulatedPoint& point = *joint.result.point;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        ViewReconstruction& view = joint.views[i];
        view.reprojectionPx = project(cameras[i], point.pointInWorld);
        view.reprojectionInside = view.reprojectionPx && isInside(cameras[i].size, *view.reprojectionPx);
    }
    for (std::size_t k = 0; k < evidence.views.size(); ++k) {
        ViewReconstruction& view = joint.views[evidence.views[k]];
        if (std::isfinite(point.residualPx[k]))
            view.errorPx = point.residualPx[k];
        view.outlier = !point.inlier[k];
    }
}

/// Information of the inliers, 1/mm^2.
Eigen::Matrix3d informationOf(const TriangulatedPoint& point) {
    return point.covariance.inverse();
}

/// Squared Mahalanobis length of a residual whose prediction has the given covariance of the point.
double surprise(const Camera& camera, const Eigen::Vector3d& pointInWorld, const Eigen::Matrix3d& covariance,
                const Eigen::Vector2d& px, double sigmaPx) {
    const auto projection = projectWithJacobian(camera, pointInWorld);
    if (!projection)
        return 0;
    const Matrix23d& jacobian = projection->pxByPointInWorld;
    const Eigen::Matrix2d spread =
        jacobian * covariance * jacobian.transpose() + sigmaPx * sigmaPx * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d residual = projection->px - px;
    return residual.dot(spread.inverse() * residual);
}

/// The point without observation `left`, from the other inliers; empty if they are fewer than two.
std::optional<Eigen::Vector3d> pointWithout(const std::vector<Camera>& cameras, const Evidence& evidence,
                                            const TriangulatedPoint& point, std::size_t left,
                                            Eigen::Matrix3d& covariance, const TriangulationOptions& options) {
    std::vector<Observation> others;
    for (std::size_t k = 0; k < evidence.observations.size(); ++k)
        if (k != left && point.inlier[k])
            others.push_back(evidence.observations[k]);
    if (others.size() < 2)
        return std::nullopt;
    const auto refined = refinePoint(cameras, others, point.pointInWorld, options);
    if (refined)
        covariance = triangulationInformation(cameras, others, *refined, options).inverse();
    return refined;
}

/// By how much the residuals of the inliers are larger than the sigmas say, as a variance.
double misfitOf(const TriangulatedPoint& point, const Evidence& evidence, const TriangulationOptions& options) {
    double squares = 0, freedom = -3;
    for (std::size_t k = 0; k < point.inlier.size(); ++k) {
        if (point.inlier[k]) {
            squares += std::pow(point.residualPx[k] / options.sigmaOf(evidence.observations[k].camera), 2);
            freedom += 2;
        }
    }
    return misfitFactor(squares, freedom);
}

/// Leave-one-out residuals, and the manual mark that disagrees most beyond chance.
void findSuspect(JointReconstruction& joint, const std::vector<Camera>& cameras, const Evidence& evidence,
                 const TriangulationOptions& options) {
    constexpr double kChiSquare999 = 13.815510557964274; // two degrees of freedom: -2 ln 0.001
    double worst = kChiSquare999;
    const double misfit = options.isSigmaAssumed ? misfitOf(*joint.result.point, evidence, options) : 1;
    for (std::size_t k = 0; k < evidence.views.size(); ++k) {
        const std::size_t i = evidence.views[k];
        ViewReconstruction& view = joint.views[i];
        Eigen::Matrix3d covariance;
        const auto without = pointWithout(cameras, evidence, *joint.result.point, k, covariance, options);
        const auto px = without ? project(cameras[i], *without) : std::nullopt;
        if (!px)
            continue;
        view.leaveOneOutPx = (*px - view.mark->px).norm();
        const double found =
            surprise(cameras[i], *without, covariance, view.mark->px, options.sigmaOf(static_cast<int>(i))) / misfit;
        if (found > worst) {
            worst = found;
            joint.suspect = view.camera;
        }
    }
}

bool wantsClick(const ViewReconstruction& view) {
    return view.hasPicture && (!view.mark || view.outside || (view.mark->hasPlace() && !view.mark->isEvidence()));
}

/// Ranks the views that would see the point by the uncertainty after one more click there.
void rankNextViews(JointReconstruction& joint, const std::vector<Camera>& cameras, const Eigen::Vector3d& pointInWorld,
                   const Eigen::Matrix3d& information, const TriangulationOptions& options) {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (!wantsClick(joint.views[i]))
            continue;
        const auto px = project(cameras[i], pointInWorld);
        if (!px || !isInside(cameras[i].size, *px))
            continue;
        const Eigen::Matrix3d more =
            information + triangulationInformation(cameras, {{static_cast<int>(i), *px}}, pointInWorld, options);
        const double sigma = sigmaMm(more.inverse());
        if (std::isfinite(sigma))
            joint.nextViews.push_back({cameras[i].name, sigma});
    }
    std::stable_sort(joint.nextViews.begin(), joint.nextViews.end(),
                     [](const NextView& a, const NextView& b) { return a.predictedSigmaMm < b.predictedSigmaMm; });
}

/// With one click there is a ray: the place on it that is nearest to where the joint is expected.
void rankSecondView(JointReconstruction& joint, const std::vector<Camera>& cameras, const Evidence& evidence,
                    const ReconstructionOptions& options) {
    const Observation& click = evidence.observations.front();
    const auto ray = viewingRay(cameras[evidence.views.front()], click.px);
    if (!ray || !options.nearInWorld)
        return;
    const Eigen::Vector3d onRay = ray->pointNearestOrigin();
    const Eigen::Vector3d point = onRay + ray->direction.dot(*options.nearInWorld - onRay) * ray->direction;
    rankNextViews(joint, cameras, point, triangulationInformation(cameras, {click}, point, options.triangulation),
                  options.triangulation);
}

} // namespace

JointReconstruction reconstruct(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                                const std::string& rater, const JointId& jointId,
                                const ReconstructionOptions& options) {
    JointReconstruction joint;
    joint.systematicPx = options.triangulation.systematicPx;
    joint.views = viewsOf(set, cameras, frame, rater, jointId);
    findPictures(joint.views, options.withoutPicture);
    countViews(joint);
    const Evidence evidence = collect(joint.views, false);
    joint.result = triangulate(cameras, evidence.observations, options.triangulation);
    if (evidence.observations.empty())
        if (auto accepted = acceptedPoint(joint.views, cameras, options.triangulation)) {
            joint.result = {std::move(accepted), TriangulationFailure::None};
            joint.isAccepted = true;
        }
    if (!joint.result.point) {
        const Evidence withGuesses = collect(joint.views, true);
        if (withGuesses.views.size() > evidence.views.size()) {
            const auto guess = triangulate(cameras, withGuesses.observations, options.triangulation);
            if (guess.point)
                joint.proposal = guess.point->pointInWorld;
        }
        if (joint.result.failure == TriangulationFailure::ViewsDisagree)
            joint.gaps = worstCurveGaps(cameras, evidence.observations);
        if (options.details && evidence.observations.size() == 1)
            rankSecondView(joint, cameras, evidence, options);
        return joint;
    }
    lookFromEveryView(joint, cameras, evidence);
    if (options.details) {
        const TriangulatedPoint& point = *joint.result.point;
        for (std::size_t i = 0; i < cameras.size(); ++i)
            joint.views[i].ellipse95 = projectedEllipse(cameras[i], point.pointInWorld, point.covariance);
        findSuspect(joint, cameras, evidence, options.triangulation);
        rankNextViews(joint, cameras, point.pointInWorld, informationOf(point), options.triangulation);
    }
    return joint;
}

std::map<JointId, JointReconstruction> reconstructFrame(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                                        int frame, const std::string& rater,
                                                        const ReconstructionOptions& options) {
    std::map<JointId, JointReconstruction> joints;
    for (const auto& [key, mark] : marksOfFrame(set, frame, rater))
        if (!joints.contains(key.joint))
            joints.emplace(key.joint, reconstruct(set, cameras, frame, rater, key.joint, options));
    return joints;
}

std::vector<std::string> ratersOf(const AnnotationSet& set, std::optional<int> frame) {
    std::set<std::string> raters;
    const MarkRange range = frame ? marksOfFrame(set, *frame) : MarkRange{set.marks.begin(), set.marks.end()};
    for (auto mark = range.first; mark != range.last;) {
        raters.insert(mark->first.rater);
        mark = marksOfFrame(set, mark->first.frame, mark->first.rater).last;
    }
    return {raters.begin(), raters.end()};
}

bool isBad(const JointReconstruction& joint, double badRmsPx) {
    if (!joint.hasPoint())
        return joint.manualViews >= 2;
    const TriangulatedPoint& point = *joint.result.point;
    constexpr double kAxesAndSpread = 2; // a residual has two axes, and some joints have more of it than others
    return point.rmsPx > std::hypot(badRmsPx, kAxesAndSpread * joint.systematicPx) ||
           std::find(point.inlier.begin(), point.inlier.end(), false) != point.inlier.end();
}

namespace {

bool hasOccluded(const JointReconstruction& joint) {
    return std::any_of(
        joint.views.begin(), joint.views.end(),
        [](const ViewReconstruction& view) { return view.mark && view.mark->state == MarkState::Occluded; });
}

} // namespace

std::map<Side, HandCoverage> coverageOf(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                                        const std::string& rater, double badRmsPx, const TriangulationOptions& options,
                                        const PictureGaps& gaps) {
    std::map<Side, HandCoverage> coverage;
    for (const auto& [id, joint] :
         reconstructFrame(set, cameras, frame, rater, {options, false, std::nullopt, gaps.at(frame)})) {
        HandCoverage& hand = coverage[id.hand];
        const bool bad = isBad(joint, badRmsPx);
        hand.done += !bad && joint.status == JointStatus::Done;
        hand.partial += !bad && joint.status == JointStatus::Partial;
        hand.bad += bad;
        hand.badDone += bad && joint.status == JointStatus::Done;
        hand.occluded += hasOccluded(joint);
    }
    return coverage;
}

} // namespace core
