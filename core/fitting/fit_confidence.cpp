// SPDX-License-Identifier: MIT
#include "core/fitting/fit_confidence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/fitting/stopwatch.h"
#include "core/numeric/median.h"
#include "core/numeric/robust_linear.h"

namespace core {

namespace {

constexpr double kLeastSigmaMm = 0.05;
/// Contours are wrong in ways that their residuals do not show (rounded tips, filled webs): calibrated so that the
/// normalised error squared of simulated noisy fits of the demo's hands has a median of that of three coordinates.
constexpr double kModelErrorFactor = 4.5;
constexpr double kLeastChangeScale = 0.3, kMostChangeScale = 3;

constexpr float kEvidenceTauRad = 0.39f; ///< noise and evidence are those of matches within this angle
constexpr int kEvidencePoints = 300;     ///< rim points per camera
constexpr double kGateSigmas = 4;        ///< matches beyond it are wrong, not noisy
constexpr double kEvidenceTangent = 0.1; ///< as `best` weighs the distance along the outline
constexpr int kMostLagPx = 60;           ///< how far along the outline correlations are looked for
constexpr int kLagBinPx = 4;

/// Integral of the autocorrelation of the residuals along the outlines, px: neighbours that are nearer than that are
/// not independent. It ends where the correlation is no longer positive.
class CorrelationLength {
public:
    template <typename Residuals>
    void add(const Residuals& sorted) {
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            m_variance += sorted[i].px * sorted[i].px;
            ++m_count;
            for (std::size_t j = i + 1; j < sorted.size(); ++j) {
                const int lag = sorted[j].contourPoint - sorted[i].contourPoint;
                if (lag >= kMostLagPx)
                    break;
                m_products[lag / kLagBinPx] += sorted[i].px * sorted[j].px;
                ++m_pairs[lag / kLagBinPx];
            }
        }
    }
    double lengthPx() const {
        if (m_count == 0 || m_variance <= 0)
            return 1;
        double length = 0;
        for (int bin = 0; bin < kMostLagPx / kLagBinPx; ++bin) {
            if (m_pairs[bin] == 0)
                continue;
            const double correlation = m_products[bin] / m_pairs[bin] / (m_variance / m_count);
            if (correlation <= 0)
                break;
            length += 2 * kLagBinPx * std::min(correlation, 1.0); // to both sides
        }
        return std::max(1.0, length);
    }

private:
    std::array<double, kMostLagPx / kLagBinPx> m_products{};
    std::array<int, kMostLagPx / kLagBinPx> m_pairs{};
    double m_variance = 0;
    int m_count = 0;
};

/// s: root mean square Mahalanobis distance of the angles from the start's, per degree of freedom.
double changeScale(const Eigen::MatrixXd& precision, const Pose& start, const Pose& pose) {
    const Eigen::VectorXd change = (pose - start).tail(precision.rows());
    const double squared =
        change.dot(precision * change) / static_cast<double>(std::max<Eigen::Index>(1, change.size()));
    return std::clamp(std::sqrt(squared), kLeastChangeScale, kMostChangeScale);
}

/// The largest standard deviation of a joint's place (root of the trace), mm.
double largestSigmaMm(const FitConfidence& confidence) {
    double most = 0;
    for (const auto& hand : confidence.jointCovarianceMm2)
        for (const Eigen::Matrix3d& joint : hand)
            most = std::max(most, joint.trace());
    return std::sqrt(most);
}

} // namespace

