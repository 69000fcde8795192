// SPDX-License-Identifier: MIT
#include "core/io/dataset/attach_masks.h"

#include <algorithm>
#include <map>

#include "core/error.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/dataset/footage_presence.h"
#include "core/io/dataset/frames.h"
#include "core/io/dataset/mask_folder.h"
#include "core/io/footage/image_file.h"
#include "core/io/footage/image_orientation.h"

namespace core {

namespace fs = std::filesystem;

namespace {

ViewSource& viewOf(Sequence& sequence, const std::string& camera) {
    const auto view = std::find_if(sequence.views.begin(), sequence.views.end(),
                                   [&](const ViewSource& one) { return one.camera == camera; });
    if (view != sequence.views.end())
        return *view;
    sequence.views.push_back({camera, ViewKind::None, "", 0});
    return sequence.views.back();
}

std::vector<std::string> namesOf(const std::vector<Camera>& cameras) {
    std::vector<std::string> names;
    for (const Camera& camera : cameras)
        names.push_back(camera.name);
    return names;
}

/// One pattern for all cameras; masks of single cameras that were there before go.
void setForAll(Sequence& sequence, const std::vector<std::string>& cameras, const std::string& pattern, int offset) {
    sequence.masks = pattern;
    for (const std::string& camera : cameras) {
        ViewSource& view = viewOf(sequence, camera);
        view.masks.clear();
        view.masksOffset = offset;
    }
}

void setForOne(Sequence& sequence, const std::string& camera, const std::string& pattern, int offset) {
    ViewSource& view = viewOf(sequence, camera);
    view.masks = pattern;
    view.masksOffset = offset;
}

/// Numbers that lead to no frame of the sequence: a shift by one, or masks of another recording.
void noteNumbers(std::vector<MaskNote>& notes, const std::string& camera, const std::vector<int>& numbers, int offset,
                 int frameCount) {
    const auto isBeyond = [&](int number) { return number < offset || number >= offset + frameCount; };
    const auto beyond = std::count_if(numbers.begin(), numbers.end(), isBeyond);
    if (beyond == 0)
        return;
    notes.push_back({MaskNoteKind::OtherNumbers, camera, static_cast<int>(beyond), frameCount, offset, numbers.front(),
                     numbers.back()});
}

void setFromFolder(const Dataset& dataset, Sequence& sequence, const MaskSource& source, std::vector<MaskNote>& notes) {
    const std::vector<std::string> cameras =
        source.camera.empty() ? namesOf(dataset.cameras) : std::vector<std::string>{source.camera};
    const std::map<std::string, MaskNaming> found = findMaskNaming(source.from, cameras);
    if (found.empty()) {
        throw Error(ErrorCode::NotFound, source.from, "",
                    "holds no masks that are named by camera and frame, such as " + cameras.front() +
                        "/000000.png or " + cameras.front() + "_0.png");
    }
    const std::string& first = found.begin()->second.pattern;
    const bool isOnePattern = source.camera.empty() && std::all_of(found.begin(), found.end(), [&](const auto& one) {
                                  return one.second.pattern == first;
                              });
    if (isOnePattern)
        setForAll(sequence, cameras, pathFromDataset(dataset.folder, first), source.offset);
    for (const auto& [camera, naming] : found) {
        if (!isOnePattern)
            setForOne(sequence, camera, pathFromDataset(dataset.folder, naming.pattern), source.offset);
        noteNumbers(notes, camera, naming.numbers, source.offset, sequence.frameCount);
    }
}

void setFrom(const Dataset& dataset, Sequence& sequence, const MaskSource& source, std::vector<MaskNote>& notes) {
    if (!source.camera.empty() && dataset.cameraIndex(source.camera) < 0)
        throw Error(ErrorCode::NotFound, source.from, "camera \"" + source.camera + "\"", "unknown camera");
    if (source.from.find("{frame") == std::string::npos) {
        setFromFolder(dataset, sequence, source, notes);
        return;
    }
    const std::string pattern = pathFromDataset(dataset.folder, source.from);
    if (!source.camera.empty()) {
        setForOne(sequence, source.camera, pattern, source.offset);
    } else if (dataset.cameras.size() > 1 && pattern.find("{camera}") == std::string::npos) {
        throw Error(ErrorCode::Usage, source.from, "{camera}",
                    "is missing: a pattern for all cameras needs it (or give CAMERA=PATTERN for each)");
    } else {
        setForAll(sequence, namesOf(dataset.cameras), pattern, source.offset);
    }
}

/// The mask file of a frame. ".." climbs out of a dataset's folder even while that does not exist yet.
fs::path fileOf(const Dataset& dataset, const Sequence& sequence, const std::string& camera, int frame) {
    std::error_code ignored;
    const fs::path file = maskFile(dataset.folder, sequence, camera, frame);
    return fs::exists(dataset.folder, ignored) ? file : file.lexically_normal();
}

/// Number of frames that have a mask of this camera; the first one is looked at.
int countMasks(const Dataset& dataset, const Sequence& sequence, const Camera& camera) {
    int count = 0;
    std::error_code ignored;
    for (int frame = 0; frame < sequence.frameCount; ++frame) {
        const fs::path file = fileOf(dataset, sequence, camera.name, frame);
        if (file.empty() || !fs::is_regular_file(file, ignored))
            continue;
        if (count++ == 0) {
            const cv::Mat mask = readMask(file);
            if (mask.cols != camera.size.width || mask.rows != camera.size.height) {
                throw Error(ErrorCode::BadInput, file.string(), "size",
                            sizeText({mask.cols, mask.rows}) + ", but " + camera.name + " is calibrated for " +
                                sizeText(camera.size));
            }
        }
    }
    return count;
}

/// Puts how many masks there are before the other notes.
void noteCounts(const Dataset& dataset, const Sequence& sequence, const std::string& asked,
                std::vector<MaskNote>& notes) {
    std::vector<MaskNote> counts;
    int all = 0;
    std::string example;
    for (const Camera& camera : dataset.cameras) {
        example = example.empty() ? fileOf(dataset, sequence, camera.name, 0).string() : example;
        const int count = countMasks(dataset, sequence, camera);
        all += count;
        counts.push_back({MaskNoteKind::Count, camera.name, count, sequence.frameCount});
    }
    if (all == 0) {
        throw Error(ErrorCode::NotFound, asked, "",
                    "no mask of any frame of sequence \"" + sequence.name + "\" was found (the first one would be " +
                        example + ")");
    }
    notes.insert(notes.begin(), counts.begin(), counts.end());
}

} // namespace

std::string maskNoteText(const MaskNote& note) {
    if (note.kind == MaskNoteKind::Count) {
        return note.camera + ": " + std::to_string(note.count) + " of " + std::to_string(note.frameCount) +
               " frames have a mask";
    }
    const std::string range = std::to_string(note.offset) + " to " + std::to_string(note.offset + note.frameCount - 1);
    const std::string first = std::to_string(note.firstNumber);
    return note.camera + ": " + std::to_string(note.count) +
           (note.count == 1 ? " mask has a number" : " masks have numbers") + " that the sequence does not need (" +
           range + "); the masks are numbered " + first + " to " + std::to_string(note.lastNumber) +
           (note.suggestsOffset() ? ": if number " + first + " is of frame 0, use --offset " + first : "");
}

MaskSource parseMaskSource(const Dataset& dataset, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos && dataset.cameraIndex(text.substr(0, equals)) >= 0)
        return {text.substr(0, equals), text.substr(equals + 1), 0};
    return {"", text, 0};
}

std::vector<MaskNote> attachMasks(Dataset& dataset, const std::string& sequenceName,
                                  const std::vector<MaskSource>& sources) {
    if (sources.empty())
        throw Error(ErrorCode::Usage, "", "masks", "no pattern and no folder is given");
    const auto index = static_cast<std::size_t>(&dataset.sequence(sequenceName) - dataset.sequences.data());
    Sequence sequence = dataset.sequences[index];
    sequence.masksMadeBy.clear();
    std::vector<MaskNote> notes;
    for (const MaskSource& source : sources)
        setFrom(dataset, sequence, source, notes);
    noteCounts(dataset, sequence, sources.front().from, notes);
    dataset.sequences[index] = sequence;
    return notes;
}

std::vector<MaskNote> attachMasks(Dataset& dataset, const std::string& sequence, const std::string& from) {
    return attachMasks(dataset, sequence, std::vector<MaskSource>{parseMaskSource(dataset, from)});
}

} // namespace core
