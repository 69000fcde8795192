// SPDX-License-Identifier: MIT
#include <cstdio>

#include "core/processor/instruction_sets.h"

/// Prints the newest level of x86-64 that this processor runs; used when the project is configured
/// (cmake/processor.cmake).
int main() {
    const core::InstructionSets here = core::instructionSetsHere();
    const auto runs = [here](core::InstructionSets level) { return (level & ~here) == 0; };
    std::printf("%s", runs(core::kX86V3) ? "x86-64-v3" : runs(core::kX86V2) ? "x86-64-v2" : "baseline");
    return 0;
}
