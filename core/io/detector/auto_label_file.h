// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/annotation/edit.h"
#include "core/io/dataset/dataset.h"
#include "core/labelling/auto_labels.h"

namespace core {

/// Writes labels as ground truth (format "handlens-ground-truth"): rater "auto", marks placed "auto", and beside each
/// hand's "joints" its "doubt".
void writeAutoLabels(const std::filesystem::path& file, const Dataset& dataset, const Sequence& sequence,
                     const AutoLabels& labels);

/// The labels as proposed marks of `rater`, in one step: only views without a mark whose picture shows the joint.
/// Their likelihood is 1 - doubt. `joints`: those that are proposed; none given: all that are labelled.
Edit autoLabelEdit(const AnnotationSet& set, const Dataset& dataset, const AutoLabels& labels, const std::string& rater,
                   const std::vector<JointId>& joints = {});

} // namespace core
