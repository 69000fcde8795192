// SPDX-License-Identifier: MIT
#include "core/io/benchmark/realism_folder.h"

#include "core/io/files/atomic_file.h"
#include "core/io/files/gnuplot.h"

namespace core {

namespace fs = std::filesystem;

fs::path realismSettingFolder(const fs::path& folder, const RealismSetting& setting) {
    return folder / "settings" / setting.id;
}

void writeRealismTables(const fs::path& folder, const std::string& dataset, std::vector<RealismResult> results,
                        const std::vector<std::string>& methods) {
    addAgreements(results, methods);
    ensureFolder(folder);
    writeFileAtomically(folder / "realism.csv", realismCsv(results, methods));
    writeFileAtomically(folder / "table.md", realismMarkdown(results, methods));
    writeFileAtomically(folder / "table.tex", realismLatex(results, methods));
    const std::vector<Figure> figures = realismFigures(results, methods);
    std::vector<std::string> programs;
    for (const Figure& figure : figures)
        programs.push_back(figure.gnuplot);
    writeFileAtomically(folder / "report.html",
                        realismReportHtml(dataset, results, methods, figures, drawWithGnuplot(programs)));
}

} // namespace core
