// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/annotation/annotation_summary.h"
#include "core/io/dataset/dataset.h"
#include "core/rig/rig_health.h"
#include "core/text/gnuplot_text.h"

namespace core {

/// The figures of a report on annotations: finished joints over the frames, errors of all points, uncertainty per
/// joint. None without annotations.
std::vector<Figure> annotationFigures(const std::vector<AnnotationSummary>& sequences);

/// One HTML page that needs no network: progress, raters and their agreement, worst joints, doubts, figures. `pictures`
/// are the SVGs of the figures, in their order; null if they could not be drawn. `rig` holds what the clicks say of the
/// cameras.
std::string annotationReportHtml(const std::string& dataset, const std::vector<AnnotationSummary>& sequences,
                                 const std::vector<Figure>& figures, const std::vector<std::string>* pictures,
                                 const RigHealth& rig = {});

struct AnnotationReportOptions {
    double badRmsPx = 2; ///< joints with a larger reprojection error count as bad
    QualityOptions quality;
    bool estimateSigmas = true; ///< from the clicks; else every click counts as quality.triangulation says
};

/// Reads the annotations of a dataset and writes the report of all its sequences, atomically; nothing, and false, if
/// `stop` was requested before. `progress` counts sequences.
bool writeAnnotationReport(const Dataset& dataset, const std::filesystem::path& path,
                           const AnnotationReportOptions& options = {}, std::stop_token stop = {},
                           const std::function<void(int done, int total)>& progress = {});

} // namespace core
