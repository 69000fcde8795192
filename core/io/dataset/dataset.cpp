// SPDX-License-Identifier: MIT
#include "core/io/dataset/dataset.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"
#include "core/io/hands/hand_file.h"
#include "core/io/hands/motion_file.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

namespace {

const std::map<std::string, ViewKind> kViewKinds{{"none", ViewKind::None},
                                                 {"rendered", ViewKind::Rendered},
                                                 {"images", ViewKind::Images},
                                                 {"video", ViewKind::Video}};

std::string viewKindName(ViewKind kind) {
    for (const auto& [name, value] : kViewKinds)
        if (value == kind)
            return name;
    return "none";
}

/// Pairs of a first instant and a count; none if the key is not there.
std::vector<InstantRange> rangesFromJson(const json& object, const char* key) {
    std::vector<InstantRange> ranges;
    for (const json& range : object.value(key, json::array()))
        ranges.push_back({range[0].get<int>(), range[1].get<int>()});
    return ranges;
}

/// Notes about the footage: text that datasets of before hold in "notes", and data in "footageNotes".
std::vector<FootageNote> notesFromJson(const json& sequence) {
    std::vector<FootageNote> notes;
    for (const json& value : sequence.value("footageNotes", json::array())) {
        notes.push_back({*footageNoteFromName(value["kind"].get<std::string>()),
                         value.value("cameras", std::vector<std::string>()), rangesFromJson(value, "ranges"),
                         value.value("numbers", std::vector<double>())});
    }
    for (const json& text : sequence.value("notes", json::array()))
        notes.push_back({FootageNoteKind::Text, {}, {}, {}, text.get<std::string>()});
    return notes;
}

ordered_json toJson(const FootageNote& note) {
    ordered_json value{{"kind", footageNoteName(note.kind)}};
    if (!note.cameras.empty())
        value["cameras"] = note.cameras;
    for (const InstantRange& range : note.ranges)
        value["ranges"].push_back(ordered_json::array({range.first, range.count}));
    for (const double number : note.numbers) {
        const auto whole = static_cast<long long>(number);
        value["numbers"].push_back(static_cast<double>(whole) == number ? ordered_json(whole) : ordered_json(number));
    }
    return value;
}

ViewSource viewFromJson(const json& value) {
    ViewSource view{value["camera"].get<std::string>(), kViewKinds.at(value["kind"].get<std::string>()),
                    value.value("path", ""), value.value("offsetFrames", 0), rangesFromJson(value, "missing")};
    view.rotateDegrees = value.value("rotate", 0);
    if (value.contains("white"))
        view.levels = GreyLevels{value.value("black", 0), value["white"].get<int>()};
    view.masks = value.value("masks", "");
    view.masksOffset = value.value("masksOffset", 0);
    return view;
}

/// What is not as usual is written only where it is so.
ordered_json toJson(const ViewSource& view) {
    ordered_json value{{"camera", view.camera},
                       {"kind", viewKindName(view.kind)},
                       {"path", view.path},
                       {"offsetFrames", view.offsetFrames}};
    if (view.rotateDegrees != 0)
        value["rotate"] = view.rotateDegrees;
    if (view.levels) {
        value["black"] = view.levels->black;
        value["white"] = view.levels->white;
    }
    if (!view.masks.empty())
        value["masks"] = view.masks;
    if (view.masksOffset != 0)
        value["masksOffset"] = view.masksOffset;
    for (const InstantRange& range : view.missing)
        value["missing"].push_back(ordered_json::array({range.first, range.count}));
    return value;
}

Sequence sequenceFromJson(const json& value) {
    Sequence sequence;
    sequence.name = value["name"].get<std::string>();
    sequence.frameCount = value["frameCount"].get<int>();
    sequence.framesPerSecond = value.value("framesPerSecond", 50.0);
    sequence.masks = value.value("masks", "");
    sequence.motion = value.value("motion", "");
    sequence.annotations = value.value("annotations", "");
    for (const json& view : value["views"])
        sequence.views.push_back(viewFromJson(view));
    sequence.notes = notesFromJson(value);
    sequence.masksMadeBy = value.value("masksMadeBy", "");
    return sequence;
}

ordered_json toJson(const Sequence& sequence) {
    ordered_json views = ordered_json::array();
    for (const ViewSource& view : sequence.views)
        views.push_back(toJson(view));
    ordered_json value{{"name", sequence.name},
                       {"frameCount", sequence.frameCount},
                       {"framesPerSecond", sequence.framesPerSecond},
                       {"motion", sequence.motion},
                       {"annotations", sequence.annotations},
                       {"masks", sequence.masks},
                       {"views", views}};
    if (!sequence.masksMadeBy.empty())
        value["masksMadeBy"] = sequence.masksMadeBy;
    for (const FootageNote& note : sequence.notes)
        if (note.kind == FootageNoteKind::Text)
            value["notes"].push_back(note.text);
        else
            value["footageNotes"].push_back(toJson(note));
    return value;
}

ordered_json toJson(const Dataset& dataset) {
    ordered_json hands = ordered_json::array();
    for (std::size_t h = 0; h < dataset.hands.size(); ++h)
        hands.push_back({{"side", sideName(dataset.hands[h].side)}, {"file", dataset.handFiles[h]}});
    ordered_json sequences = ordered_json::array();
    for (const Sequence& sequence : dataset.sequences)
        sequences.push_back(toJson(sequence));
    return {{"format", "handlens-dataset"},   {"version", 1},   {"name", dataset.name},
            {"cameras", dataset.camerasFile}, {"hands", hands}, {"sequences", sequences}};
}

void readHands(Dataset& dataset, const json& document, const std::string& file) {
    for (const json& hand : document["hands"]) {
        const std::string field = "hands[" + std::to_string(dataset.hands.size()) + "]";
        dataset.handFiles.push_back(hand["file"].get<std::string>());
        dataset.hands.push_back(readHandModel(pathInside(dataset.folder, dataset.handFiles.back(), field + ".file")));
        if (hand["side"] != sideName(dataset.hands.back().side))
            throw Error(ErrorCode::BadInput, file, field + ".side", "the file holds the other hand");
    }
    if (dataset.hands.size() == 2 && dataset.hands[0].side == dataset.hands[1].side)
        throw Error(ErrorCode::BadInput, file, "hands", "the same side is named twice");
}

/// The missing instants of a view: increasing, apart, and not beyond the sequence's end.
void checkMissing(const ViewSource& view, int frameCount, const std::string& file, const std::string& field) {
    int from = 0;
    for (std::size_t i = 0; i < view.missing.size(); ++i) {
        const InstantRange& range = view.missing[i];
        if (range.first < from || range.count < 1 || range.count > frameCount - range.first) {
            throw Error(ErrorCode::BadInput, file, field + ".missing[" + std::to_string(i) + "]",
                        "must be [first instant, count], after the ranges before it and within the sequence's " +
                            std::to_string(frameCount) + " frames");
        }
        from = range.first + range.count;
    }
}

/// Throws Error if the view makes no sense in itself.
void checkView(const ViewSource& view, const Sequence& sequence, const std::string& file, const std::string& field) {
    if ((view.kind == ViewKind::Images || view.kind == ViewKind::Video) && view.path.empty())
        throw Error(ErrorCode::BadInput, file, field + ".path", "is missing");
    if (view.kind == ViewKind::Rendered && sequence.motion.empty())
        throw Error(ErrorCode::BadInput, file, field + ".kind", "there is no motion to render from");
    checkMissing(view, sequence.frameCount, file, field);
    if (view.levels && view.levels->white <= view.levels->black)
        throw Error(ErrorCode::BadInput, file, field + ".white", "must be above black");
}

/// Notes say of which cameras they are, and have as many numbers as their kind needs.
void checkNotes(const Sequence& sequence, const std::string& file, const std::string& field) {
    std::size_t index = 0;
    for (const FootageNote& note : sequence.notes) {
        if (note.kind == FootageNoteKind::Text)
            continue;
        if (!isWhole(note)) {
            throw Error(ErrorCode::BadInput, file, field + ".footageNotes[" + std::to_string(index) + "]",
                        "a note of kind \"" + std::string(footageNoteName(note.kind)) +
                            "\" needs other cameras, ranges or numbers");
        }
        ++index;
    }
}

/// The files of the dataset itself lie in its folder (footage and masks, which are only read, may lie elsewhere).
void checkPaths(const Dataset& dataset, const fs::path& folder) {
    pathInside(folder, "dataset.json", "");
    pathInside(folder, dataset.camerasFile, "cameras");
    for (std::size_t h = 0; h < dataset.handFiles.size(); ++h)
        pathInside(folder, dataset.handFiles[h], "hands[" + std::to_string(h) + "].file");
    for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
        const std::string field = "sequences[" + std::to_string(s) + "]";
        pathInside(folder, dataset.sequences[s].motion, field + ".motion");
        annotationPathInside(folder, dataset.sequences[s].annotations, field + ".annotations");
    }
}

