// SPDX-License-Identifier: MIT
#include "core/io/dataset_annotations.h"

#include "core/io/annotation_store.h"

namespace core {

std::filesystem::path annotationFile(const Dataset& dataset, const Sequence& sequence) {
    return dataset.folder / (sequence.annotations.empty() ? "annotations/" + sequence.name + ".sqlite" : sequence.annotations);
}

AnnotationSet readAnnotations(const Dataset& dataset, const Sequence& sequence) {
    const std::filesystem::path file = annotationFile(dataset, sequence);
    return std::filesystem::exists(file) ? AnnotationStore::open(file, StoreAccess::ReadOnly).annotations() : AnnotationSet{};
}

} // namespace core
