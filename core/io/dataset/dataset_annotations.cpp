// SPDX-License-Identifier: MIT
#include "core/io/dataset/dataset_annotations.h"

#include "core/io/dataset/dataset_paths.h"
#include "core/io/store/annotation_store.h"

namespace core {

std::filesystem::path annotationFile(const Dataset& dataset, const Sequence& sequence) {
    const std::string relative =
        sequence.annotations.empty() ? "annotations/" + sequence.name + ".sqlite" : sequence.annotations;
    return annotationPathInside(dataset.folder, relative, "annotations of sequence \"" + sequence.name + "\"");
}

AnnotationSet readAnnotations(const Dataset& dataset, const Sequence& sequence) {
    const std::filesystem::path file = annotationFile(dataset, sequence);
    return std::filesystem::exists(file) ? AnnotationStore::open(file, StoreAccess::ReadOnly).annotations()
                                         : AnnotationSet{};
}

} // namespace core
