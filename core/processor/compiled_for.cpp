// SPDX-License-Identifier: MIT
#include "core/processor/instruction_sets.h"

namespace core {

// Compiled with the flags of the program: the compiler says here what it may use. A constant, so no code of this file
// runs.
constexpr InstructionSets kFromFlags = 0
#ifdef __SSE3__
                                       | kSse3
#endif
#ifdef __SSSE3__
                                       | kSsse3
#endif
#ifdef __SSE4_1__
                                       | kSse41
#endif
#ifdef __SSE4_2__
                                       | kSse42
#endif
#ifdef __POPCNT__
                                       | kPopcnt
#endif
#ifdef __MOVBE__
                                       | kMovbe
#endif
#ifdef __AVX__
                                       | kAvx
#endif
#ifdef __F16C__
                                       | kF16c
#endif
#ifdef __FMA__
                                       | kFma
#endif
#ifdef __AVX2__
                                       | kAvx2
#endif
#ifdef __BMI__
                                       | kBmi1
#endif
#ifdef __BMI2__
                                       | kBmi2
#endif
#ifdef __LZCNT__
                                       | kLzcnt
#endif
#ifdef __AVX512F__
                                       | kAvx512
#endif
    ;

const InstructionSets kCompiledFor = kFromFlags;

} // namespace core