Eigen::MatrixXd poseCovariance(const Eigen::MatrixXd& hessian, double sigmaMm, double pointsPerSample,
                               const Eigen::MatrixXd& changePrecision, double changeScale) {
    Eigen::MatrixXd information = hessian / (sigmaMm * sigmaMm * pointsPerSample);
    const Eigen::Index angles = changePrecision.rows();
    information.bottomRightCorner(angles, angles) += changePrecision / (changeScale * changeScale);
    constexpr double kUnseenMm = 100; // a hand that no camera sees
    information.diagonal().head<kRigidDofs>().array() += 1 / (kUnseenMm * kUnseenMm);
    return information.ldlt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

std::vector<Eigen::Matrix3d> jointCovariances(const Skeleton& skeleton, const Pose& pose,
                                              const Eigen::MatrixXd& poseCovarianceOfHand) {
    const Eigen::MatrixXd jacobian = jointJacobian(skeleton, pose);
    std::vector<Eigen::Matrix3d> covariances;
    for (Eigen::Index j = 0; j < jacobian.rows(); j += 3) {
        const auto rows = jacobian.middleRows<3>(j);
        covariances.push_back(rows * poseCovarianceOfHand * rows.transpose());
    }
    return covariances;
}

namespace {

/// The unknowns of systematicPart in one vector: poses hand by hand, logarithm of the scale, girth, shifts by view.
struct SystematicUnknowns {
    std::vector<Eigen::Index> poseOf; ///< per hand
    Eigen::Index scale = 0, girth = 0, shifts = 0, count = 0;

    SystematicUnknowns(const HandPoses& poses, const std::vector<OutlineResidual>& residuals) {
        for (const Pose& pose : poses) {
            poseOf.push_back(scale);
            scale += pose.size();
        }
        girth = scale + 1;
        shifts = scale + 2;
        count = shifts;
        for (const OutlineResidual& residual : residuals)
            count = std::max<Eigen::Index>(count, shifts + 2 * (residual.view + 1));
    }
};

Eigen::MatrixXd systematicRows(const SystematicUnknowns& unknowns, const std::vector<OutlineResidual>& residuals) {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(residuals.size()), unknowns.count);
    Eigen::Index row = 0;
    for (const OutlineResidual& residual : residuals) {
        rows.row(row).segment(unknowns.poseOf[static_cast<std::size_t>(residual.hand)], residual.perPose.size()) =
            residual.perPose;
        rows(row, unknowns.scale) = residual.perLogScale;
        rows(row, unknowns.girth) = residual.perGirthMm;
        rows.row(row++).segment<2>(unknowns.shifts + 2 * residual.view) =
            -residual.mmPerPx * residual.normalPx.transpose();
    }
    return rows;
}

Eigen::MatrixXd systematicPriors(const SystematicUnknowns& unknowns, const FittingHands& hands) {
    constexpr double kScale = 0.05, kGirthMm = 1, kShiftPx = 5, kRigid = 100;
    Eigen::MatrixXd priors = Eigen::MatrixXd::Zero(unknowns.count, unknowns.count);
    for (std::size_t h = 0; h < unknowns.poseOf.size(); ++h) {
        const Eigen::MatrixXd& precision = hands.changePrecision[h];
        const Eigen::Index first = unknowns.poseOf[h];
        priors.diagonal().segment<kRigidDofs>(first).array() += 1 / (kRigid * kRigid);
        priors.block(first + kRigidDofs, first + kRigidDofs, precision.rows(), precision.cols()) += precision;
    }
    priors(unknowns.scale, unknowns.scale) = 1 / (kScale * kScale);
    priors(unknowns.girth, unknowns.girth) = 1 / (kGirthMm * kGirthMm);
    priors.diagonal().tail(unknowns.count - unknowns.shifts).setConstant(1 / (kShiftPx * kShiftPx));
    return priors;
}

/// Joints at which fingers bend: roots and what is inside the palm move little and hide how much these do.
bool isOfFinger(const Bone& bone) {
    return bone.parent >= 0 && !bone.name.ends_with("_cmc");
}

} // namespace

