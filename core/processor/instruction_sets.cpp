// SPDX-License-Identifier: MIT
#include "core/processor/instruction_sets.h"

namespace core {

namespace {

struct NamedSet {
    InstructionSets bit;
    const char* name;
};
constexpr NamedSet kNames[] = {{kSse3, "SSE3"},     {kSsse3, "SSSE3"},   {kSse41, "SSE4.1"}, {kSse42, "SSE4.2"},
                               {kPopcnt, "POPCNT"}, {kMovbe, "MOVBE"},   {kAvx, "AVX"},      {kF16c, "F16C"},
                               {kFma, "FMA"},       {kAvx2, "AVX2"},     {kBmi1, "BMI1"},    {kBmi2, "BMI2"},
                               {kLzcnt, "LZCNT"},   {kAvx512, "AVX-512"}};

/// Text that grows to the end of a buffer and not further.
class Text {
public:
    Text(char* text, std::size_t size)
        : m_next(text)
        , m_end(text + size) {}

    void add(const char* part) {
        for (; *part != '\0' && m_next + 1 < m_end; ++part)
            *m_next++ = *part;
        if (m_next < m_end)
            *m_next = '\0';
    }

private:
    char* m_next;
    char* m_end;
};

} // namespace

bool describeMissing(InstructionSets needed, InstructionSets present, char* text, std::size_t size) {
    const InstructionSets missing = needed & ~present;
    if (missing == 0)
        return false;
    Text sentence(text, size);
    sentence.add("this build needs a processor with ");
    bool isFirst = true;
    for (const NamedSet& set : kNames) {
        if ((missing & set.bit) == 0)
            continue;
        sentence.add(isFirst ? "" : ", ");
        sentence.add(set.name);
        isFirst = false;
    }
    sentence.add(", which this one lacks; build Handlens on this machine with ./setup.sh");
    return true;
}

} // namespace core
