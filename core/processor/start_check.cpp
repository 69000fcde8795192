// SPDX-License-Identifier: MIT
#include <errno.h> // program_invocation_short_name
#include <unistd.h>

#include "core/processor/instruction_sets.h"

namespace {

void write(const char* text) {
    std::size_t length = 0;
    while (text[length] != '\0')
        ++length;
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, length);
}

/// Ends the program with one sentence instead of an illegal instruction. Runs before every other initialiser of the
/// program (101 is the first priority that is not the compiler's own).
__attribute__((constructor(101))) void requireProcessor() {
    char text[256];
    if (core::describeMissing(core::kCompiledFor, core::instructionSetsHere(), text, sizeof text)) {
        write(program_invocation_short_name);
        write(": ");
        write(text);
        write("\n");
        ::_exit(1);
    }
}

} // namespace