/// Names that are used twice, views of an unknown camera, kinds that cannot be.
void checkSequences(const Dataset& dataset, const std::string& file) {
    std::set<std::string> names;
    for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
        const Sequence& sequence = dataset.sequences[s];
        const std::string field = "sequences[" + std::to_string(s) + "]";
        if (!isFileName(sequence.name))
            throw Error(ErrorCode::BadInput, file, field + ".name", "must be usable as a file name");
        if (!names.insert(sequence.name).second)
            throw Error(ErrorCode::BadInput, file, field + ".name", "the name \"" + sequence.name + "\" is used twice");
        checkNotes(sequence, file, field);
        std::set<std::string> seen;
        for (std::size_t v = 0; v < sequence.views.size(); ++v) {
            const ViewSource& view = sequence.views[v];
            const std::string viewField = field + ".views[" + std::to_string(v) + "]";
            if (dataset.cameraIndex(view.camera) < 0 || !seen.insert(view.camera).second) {
                throw Error(ErrorCode::BadInput, file, viewField + ".camera",
                            "\"" + view.camera + "\" is not a camera of this dataset, or is named twice");
            }
            checkView(view, sequence, file, viewField);
        }
    }
}

} // namespace

const Sequence& Dataset::sequence(const std::string& sequenceName) const {
    std::string known;
    for (const Sequence& candidate : sequences) {
        if (candidate.name == sequenceName)
            return candidate;
        known += (known.empty() ? "" : ", ") + candidate.name;
    }
    throw Error(ErrorCode::NotFound, folder.string(), "sequence \"" + sequenceName + "\"",
                "is not in this dataset (it has: " + (known.empty() ? "none" : known) + ")");
}

