// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

// This folder is compiled for the oldest processor of the architecture and uses no inline function of the standard
// library: the linker could take that function's code from a part of the program that is compiled for a newer
// processor.

namespace core {

/// A set of instruction sets that not every processor of the architecture has, one bit each.
/// Always 0 on architectures other than x86-64.
using InstructionSets = std::uint32_t;

constexpr InstructionSets kSse3 = 1u << 0;
constexpr InstructionSets kSsse3 = 1u << 1;
constexpr InstructionSets kSse41 = 1u << 2;
constexpr InstructionSets kSse42 = 1u << 3;
constexpr InstructionSets kPopcnt = 1u << 4;
constexpr InstructionSets kMovbe = 1u << 5;
constexpr InstructionSets kAvx = 1u << 6;
constexpr InstructionSets kF16c = 1u << 7;
constexpr InstructionSets kFma = 1u << 8;
constexpr InstructionSets kAvx2 = 1u << 9;
constexpr InstructionSets kBmi1 = 1u << 10;
constexpr InstructionSets kBmi2 = 1u << 11;
constexpr InstructionSets kLzcnt = 1u << 12;
constexpr InstructionSets kAvx512 = 1u << 13;

/// What a program that is compiled for x86-64-v2 and x86-64-v3 may use.
constexpr InstructionSets kX86V2 = kSse3 | kSsse3 | kSse41 | kSse42 | kPopcnt;
constexpr InstructionSets kX86V3 = kX86V2 | kMovbe | kAvx | kF16c | kFma | kAvx2 | kBmi1 | kBmi2 | kLzcnt;

/// The instruction sets that this processor has and the operating system lets programs use.
InstructionSets instructionSetsHere();

/// Writes one sentence to `text` (at most `size` bytes with the final 0) about what `present` lacks of `needed`.
/// Returns false and writes nothing if everything is there.
bool describeMissing(InstructionSets needed, InstructionSets present, char* text, std::size_t size);

/// The instruction sets that the rest of the program was compiled for (compiled_for.cpp, the only file here with the
/// program's own flags).
extern const InstructionSets kCompiledFor;

} // namespace core
