// SPDX-License-Identifier: MIT
#include "core/io/dataset/derived_dataset.h"

#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/files/atomic_file.h"
#include "core/io/store/annotation_store.h"

namespace core {

namespace fs = std::filesystem;

namespace {

std::string seenFrom(const fs::path& folder, const fs::path& originalFolder, const std::string& path) {
    return path.empty() ? path : pathFromDataset(folder, originalFolder / path);
}

void copyAnnotations(const fs::path& from, const fs::path& to) {
    ensureFolder(to.parent_path());
    AnnotationStore::open(from, StoreAccess::ReadOnly).copyTo(to);
}

} // namespace

void writeDerivedDataset(const Dataset& original, const Dataset& changed, const fs::path& folder) {
    PendingFolder pending(folder);
    Dataset derived = changed;
    std::vector<Motion> motions;
    for (Sequence& sequence : derived.sequences) {
        motions.push_back(readMotion(original, original.sequence(sequence.name)));
        sequence.masks = seenFrom(folder, original.folder, sequence.masks);
        for (ViewSource& view : sequence.views) {
            view.path = seenFrom(folder, original.folder, view.path);
            view.masks = seenFrom(folder, original.folder, view.masks);
        }
    }
    derived.folder = pending.path();
    writeDataset(derived, motions, pending.path());
    for (const Sequence& sequence : original.sequences) {
        const fs::path file = annotationFile(original, sequence);
        if (fs::exists(file))
            copyAnnotations(file, annotationFile(derived, sequence));
    }
    pending.commit();
}

} // namespace core
