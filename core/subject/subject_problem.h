// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/fitting/joint_problem.h"
#include "core/numeric/levenberg_marquardt.h"
#include "core/subject/arrow_system.h"
#include "core/subject/posed_shape.h"

namespace core {

/// What is known of the hands before anything is measured; standard deviations.
struct SubjectPriors {
    double logScale = 0.2;        ///< of the overall scale
    double girthMm = 2;           ///< of the girth
    double lengthShare = 0.03;    ///< of a segment's length beyond the scale
    double neighbourShare = 0.02; ///< between a segment and the next one of its chain
    double boneGirthMm = 0.15;    ///< of a bone's girth from the hand's
    double handsLogScale = 0.01;  ///< between both hands
    double handsShare = 0.01;     ///< between the same segment of both hands
    double handsGirthMm = 0.2;    ///< between both hands
    double angleRad = 0.6;        ///< of an angle from that of the start
    double modelSigmaMm = 0.3;    ///< how far joints are clicked from where the model has them, added to covariances
    double robustFactor = 2;      ///< of proportions: differences beyond that many deviations cost ever less (Cauchy)
};

/// One frame: the annotated joints of each hand and where each hand starts; a hand without targets is not there.
struct SubjectPose {
    std::vector<std::vector<JointTarget>> targets; ///< per hand
    std::vector<std::optional<Pose>> start;        ///< per hand
};

/// A point of the surface that an outline was seen at: residual = across . (point + offset - centre), in mm.
struct OutlineMatch {
    int frame = 0;
    int hand = 0;
    int vertexA = 0;
    int vertexB = 0;
    double t = 0;           ///< the point is (1 - t) A + t B + offset
    Eigen::Vector3d offset; ///< of the rim's bulge, in the world
    Eigen::Vector3d centre; ///< of the camera
    Eigen::Vector3d across; ///< unit, perpendicular to the ray, across the outline
    double weight = 0;      ///< 1 / sigma^2, robust factor included, 1/mm^2
};

/// How far a hand's joint is from where it was annotated, mm in the world, and the covariance of the annotation.
struct JointResidual {
    std::size_t hand = 0;
    Eigen::Vector3d residual;
    Eigen::Matrix3d covariance;
};

/// The poses of all frames and the shapes of all hands, to be found together. The unknowns: per frame and hand that is
/// there its pose, in that order, then each hand's shape. Minimises half the sum of the squared joint distances
/// (whitened by their covariances), the outline distances and the priors. Priors on proportions (lengths beyond the
/// scale, girths of bones, likeness of neighbours and hands) are robust, k^2 / 2 log(1 + r^2 / k^2): noise is held down
/// as by a Gaussian, a finger that is really longer is not.
class SubjectProblem {
public:
    /// All arguments must outlive the problem.
    SubjectProblem(const std::vector<ShapeSpace>& spaces, const std::vector<SubjectPose>& frames,
                   const std::vector<OutlineMatch>& outline, const SubjectPriors& priors);

    double cost(const Eigen::VectorXd& x) const;
    void linearise(const Eigen::VectorXd& x, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const;
    Eigen::VectorXd retract(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const;

    /// The model's hands in their starting poses.
    Eigen::VectorXd start() const;
    int size() const { return m_size; }
    /// Where the pose of a hand begins in the unknowns, or -1 if it is not there; where its shape begins.
    int poseOffset(std::size_t frame, std::size_t hand) const { return m_poseOffset[frame][hand]; }
    int shapeOffset(std::size_t hand) const { return m_shapeOffset[hand]; }
    Pose pose(const Eigen::VectorXd& x, std::size_t frame, std::size_t hand) const;
    HandShape shape(const Eigen::VectorXd& x, std::size_t hand) const;
    std::vector<JointResidual> jointResiduals(const Eigen::VectorXd& x) const;
    /// The poses as blocks of the linearised problem, which meet in the shapes alone.
    std::vector<UnknownsRange> poseBlocks() const;
    /// How many parameters the data decide, the priors taking the others: size - trace(H^-1 H_priors).
    double parametersFromData(const Eigen::VectorXd& x) const;

private:
    /// One prior: (x[a] - x[b] - value) / sigma, b = -1 for none.
    struct Link {
        int a = 0, b = -1;
        double value = 0, sigma = 1;
        bool isRobust = false;
    };
    double residualOf(const Link& link, const Eigen::VectorXd& x) const;
    /// Derivative of the link's cost by half its squared residual.
    double weightOf(const Link& link, double residual) const;
    void addAngleLinks();
    void addShapeLinks(std::size_t hand);
    void addHandLinks();
    struct Accumulator;
    /// Visits every hand of every frame; with an accumulator, adds to it. Returns the cost of joints and outlines.
    double visit(const Eigen::VectorXd& x, Accumulator* sums) const;
    double visitJoints(PosedShape& posed, std::size_t frame, std::size_t hand, Accumulator* sums) const;
    double visitOutline(PosedShape& posed, std::size_t frame, std::size_t hand, Accumulator* sums) const;

    const std::vector<ShapeSpace>& m_spaces;
    const std::vector<SubjectPose>& m_frames;
    const std::vector<OutlineMatch>& m_outline;
    SubjectPriors m_priors;
    std::vector<std::vector<int>> m_poseOffset;
    std::vector<int> m_shapeOffset;
    std::vector<Link> m_links;
    int m_size = 0;
};

/// The damped step of the solver, by eliminating the poses.
Eigen::VectorXd dampedStep(const SubjectProblem& problem, const Eigen::VectorXd& x, const Eigen::MatrixXd& damped,
                           const Eigen::VectorXd& gradient);

} // namespace core
