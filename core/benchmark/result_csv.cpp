// SPDX-License-Identifier: MIT
#include "core/benchmark/result_csv.h"

#include <cmath>

#include "core/benchmark/metrics.h"
#include "core/text/csv_line.h"
#include "core/text/number_text.h"

namespace core {

namespace {

/// sequence,start,test,difference,method
std::string keyOf(const PairResult& row) {
    return csvCell(row.pair.sequence) + "," + std::to_string(row.pair.start) + "," + std::to_string(row.pair.test) +
           "," + std::to_string(row.pair.difference()) + "," + csvCell(row.method);
}

} // namespace

std::string resultsCsv(const BenchmarkResults& results) {
    std::string text = "sequence,start,test,difference,method,initial_error_mm,error_mm,iterations,seconds\n";
    for (const PairResult& row : results.rows) {
        text += keyOf(row) + "," + exactText(row.initialErrorMm) + "," + exactText(row.errorMm) + "," +
                std::to_string(row.iterations) + "," + exactText(row.seconds) + "\n";
    }
    return text;
}

std::string jointsCsv(const BenchmarkResults& results) {
    std::string text = "sequence,start,test,difference,method,hand,joint,error_mm\n";
    for (const PairResult& row : results.rows) {
        const std::string key = keyOf(row);
        for (std::size_t j = 0; j < results.joints.size() && j < row.jointErrorsMm.size(); ++j) {
            if (!std::isnan(row.jointErrorsMm[j])) {
                text += key + "," + std::string(sideName(results.joints[j].hand)) + "," +
                        csvCell(results.joints[j].joint) + "," + exactText(row.jointErrorsMm[j]) + "\n";
            }
        }
    }
    return text;
}

std::string curvesCsv(const BenchmarkResults& results) {
    std::string text = "method,threshold_mm,share\n";
    for (const ErrorCurve& curve : errorCurves(results)) {
        for (std::size_t i = 0; i < curve.share.size(); ++i) {
            text += csvCell(curve.method) + "," + fixedText(curve.thresholdsMm[i], 1) + "," +
                    fixedText(curve.share[i], 6) + "\n";
        }
    }
    return text;
}

} // namespace core
