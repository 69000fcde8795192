// SPDX-License-Identifier: MIT
#include "core/subject/arrow_system.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/support/random_values.h"

namespace {

using Eigen::MatrixXd;

TEST(ArrowSystem, SolvesAndInvertsAsTheDenseSystemDoes) {
    test::RandomValues random("arrow");
    const std::vector<core::UnknownsRange> blocks{{0, 3}, {3, 5}, {8, 2}};
    constexpr Eigen::Index kSize = 14;
    MatrixXd rows = MatrixXd::Zero(40, kSize);
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
        const core::UnknownsRange& block = blocks[static_cast<std::size_t>(r) % blocks.size()];
        rows.row(r).segment(block.at, block.size) = random.vector(block.size, 1);
        rows.row(r).tail(4) = random.vector(4, 1);
    }
    const MatrixXd matrix = rows.transpose() * rows + 0.1 * MatrixXd::Identity(kSize, kSize);
    const Eigen::VectorXd right = random.vector(kSize, 1);
    const MatrixXd inverse = matrix.inverse();
    const core::ArrowSystem system(matrix, blocks);
    EXPECT_LT((system.solve(right) - inverse * right).norm(), 1e-9);
    EXPECT_LT((system.restOfInverse() - inverse.bottomRightCorner(4, 4)).norm(), 1e-9);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Eigen::VectorXd expected = inverse.diagonal().segment(blocks[i].at, blocks[i].size);
        EXPECT_LT((system.diagonalOfInverse(i) - expected).norm(), 1e-9) << i;
    }
}

} // namespace
