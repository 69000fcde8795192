// SPDX-License-Identifier: MIT
#include "core/subject/arrow_system.h"

namespace core {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ArrowSystem::ArrowSystem(const MatrixXd& matrix, std::vector<UnknownsRange> blocks)
    : m_blocks(std::move(blocks)) {
    m_rest.at = m_blocks.empty() ? 0 : m_blocks.back().at + m_blocks.back().size;
    m_rest.size = matrix.rows() - m_rest.at;
    MatrixXd schur = matrix.block(m_rest.at, m_rest.at, m_rest.size, m_rest.size);
    for (const UnknownsRange& block : m_blocks) {
        m_inverses.emplace_back(matrix.block(block.at, block.at, block.size, block.size));
        m_couplings.emplace_back(matrix.block(block.at, m_rest.at, block.size, m_rest.size));
        m_eliminated.emplace_back(m_inverses.back().solve(m_couplings.back()));
        schur.noalias() -= m_couplings.back().transpose() * m_eliminated.back();
    }
    m_schur.compute(schur);
}

VectorXd ArrowSystem::solve(const VectorXd& right) const {
    VectorXd rest = right.segment(m_rest.at, m_rest.size);
    for (std::size_t i = 0; i < m_blocks.size(); ++i)
        rest -= m_eliminated[i].transpose() * right.segment(m_blocks[i].at, m_blocks[i].size);
    VectorXd solution(right.size());
    const VectorXd tail = m_schur.solve(rest);
    solution.segment(m_rest.at, m_rest.size) = tail;
    for (std::size_t i = 0; i < m_blocks.size(); ++i) {
        solution.segment(m_blocks[i].at, m_blocks[i].size) =
            m_inverses[i].solve(right.segment(m_blocks[i].at, m_blocks[i].size)) - m_eliminated[i] * tail;
    }
    return solution;
}

MatrixXd ArrowSystem::restOfInverse() const {
    return m_schur.solve(MatrixXd::Identity(m_rest.size, m_rest.size));
}

VectorXd ArrowSystem::diagonalOfInverse(std::size_t block) const {
    const Eigen::Index size = m_blocks[block].size;
    const MatrixXd own = m_inverses[block].solve(MatrixXd::Identity(size, size));
    const MatrixXd through = m_schur.solve(m_eliminated[block].transpose());
    return own.diagonal() + (m_eliminated[block].array() * through.transpose().array()).rowwise().sum().matrix();
}

} // namespace core
