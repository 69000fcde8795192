// SPDX-License-Identifier: MIT
#include "core/subject/subject_problem.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace core {

/// Normal equations, filled block by block: a row touches one pose and one shape.
struct SubjectProblem::Accumulator {
    Eigen::MatrixXd& hessian;
    Eigen::VectorXd& gradient;

    void add(int poseAt, Eigen::Index poseSize, int shapeAt, const Eigen::MatrixXd& rows,
             const Eigen::VectorXd& residual) {
        const Eigen::Index shapeSize = rows.cols() - poseSize;
        const Eigen::MatrixXd square = rows.transpose() * rows;
        const Eigen::VectorXd slope = rows.transpose() * residual;
        hessian.block(poseAt, poseAt, poseSize, poseSize) += square.topLeftCorner(poseSize, poseSize);
        hessian.block(poseAt, shapeAt, poseSize, shapeSize) += square.topRightCorner(poseSize, shapeSize);
        hessian.block(shapeAt, poseAt, shapeSize, poseSize) += square.bottomLeftCorner(shapeSize, poseSize);
        hessian.block(shapeAt, shapeAt, shapeSize, shapeSize) += square.bottomRightCorner(shapeSize, shapeSize);
        gradient.segment(poseAt, poseSize) += slope.head(poseSize);
        gradient.segment(shapeAt, shapeSize) += slope.tail(shapeSize);
    }
};

SubjectProblem::SubjectProblem(const std::vector<ShapeSpace>& spaces, const std::vector<SubjectPose>& frames,
                               const std::vector<OutlineMatch>& outline, const SubjectPriors& priors)
    : m_spaces(spaces)
    , m_frames(frames)
    , m_outline(outline)
    , m_priors(priors) {
    for (const SubjectPose& frame : frames) {
        auto& offsets = m_poseOffset.emplace_back();
        for (std::size_t h = 0; h < spaces.size(); ++h) {
            offsets.push_back(frame.start[h] ? m_size : -1);
            m_size += frame.start[h] ? spaces[h].model().skeleton.poseSize() : 0;
        }
    }
    for (const ShapeSpace& space : spaces) {
        m_shapeOffset.push_back(m_size);
        m_size += space.size();
    }
    addAngleLinks();
    for (std::size_t h = 0; h < spaces.size(); ++h)
        addShapeLinks(h);
    addHandLinks();
}

void SubjectProblem::addAngleLinks() {
    for (std::size_t f = 0; f < m_frames.size(); ++f) {
        for (std::size_t h = 0; h < m_spaces.size(); ++h) {
            if (m_poseOffset[f][h] < 0)
                continue;
            for (Eigen::Index k = kRigidDofs; k < m_frames[f].start[h]->size(); ++k) {
                m_links.push_back(
                    {m_poseOffset[f][h] + static_cast<int>(k), -1, (*m_frames[f].start[h])[k], m_priors.angleRad});
            }
        }
    }
}

void SubjectProblem::addShapeLinks(std::size_t hand) {
    const ShapeSpace& space = m_spaces[hand];
    const int at = m_shapeOffset[hand];
    m_links.push_back({at, -1, 0, m_priors.logScale});
    m_links.push_back({at + 1, -1, 0, m_priors.girthMm});
    for (int a = 0; a < space.segmentCount(); ++a) {
        m_links.push_back({at + space.lengthIndex(a), -1, 0, m_priors.lengthShare, true});
        for (int b = 0; b < space.segmentCount(); ++b) {
            const int end = space.segments()[static_cast<std::size_t>(a)].end;
            if (end >= 0 && space.segments()[static_cast<std::size_t>(b)].bone == end)
                m_links.push_back(
                    {at + space.lengthIndex(a), at + space.lengthIndex(b), 0, m_priors.neighbourShare, true});
        }
    }
    for (int b = 0; b < space.boneCount(); ++b)
        m_links.push_back({at + space.girthIndex(b), -1, 0, m_priors.boneGirthMm, true});
}

/// Both hands are alike: in scale and girth always, bone by bone where they have the same bones.
void SubjectProblem::addHandLinks() {
    if (m_spaces.size() != 2)
        return;
    const auto& first = m_spaces[0].model().skeleton.bones;
    const auto& second = m_spaces[1].model().skeleton.bones;
    const bool sameBones = m_spaces[0].size() == m_spaces[1].size() &&
                           std::equal(first.begin(), first.end(), second.begin(), second.end(),
                                      [](const Bone& a, const Bone& b) { return a.name == b.name; });
    for (int k = 0; k < (sameBones ? m_spaces[0].size() : 2); ++k) {
        const double sigma = k == 0                                    ? m_priors.handsLogScale
                             : k >= 2 && k < m_spaces[0].girthIndex(0) ? m_priors.handsShare
                                                                       : m_priors.handsGirthMm;
        m_links.push_back({m_shapeOffset[0] + k, m_shapeOffset[1] + k, 0, sigma, k >= 2});
    }
}

