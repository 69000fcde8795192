// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/io/dataset/dataset.h"
#include "core/io/segmentation/sequence_evidence.h"
#include "core/segmentation/silhouette.h"

namespace core {

/// How the masks of a folder were made: its segmentation.json.
struct MaskRecord {
    std::string program; ///< name and version, such as "Handlens 0.9.0"
    std::string sequence;
    SegmentationMethod method = SegmentationMethod::Model;
    std::string evidence;    ///< originName; of Background where the pictures without hands come from
    double bandMm = 0;       ///< of Model
    double forearmPalms = 0; ///< of Landmarks, and of others that know joints
    std::string joints{};    ///< of Background, Chroma and Skin: where the joints come from at which forearms end
    std::string backdrop;    ///< of Chroma, "#rrggbb"; empty: that of the picture's border
    bool operator==(const MaskRecord&) const = default;
};

/// `joints`: of methods that need none, where those come from that are known all the same.
MaskRecord maskRecord(const std::string& program, const Sequence& sequence, const SilhouetteOptions& options,
                      const std::string& evidence, EvidenceOrigin joints = EvidenceOrigin::None);

/// In one line for people: "model by motion, band 6 mm (Handlens 0.9.0)".
std::string recordText(const MaskRecord& record);

/// The record of a folder; none if it has no segmentation.json. Throws Error(BadInput) if that is damaged.
std::optional<MaskRecord> readMaskRecord(const std::filesystem::path& folder);

/// Makes the folder ready for masks of that record: it is made, its segmentation.json is written. A folder that has one
/// already goes on if it says the same (the program's version aside). Throws Error(BadInput) if the folder holds masks
/// that were made otherwise, or anything that was not made so at all: they would be mixed.
void claimMaskFolder(const std::filesystem::path& folder, const MaskRecord& record);

/// FOLDER/<camera>/<frame:06>.png
std::filesystem::path madeMaskFile(const std::filesystem::path& folder, const std::string& camera, int frame);

/// The pattern of masks that the sequence has and that are not those of this folder; empty if there are none.
std::string otherMasks(const Dataset& dataset, const Sequence& sequence, const std::filesystem::path& folder);

/// Gives the sequence the masks of a folder, and says in dataset.json how they were made: the file is read again and
/// rewritten, atomically. Returns notes as attachMasks does.
std::vector<std::string> attachMadeMasks(const std::filesystem::path& datasetFolder, const std::string& sequence,
                                         const std::filesystem::path& folder);

} // namespace core
