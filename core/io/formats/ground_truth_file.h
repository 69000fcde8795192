// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "core/annotation/reconstruction.h"
#include "core/io/dataset/dataset.h"
#include "core/io/formats/annotation_exchange.h"

namespace core {

/// One joint as it stands in the ground truth: {"xyz", "covariance", "rmsPx", "views", "unplaceable", "status"}.
nlohmann::ordered_json groundTruthJoint(const JointReconstruction& joint);

/// Writes the ground truth of one sequence (format "handlens-ground-truth"): all raters, or only one.
void writeGroundTruth(const std::filesystem::path& file, const Dataset& dataset, const Sequence& sequence,
                      const AnnotationSet& set, const AnnotationExportOptions& options);

/// Reads the marks and notes of a ground truth file; points and residuals follow from them. Raters are those of the
/// file. Joints keep their names. Marks in cameras that the dataset lacks, or in frames that the sequence lacks, are
/// left out with a warning.
ImportedAnnotations readGroundTruth(const std::filesystem::path& file, const Dataset& dataset,
                                    const Sequence& sequence);

} // namespace core