int Dataset::cameraIndex(const std::string& cameraName) const {
    for (std::size_t c = 0; c < cameras.size(); ++c)
        if (cameras[c].name == cameraName)
            return static_cast<int>(c);
    return -1;
}

std::string maskPattern(const Sequence& sequence, const std::string& camera) {
    const auto view = std::find_if(sequence.views.begin(), sequence.views.end(),
                                   [&](const ViewSource& one) { return one.camera == camera; });
    return view == sequence.views.end() || view->masks.empty() ? sequence.masks : view->masks;
}

bool hasMasks(const Sequence& sequence) {
    return !sequence.masks.empty() || std::any_of(
                                          sequence.views.begin(), sequence.views.end(),
                                          [](const ViewSource& view) { return !view.masks.empty(); });
}

std::vector<std::string> notesInWords(const Sequence& sequence) {
    std::vector<std::string> words;
    for (const FootageNote& note : sequence.notes)
        words.push_back(footageNoteText(note));
    return words;
}

int countViews(const Sequence& sequence) {
    return static_cast<int>(std::count_if(
        sequence.views.begin(), sequence.views.end(),
        [](const ViewSource& view) { return view.kind != ViewKind::None; }));
}

Dataset readDataset(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        throw Error(ErrorCode::NotFound, folder.string(), "", "no such dataset folder");
    const fs::path file = folder / "dataset.json";
    const json document = readOwnFile(file, "dataset");
    Dataset dataset;
    dataset.folder = folder;
    dataset.name = document["name"].get<std::string>();
    dataset.camerasFile = document["cameras"].get<std::string>();
    dataset.cameras = readCameras(pathInside(folder, dataset.camerasFile, "cameras"));
    readHands(dataset, document, file.string());
    for (const json& sequence : document["sequences"])
        dataset.sequences.push_back(sequenceFromJson(sequence));
    checkSequences(dataset, file.string());
    checkPaths(dataset, folder);
    return dataset;
}

void writeDataset(const Dataset& dataset, const std::vector<Motion>& motions, const fs::path& folder) {
    checkSequences(dataset, (folder / "dataset.json").string());
    checkPaths(dataset, folder);
    PendingFolder pending(folder);
    writeCameras(pending.path() / dataset.camerasFile, dataset.cameras);
    for (std::size_t h = 0; h < dataset.hands.size(); ++h) {
        const fs::path file = pending.path() / dataset.handFiles.at(h);
        ensureFolder(file.parent_path());
        writeHandModel(file, dataset.hands[h]);
    }
    for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
        if (s < motions.size() && !motions[s].empty()) {
            const fs::path file = pending.path() / dataset.sequences[s].motion;
            ensureFolder(file.parent_path());
            writeMotionFile(file, dataset.hands, motions[s]);
        }
        if (!dataset.sequences[s].annotations.empty())
            ensureFolder((pending.path() / dataset.sequences[s].annotations).parent_path());
    }
    writeJsonFile(pending.path() / "dataset.json", toJson(dataset));
    pending.commit();
}

void rewriteDatasetFile(const Dataset& dataset) {
    const fs::path file = dataset.folder / "dataset.json";
    checkSequences(dataset, file.string());
    checkPaths(dataset, dataset.folder);
    writeJsonFile(file, toJson(dataset));
}

Motion readMotion(const Dataset& dataset, const Sequence& sequence) {
    if (sequence.motion.empty())
        return {};
    return readMotionFile(pathInside(dataset.folder, sequence.motion, "motion"), dataset.hands, sequence.frameCount);
}

} // namespace core