Eigen::VectorXd SubjectProblem::start() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(m_size);
    for (std::size_t f = 0; f < m_frames.size(); ++f)
        for (std::size_t h = 0; h < m_spaces.size(); ++h)
            if (m_poseOffset[f][h] >= 0)
                x.segment(m_poseOffset[f][h], m_frames[f].start[h]->size()) = *m_frames[f].start[h];
    return x;
}

Pose SubjectProblem::pose(const Eigen::VectorXd& x, std::size_t frame, std::size_t hand) const {
    return x.segment(m_poseOffset[frame][hand], m_spaces[hand].model().skeleton.poseSize());
}

HandShape SubjectProblem::shape(const Eigen::VectorXd& x, std::size_t hand) const {
    return x.segment(m_shapeOffset[hand], m_spaces[hand].size());
}

Eigen::VectorXd SubjectProblem::retract(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const {
    Eigen::VectorXd moved = x + step;
    for (std::size_t f = 0; f < m_frames.size(); ++f) {
        for (std::size_t h = 0; h < m_spaces.size(); ++h) {
            const int at = m_poseOffset[f][h];
            if (at >= 0) {
                const Eigen::Index size = m_spaces[h].model().skeleton.poseSize();
                moved.segment(at, size) = core::retract(x.segment(at, size), step.segment(at, size));
            }
        }
    }
    return moved;
}

double SubjectProblem::visitJoints(PosedShape& posed, std::size_t frame, std::size_t hand, Accumulator* sums) const {
    double cost = 0;
    for (const JointTarget& target : m_frames[frame].targets[hand]) {
        const Eigen::Matrix3d covariance =
            target.covariance + m_priors.modelSigmaMm * m_priors.modelSigmaMm * Eigen::Matrix3d::Identity();
        const Eigen::Matrix3d whitening = covariance.llt().matrixL().solve(Eigen::Matrix3d::Identity());
        const Eigen::Vector3d residual = whitening * (posed.origin(target.bone) - target.pointInWorld);
        cost += 0.5 * residual.squaredNorm();
        if (sums)
            sums->add(m_poseOffset[frame][hand], m_spaces[hand].model().skeleton.poseSize(), m_shapeOffset[hand],
                      whitening * posed.originDerivative(target.bone), residual);
    }
    return cost;
}

double SubjectProblem::visitOutline(PosedShape& posed, std::size_t frame, std::size_t hand, Accumulator* sums) const {
    std::vector<const OutlineMatch*> matches;
    for (const OutlineMatch& match : m_outline)
        if (match.frame == static_cast<int>(frame) && match.hand == static_cast<int>(hand))
            matches.push_back(&match);
    const auto count = static_cast<Eigen::Index>(matches.size());
    const Eigen::Index poseSize = m_spaces[hand].model().skeleton.poseSize();
    Eigen::VectorXd residual(count);
    Eigen::MatrixXd rows(sums ? count : 0, poseSize + m_spaces[hand].size());
    for (Eigen::Index i = 0; i < count; ++i) {
        const OutlineMatch& m = *matches[static_cast<std::size_t>(i)];
        const double root = std::sqrt(m.weight);
        const Eigen::Vector3d point = (1 - m.t) * posed.vertex(m.vertexA) + m.t * posed.vertex(m.vertexB) + m.offset;
        residual[i] = root * m.across.dot(point - m.centre);
        if (sums)
            rows.row(i) = root * m.across.transpose() *
                          ((1 - m.t) * posed.vertexDerivative(m.vertexA) + m.t * posed.vertexDerivative(m.vertexB));
    }
    if (sums && count > 0)
        sums->add(m_poseOffset[frame][hand], poseSize, m_shapeOffset[hand], rows, residual);
    return 0.5 * residual.squaredNorm();
}

double SubjectProblem::visit(const Eigen::VectorXd& x, Accumulator* sums) const {
    double cost = 0;
    for (std::size_t h = 0; h < m_spaces.size(); ++h) {
        const HandShape shape = this->shape(x, h);
        const HandModel hand = m_spaces[h].shaped(shape);
        for (std::size_t f = 0; f < m_frames.size(); ++f) {
            if (m_poseOffset[f][h] < 0)
                continue;
            const Pose pose = this->pose(x, f, h);
            PosedShape posed(m_spaces[h], hand, shape, pose);
            if (sums)
                posed.linearise();
            cost += visitJoints(posed, f, h, sums) + visitOutline(posed, f, h, sums);
        }
    }
    return cost;
}

double SubjectProblem::cost(const Eigen::VectorXd& x) const {
    double sum = visit(x, nullptr);
    const double k2 = m_priors.robustFactor * m_priors.robustFactor;
    for (const Link& link : m_links) {
        const double squared = std::pow(residualOf(link, x), 2);
        sum += 0.5 * (link.isRobust ? k2 * std::log1p(squared / k2) : squared);
    }
    return sum;
}

double SubjectProblem::residualOf(const Link& link, const Eigen::VectorXd& x) const {
    return (x[link.a] - (link.b >= 0 ? x[link.b] : 0) - link.value) / link.sigma;
}

double SubjectProblem::weightOf(const Link& link, double residual) const {
    const double relative = residual / m_priors.robustFactor;
    return link.isRobust ? 1 / (1 + relative * relative) : 1;
}

void SubjectProblem::linearise(const Eigen::VectorXd& x, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
    hessian.setZero(m_size, m_size);
    gradient.setZero(m_size);
    Accumulator sums{hessian, gradient};
    visit(x, &sums);
    for (const Link& link : m_links) {
        const double residual = residualOf(link, x);
        const double factor = weightOf(link, residual), weight = factor / (link.sigma * link.sigma);
        const double slope = factor * residual / link.sigma;
        hessian(link.a, link.a) += weight;
        gradient[link.a] += slope;
        if (link.b >= 0) {
            hessian(link.b, link.b) += weight;
            hessian(link.a, link.b) -= weight;
            hessian(link.b, link.a) -= weight;
            gradient[link.b] -= slope;
        }
    }
}

std::vector<JointResidual> SubjectProblem::jointResiduals(const Eigen::VectorXd& x) const {
    std::vector<JointResidual> residuals;
    for (std::size_t h = 0; h < m_spaces.size(); ++h) {
        const HandModel hand = m_spaces[h].shaped(shape(x, h));
        for (std::size_t f = 0; f < m_frames.size(); ++f) {
            if (m_poseOffset[f][h] < 0)
                continue;
            const auto joints = jointPositions(hand.skeleton, pose(x, f, h));
            for (const JointTarget& target : m_frames[f].targets[h])
                residuals.push_back(
                    {h, joints[static_cast<std::size_t>(target.bone)] - target.pointInWorld, target.covariance});
        }
    }
    return residuals;
}

std::vector<UnknownsRange> SubjectProblem::poseBlocks() const {
    std::vector<UnknownsRange> blocks;
    for (std::size_t f = 0; f < m_frames.size(); ++f)
        for (std::size_t h = 0; h < m_spaces.size(); ++h)
            if (m_poseOffset[f][h] >= 0)
                blocks.push_back({m_poseOffset[f][h], m_spaces[h].model().skeleton.poseSize()});
    return blocks;
}

double SubjectProblem::parametersFromData(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
    linearise(x, hessian, gradient);
    const ArrowSystem system(hessian, poseBlocks());
    const std::vector<UnknownsRange> blocks = poseBlocks();
    Eigen::VectorXd poseDiagonal = Eigen::VectorXd::Zero(m_size);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        poseDiagonal.segment(blocks[i].at, blocks[i].size) = system.diagonalOfInverse(i);
    const Eigen::MatrixXd shapes = system.restOfInverse();
    const int first = m_shapeOffset.front();
    double fromPriors = 0;
    for (const Link& link : m_links) {
        const double weight = weightOf(link, residualOf(link, x)) / (link.sigma * link.sigma);
        const int a = link.a - first, b = link.b - first;
        if (a < 0)
            fromPriors += weight * poseDiagonal[link.a];
        else
            fromPriors += weight * (link.b < 0 ? shapes(a, a) : shapes(a, a) + shapes(b, b) - 2 * shapes(a, b));
    }
    return m_size - fromPriors;
}

Eigen::VectorXd dampedStep(const SubjectProblem& problem, const Eigen::VectorXd& /*x*/, const Eigen::MatrixXd& damped,
                           const Eigen::VectorXd& gradient) {
    return -ArrowSystem(damped, problem.poseBlocks()).solve(gradient);
}

} // namespace core