SystematicPart systematicPart(const FittingHands& hands, const HandPoses& poses,
                              const std::vector<OutlineResidual>& residuals, double pointsPerSample) {
    SystematicPart part;
    if (residuals.empty())
        return part;
    const SystematicUnknowns unknowns(poses, residuals);
    Eigen::VectorXd mm(static_cast<Eigen::Index>(residuals.size()));
    for (std::size_t i = 0; i < residuals.size(); ++i)
        mm[static_cast<Eigen::Index>(i)] = residuals[i].mm;
    const Eigen::VectorXd found = robustLinearSolution(
        systematicRows(unknowns, residuals), mm, systematicPriors(unknowns, hands),
        {.measurementsPerSample = kModelErrorFactor * pointsPerSample, .leastSigma = kLeastSigmaMm});
    part.scale = std::exp(found[unknowns.scale]);
    part.girthMm = found[unknowns.girth];
    const Eigen::VectorXd shifts = found.tail(unknowns.count - unknowns.shifts);
    part.shiftPx = std::sqrt(shifts.squaredNorm() / std::max(1.0, 0.5 * static_cast<double>(shifts.size())));
    double sum = 0;
    int count = 0;
    for (std::size_t h = 0; h < poses.size(); ++h) {
        const Skeleton& skeleton = hands.models[h].skeleton;
        const auto joints = jointPositions(skeleton, poses[h]);
        const Eigen::VectorXd moved =
            jointJacobian(skeleton, poses[h]) * found.segment(unknowns.poseOf[h], poses[h].size());
        for (std::size_t b = 0; b < joints.size(); ++b) {
            if (!isOfFinger(skeleton.bones[b]))
                continue;
            sum += (moved.segment<3>(3 * static_cast<Eigen::Index>(b)) +
                    found[unknowns.scale] * (joints[b] - joints.front()))
                       .norm();
            ++count;
        }
    }
    part.jointMm = count > 0 ? sum / count : 0;
    return part;
}

double doubtOf(const FitConfidence& confidence) {
    // The share without a match and the rival add nothing once these are known. Silhouettes that overlap less than the
    // noise alone lets them do tell of another hand or another rig, on which contours agree with each other elsewhere.
    constexpr double kLeastOverlap = 0.8;
    // The systematic part of the residuals is about half of the error that another hand or another rig makes.
    constexpr double kHarmlessMm = 0.9;
    const double evidence = -7.1 + 15 * confidence.deepPx + 0.9 * largestSigmaMm(confidence) +
                            60 * std::max(0.0, kLeastOverlap - confidence.overlap) +
                            12 * std::max(0.0, confidence.systematic.jointMm - kHarmlessMm);
    return 1 / (1 + std::exp(-evidence));
}

FitConfidence judgeFit(PoseRefiner& refiner, const HandPoses& start, const HandPoses& poses, double rivalMm) {
    const PoseRefiner::Evidence evidence = refiner.evidence(poses);
    FitConfidence confidence;
    confidence.sigmaPx = evidence.sigmaPx;
    const SilhouetteComparison& areas = evidence.silhouettes;
    confidence.overlap = areas.unionPx2 > 0 ? 1 - areas.differencePx2 / areas.unionPx2 : 0;
    confidence.deepPx = evidence.outlinePx > 0 ? areas.deepPx2 / evidence.outlinePx : 0;
    confidence.unmatchedShare = evidence.unmatchedShare;
    confidence.rivalMm = rivalMm;
    confidence.pointsPerSample = evidence.pointsPerSample;
    const FittingHands& hands = refiner.hands();
    const KnownJoints& known = refiner.knownJoints();
    for (std::size_t h = 0; h < hands.models.size(); ++h) {
        const Eigen::MatrixXd& precision = hands.changePrecision[h];
        const double sigmaMm = std::max(kLeastSigmaMm, evidence.sigmaMm);
        const double pointsPerSample = kModelErrorFactor * evidence.pointsPerSample;
        Eigen::MatrixXd hessian = evidence.equations[h].hessian;
        if (h < known.size() && !known[h].empty())
            hessian += sigmaMm * sigmaMm * pointsPerSample *
                       knownJointEquations(hands.models[h].skeleton, known[h], poses[h]).hessian;
        const Eigen::MatrixXd covariance =
            poseCovariance(hessian, sigmaMm, pointsPerSample, precision, changeScale(precision, start[h], poses[h]));
        confidence.jointCovarianceMm2.push_back(jointCovariances(hands.models[h].skeleton, poses[h], covariance));
    }
    confidence.systematic = systematicPart(hands, poses, evidence.residuals, evidence.pointsPerSample);
    confidence.doubt = doubtOf(confidence);
    return confidence;
}

