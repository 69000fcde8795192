// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "core/processor/instruction_sets.h"

namespace {

std::string missing(core::InstructionSets needed, core::InstructionSets present) {
    char text[256] = "untouched";
    return core::describeMissing(needed, present, text, sizeof text) ? text : "";
}

TEST(InstructionSets, OfAProcessorThatHasEverythingAreNotDescribed) {
    EXPECT_EQ(missing(core::kX86V3, core::kX86V3), "");
    EXPECT_EQ(missing(core::kX86V3, core::kX86V3 | core::kAvx512), "");
    EXPECT_EQ(missing(0, 0), "") << "a build for the baseline runs anywhere";
}

TEST(InstructionSets, ThatAreMissingAreNamedInOneSentence) {
    EXPECT_EQ(missing(core::kX86V3, core::kX86V3 & ~(core::kFma | core::kAvx2)),
              "this build needs a processor with FMA, AVX2, which this one lacks; build Handlens on this machine with "
              "./setup.sh");
    EXPECT_EQ(missing(core::kX86V2, core::kSse3 | core::kSsse3 | core::kSse41 | core::kPopcnt),
              "this build needs a processor with SSE4.2, which this one lacks; build Handlens on this machine with "
              "./setup.sh");
    EXPECT_NE(missing(core::kX86V3, 0)
                  .find("SSE3, SSSE3, SSE4.1, SSE4.2, POPCNT, MOVBE, AVX, F16C, FMA, AVX2, BMI1, BMI2, LZCNT, which"),
              std::string::npos);
}

TEST(InstructionSets, DescriptionEndsAtTheEndOfTheBuffer) {
    char text[12] = {};
    EXPECT_TRUE(core::describeMissing(core::kX86V3, 0, text, sizeof text));
    EXPECT_STREQ(text, "this build ");
}

TEST(InstructionSets, HereAreThoseOfTheKernelsList) {
    std::string flags;
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line) && flags.empty();)
        flags = line.starts_with("flags") ? line + " " : "";
    if (flags.empty())
        GTEST_SKIP() << "not an x86 processor";
    const std::pair<const char*, core::InstructionSets> names[] = {
        {"ssse3", core::kSsse3}, {"sse4_1", core::kSse41},  {"sse4_2", core::kSse42}, {"popcnt", core::kPopcnt},
        {"movbe", core::kMovbe}, {"avx", core::kAvx},       {"f16c", core::kF16c},    {"fma", core::kFma},
        {"avx2", core::kAvx2},   {"bmi1", core::kBmi1},     {"bmi2", core::kBmi2},    {"abm", core::kLzcnt},
        {"pni", core::kSse3},    {"avx512f", core::kAvx512}};
    for (const auto& [name, set] : names)
        EXPECT_EQ((core::instructionSetsHere() & set) != 0,
                  flags.find(std::string(" ") + name + " ") != std::string::npos)
            << name;
}

TEST(InstructionSets, OfThisBuildAreThereWhereItsTestsRun) {
    EXPECT_EQ(core::kCompiledFor & ~core::instructionSetsHere(), 0u);
}

TEST(StartCheck, EndsAProgramForANewerProcessorBeforeItsOwnInitialisers) {
    FILE* pipe = ::popen(HANDLENS_TOO_NEW " 2>&1", "r");
    ASSERT_NE(pipe, nullptr);
    char text[512] = {};
    const std::size_t length = std::fread(text, 1, sizeof text - 1, pipe);
    const int status = ::pclose(pipe);
    EXPECT_EQ(status >> 8, 1);
    EXPECT_EQ(std::string(text, length), "handlens_too_new: this build needs a processor with AVX2, which this one "
                                         "lacks; build Handlens on this machine with ./setup.sh\n");
}

} // namespace
