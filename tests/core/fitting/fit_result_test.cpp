// SPDX-License-Identifier: MIT
#include "core/fitting/fit_result.h"

#include <gtest/gtest.h>

namespace {

using core::FitTermination;

TEST(FitTermination, HasANameForEach) {
    EXPECT_EQ(core::terminationName(FitTermination::Converged), "converged");
    EXPECT_EQ(core::terminationName(FitTermination::MaxIterations), "max_iterations");
    EXPECT_EQ(core::terminationName(FitTermination::NoMatches), "no_matches");
    EXPECT_EQ(core::terminationName(FitTermination::Stopped), "stopped");
}

} // namespace
