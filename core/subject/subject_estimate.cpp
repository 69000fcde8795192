// SPDX-License-Identifier: MIT
#include "core/subject/subject_estimate.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "core/error.h"
#include "core/fitting/joint_fit.h"
#include "core/numeric/median.h"
#include "core/subject/outline_matching.h"
#include "core/subject/subject_measures.h"

namespace core {

namespace {

using Eigen::VectorXd;

/// One run: what does not change, and the unknowns.
struct Run {
    const std::vector<Camera>& cameras;
    const std::vector<SubjectFrame>& frames;
    SubjectOptions options;
    std::vector<ShapeSpace> spaces;
    std::vector<SubjectPose> poses;
    std::vector<OutlineMatch> outline;
    VectorXd x;
};

HandShape scaledShape(const ShapeSpace& space, double scale) {
    HandShape shape = space.modelShape();
    shape[0] = std::log(scale);
    return shape;
}

/// Joints of each frame and the poses that explain them with the model's proportions.
std::vector<SubjectPose> startingPoses(const std::vector<ShapeSpace>& spaces, const std::vector<SubjectFrame>& frames,
                                       double scale) {
    std::vector<SubjectPose> poses(frames.size());
    for (std::size_t h = 0; h < spaces.size(); ++h) {
        const Skeleton skeleton = spaces[h].shaped(scaledShape(spaces[h], scale)).skeleton;
        for (std::size_t f = 0; f < frames.size(); ++f) {
            const std::vector<JointTarget>& targets = frames[f].targets[h];
            poses[f].targets.push_back(targets);
            std::optional<JointFit> fit;
            if (static_cast<int>(targets.size()) >= kFewestSubjectJoints)
                fit = fitPoseToJoints(skeleton, targets, skeleton.restPose());
            poses[f].start.push_back(fit ? std::optional(fit->pose) : std::nullopt);
            if (!fit)
                poses[f].targets.back().clear();
        }
    }
    return poses;
}

int framesOf(const std::vector<SubjectPose>& poses, std::size_t hand) {
    int count = 0;
    for (const SubjectPose& pose : poses)
        count += pose.start[hand] ? 1 : 0;
    return count;
}

int framesOfAny(const std::vector<SubjectPose>& poses) {
    int count = 0;
    for (const SubjectPose& pose : poses) {
        bool any = false;
        for (const auto& start : pose.start)
            any = any || start;
        count += any ? 1 : 0;
    }
    return count;
}

/// Whether every hand that is annotated anywhere is annotated here, so that outlines can be explained.
bool hasAllHands(const Run& run, std::size_t frame) {
    for (std::size_t h = 0; h < run.spaces.size(); ++h)
        if (!run.poses[frame].start[h] && framesOf(run.poses, h) > 0)
            return false;
    return true;
}

void solve(Run& run, int iterations) {
    const SubjectProblem problem(run.spaces, run.poses, run.outline, run.options.priors);
    SolverOptions solver;
    solver.maxIterations = iterations;
    solver.minStep = 1e-6;
    solver.initialDamping = 1e-6;
    levenbergMarquardt(problem, solver, run.x);
}

std::vector<HandModel> shapedHands(const Run& run, const SubjectProblem& problem) {
    std::vector<HandModel> hands;
    for (std::size_t h = 0; h < run.spaces.size(); ++h)
        hands.push_back(run.spaces[h].shaped(problem.shape(run.x, h)));
    return hands;
}

double residualMm(const OutlineMatch& m, const PosedShape& hand) {
    return m.across.dot((1 - m.t) * hand.vertex(m.vertexA) + m.t * hand.vertex(m.vertexB) + m.offset - m.centre);
}

/// Matches the outlines anew where the hands are now. Returns the robust scale of the residuals, mm.
double matchAgain(Run& run, double gatePx) {
    const std::vector<OutlineMatch> none;
    const SubjectProblem problem(run.spaces, run.poses, none, run.options.priors);
    const std::vector<HandModel> hands = shapedHands(run, problem);
    std::vector<HandShape> shapes;
    for (std::size_t h = 0; h < hands.size(); ++h)
        shapes.push_back(problem.shape(run.x, h));
    OutlineMatcher matcher(run.spaces, hands);
    run.outline.clear();
    std::vector<double> residuals;
    for (std::size_t f = 0; f < run.frames.size(); ++f) {
        if (run.frames[f].outlines.empty() || !hasAllHands(run, f))
            continue;
        HandPoses poses(hands.size());
        std::vector<std::optional<PosedShape>> posed(hands.size());
        for (std::size_t h = 0; h < hands.size(); ++h) {
            if (!run.poses[f].start[h])
                continue;
            poses[h] = problem.pose(run.x, f, h);
            posed[h].emplace(run.spaces[h], hands[h], shapes[h], poses[h]);
        }
        const std::size_t first = run.outline.size();
        matcher.match(poses, run.cameras, run.frames[f].outlines, static_cast<int>(f),
                      {run.options.pointsPerCamera, gatePx, run.options.outlineShare}, run.outline);
        for (std::size_t i = first; i < run.outline.size(); ++i)
            residuals.push_back(residualMm(run.outline[i], *posed[static_cast<std::size_t>(run.outline[i].hand)]));
    }
    return weighOutline(residuals, run.options.outlineShare, run.outline);
}

double chiSquared(const std::vector<JointResidual>& residuals, double modelSigmaMm) {
    double sum = 0;
    for (const JointResidual& joint : residuals) {
        const Eigen::Matrix3d covariance = joint.covariance + modelSigmaMm * modelSigmaMm * Eigen::Matrix3d::Identity();
        sum += joint.residual.dot(covariance.llt().solve(joint.residual));
    }
    return sum;
}

/// How far joints are clicked from where the model has them, mm per axis: what the clicks' covariances leave
/// unexplained. The given one where too few joints could tell.
double estimatedModelSigma(const Run& run) {
    constexpr double kLeastMm = 0.05, kMostMm = 8;
    constexpr int kFewestFreedoms = 20;
    const SubjectProblem problem(run.spaces, run.poses, run.outline, run.options.priors);
    const std::vector<JointResidual> residuals = problem.jointResiduals(run.x);
    const double freedoms = 3.0 * static_cast<double>(residuals.size()) - problem.parametersFromData(run.x);
    if (freedoms < kFewestFreedoms)
        return run.options.priors.modelSigmaMm;
    double low = kLeastMm, high = kMostMm;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (chiSquared(residuals, middle) > freedoms ? low : high) = middle;
    }
    return high;
}

SubjectResult describe(const Run& run) {
    const SubjectProblem problem(run.spaces, run.poses, run.outline, run.options.priors);
    Eigen::MatrixXd hessian;
    VectorXd gradient;
    problem.linearise(run.x, hessian, gradient);
    const Eigen::MatrixXd covariance = ArrowSystem(hessian, problem.poseBlocks()).restOfInverse();
    SubjectResult result;
    for (std::size_t h = 0; h < run.spaces.size(); ++h) {
        const Eigen::Index at = problem.shapeOffset(h) - problem.shapeOffset(0), size = run.spaces[h].size();
        result.hands.push_back(measuredHand(run.spaces[h], problem.shape(run.x, h),
                                            covariance.block(at, at, size, size), run.options.outlineBiasMm));
        result.hands.back().frames = framesOf(run.poses, h);
    }
    std::vector<double> squared(run.spaces.size(), 0), count(run.spaces.size(), 0);
    for (const JointResidual& joint : problem.jointResiduals(run.x)) {
        squared[joint.hand] += joint.residual.squaredNorm();
        ++count[joint.hand];
    }
    for (std::size_t h = 0; h < run.spaces.size(); ++h)
        result.hands[h].jointRmsMm = count[h] > 0 ? std::sqrt(squared[h] / count[h]) : 0;
    result.frames = framesOfAny(run.poses);
    result.modelSigmaMm = run.options.priors.modelSigmaMm;
    return result;
}

void requireEnough(const std::vector<SubjectPose>& poses) {
    if (framesOfAny(poses) < kFewestSubjectFrames) {
        throw Error(ErrorCode::BadInput, "", "annotations",
                    "a frame with " + std::to_string(kFewestSubjectJoints) +
                        " or more joints of a hand in 3D is needed to measure it, and there is none");
    }
}

/// From the model at that scale: poses and shapes by the joints alone, and how far these are clicked from the model's.
void solveJoints(Run& run, double scale) {
    {
        const SubjectProblem problem(run.spaces, run.poses, run.outline, run.options.priors);
        run.x = problem.start();
        for (std::size_t h = 0; h < run.spaces.size(); ++h)
            run.x[problem.shapeOffset(h)] = std::log(scale);
    }
    solve(run, 30);
    constexpr int kModelSigmaRounds = 2;
    for (int round = 0; round < kModelSigmaRounds; ++round) {
        run.options.priors.modelSigmaMm = estimatedModelSigma(run);
        solve(run, 10);
    }
}

/// Joints and outlines together, matched again until nothing moves. Returns the robust scale of the residuals, mm.
double solveOutlines(Run& run, const std::stop_token& stop) {
    double sigma = 0;
    for (int round = 0; round < run.options.maxRounds && !stop.stop_requested(); ++round) {
        sigma = matchAgain(run, round < 3 ? 40 : 15);
        if (run.outline.empty())
            break;
        const VectorXd before = run.x;
        solve(run, 4);
        if (round > 4 && (run.x - before).cwiseAbs().maxCoeff() < 2e-3)
            break;
    }
    return sigma;
}

} // namespace

