// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/annotation/annotation_summary.h"
#include "core/io/dataset.h"
#include "core/numeric/gnuplot_text.h"

namespace core {

/// The figures of a report on annotations: finished joints over the frames, errors of all points, uncertainty per joint. None
/// without annotations.
std::vector<Figure> annotationFigures(const std::vector<AnnotationSummary>& sequences);

/// One HTML page that needs no network: progress, raters and their agreement, worst joints, doubts, figures. `pictures` are the
/// SVGs of annotationFigures, null if they could not be drawn.
std::string annotationReportHtml(const std::string& dataset, const std::vector<AnnotationSummary>& sequences,
                                 const std::vector<std::string>* pictures);

/// Reads the annotations of a dataset and writes the report of all its sequences, atomically.
void writeAnnotationReport(const Dataset& dataset, const std::filesystem::path& path, double badRmsPx = 2,
                           const QualityOptions& options = {});

} // namespace core
