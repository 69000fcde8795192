// SPDX-License-Identifier: MIT
#include <cstdio>

#include "core/processor/instruction_sets.h"

// In place of the product's own: compiled for AVX2, run where it is missing.
namespace core {
const InstructionSets kCompiledFor = kX86V3;
InstructionSets instructionSetsHere() {
    return kX86V3 & ~kAvx2;
}
} // namespace core

namespace {
const int kInitialiser = std::puts("an initialiser ran");
} // namespace

int main() {
    return kInitialiser < 0 ? 2 : 0;
}