double annotatedOverModelLength(const std::vector<HandModel>& hands, const std::vector<SubjectFrame>& frames) {
    std::vector<double> ratios;
    for (const SubjectFrame& frame : frames) {
        for (std::size_t h = 0; h < hands.size(); ++h) {
            const auto& bones = hands[h].skeleton.bones;
            for (const JointTarget& end : frame.targets[h]) {
                for (const JointTarget& begin : frame.targets[h]) {
                    const auto e = static_cast<std::size_t>(end.bone), b = static_cast<std::size_t>(begin.bone);
                    const double model =
                        (bones[e].worldFromBoneAtRest.translation - bones[b].worldFromBoneAtRest.translation).norm();
                    if (bones[e].parent == begin.bone && model > 1)
                        ratios.push_back((end.pointInWorld - begin.pointInWorld).norm() / model);
                }
            }
        }
    }
    return ratios.empty() ? 0 : medianOf(ratios);
}

SubjectResult estimateSubject(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                              const std::vector<SubjectFrame>& frames, const SubjectOptions& options,
                              std::stop_token stop) {
    Run run{cameras, frames, options, {}, {}, {}, {}};
    for (const HandModel& hand : hands)
        run.spaces.emplace_back(hand);
    const double ratio = annotatedOverModelLength(hands, frames);
    const double scale = ratio > 0 ? ratio : 1;
    run.poses = startingPoses(run.spaces, frames, scale);
    requireEnough(run.poses);
    const bool lengthsKept = framesOfAny(run.poses) < options.framesForLengths;
    const bool girthKept = framesOfAny(run.poses) < options.framesForGirth;
    if (lengthsKept)
        run.options.priors.lengthShare = run.options.priors.boneGirthMm = options.fixedShare;
    if (girthKept)
        run.options.priors.girthMm = options.fixedShare;
    solveJoints(run, scale);
    const double sigma = girthKept ? 0 : solveOutlines(run, stop);
    SubjectResult result = describe(run);
    result.lengthsKept = lengthsKept;
    result.girthKept = girthKept;
    result.outlineSigmaMm = sigma;
    for (std::size_t f = 0; sigma > 0 && f < frames.size(); ++f)
        result.outlineFrames += !frames[f].outlines.empty() && hasAllHands(run, f) ? 1 : 0;
    result.stopped = stop.stop_requested();
    return result;
}

} // namespace core
