// SPDX-License-Identifier: MIT
#include "core/io/segmentation/mask_record.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/dataset/attach_masks.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr const char* kRecordFile = "segmentation.json";

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string patternOf(const fs::path& folder) {
    return (folder / "{camera}" / "{frame:06}.png").string();
}

bool holdsAnything(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder, ignored) && fs::directory_iterator(folder, ignored) != fs::directory_iterator();
}

} // namespace

MaskRecord maskRecord(const std::string& program, const Sequence& sequence, const SilhouetteOptions& options,
                      const std::string& evidence, EvidenceOrigin joints) {
    MaskRecord record{program, sequence.name, options.method, evidence, 0, 0, "", ""};
    if (options.method == SegmentationMethod::Model)
        record.bandMm = options.bandMm;
    else if (options.method != SegmentationMethod::Landmarks && joints != EvidenceOrigin::None)
        record.joints = originName(joints);
    if (options.method == SegmentationMethod::Landmarks || !record.joints.empty())
        record.forearmPalms = options.forearmPalms;
    if (options.method == SegmentationMethod::Chroma && options.backdrop) {
        char text[8];
        const cv::Scalar& bgr = *options.backdrop;
        std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(bgr[2]) & 255U,
                      static_cast<unsigned>(bgr[1]) & 255U, static_cast<unsigned>(bgr[0]) & 255U);
        record.backdrop = text;
    }
    return record;
}

std::string recordText(const MaskRecord& record) {
    std::string text(methodName(record.method));
    if (!record.evidence.empty() && record.evidence != "none")
        text += " by " + record.evidence;
    if (record.method == SegmentationMethod::Model)
        text += ", band " + numberText(record.bandMm) + " mm";
    if (record.method == SegmentationMethod::Landmarks || !record.joints.empty())
        text += ", forearm " + numberText(record.forearmPalms);
    if (!record.joints.empty())
        text += " by " + record.joints;
    if (!record.backdrop.empty())
        text += ", backdrop " + record.backdrop;
    return text + " (" + record.program + ")";
}

std::optional<MaskRecord> readMaskRecord(const fs::path& folder) {
    std::error_code ignored;
    const fs::path file = folder / kRecordFile;
    if (!fs::exists(file, ignored))
        return std::nullopt;
    const nlohmann::json value = readOwnFile(file, "segmentation");
    MaskRecord record;
    record.program = value["program"];
    record.sequence = value["sequence"];
    record.method = *segmentationMethodFromName(value["method"].get<std::string>());
    record.evidence = value["evidence"];
    record.bandMm = value["options"].value("bandMm", 0.0);
    record.forearmPalms = value["options"].value("forearmPalms", 0.0);
    record.joints = value["options"].value("joints", "");
    record.backdrop = value["options"].value("backdrop", "");
    return record;
}

void claimMaskFolder(const fs::path& folder, const MaskRecord& record) {
    if (std::optional<MaskRecord> there = readMaskRecord(folder)) {
        there->program = record.program;
        if (*there != record) {
            throw Error(ErrorCode::BadInput, (folder / kRecordFile).string(), "",
                        "the masks there are of sequence \"" + there->sequence + "\", " + recordText(*there) +
                            ", not of \"" + record.sequence + "\", " + recordText(record) + "; choose another folder");
        }
        return;
    }
    if (holdsAnything(folder))
        throw Error(ErrorCode::BadInput, folder.string(), kRecordFile,
                    "is missing: the folder holds other files; choose one that is empty or new");
    ordered_json options = ordered_json::object();
    if (record.method == SegmentationMethod::Model)
        options["bandMm"] = record.bandMm;
    if (record.method == SegmentationMethod::Landmarks || !record.joints.empty())
        options["forearmPalms"] = record.forearmPalms;
    if (!record.joints.empty())
        options["joints"] = record.joints;
    if (!record.backdrop.empty())
        options["backdrop"] = record.backdrop;
    ensureFolder(folder);
    writeJsonFile(folder / kRecordFile, {{"format", "handlens-segmentation"},
                                         {"version", 1},
                                         {"program", record.program},
                                         {"sequence", record.sequence},
                                         {"method", methodName(record.method)},
                                         {"evidence", record.evidence},
                                         {"options", options}});
}

fs::path madeMaskFile(const fs::path& folder, const std::string& camera, int frame) {
    char name[24];
    std::snprintf(name, sizeof name, "%06d.png", frame);
    return folder / camera / name;
}

std::string otherMasks(const Dataset& dataset, const Sequence& sequence, const fs::path& folder) {
    const std::string own = pathFromDataset(dataset.folder, patternOf(folder));
    for (const Camera& camera : dataset.cameras)
        if (const std::string pattern = maskPattern(sequence, camera.name); !pattern.empty() && pattern != own)
            return pattern;
    return "";
}

std::vector<std::string> attachMadeMasks(const fs::path& datasetFolder, const std::string& sequence,
                                         const fs::path& folder) {
    Dataset dataset = readDataset(datasetFolder);
    std::vector<std::string> notes;
    for (const MaskNote& note : attachMasks(dataset, sequence, {MaskSource{"", patternOf(folder), 0}}))
        notes.push_back(maskNoteText(note));
    for (Sequence& one : dataset.sequences)
        if (one.name == sequence)
            if (const auto record = readMaskRecord(folder))
                one.masksMadeBy = recordText(*record);
    rewriteDatasetFile(dataset);
    return notes;
}

} // namespace core
