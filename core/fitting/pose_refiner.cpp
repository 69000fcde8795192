// SPDX-License-Identifier: MIT
#include "core/fitting/pose_refiner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/fitting/stopwatch.h"
#include "core/hand/finger_prior.h"
#include "core/numeric/box_step.h"
#include "core/numeric/median.h"

namespace core {

namespace {

/// Vertices of the coarser levels; the coarse one also decides what covers what.
constexpr std::array<int, kSurfaceLevels> kLevelVertices{700, 2000, 0};

/// Recorded angles leave their limits by a few degrees: beyond a limit the pose is pulled back softly, and held hard
/// only this far outside.
constexpr double kLimitSlackRad = 0.2;
constexpr double kLimitPull = 1e4; ///< mm^2 per rad^2
constexpr double kAngleFloor = 20; ///< mm^2 per rad^2: holds what no camera sees
constexpr double kRigidFloor = 1e-3;

/// What a known joint's squared Mahalanobis distance weighs in the equations of the outlines: the variance of an
/// outline times the rim points that err together.
constexpr double kKnownJointMm2 = 10;
/// And in the mean distance of the outlines: a joint that is 10 mm off as much as a finger that is in a wrong place.
constexpr double kKnownJointPx = 0.002;

constexpr float kCoarseCellPx = 4;
constexpr float kCoarseOutwardPx = 4;

} // namespace

FittingHands makeFittingHands(std::vector<HandModel> models) {
    FittingHands hands;
    hands.models = std::move(models);
    for (const HandModel& model : hands.models) {
        hands.cuts.push_back(forearmCut(model));
        hands.changePrecision.push_back(fingerChangePrecision(model.skeleton, learntFingerMotion()));
        auto& levels = hands.levels.emplace_back();
        for (std::size_t level = 0; level < kSurfaceLevels; ++level) {
            levels[level] = makeSkinnedSurface(model, kLevelVertices[level]);
            hands.boneOfVertex[level].push_back(strongestBones(levels[level]));
        }
    }
    hands.capsules = handCapsules(hands.models);
    return hands;
}

PoseRefiner::PoseRefiner(const FittingHands& hands, const std::vector<Camera>& cameras,
                         const std::vector<CameraTarget>& targets, const HandPoses& start, int threads,
                         FitProfile& profile)
    : m_hands(hands)
    , m_cameras(cameras)
    , m_targets(targets)
    , m_start(start)
    , m_threads(threads)
    , m_profile(profile)
    , m_views(targets.size())
    , m_forearms(hands.cuts)
    , m_posed(hands.models.size()) {
    for (View& view : m_views) {
        view.matched.correspondences.resize(hands.models.size());
        view.equations.resize(hands.models.size());
    }
}

void PoseRefiner::forEachView(const std::function<void(View&, const CameraTarget&)>& work) {
    if (m_threads <= 1) {
        for (std::size_t v = 0; v < m_views.size(); ++v)
            work(m_views[v], m_targets[v]);
    } else {
        tbb::task_arena(m_threads).execute([&] {
            tbb::parallel_for(
                std::size_t{0}, m_views.size(), [&](std::size_t v) { work(m_views[v], m_targets[v]); });
        });
    }
    for (View& view : m_views) {
        m_profile.rims += std::exchange(view.secondsRim, 0);
        m_profile.matching += std::exchange(view.secondsMatch, 0);
        m_profile.solving += std::exchange(view.secondsSolve, 0);
        m_profile.scoring += std::exchange(view.secondsScore, 0);
    }
}

void PoseRefiner::poseSurfaces(const HandPoses& poses, Detail detail) {
    const Stopwatch watch;
    for (std::size_t h = 0; h < m_hands.models.size(); ++h) {
        const BoneMatrices bones = boneMatrices(m_hands.models[h].skeleton, poses[h]);
        poseSurface(m_hands.levels[h][0], bones, m_posed[h][0]);
        const auto level = static_cast<std::size_t>(detail);
        if (level > 0)
            poseSurface(m_hands.levels[h][level], bones, m_posed[h][level]);
    }
    m_profile.skinning += watch.seconds();
}

std::vector<RimSource> PoseRefiner::rimSources(Detail detail) const {
    const auto level = static_cast<std::size_t>(detail);
    std::vector<RimSource> sources;
    for (std::size_t h = 0; h < m_hands.models.size(); ++h)
        sources.push_back({&m_hands.levels[h][level], &m_posed[h][level], &m_hands.levels[h][0], &m_posed[h][0]});
    return sources;
}

void PoseRefiner::extractRim(View& view, const CameraTarget& target, Detail detail, int points) {
    const Stopwatch watch;
    RimOptions options;
    options.maxPoints = points;
    if (detail == Detail::Coarse) {
        options.cellPx = kCoarseCellPx;
        options.outwardPx = kCoarseOutwardPx;
    }
    visibleRim(m_cameras[static_cast<std::size_t>(target.camera)], rimSources(detail), options, view.scratch, view.rim);
    view.matched.boneOfVertex = m_hands.boneOfVertex[static_cast<std::size_t>(detail)];
    leaveOut(view.forearms, view.rim, view.matched);
    view.secondsRim += watch.seconds();
}

void PoseRefiner::recordMatches(bool on) {
    for (View& view : m_views)
        view.matched.recording = on;
}

/// Null unless the iteration recorded.
std::shared_ptr<const IterationMatches> PoseRefiner::takeRecords() {
    if (m_views.empty() || !m_views.front().matched.recording)
        return nullptr;
    auto records = std::make_shared<IterationMatches>();
    for (std::size_t v = 0; v < m_views.size(); ++v) {
        std::vector<MatchRecord>& found = m_views[v].matched.records;
        records->push_back(
            {m_targets[v].camera, std::vector<MatchRecord>(found.begin(), found.end()), m_views[v].forearms});
        found.clear();
    }
    return records;
}

IterationMatches PoseRefiner::matchesAt(const HandPoses& poses) {
    if (!m_lastSettings)
        return {};
    poseSurfaces(poses, m_lastSettings->detail);
    placeForearms(poses);
    forEachView([&](View& view, const CameraTarget& target) {
        view.matched.records.clear();
        extractRim(view, target, m_lastSettings->detail, m_lastSettings->pointsPerCamera);
        matchRim(target, *m_lastSettings, view.rim, view.forearms, view.matched);
    });
    const auto records = takeRecords();
    return records ? *records : IterationMatches();
}

FitIteration PoseRefiner::iterate(HandPoses& poses, const IterationSettings& settings) {
    m_lastSettings = settings;
    poseSurfaces(poses, settings.detail);
    placeForearms(poses);
    std::vector<HandLinearisation> linearisations;
    for (std::size_t h = 0; h < m_hands.models.size(); ++h) {
        linearisations.emplace_back(m_hands.models[h], m_hands.levels[h][static_cast<std::size_t>(settings.detail)],
                                    poses[h]);
    }
    forEachView([&](View& view, const CameraTarget& target) {
        view.matched.records.clear();
        extractRim(view, target, settings.detail, settings.pointsPerCamera);
        Stopwatch watch;
        matchRim(target, settings, view.rim, view.forearms, view.matched);
        view.secondsMatch += watch.restart();
        for (std::size_t h = 0; h < linearisations.size(); ++h) {
            view.equations[h].reset(linearisations[h].poseSize());
            linearisations[h].accumulate(view.matched.correspondences[h], view.equations[h]);
        }
        view.secondsSolve += watch.seconds();
    });
    const Stopwatch watch;
    FitIteration record;
    double squared = 0;
    const HandPoses before = poses;
    std::vector<CapsuleOverlap> overlaps;
    if (settings.overlapWeight > 0)
        overlaps = capsuleOverlaps(m_hands.capsules, m_hands.models, poses);
    for (std::size_t h = 0; h < m_hands.models.size(); ++h) {
        NormalEquations sum;
        sum.reset(linearisations[h].poseSize());
        for (const View& view : m_views) // fixed order: independent of the threads
            sum += view.equations[h];
        squared += sum.sumSquaredMm2;
        record.matches += sum.count;
        if (sum.count > 0)
            poses[h] = retract(poses[h], solveHand(h, poses, sum, overlaps, settings));
    }
    for (const View& view : m_views)
        record.rejected += view.matched.rejected;
    record.costMm2 = record.matches ? squared / (2 * record.matches) : 0;
    record.rigidOnly = settings.rigidOnly;
    record.level = static_cast<int>(settings.detail);
    record.stepMm = meanJointDistanceMm(m_hands.models, before, poses);
    record.matchRecords = takeRecords();
    m_profile.solving += watch.seconds();
    return record;
}

// (H + mu diag(H) + F) s = -(g + f): F and f hold the prior on the angles' distance from the start, the depth by
// which bones penetrate each other, the pull back to the limits, and floors for what no camera sees. s is bounded so
// that no angle leaves its limits by more than the slack.
Eigen::VectorXd PoseRefiner::solveHand(std::size_t hand, const HandPoses& poses, const NormalEquations& equations,
                                       const std::vector<CapsuleOverlap>& overlaps,
                                       const IterationSettings& settings) const {
    const Skeleton& skeleton = m_hands.models[hand].skeleton;
    const Eigen::Index size = settings.rigidOnly ? kRigidDofs : skeleton.poseSize();
    Eigen::MatrixXd hessian = equations.hessian.topLeftCorner(size, size);
    Eigen::VectorXd gradient = equations.gradient.head(size);
    Eigen::VectorXd lower = Eigen::VectorXd::Constant(size, -std::numeric_limits<double>::infinity());
    Eigen::VectorXd upper = -lower;
    hessian.diagonal() *= 1 + settings.damping;
    hessian.diagonal().head<kRigidDofs>().array() += kRigidFloor;
    for (Eigen::Index k = kRigidDofs; k < size; ++k) {
        const DegreeOfFreedom& dof = skeleton.dofs[static_cast<std::size_t>(k - kRigidDofs)];
        const double angle = poses[hand][k];
        hessian(k, k) += kAngleFloor;
        const double prior = settings.startPrior * equations.count;
        hessian(k, k) += prior;
        gradient[k] += prior * (angle - m_start[hand][k]);
        const double outside = angle - std::clamp(angle, dof.minRad, dof.maxRad);
        if (outside != 0) {
            hessian(k, k) += kLimitPull;
            gradient[k] += kLimitPull * outside;
        }
        lower[k] = std::min(0.0, dof.minRad - kLimitSlackRad - angle);
        upper[k] = std::max(0.0, dof.maxRad + kLimitSlackRad - angle);
    }
    if (settings.motionPrior > 0 && !settings.rigidOnly) {
        const Eigen::MatrixXd& precision = m_hands.changePrecision[hand];
        addFingerChange(precision, settings.motionPrior * equations.count,
                        (poses[hand] - m_start[hand]).tail(precision.rows()), hessian, gradient);
    }
    if (hand < m_known.size() && !m_known[hand].empty()) {
        const KnownJointEquations known = knownJointEquations(skeleton, m_known[hand], poses[hand]);
        hessian += kKnownJointMm2 * known.hessian.topLeftCorner(size, size);
        gradient += kKnownJointMm2 * known.gradient.head(size);
    }
    addOverlaps(overlaps, static_cast<int>(hand), skeleton, poses[hand], settings.overlapWeight * equations.count,
                hessian, gradient);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(skeleton.poseSize());
    step.head(size) = boxConstrainedStep(hessian, gradient, lower, upper);
    return step;
}

int beyondNoisePx(double noisePx) {
    return std::clamp(static_cast<int>(std::ceil(3.5 * noisePx)), 4, 12);
}

double PoseRefiner::outlineLengthPx() const {
    std::size_t length = 0;
    for (const View& view : m_views)
        length += view.contourPoints;
    return static_cast<double>(length);
}

const cv::Mat& PoseRefiner::unsureMask(View& view, const CameraTarget& target, int depthPx) const {
    if (view.unsureDepthPx != depthPx) {
        const cv::Rect around(target.maskBounds.x - depthPx, target.maskBounds.y - depthPx,
                              target.maskBounds.width + 2 * depthPx, target.maskBounds.height + 2 * depthPx);
        const cv::Rect part = around & cv::Rect({}, target.mask.size());
        const cv::Mat square = cv::Mat::ones(2 * depthPx + 1, 2 * depthPx + 1, CV_8U);
        view.unsure = cv::Mat::zeros(target.mask.size(), CV_8U);
        cv::morphologyEx(target.mask(part), view.unsure(part), cv::MORPH_GRADIENT, square);
        view.unsureDepthPx = depthPx;
    }
    return view.unsure;
}

void PoseRefiner::compareView(View& view, const CameraTarget& target, const std::vector<RimSource>& sources,
                              const cv::Mat& unsure, float cellPx) {
    const Stopwatch watch;
    RimOptions options;
    options.cellPx = cellPx;
    view.silhouettes = compareSilhouettes(m_cameras[static_cast<std::size_t>(target.camera)], sources, options,
                                          target.mask, unsure, target.maskBounds, view.scratch, view.forearms);
    if (!std::exchange(view.isCounted, true)) {
        view.contourPoints = target.contour.size();
        for (std::size_t q = 0; q < target.contour.size(); ++q)
            view.contourPoints -= isInside(view.forearms, contourPx(target, static_cast<int>(q))) ? 1 : 0;
    }
    view.secondsScore += watch.seconds();
}

double PoseRefiner::silhouetteDifferencePx(const HandPoses& poses, float cellPx) {
    poseSurfaces(poses, Detail::Coarse);
    placeForearms(poses);
    const std::vector<RimSource> sources = rimSources(Detail::Coarse);
    forEachView([&](View& view, const CameraTarget& target) { compareView(view, target, sources, {}, cellPx); });
    double area = 0;
    for (const View& view : m_views)
        area += view.silhouettes.differencePx2;
    const double length = outlineLengthPx();
    return (length > 0 ? area / length : 0) + kKnownJointPx * knownJointMisfit(m_hands.models, m_known, poses);
}

double PoseRefiner::deepDifferencePx(const HandPoses& poses, int depthPx) {
    poseSurfaces(poses, Detail::Coarse);
    placeForearms(poses);
    const std::vector<RimSource> sources = rimSources(Detail::Coarse);
    forEachView([&](View& view, const CameraTarget& target) {
        compareView(view, target, sources, unsureMask(view, target, depthPx));
    });
    double area = 0;
    for (const View& view : m_views)
        area += view.silhouettes.deepPx2;
    const double length = outlineLengthPx();
    return length > 0 ? area / length : 0;
}

void PoseRefiner::placeForearms(const HandPoses& poses) {
    if (!m_forearms.any())
        return;
    const std::vector<std::optional<ForearmCut>> cuts = m_forearms.cuts();
    for (std::size_t v = 0; v < m_views.size(); ++v) {
        const Camera& camera = m_cameras[static_cast<std::size_t>(m_targets[v].camera)];
        std::vector<ConvexRegion> regions = forearmRegions(camera, m_hands.models, poses, cuts);
        if (regions == m_views[v].forearms)
            continue; // only fingers have moved: contour points are not counted again
        m_views[v].forearms = std::move(regions);
        m_views[v].isCounted = false;
    }
}

template <typename Search>
std::vector<Search> PoseRefiner::lookBeyondHands(const HandPoses& poses) {
    poseSurfaces(poses, Detail::Coarse);
    const std::vector<RimSource> sources = rimSources(Detail::Coarse);
    std::vector<Search> searches(poses.size());
    for (std::size_t v = 0; v < m_views.size(); ++v) {
        const Camera& camera = m_cameras[static_cast<std::size_t>(m_targets[v].camera)];
        RimScratch& scratch = m_views[v].scratch;
        visibleRim(camera, sources, {.cellPx = kCoarseCellPx}, scratch, m_views[v].rim);
        for (std::size_t h = 0; h < poses.size(); ++h)
            searches[h].look(camera, m_forearms.atModelsEnd(h), worldFromRest(m_hands.models[h], poses[h]),
                             scratch.coverage, m_targets[v].mask);
    }
    return searches;
}

void PoseRefiner::cutForearms(const HandPoses& poses) {
    m_cutsForearms = true;
    m_forearms.add(lookBeyondHands<ForearmSearch>(poses));
}

bool PoseRefiner::cutSleeves(const HandPoses& poses) {
    return m_forearms.any() && m_forearms.add(lookBeyondHands<SleeveSearch>(poses));
}

bool PoseRefiner::updateForearms(const HandPoses& poses) {
    const bool found = m_cutsForearms && !m_forearms.all() && m_forearms.add(lookBeyondHands<ForearmSearch>(poses));
    return cutSleeves(poses) || found;
}

} // namespace core
