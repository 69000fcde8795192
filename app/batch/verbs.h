// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace app {

// Every verb adds itself as a subcommand with its options and a callback that does the work. One file per verb.
void addAnnotationsVerb(CLI::App& program);
void addAutolabelVerb(CLI::App& program);
void addBenchmarkVerb(CLI::App& program);
void addCalibrationVerb(CLI::App& program);
void addCheckVerb(CLI::App& program);
void addDetectorVerb(CLI::App& program);
void addExportVerb(CLI::App& program);
void addFitVerb(CLI::App& program);
void addDemoVerb(CLI::App& program);
void addImportVerb(CLI::App& program);
void addInfoVerb(CLI::App& program);
void addJointsVerb(CLI::App& program);
void addMasksVerb(CLI::App& program);
void addMergeVerb(CLI::App& program);
void addNewVerb(CLI::App& program);
void addRelinkVerb(CLI::App& program);
void addRenderVerb(CLI::App& program);
void addReportVerb(CLI::App& program);
void addRigVerb(CLI::App& program);
void addSegmentVerb(CLI::App& program);
void addSubjectVerb(CLI::App& program);
void addTriangulateVerb(CLI::App& program);

} // namespace app
