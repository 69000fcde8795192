// SPDX-License-Identifier: MIT
#include "core/subject/subject_estimate.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "core/error.h"
#include "core/fitting/joint_fit.h"
#include "core/numeric/median.h"
#include "core/subject/outline_matching.h"

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

bool hasAllHands(const SubjectPose& pose) {
    for (const auto& start : pose.start)
        if (!start)
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

/// Matches the outlines anew where the hands are now. Returns the robust scale of the residuals, mm.
double matchAgain(Run& run, double gatePx) {
    const std::vector<OutlineMatch> none;
    const SubjectProblem problem(run.spaces, run.poses, none, run.options.priors);
    const std::vector<HandModel> hands = shapedHands(run, problem);
    run.outline.clear();
    std::vector<double> residuals;
    for (std::size_t f = 0; f < run.frames.size(); ++f) {
        if (run.frames[f].outlines.empty() || !hasAllHands(run.poses[f]))
            continue;
        HandPoses poses;
        for (std::size_t h = 0; h < hands.size(); ++h)
            poses.push_back(problem.pose(run.x, f, h));
        const std::size_t first = run.outline.size();
        matchOutlines(run.spaces, hands, poses, run.cameras, run.frames[f].outlines, static_cast<int>(f),
                      {run.options.pointsPerCamera, gatePx, run.options.outlineShare}, run.outline);
        for (std::size_t h = 0; h < hands.size(); ++h)
            poses[h] = problem.pose(run.x, f, h);
        std::vector<HandShape> shapes;
        std::vector<PosedShape> posed;
        shapes.reserve(hands.size());
        for (std::size_t h = 0; h < hands.size(); ++h) {
            shapes.push_back(problem.shape(run.x, h));
            posed.emplace_back(run.spaces[h], hands[h], shapes[h], poses[h]);
        }
        for (std::size_t i = first; i < run.outline.size(); ++i) {
            const OutlineMatch& m = run.outline[i];
            const PosedShape& hand = posed[static_cast<std::size_t>(m.hand)];
            residuals.push_back(
                m.across.dot((1 - m.t) * hand.vertex(m.vertexA) + m.t * hand.vertex(m.vertexB) + m.offset - m.centre));
        }
    }
    return weighOutline(residuals, run.options.outlineShare, run.outline);
}

/// Mean of each bone's weight over the surface.
VectorXd meanWeights(const HandModel& model) {
    VectorXd mean = VectorXd::Zero(static_cast<Eigen::Index>(model.skeleton.bones.size()));
    for (const SkinWeight& w : model.weights.entries)
        mean[w.bone] += w.weight / static_cast<double>(model.mesh.vertices.size());
    return mean;
}

Measured linearised(double value, const VectorXd& slope, const Eigen::MatrixXd& covariance) {
    return {value, std::sqrt(std::max(0.0, slope.dot(covariance * slope)))};
}

/// d length / d shape of a segment.
VectorXd lengthSlope(const ShapeSpace& space, int segment, const HandShape& shape) {
    VectorXd slope = VectorXd::Zero(space.size());
    slope[0] = space.lengthMm(segment, shape);
    slope[space.lengthIndex(segment)] = slope[0] / (1 + shape[space.lengthIndex(segment)]);
    return slope;
}

void describeLengths(const ShapeSpace& space, const Eigen::MatrixXd& covariance, SubjectHand& result) {
    const auto& bones = space.model().skeleton.bones;
    VectorXd sumSlope = VectorXd::Zero(space.size());
    double sum = 0, modelSum = 0;
    for (int a = 0; a < space.segmentCount(); ++a) {
        const ShapeSegment& segment = space.segments()[static_cast<std::size_t>(a)];
        const VectorXd slope = lengthSlope(space, a, result.shape);
        const Measured length = linearised(space.lengthMm(a, result.shape), slope, covariance);
        const double modelMm = segment.alongAtRest.norm();
        const std::string end = segment.end < 0 ? "tip" : bones[static_cast<std::size_t>(segment.end)].name;
        result.bones.push_back(
            {bones[static_cast<std::size_t>(segment.bone)].name, end, modelMm, length.value, length.sigma});
        if (segment.end >= 0) {
            sumSlope += slope;
            sum += length.value;
            modelSum += modelMm;
        }
    }
    if (modelSum > 0)
        result.scale = linearised(sum / modelSum, sumSlope / modelSum, covariance);
}

SubjectHand describe(const Run& run, const SubjectProblem& problem, std::size_t h, const Eigen::MatrixXd& covariance) {
    const ShapeSpace& space = run.spaces[h];
    SubjectHand result;
    result.shape = problem.shape(run.x, h);
    result.hand = space.shaped(result.shape);
    result.frames = framesOf(run.poses, h);
    const Eigen::MatrixXd own =
        covariance.block(problem.shapeOffset(h), problem.shapeOffset(h), space.size(), space.size());
    describeLengths(space, own, result);
    VectorXd slope = VectorXd::Zero(space.size());
    slope[1] = 1;
    slope.segment(space.girthIndex(0), space.boneCount()) = meanWeights(space.model());
    result.girthMm = linearised(slope.dot(result.shape), slope, own);
    double squared = 0;
    int count = 0;
    for (std::size_t f = 0; f < run.poses.size(); ++f) {
        if (problem.poseOffset(f, h) < 0)
            continue;
        const auto joints = jointPositions(result.hand.skeleton, problem.pose(run.x, f, h));
        for (const JointTarget& target : run.poses[f].targets[h]) {
            squared += (joints[static_cast<std::size_t>(target.bone)] - target.pointInWorld).squaredNorm();
            ++count;
        }
    }
    result.jointRmsMm = count ? std::sqrt(squared / count) : 0;
    return result;
}

SubjectResult describe(const Run& run) {
    const SubjectProblem problem(run.spaces, run.poses, run.outline, run.options.priors);
    Eigen::MatrixXd hessian;
    VectorXd gradient;
    problem.linearise(run.x, hessian, gradient);
    const Eigen::MatrixXd covariance = hessian.ldlt().solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
    SubjectResult result;
    for (std::size_t h = 0; h < run.spaces.size(); ++h)
        result.hands.push_back(describe(run, problem, h, covariance));
    result.frames = framesOfAny(run.poses);
    return result;
}

void requireEnough(const std::vector<SubjectPose>& poses) {
    const int frames = framesOfAny(poses);
    if (frames < kFewestSubjectFrames) {
        throw Error(ErrorCode::BadInput, "", "annotations",
                    "at least " + std::to_string(kFewestSubjectFrames) + " frames with " +
                        std::to_string(kFewestSubjectJoints) +
                        " or more joints of a hand in 3D are needed to measure it, and there are " +
                        std::to_string(frames));
    }
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
    if (lengthsKept)
        run.options.priors.lengthShare = run.options.priors.boneGirthMm = options.fixedShare;
    {
        const SubjectProblem problem(run.spaces, run.poses, run.outline, run.options.priors);
        run.x = problem.start();
        for (std::size_t h = 0; h < run.spaces.size(); ++h)
            run.x[problem.shapeOffset(h)] = std::log(scale);
    }
    solve(run, 30);
    double sigma = 0;
    for (int round = 0; round < options.maxRounds && !stop.stop_requested(); ++round) {
        sigma = matchAgain(run, round < 3 ? 40 : 15);
        if (run.outline.empty())
            break;
        const VectorXd before = run.x;
        solve(run, 4);
        if (round > 4 && (run.x - before).cwiseAbs().maxCoeff() < 2e-3)
            break;
    }
    SubjectResult result = describe(run);
    result.lengthsKept = lengthsKept;
    result.outlineSigmaMm = sigma;
    for (std::size_t f = 0; sigma > 0 && f < frames.size(); ++f)
        result.outlineFrames += !frames[f].outlines.empty() && hasAllHands(run.poses[f]) ? 1 : 0;
    result.stopped = stop.stop_requested();
    return result;
}

} // namespace core
