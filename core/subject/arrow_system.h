// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace core {

/// Where the unknowns of one block begin, and how many they are.
struct UnknownsRange {
    Eigen::Index at = 0;
    Eigen::Index size = 0;
};

/// A symmetric positive definite system whose blocks A_i on the diagonal meet only in the unknowns that follow them
/// (B_i, C): the blocks are eliminated by the Schur complement S = C - sum_i B_i^T A_i^-1 B_i, so that the effort grows
/// with the number of blocks and not with its cube.
class ArrowSystem {
public:
    /// `blocks` one after another from 0 on; what follows the last one is the rest. Reads both triangles of `matrix`.
    ArrowSystem(const Eigen::MatrixXd& matrix, std::vector<UnknownsRange> blocks);

    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
    /// The part of the inverse that belongs to the rest: S^-1.
    Eigen::MatrixXd restOfInverse() const;
    /// The diagonal of the inverse in block i: that of A^-1 + A^-1 B S^-1 B^T A^-1.
    Eigen::VectorXd diagonalOfInverse(std::size_t block) const;

private:
    std::vector<UnknownsRange> m_blocks;
    std::vector<Eigen::LDLT<Eigen::MatrixXd>> m_inverses; ///< of A_i
    std::vector<Eigen::MatrixXd> m_couplings;             ///< B_i
    std::vector<Eigen::MatrixXd> m_eliminated;            ///< A_i^-1 B_i
    UnknownsRange m_rest;
    Eigen::LDLT<Eigen::MatrixXd> m_schur;
};

} // namespace core
