// SPDX-License-Identifier: MIT
#include "core/processor/instruction_sets.h"

#if defined(__x86_64__)

#include <cpuid.h>

namespace core {

namespace {

/// The register state that the operating system saves: bit 1 SSE, bit 2 AVX, bits 5 to 7 AVX-512 (register XCR0).
std::uint32_t savedState() {
    std::uint32_t low = 0, high = 0;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return low;
}

InstructionSets where(std::uint32_t word, int bit, InstructionSets set) {
    return (word >> bit & 1u) != 0 ? set : 0;
}

} // namespace

// Bits as in the Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2A, CPUID.
InstructionSets instructionSetsHere() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0)
        return 0;
    const bool savesAvx = (c >> 27 & 1u) != 0 && (savedState() & 0x6u) == 0x6u;
    const bool savesAvx512 = savesAvx && (savedState() & 0xe0u) == 0xe0u;
    InstructionSets sets = where(c, 0, kSse3) | where(c, 9, kSsse3) | where(c, 19, kSse41) | where(c, 20, kSse42) |
                           where(c, 22, kMovbe) | where(c, 23, kPopcnt);
    if (savesAvx)
        sets |= where(c, 12, kFma) | where(c, 28, kAvx) | where(c, 29, kF16c);
    if (__get_cpuid_count(7, 0, &a, &b, &c, &d) != 0) {
        sets |= where(b, 3, kBmi1) | where(b, 8, kBmi2);
        if (savesAvx)
            sets |= where(b, 5, kAvx2);
        if (savesAvx512)
            sets |= where(b, 16, kAvx512);
    }
    if (__get_cpuid(0x80000001u, &a, &b, &c, &d) != 0)
        sets |= where(c, 5, kLzcnt);
    return sets;
}

} // namespace core

#else

namespace core {

InstructionSets instructionSetsHere() {
    return 0;
}

} // namespace core

#endif
