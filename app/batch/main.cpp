// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/verbs.h"
#include "core/error.h"

namespace {

constexpr int kBadUsage = 2;
constexpr int kFailure = 1;

/// The one line of an error; whatever a file contained, it stays one line.
int fail(std::string message, int status) {
    for (char& c : message)
        c = static_cast<unsigned char>(c) < 32 || c == 127 ? ' ' : c;
    std::fprintf(stderr, "handlens-batch: %s\n", message.c_str());
    return status;
}

void addVerbs(CLI::App& program) {
    app::addAnnotationsVerb(program);
    app::addAutolabelVerb(program);
    app::addBenchmarkVerb(program);
    app::addCalibrationVerb(program);
    app::addCheckVerb(program);
    app::addDetectorVerb(program);
    app::addExportVerb(program);
    app::addFitVerb(program);
    app::addDemoVerb(program);
    app::addImportVerb(program);
    app::addInfoVerb(program);
    app::addJointsVerb(program);
    app::addMasksVerb(program);
    app::addMergeVerb(program);
    app::addNewVerb(program);
    app::addRelinkVerb(program);
    app::addRenderVerb(program);
    app::addReportVerb(program);
    app::addRigVerb(program);
    app::addSegmentVerb(program);
    app::addSubjectVerb(program);
    app::addTriangulateVerb(program);
}

bool isVerb(CLI::App& program, const std::string& word) {
    return !program.get_subcommands([&](const CLI::App* verb) { return verb->get_name() == word; }).empty();
}

} // namespace

int main(int argc, char** argv) {
    try {
        app::watchForInterrupts();
        CLI::App program("Handlens without a window: 3D hand ground truth in calibrated multi-camera footage",
                         "handlens-batch");
        program.set_version_flag("--version", HANDLENS_VERSION);
        program.require_subcommand(1);
        addVerbs(program);
        if (argc > 1 && argv[1][0] != '-' && !isVerb(program, argv[1]))
            return fail("\"" + std::string(argv[1]) + "\": unknown command (see --help)", kBadUsage);
        try {
            program.parse(argc, argv);
        } catch (const CLI::Success& request) { // --help, --version
            return program.exit(request);
        } catch (const CLI::ParseError& error) {
            return fail(std::string(error.what()) + " (see --help)", kBadUsage);
        }
        return 0;
    } catch (const app::Interrupted& interrupted) {
        return fail(interrupted.what(), app::interruptStatus());
    } catch (const core::Error& error) {
        const int status = error.code() == core::ErrorCode::Usage ? kBadUsage : kFailure;
        return fail(error.what(), app::interruptStatus() != 0 ? app::interruptStatus() : status);
    } catch (const std::bad_alloc&) {
        return fail("out of memory", kFailure);
    } catch (const std::exception& error) {
        return fail(std::string("unexpected: ") + error.what(), kFailure);
    }
}
