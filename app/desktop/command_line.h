// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace app {

/// What the program was asked to do.
struct CommandLine {
    std::string dataset;
    std::string sequence;
    int frame = 0;
    std::string language;
    std::string rater;
    bool offscreen = false;
    std::string script;
    std::string workspace;
    std::string out;
};

/// The arguments, or the exit status to end with (0 after help or the version, 2 for bad usage) once the text was
/// printed.
struct ParsedCommandLine {
    std::optional<CommandLine> arguments;
    int exitStatus = 0;
};
ParsedCommandLine parseCommandLine(int argc, char** argv);

} // namespace app
