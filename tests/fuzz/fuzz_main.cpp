// SPDX-License-Identifier: MIT
// libFuzzer's entry, compiled once per target: HANDLENS_FUZZ_TARGET is its name in fuzz_targets.h.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::HANDLENS_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