namespace {

/// Unit, perpendicular to the contour point's ray, outward.
Eigen::Vector3d across(const RimPoint& rim, const CameraTarget& target, int contourPoint) {
    const Eigen::Vector3d& ray = target.rayDirection[static_cast<std::size_t>(contourPoint)];
    const Eigen::Vector3d normal = rim.normal.cast<double>();
    return (normal - normal.dot(ray) * ray).normalized();
}

/// Without its view and the derivatives by scale and pose.
OutlineResidual outlineResidual(const RimPoint& rim, const CameraTarget& target, int contourPoint, double focalPx) {
    const Eigen::Vector3d offset = rim.point.cast<double>() - target.centre;
    const Eigen::Vector3d direction = across(rim, target, contourPoint);
    OutlineResidual residual;
    residual.hand = rim.hand;
    residual.contourPoint = contourPoint;
    residual.px = acrossPx(rim, target, contourPoint);
    residual.mm = direction.dot(offset);
    residual.mmPerPx = offset.dot(target.rayDirection[static_cast<std::size_t>(contourPoint)]) / focalPx;
    residual.normalPx = rim.normalPx.cast<double>();
    residual.perGirthMm = direction.dot(rim.normal.cast<double>());
    return residual;
}

} // namespace

void PoseRefiner::measureNoise(View& view, const CameraTarget& target) const {
    MatchRule rule;
    rule.distance = DistanceKind::DchThres;
    rule.tauRad = kEvidenceTauRad;
    std::vector<double> px;
    for (const RimPoint& rim : view.rim) {
        view.matched.matches.clear();
        findMatches(target, rule, rim, view.matched.matches);
        for (const WeightedMatch& match : view.matched.matches) {
            if (isInside(view.forearms, contourPx(target, match.index)))
                continue;
            px.push_back(std::abs(acrossPx(rim, target, match.index)));
        }
    }
    view.noisePx = px.empty() ? 0 : kSigmaPerMedian * medianOf(px);
}

PoseRefiner::Noise PoseRefiner::contourNoise(const HandPoses& poses) {
    constexpr int kPoints = 120;
    poseSurfaces(poses, Detail::Medium);
    placeForearms(poses);
    forEachView([&](View& view, const CameraTarget& target) {
        extractRim(view, target, Detail::Medium, kPoints);
        const Stopwatch watch;
        measureNoise(view, target);
        view.secondsScore += watch.seconds();
    });
    Noise noise;
    for (const View& view : m_views)
        noise.perCameraPx.push_back(view.noisePx);
    if (!noise.perCameraPx.empty())
        noise.px = medianOf(noise.perCameraPx);
    return noise;
}

