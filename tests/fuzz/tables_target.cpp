// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/error.h"
#include "core/io/hdf5/column_pickle.h"
#include "core/io/hdf5/pandas_frame.h"
#include "core/io/hdf5/sleap_file.h"
#include "core/io/matlab/mat_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/memory_file.h"

namespace fuzz {

namespace {

template <typename Read>
void attempt(const Read& read) {
    try {
        read();
    } catch (const core::Error&) {
    }
}

void walk(const core::MatValue& value, int depth) {
    constexpr int kDepth = 4;
    constexpr std::size_t kElements = 4;
    if (value.isMissing())
        return;
    attempt([&] { value.numbers(); });
    attempt([&] { value.text(); });
    attempt([&] { value.texts(); });
    if (depth == kDepth)
        return;
    for (std::size_t i = 0; i < std::min(value.count(), kElements); ++i)
        attempt([&] { walk(value.element(i), depth + 1); });
    for (const char* member : {"K", "r", "t", "RDistort", "TDistort", "data_3D"})
        attempt([&] { walk(value.member(member), depth + 1); });
}

} // namespace

void readMatlab(std::string_view bytes) {
    const MemoryFile file(bytes);
    attempt([&] {
        const core::MatFile matlab(file.path());
        for (const char* name : {"params", "camParams", "data_3D", "status", "camnames", "a"}) {
            attempt([&] { walk(matlab.read(name), 0); });
            attempt([&] { matlab.readShape(name).size(1); });
        }
    });
}

void readHdf5(std::string_view bytes) {
    const MemoryFile file(bytes);
    attempt([&] { core::readPandasFrame(core::Hdf5File(file.path())); });
    attempt([&] { core::readSleapFile(file.path()); });
}

void readPickle(std::string_view bytes) {
    core::columnsOfPickle(bytes);
}

} // namespace fuzz
