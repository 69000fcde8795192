// SPDX-License-Identifier: MIT
#include "core/io/formats/annotation_formats.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/annotation/raters.h"
#include "core/error.h"
#include "core/io/formats/format_requests.h"
#include "core/io/formats/ground_truth_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

using Writer = void (*)(const ExportRequest&);
using Reader = void (*)(ImportRequest&);

/// How one kind is written and read; the ground truth goes its own way because it holds all raters.
struct Handler {
    AnnotationFormat format;
    Writer write;
    Reader read;
    const char* map; ///< built-in joint map; empty: every joint keeps its name
};

const std::vector<Handler>& handlers() {
    static const std::vector<Handler> list{
        {{"handlens", "Handlens ground truth (JSON)", true, false, true}, nullptr, nullptr, ""},
        {{"tzionas", "The method authors' NNN.txt, a folder per camera", true, true},
         writeTzionasAnnotations,
         readTzionasAnnotations,
         "tzionas"},
        {{"coco", "COCO keypoints (JSON)", true, false}, writeCocoAnnotations, readCocoAnnotations, "coco"},
        {{"anipose2d", "Anipose 2D tables, a CSV file per camera", true, true}, writeAnipose2d, readPoseTables, ""},
        {{"anipose3d", "Anipose 3D table (CSV)", true, false}, writeAnipose3d, readAnipose3d, ""},
        {{"deeplabcut", "DeepLabCut or Lightning Pose labels, a CSV file per camera (HDF5 is read, too)", true, true},
         writeDeepLabCut,
         readPoseTables,
         ""},
        {{"sleap", "SLEAP project (.slp) or analysis export (.h5)", true, false, false, false}, nullptr, readSleap, ""},
        {{"label3d", "Label3D session or DANNCE labels (.mat)", true, false, false, false}, nullptr, readLabel3d, ""},
        {{"trc", "Marker trajectories (TRC)", false, false}, writeTrc, nullptr, ""},
        {{"interhand", "InterHand2.6M-style joints and cameras (JSON)", false, true},
         writeInterHand,
         nullptr,
         "interhand"},
        {{"freihand", "HanCo-style joints and calibrations in FreiHAND's order (JSON)", false, true},
         writeFreiHand,
         nullptr,
         "freihand"},
        {{"csv", "Plain table of 3D joints (CSV)", false, false, true}, writePointCsv, nullptr, ""},
        {{"csv-marks", "Plain table of marks (CSV)", true, false, true}, writeMarkCsv, readMarkCsv, ""},
    };
    return list;
}

const Handler& handlerOf(std::string_view kind) {
    const auto& list = handlers();
    const auto found =
        std::find_if(list.begin(), list.end(), [kind](const Handler& handler) { return handler.format.kind == kind; });
    if (found == list.end()) {
        std::string known;
        for (const Handler& handler : list)
            known += (known.empty() ? "" : ", ") + std::string(handler.format.kind);
        throw Error(ErrorCode::Usage, "", std::string(kind), "is an unknown kind of annotations; known are " + known);
    }
    return *found;
}

JointMap mapFor(const Handler& handler, const fs::path& given) {
    if (!given.empty())
        return readJointMap(given);
    return handler.map[0] == '\0' ? JointMap() : readJointMap(handler.map);
}