void PoseRefiner::collectEvidence(View& view, const CameraTarget& target, const std::vector<HandLinearisation>& hands,
                                  const std::vector<Eigen::Vector3d>& roots) const {
    IterationSettings settings;
    settings.rule.distance = DistanceKind::DchThres;
    settings.rule.tauRad = kEvidenceTauRad;
    settings.tangentWeight = kEvidenceTangent;
    settings.rule.gatePx = static_cast<float>(kGateSigmas * std::max(view.noisePx, 0.5));
    matchRim(target, settings, view.rim, view.forearms, view.matched);
    view.residuals.clear();
    const Eigen::Matrix3d& intrinsics = m_cameras[static_cast<std::size_t>(target.camera)].intrinsics;
    const double focalPx = 0.5 * (intrinsics(0, 0) + intrinsics(1, 1));
    std::vector<WeightedMatch>& matches = view.matched.matches;
    for (const RimPoint& rim : view.rim) {
        matches.clear();
        findMatches(target, settings.rule, rim, matches);
        for (const WeightedMatch& match : matches) {
            if (isInside(view.forearms, contourPx(target, match.index)))
                continue;
            view.residuals.push_back(outlineResidual(rim, target, match.index, focalPx));
            OutlineResidual& found = view.residuals.back();
            const auto h = static_cast<std::size_t>(rim.hand);
            found.view = static_cast<int>(&view - m_views.data());
            found.perLogScale = across(rim, target, match.index).dot(rim.point.cast<double>() - roots[h]);
            found.perPose = across(rim, target, match.index).transpose() *
                            hands[h].pointJacobian(rim.vertexA, rim.vertexB, static_cast<double>(rim.t));
        }
    }
    for (std::size_t h = 0; h < hands.size(); ++h) {
        view.equations[h].reset(hands[h].poseSize());
        hands[h].accumulate(view.matched.correspondences[h], view.equations[h]);
    }
    std::sort(view.residuals.begin(), view.residuals.end(),
              [](const OutlineResidual& a, const OutlineResidual& b) { return a.contourPoint < b.contourPoint; });
}

PoseRefiner::Evidence PoseRefiner::evidence(const HandPoses& poses) {
    Evidence found;
    const int depthPx = beyondNoisePx(contourNoise(poses).px); // and each view's noise is the gate of its matches
    std::vector<HandLinearisation> hands;
    std::vector<Eigen::Vector3d> roots;
    for (std::size_t h = 0; h < m_hands.models.size(); ++h) {
        hands.emplace_back(m_hands.models[h], m_hands.levels[h][static_cast<std::size_t>(Detail::Medium)], poses[h]);
        roots.push_back(jointPositions(m_hands.models[h].skeleton, poses[h]).front());
    }
    const std::vector<RimSource> sources = rimSources(Detail::Coarse);
    forEachView([&](View& view, const CameraTarget& target) {
        extractRim(view, target, Detail::Medium, kEvidencePoints);
        collectEvidence(view, target, hands, roots);
        compareView(view, target, sources, unsureMask(view, target, depthPx));
    });
    CorrelationLength correlation;
    std::vector<double> px, mm;
    std::size_t rim = 0, unmatched = 0;
    found.equations.resize(hands.size());
    for (std::size_t h = 0; h < hands.size(); ++h)
        found.equations[h].reset(hands[h].poseSize());
    for (const View& view : m_views) {
        for (std::size_t h = 0; h < hands.size(); ++h)
            found.equations[h] += view.equations[h];
        correlation.add(view.residuals);
        for (const OutlineResidual& residual : view.residuals) {
            px.push_back(std::abs(residual.px));
            mm.push_back(std::abs(residual.mm));
        }
        found.residuals.insert(found.residuals.end(), view.residuals.begin(), view.residuals.end());
        rim += view.rim.size();
        unmatched += static_cast<std::size_t>(view.matched.rejected);
        found.silhouettes.differencePx2 += view.silhouettes.differencePx2;
        found.silhouettes.deepPx2 += view.silhouettes.deepPx2;
        found.silhouettes.unionPx2 += view.silhouettes.unionPx2;
    }
    found.outlinePx = outlineLengthPx();
    found.unmatchedShare = rim > 0 ? static_cast<double>(unmatched) / static_cast<double>(rim) : 1;
    if (!px.empty()) {
        const double matched = static_cast<double>(px.size());
        found.sigmaPx = kSigmaPerMedian * medianOf(px);
        found.sigmaMm = kSigmaPerMedian * medianOf(mm);
        found.pointsPerSample = std::max(1.0, matched * correlation.lengthPx() / std::max(1.0, found.outlinePx));
    }
    return found;
}

} // namespace core
