// SPDX-License-Identifier: MIT
#include "core/io/derived/subject_file.h"

#include <nlohmann/json.hpp>

#include "core/io/dataset/dataset_rig.h"
#include "core/io/files/json_file.h"
#include "core/rig/rig_findings.h"

namespace core {

namespace {

using nlohmann::ordered_json;

ordered_json numberJson(const Measured& number) {
    return {{"value", number.value}, {"sigma", number.sigma}};
}

ordered_json boneJson(const SubjectBone& bone) {
    return {{"from", bone.from},
            {"to", bone.to},
            {"modelMm", bone.modelMm},
            {"lengthMm", bone.lengthMm},
            {"sigmaMm", bone.sigmaMm},
            {"share", bone.share},
            {"shareSigma", bone.shareSigma},
            {"unlikeModel", bone.isUnlikeModel()}};
}

ordered_json handJson(const SubjectHand& hand) {
    ordered_json bones = ordered_json::array();
    for (const SubjectBone& bone : hand.bones)
        bones.push_back(boneJson(bone));
    return {{"hand", std::string(sideName(hand.hand.side))},
            {"frames", hand.frames},
            {"jointRmsMm", hand.jointRmsMm},
            {"scale", numberJson(hand.scale)},
            {"girthMm", numberJson(hand.girthMm)},
            {"bones", bones}};
}

} // namespace

void writeSubjectFile(const std::filesystem::path& file, const MeasuredSubject& measured) {
    const SubjectResult& result = measured.result;
    ordered_json frames = ordered_json::array(), hands = ordered_json::array();
    for (const SubjectFrameName& frame : measured.frames)
        frames.push_back({{"sequence", frame.sequence}, {"frame", frame.frame}});
    for (const SubjectHand& hand : result.hands)
        hands.push_back(handJson(hand));
    ordered_json document;
    document["units"] = "mm";
    document["frames"] = frames;
    document["annotatedFrames"] = measured.annotatedFrames;
    document["outlineFrames"] = result.outlineFrames;
    document["outlineSigmaMm"] = result.outlineSigmaMm;
    document["modelSigmaMm"] = result.modelSigmaMm;
    document["calibrationUnitMm"] = measured.unitMm;
    document["calibrationUnitKnown"] = measured.isUnitKnown;
    document["lengthsKept"] = result.lengthsKept;
    document["girthKept"] = result.girthKept;
    document["rigFindings"] = rigFindings(measured.rigHealth, sequenceNames(measured.dataset));
    document["hands"] = hands;
    checkSchema(nlohmann::json(document), "subject", file.string());
    writeJsonFile(file, document);
}

} // namespace core