/// The one that is asked for, or the one with most marks (the first of equals); "" if there are no marks. Proposals do
/// not count.
std::string chosenRater(const Sequence& sequence, const AnnotationSet& set, const std::optional<std::string>& asked) {
    std::map<std::string, int> marks;
    for (const auto& [key, mark] : set.marks)
        marks[key.rater] += mark.isSettled();
    if (asked) {
        if (!marks.contains(*asked))
            throw Error(ErrorCode::NotFound, sequence.annotations, "rater", "\"" + *asked + "\" has made no marks");
        return *asked;
    }
    const auto most =
        std::max_element(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == marks.end() || most->second == 0 ? std::string() : most->first;
}

/// All marks under one name; repeat rounds stay repeat rounds. Two people's marks must not meet in one joint.
AnnotationSet withRater(const AnnotationSet& set, const std::string& rater, const std::string& file) {
    AnnotationSet renamed;
    renamed.notes = set.notes;
    std::map<std::tuple<int, std::string, JointId>, std::string> owners;
    for (const auto& [key, mark] : set.marks) {
        MarkKey place = key;
        place.rater = isRepeatRater(key.rater) ? repeatRaterName(rater) : rater;
        const auto [owner, isNew] = owners.emplace(std::tuple(key.frame, place.rater, key.joint), key.rater);
        if (!isNew && owner->second != key.rater) {
            throw Error(ErrorCode::BadInput, file, "frame " + std::to_string(key.frame) + ", " + jointLabel(key.joint),
                        "is marked by " + owner->second + " and by " + key.rater + ": they cannot both become " +
                            rater);
        }
        renamed.marks.emplace(std::move(place), mark);
    }
    return renamed;
}

/// Marks that lie where no picture is.
void noteOutside(const Dataset& dataset, ImportedAnnotations& imported) {
    std::map<std::string, int> outside;
    for (const auto& [key, mark] : imported.set.marks) {
        const int camera = dataset.cameraIndex(key.camera);
        outside[key.camera] +=
            camera >= 0 && isOutside(mark, dataset.cameras[static_cast<std::size_t>(camera)]) ? 1 : 0;
    }
    for (const auto& [camera, count] : outside)
        if (count > 0)
            imported.warnings.push_back({ImportNoteKind::OutsidePicture, {camera}, count});
}

} // namespace

const std::vector<AnnotationFormat>& annotationFormats() {
    static const std::vector<AnnotationFormat> formats = [] {
        std::vector<AnnotationFormat> list;
        for (const Handler& handler : handlers())
            list.push_back(handler.format);
        return list;
    }();
    return formats;
}

const AnnotationFormat& annotationFormat(std::string_view kind) {
    return handlerOf(kind).format;
}

std::string exportAnnotations(const Dataset& dataset, const Sequence& sequence, const AnnotationSet& set,
                              std::string_view kind, const fs::path& path, const AnnotationExportOptions& options) {
    const Handler& handler = handlerOf(kind);
    if (!handler.format.canExport)
        throw Error(ErrorCode::Unsupported, "", std::string(kind), "can be read, not written");
    const bool isOfAll = handler.format.namesRaters && !options.rater;
    const std::string rater = isOfAll ? std::string() : chosenRater(sequence, set, options.rater);
    if (!handler.write) {
        writeGroundTruth(path, dataset, sequence, set, options);
        return rater;
    }
    const JointMap map = mapFor(handler, options.jointMap);
    handler.write({dataset, sequence, set, rater, map, options, path});
    return rater;
}

ImportedAnnotations importAnnotations(const Dataset& dataset, const Sequence& sequence, std::string_view kind,
                                      const fs::path& path, const AnnotationImportOptions& options) {
    const Handler& handler = handlerOf(kind);
    if (!options.camera.empty() && dataset.cameraIndex(options.camera) < 0) {
        throw Error(ErrorCode::Usage, dataset.folder.string(), "--camera",
                    "\"" + options.camera + "\" is none of its cameras");
    }
    if (!handler.format.canImport)
        throw Error(ErrorCode::Unsupported, "", std::string(kind), "can be written, not read");
    ImportedAnnotations imported;
    if (!handler.read) {
        imported = readGroundTruth(path, dataset, sequence);
    } else {
        const JointMap map = mapFor(handler, options.jointMap);
        ImportNotes notes(dataset, sequence);
        ImportRequest job{dataset, sequence, options, map, path, notes, imported.set};
        handler.read(job);
        imported.warnings = notes.all();
        imported.unknownParts = notes.unknownParts();
        imported.otherVideos = notes.otherVideos();
    }
    if (handler.format.namesRaters && options.raterForAll)
        imported.set = withRater(imported.set, options.rater, path.string());
    noteOutside(dataset, imported);
    return imported;
}

} // namespace core
