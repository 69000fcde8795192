// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/rig/rig_residuals.h"

namespace core {

/// A click in the linearised adjustment: residual = J dX + B d + noise, d the correction of its camera.
struct ErrorModelClick {
    int joint = 0;
    int camera = 0;
    int rater = 0;
    bool isUsed = true; ///< false for a wrong click
    Eigen::Vector2d residualPx = Eigen::Vector2d::Zero();
    Matrix23d byPoint = Matrix23d::Zero();
    Eigen::Matrix<double, 2, 9> byCorrection = Eigen::Matrix<double, 2, 9>::Zero();
    Eigen::Vector2d restPx = Eigen::Vector2d::Zero(); ///< after point and corrections are taken off
    double leverage = 0;                              ///< of the point's adjustment: 2 - it is what is left of the rest
};

/// The clicks with the errors of the calibration as a random effect: the corrections of the cameras are normal with
/// variances in the proportions of the refinement's weak priors, whose scale is estimated (empirical Bayes, MacKay
/// 1992); noise per rater and camera is estimated beside. One linearisation at the points of `computeRigResiduals`; a
/// camera that is off by far more than the others has a scale of its own. Deterministic.
class RigErrorModel {
public:
    RigErrorModel(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                  const RigResiduals& residuals);

    /// Estimates noise, corrections and their scale in turn.
    void estimate();

    const std::vector<std::string>& raters() const { return m_raters; }
    const std::vector<ErrorModelClick>& clicks() const { return m_clicks; }
    /// Noise of that rater in that camera, px per axis.
    double sigmaPx(int rater, int camera) const { return m_sigma(rater, camera); }
    double sigmaPx(int rater) const { return m_raterSigma[rater]; }
    /// What is left of the residuals' degrees of freedom.
    double freedom(int rater) const { return m_freedom.row(rater).sum(); }
    /// Per camera: rms over its clicks, per axis, of the shift that its wrong calibration makes; empty with fewer than
    /// three cameras.
    const std::vector<double>& systematicPx() const { return m_systematic; }

private:
    struct Range {
        std::size_t first, last;
    };
    void addClicks(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                   const RigResiduals& residuals);
    void assemble();
    void findCorrections();
    void updateScales();
    void setApartMovedCameras();
    void findRests();
    void findNoise();
    void findSystematic();
    void spreadToUnseen();
    double weightOf(const ErrorModelClick& click) const;
    Eigen::Index block(int camera) const { return 9 * static_cast<Eigen::Index>(camera); }
    double meanSquareShift(int camera, const Eigen::Matrix<double, 9, 9>& moments) const;
    bool isApart(int camera) const { return m_group[block(camera)] >= 3; }

    int m_cameraCount;
    std::vector<std::string> m_raters;
    std::vector<ErrorModelClick> m_clicks;
    std::vector<Range> m_ranges; ///< of the clicks of one joint
    Eigen::MatrixXd m_sigma;     ///< rater x camera
    Eigen::VectorXd m_raterSigma;
    Eigen::MatrixXd m_freedom; ///< rater x camera
    Eigen::MatrixXd m_normal;  ///< of the corrections, points eliminated
    Eigen::VectorXd m_gradient;
    std::vector<Eigen::Matrix<double, 9, 9>> m_shape; ///< per camera: mean of B^T B over its clicks
    std::vector<int> m_used;                          ///< per camera: clicks in use
    Eigen::VectorXd m_proportion;                     ///< standard deviation of each unknown at scale 1
    std::vector<int> m_group;                         ///< of each unknown: those of one group share a scale
    std::vector<double> m_scale2;                     ///< per group
    Eigen::VectorXd m_corrections;
    Eigen::MatrixXd m_covariance;
    std::vector<double> m_systematic;
};

} // namespace core
