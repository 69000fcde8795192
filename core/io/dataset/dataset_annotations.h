// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/annotation/annotation_set.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// Where the annotations of a sequence are kept, whether or not there are any yet. Throws Error(BadInput) if that is
/// not inside the dataset's folder.
std::filesystem::path annotationFile(const Dataset& dataset, const Sequence& sequence);

/// The annotations of a sequence, without a claim to the file; empty if it has not been annotated yet. Throws as
/// AnnotationStore::open does.
AnnotationSet readAnnotations(const Dataset& dataset, const Sequence& sequence);

} // namespace core
