// SPDX-License-Identifier: MIT
#include "core/fitting/fit_result.h"

namespace core {

std::string_view terminationName(FitTermination termination) {
    switch (termination) {
    case FitTermination::Converged:
        return "converged";
    case FitTermination::MaxIterations:
        return "max_iterations";
    case FitTermination::NoMatches:
        return "no_matches";
    case FitTermination::Stopped:
        return "stopped";
    }
    return "";
}

} // namespace core
