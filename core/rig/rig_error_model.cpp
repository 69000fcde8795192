// SPDX-License-Identifier: MIT
#include "core/rig/rig_error_model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/numeric/median.h"
#include "core/rig/rig_refinement.h"

namespace core {

namespace {

constexpr double kLeastNoisePx = 0.02; // exact clicks of a script
constexpr double kStartScale2 = 0.1;   // of the refinement's priors: a rig that was set up in a hurry
constexpr double kLeastScale2 = 1e-8;
constexpr int kSharedGroups = 3;  // pose, focal length, distortion; then one per camera that stands apart
constexpr double kWrongClick = 5; // sigma

Eigen::Matrix<double, 9, 1> proportions() {
    const RigRefinementOptions priors;
    Eigen::Matrix<double, 9, 1> sigma;
    sigma << Eigen::Vector3d::Constant(priors.turnDeg * M_PI / 180), Eigen::Vector3d::Constant(priors.shiftMm),
        priors.focalShare, priors.distortion, priors.distortion;
    return sigma;
}

int sharedGroup(Eigen::Index unknown) {
    return unknown < 6 ? 0 : unknown == 6 ? 1 : 2;
}

} // namespace

RigErrorModel::RigErrorModel(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                             const RigResiduals& residuals)
    : m_cameraCount(static_cast<int>(cameras.size())) {
    addClicks(cameras, joints, residuals);
    const auto raters = static_cast<Eigen::Index>(m_raters.size());
    std::vector<double> squares;
    for (const RigResidual& click : residuals.clicks)
        squares.push_back(click.residualPx.squaredNorm());
    const double start = squares.empty() ? 1 : std::max(kLeastNoisePx, std::sqrt(medianOf(squares) / 2));
    m_raterSigma = Eigen::VectorXd::Constant(raters, start);
    m_sigma = Eigen::MatrixXd::Constant(raters, m_cameraCount, start);
    m_freedom = Eigen::MatrixXd::Zero(raters, m_cameraCount);
    m_proportion = proportions().replicate(m_cameraCount, 1);
    for (Eigen::Index i = 0; i < m_proportion.size(); ++i)
        m_group.push_back(sharedGroup(i % 9));
    m_scale2.assign(kSharedGroups + cameras.size(), kStartScale2);
}

void RigErrorModel::addClicks(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                              const RigResiduals& residuals) {
    std::map<std::string, int> raters;
    for (const RigJoint& joint : joints)
        raters.emplace(joint.rater, 0);
    for (auto& [name, index] : raters) {
        index = static_cast<int>(m_raters.size());
        m_raters.push_back(name);
    }
    constexpr double kLeastWeight = 0.1;
    for (const RigResidual& click : residuals.clicks) {
        const auto joint = static_cast<std::size_t>(click.joint), camera = static_cast<std::size_t>(click.camera);
        const auto projection = projectWithJacobian(cameras[camera], residuals.pointInWorld[joint]);
        const auto byCorrection =
            pxByCorrection(cameras[camera], CameraCorrection::Zero(), residuals.pointInWorld[joint]);
        if (!projection || !byCorrection)
            continue;
        if (m_clicks.empty() || m_clicks.back().joint != click.joint)
            m_ranges.push_back({m_clicks.size(), m_clicks.size()});
        m_clicks.push_back({click.joint, click.camera, raters[joints[joint].rater], click.weight >= kLeastWeight,
                            click.px - projection->px, projection->pxByPointInWorld, *byCorrection});
        m_ranges.back().last = m_clicks.size();
    }
}

double RigErrorModel::weightOf(const ErrorModelClick& click) const {
    return click.isUsed ? 1 / (m_sigma(click.rater, click.camera) * m_sigma(click.rater, click.camera)) : 0;
}

void RigErrorModel::assemble() {
    const Eigen::Index size = 9 * static_cast<Eigen::Index>(m_cameraCount);
    m_normal = Eigen::MatrixXd::Zero(size, size);
    m_gradient = Eigen::VectorXd::Zero(size);
    m_shape.assign(static_cast<std::size_t>(m_cameraCount), Eigen::Matrix<double, 9, 9>::Zero());
    m_used.assign(static_cast<std::size_t>(m_cameraCount), 0);
    std::vector<Eigen::Matrix<double, 3, 9>> coupled;
    for (const Range& range : m_ranges) {
        Eigen::Matrix3d points = Eigen::Matrix3d::Zero();
        Eigen::Vector3d pull = Eigen::Vector3d::Zero();
        coupled.clear();
        for (std::size_t k = range.first; k < range.last; ++k) {
            const ErrorModelClick& click = m_clicks[k];
            const double weight = weightOf(click);
            points += weight * click.byPoint.transpose() * click.byPoint;
            pull += weight * click.byPoint.transpose() * click.residualPx;
            coupled.emplace_back(weight * click.byPoint.transpose() * click.byCorrection);
            if (!click.isUsed)
                continue;
            const auto camera = static_cast<std::size_t>(click.camera);
            const Eigen::Matrix<double, 9, 9> square = click.byCorrection.transpose() * click.byCorrection;
            m_shape[camera] += square;
            ++m_used[camera];
            m_normal.block<9, 9>(block(click.camera), block(click.camera)) += weight * square;
            m_gradient.segment<9>(block(click.camera)) += weight * click.byCorrection.transpose() * click.residualPx;
        }
        bool isFixed = false;
        Eigen::Matrix3d inverse;
        points.computeInverseWithCheck(inverse, isFixed, 1e-24);
        if (!isFixed) { // too few clicks in use: they say nothing of the cameras
            for (std::size_t k = range.first; k < range.last; ++k)
                m_clicks[k].isUsed = false;
            continue;
        }
        for (std::size_t k = range.first; k < range.last; ++k) {
            const Eigen::Matrix<double, 9, 3> reduced = coupled[k - range.first].transpose() * inverse;
            m_gradient.segment<9>(block(m_clicks[k].camera)) -= reduced * pull;
            for (std::size_t l = range.first; l < range.last; ++l)
                m_normal.block<9, 9>(block(m_clicks[k].camera), block(m_clicks[l].camera)) -=
                    reduced * coupled[l - range.first];
        }
    }
    for (std::size_t c = 0; c < m_shape.size(); ++c)
        m_shape[c] /= std::max(1, m_used[c]);
}

void RigErrorModel::findCorrections() {
    Eigen::MatrixXd posterior = m_normal;
    for (Eigen::Index i = 0; i < m_proportion.size(); ++i)
        posterior(i, i) += 1 / (m_scale2[static_cast<std::size_t>(m_group[static_cast<std::size_t>(i)])] *
                                m_proportion[i] * m_proportion[i]);
    const Eigen::LLT<Eigen::MatrixXd> solver(posterior);
    m_corrections = solver.solve(m_gradient);
    m_covariance = solver.solve(Eigen::MatrixXd::Identity(posterior.rows(), posterior.cols()));
}

/// scale^2 = sum of (d / proportion)^2 over the number of unknowns that the clicks determine (MacKay 1992).
void RigErrorModel::updateScales() {
    std::vector<double> squares(m_scale2.size(), 0), determined(m_scale2.size(), 0), count(m_scale2.size(), 0);
    for (Eigen::Index i = 0; i < m_proportion.size(); ++i) {
        const auto group = static_cast<std::size_t>(m_group[static_cast<std::size_t>(i)]);
        const double proportion2 = m_proportion[i] * m_proportion[i];
        squares[group] += m_corrections[i] * m_corrections[i] / proportion2;
        determined[group] += 1 - m_covariance(i, i) / (m_scale2[group] * proportion2);
        ++count[group];
    }
    constexpr double kLeastShare = 0.05; // a group that the clicks do not determine shrinks to zero
    for (std::size_t g = 0; g < m_scale2.size(); ++g)
        if (count[g] > 0)
            m_scale2[g] = std::max(kLeastScale2, squares[g] / std::max(determined[g], kLeastShare * count[g]));
}

double RigErrorModel::meanSquareShift(int camera, const Eigen::Matrix<double, 9, 9>& moments) const {
    return 0.5 * m_shape[static_cast<std::size_t>(camera)].cwiseProduct(moments).sum(); // tr(B^T B M) / 2
}

/// The camera that is off by far more than the others on average gets a scale of its own, one in each call.
void RigErrorModel::setApartMovedCameras() {
    double sum = 0, most = 0;
    int worst = -1, count = 0;
    for (int c = 0; c < m_cameraCount; ++c) {
        if (isApart(c) || m_used[static_cast<std::size_t>(c)] == 0)
            continue;
        const Eigen::Matrix<double, 9, 1> d = m_corrections.segment<9>(block(c));
        const double shift2 = meanSquareShift(c, d * d.transpose());
        sum += shift2;
        ++count;
        if (shift2 > most) {
            most = shift2;
            worst = c;
        }
    }
    constexpr double kApart = 9, kLeastPx2 = 0.25; // variances: F(2, 12) exceeds 9 in 0.4 % of all rigs
    if (count >= 4 && most > kLeastPx2 && most > kApart * (sum - most) / (count - 1))
        std::fill_n(m_group.begin() + block(worst), 9, kSharedGroups + worst);
}

void RigErrorModel::findRests() {
    for (const Range& range : m_ranges) {
        Eigen::Matrix3d points = Eigen::Matrix3d::Zero();
        Eigen::Vector3d pull = Eigen::Vector3d::Zero();
        for (std::size_t k = range.first; k < range.last; ++k) {
            ErrorModelClick& click = m_clicks[k];
            click.restPx = click.residualPx - click.byCorrection * m_corrections.segment<9>(block(click.camera));
            points += weightOf(click) * click.byPoint.transpose() * click.byPoint;
            pull += weightOf(click) * click.byPoint.transpose() * click.restPx;
        }
        bool isFixed = false;
        Eigen::Matrix3d inverse;
        points.computeInverseWithCheck(inverse, isFixed, 1e-24);
        if (!isFixed)
            continue;
        for (std::size_t k = range.first; k < range.last; ++k) {
            ErrorModelClick& click = m_clicks[k];
            click.restPx -= click.byPoint * (inverse * pull);
            click.leverage = weightOf(click) * (click.byPoint * inverse * click.byPoint.transpose()).trace();
        }
        for (std::size_t k = range.first; k < range.last; ++k)
            m_clicks[k].isUsed =
                m_clicks[k].restPx.norm() < kWrongClick * m_sigma(m_clicks[k].rater, m_clicks[k].camera);
    }
}

void RigErrorModel::findNoise() {
    const auto raters = static_cast<Eigen::Index>(m_raters.size());
    Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(raters, m_cameraCount), counts = squares;
    m_freedom.setZero();
    for (const ErrorModelClick& click : m_clicks) {
        if (click.isUsed) {
            squares(click.rater, click.camera) += click.restPx.squaredNorm();
            m_freedom(click.rater, click.camera) += 2 - click.leverage;
            ++counts(click.rater, click.camera);
        }
    }
    for (int c = 0; c < m_cameraCount; ++c) { // what the corrections took
        double determined = 0;
        for (Eigen::Index i = block(c); i < block(c) + 9; ++i)
            determined +=
                1 - m_covariance(i, i) / (m_scale2[static_cast<std::size_t>(m_group[static_cast<std::size_t>(i)])] *
                                          m_proportion[i] * m_proportion[i]);
        m_freedom.col(c) -= determined / std::max(1.0, counts.col(c).sum()) * counts.col(c);
    }
    m_freedom = m_freedom.cwiseMax(0);
    constexpr double kShared = 40; // degrees of freedom that the rater's other cameras count for
    for (Eigen::Index r = 0; r < raters; ++r) {
        const double freedom = m_freedom.row(r).sum();
        if (!(freedom > 1))
            continue;
        m_raterSigma[r] = std::max(kLeastNoisePx, std::sqrt(squares.row(r).sum() / freedom));
        const double variance = m_raterSigma[r] * m_raterSigma[r];
        for (int c = 0; c < m_cameraCount; ++c)
            m_sigma(r, c) =
                std::max(kLeastNoisePx, std::sqrt((squares(r, c) + kShared * variance) / (m_freedom(r, c) + kShared)));
    }
}

void RigErrorModel::findSystematic() {
    const Eigen::Matrix<double, 9, 1> proportion = proportions();
    Eigen::Matrix<double, 9, 9> pose = Eigen::Matrix<double, 9, 9>::Zero();
    pose.diagonal().head<6>() = proportion.head<6>().cwiseAbs2();
    m_systematic.assign(static_cast<std::size_t>(m_cameraCount), 0);
    double ratio = 0;
    int count = 0, seen = 0;
    for (int c = 0; c < m_cameraCount; ++c) {
        const auto d = m_corrections.segment<9>(block(c));
        const double shift2 = meanSquareShift(c, d * d.transpose() + m_covariance.block<9, 9>(block(c), block(c)));
        m_systematic[static_cast<std::size_t>(c)] = std::sqrt(std::max(0.0, shift2));
        seen += m_used[static_cast<std::size_t>(c)] > 0;
        if (m_used[static_cast<std::size_t>(c)] > 0 && !isApart(c)) {
            ratio += shift2 / meanSquareShift(c, pose);
            ++count;
        }
    }
    if (seen < 3) {
        m_systematic.clear();
        return;
    }
    // A scale from few cameras is itself uncertain: the mean of 1 / chi^2 takes the place of 1.
    const double freedom = std::max(3.0, 2.0 * count - 3);
    ratio *= freedom / (std::max(1, count) * (freedom - 2));
    for (int c = 0; c < m_cameraCount; ++c)
        if (!isApart(c))
            m_systematic[static_cast<std::size_t>(c)] = std::sqrt(ratio * meanSquareShift(c, pose));
    spreadToUnseen();
}

/// A camera without clicks is taken to be off like the others.
void RigErrorModel::spreadToUnseen() {
    double sum = 0;
    int count = 0;
    for (int c = 0; c < m_cameraCount; ++c) {
        if (m_used[static_cast<std::size_t>(c)] > 0 && !isApart(c)) {
            sum += m_systematic[static_cast<std::size_t>(c)];
            ++count;
        }
    }
    for (int c = 0; c < m_cameraCount; ++c)
        if (m_used[static_cast<std::size_t>(c)] == 0 && count > 0)
            m_systematic[static_cast<std::size_t>(c)] = sum / count;
}

void RigErrorModel::estimate() {
    if (m_clicks.empty())
        return;
    constexpr int kRounds = 6, kScaleRounds = 25;
    for (int round = 0; round < kRounds; ++round) {
        assemble();
        for (int i = 0; i < kScaleRounds; ++i) {
            findCorrections();
            updateScales();
        }
        findCorrections();
        if (round >= 2 && round + 1 < kRounds)
            setApartMovedCameras();
        findRests();
        findNoise();
    }
    findSystematic();
}

} // namespace core
