// SPDX-License-Identifier: MIT
#include "core/io/import/tzionas_import.h"

#include <algorithm>

#include "core/error.h"
#include "core/fitting/recorded_pose.h"
#include "core/geometry/camera_ring.h"
#include "core/io/calibration/tzionas_cameras.h"
#include "core/io/dataset/ring_views.h"
#include "core/io/hands/hand_file.h"
#include "core/io/hands/off_mesh.h"
#include "core/io/import/tzionas_files.h"

namespace core {

namespace fs = std::filesystem;

namespace {

using BonePoses = std::vector<std::vector<RigidMotion>>; ///< [frame][bone]

/// The recording of one hand in one folder: frame 0 of `worldFromBone` is the rigging pose.
struct Recording {
    std::vector<Bone> bones;
    BonePoses worldFromBone;
};

fs::path fileOf(const fs::path& folder, Side side, const char* extension) {
    return folder / (std::string("Model_Hand_") + (side == Side::Left ? "L." : "R.") + extension);
}

/// In the sequence's folder or, if it is not there, in the common one.
fs::path findFile(const fs::path& sequenceFolder, const fs::path& modelFiles, Side side, const char* extension) {
    const fs::path own = fileOf(sequenceFolder, side, extension);
    if (fs::exists(own) || modelFiles.empty())
        return own;
    return fileOf(modelFiles, side, extension);
}

Recording readRecording(const TzionasImportOptions& options, const fs::path& folder, Side side) {
    const SkelFile skel = readSkel(findFile(folder, options.modelFiles, side, "SKEL"));
    return {skel.bones, readMotionTable(fileOf(folder, side, "MOTION"), skel.bones, skel.motionFrames)};
}

/// Bones under their standard names, with their rest poses.
std::vector<Bone> namedBones(const Recording& recording, const fs::path& file) {
    std::vector<Bone> bones = recording.bones;
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const std::optional<std::string> name = standardJointName(bones[b].name);
        if (!name)
            throw Error(ErrorCode::BadInput, file.string(), "bone '" + bones[b].name + "'", "unknown bone name");
        bones[b].name = *name;
        bones[b].worldFromBoneAtRest = recording.worldFromBone.front()[b];
    }
    return bones;
}

HandModel readHand(const TzionasImportOptions& options, Side side, const Recording& recording) {
    const fs::path& folder = options.sequenceFolders.front();
    const auto file = [&](const char* extension) { return findFile(folder, options.modelFiles, side, extension); };
    HandModel hand;
    hand.side = side;
    hand.mesh = readOffMesh(file("OFF"));
    hand.weights = readSkin(file("SKIN"), recording.bones, hand.mesh.vertices.size());
    hand.skeleton.bones = namedBones(recording, file("SKEL"));
    hand.skeleton.dofs = readLimits(file("LIMITS"), recording.bones);
    for (const Bone& bone : hand.skeleton.bones) {
        hand.skeleton.centreAtRest +=
            bone.worldFromBoneAtRest.translation / static_cast<double>(hand.skeleton.bones.size());
    }
    checkHandModel(hand, file("OFF").string());
    return hand;
}

/// Every sequence must have been recorded with the same hand.
void checkSameHand(const HandModel& hand, const Recording& recording, const fs::path& folder) {
    const std::vector<Bone> bones = namedBones(recording, fileOf(folder, hand.side, "SKEL"));
    const std::vector<Bone>& first = hand.skeleton.bones;
    const bool isSame =
        std::equal(bones.begin(), bones.end(), first.begin(), first.end(), [](const Bone& a, const Bone& b) {
            const RigidMotion &restA = a.worldFromBoneAtRest, &restB = b.worldFromBoneAtRest;
            return a.name == b.name && a.parent == b.parent && (restA.translation - restB.translation).norm() < 0.01 &&
                   (restA.rotation - restB.rotation).norm() < 1e-3;
        });
    if (!isSame) {
        throw Error(ErrorCode::BadInput, fileOf(folder, hand.side, "MOTION").string(), "",
                    "was recorded with another hand than the first sequence; import it into a dataset of its own");
    }
}

/// The state of an import between its steps.
class Importer {
public:
    Importer(const TzionasImportOptions& options, std::stop_token stop, const ImportProgress& progress)
        : m_options(options)
        , m_stop(std::move(stop))
        , m_progress(progress) {}

    ImportedDataset run() {
        findSides();
        for (const fs::path& folder : m_options.sequenceFolders)
            readSequence(folder);
        for (const Sequence& sequence : m_result.dataset.sequences)
            m_totalFrames += sequence.frameCount;
        for (std::size_t s = 0; s < m_recordings.size(); ++s)
            fitSequence(s);
        m_result.meanErrorMm = m_errorCount > 0 ? m_errorSum / m_errorCount : 0;
        addCameras();
        return std::move(m_result);
    }

private:
    void findSides() {
        if (m_options.sequenceFolders.empty())
            throw Error(ErrorCode::Usage, "", "--models", "at least one folder is needed");
        const fs::path& first = m_options.sequenceFolders.front();
        for (const Side side : {Side::Left, Side::Right})
            if (fs::exists(fileOf(first, side, "MOTION")))
                m_sides.push_back(side);
        if (m_sides.empty())
            throw Error(ErrorCode::NotFound, first.string(), "", "holds no Model_Hand_L.MOTION or Model_Hand_R.MOTION");
    }

    void readSequence(const fs::path& folder) {
        std::vector<Recording> recordings;
        for (std::size_t h = 0; h < m_sides.size(); ++h) {
            recordings.push_back(readRecording(m_options, folder, m_sides[h]));
            if (m_result.dataset.hands.size() == h) {
                m_result.dataset.hands.push_back(readHand(m_options, m_sides[h], recordings.back()));
                m_result.dataset.handFiles.push_back("hands/" + std::string(sideName(m_sides[h])) + ".json");
            }
            checkSameHand(m_result.dataset.hands[h], recordings.back(), folder);
        }
        const std::size_t frames = recordings.front().worldFromBone.size();
        if (frames < 2 || recordings.back().worldFromBone.size() != frames) {
            throw Error(ErrorCode::BadInput, fileOf(folder, m_sides.back(), "MOTION").string(), "frames",
                        "both hands must have the same number of frames, at least one after the rigging pose");
        }
        addSequence(folder, static_cast<int>(frames) - 1);
        m_recordings.push_back(std::move(recordings));
    }

    void addSequence(const fs::path& folder, int frameCount) {
        Sequence sequence;
        const fs::path plain = fs::absolute(folder).lexically_normal();
        sequence.name = (plain.has_filename() ? plain : plain.parent_path()).filename().string();
        sequence.frameCount = frameCount;
        sequence.motion = "motion/" + sequence.name + ".json";
        sequence.annotations = "annotations/" + sequence.name + ".sqlite";
        for (const Sequence& other : m_result.dataset.sequences)
            if (other.name == sequence.name)
                throw Error(ErrorCode::Usage, folder.string(), "", "two folders are named \"" + sequence.name + "\"");
        m_result.dataset.sequences.push_back(std::move(sequence));
    }

    void fitSequence(std::size_t s) {
        Motion motion;
        for (int f = 0; f < m_result.dataset.sequences[s].frameCount; ++f) {
            if (m_stop.stop_requested())
                throw Error(ErrorCode::Usage, "", "", "stopped");
            HandPoses poses;
            for (std::size_t h = 0; h < m_sides.size(); ++h) {
                RecordedPoseFit fit =
                    fitRecordedPose(m_result.dataset.hands[h].skeleton,
                                    m_recordings[s][h].worldFromBone[static_cast<std::size_t>(f) + 1]);
                poses.push_back(std::move(fit.pose));
                countErrors(fit.originErrorMm);
            }
            motion.push_back(std::move(poses));
            if (m_progress)
                m_progress(++m_framesDone, m_totalFrames);
        }
        m_result.motions.push_back(std::move(motion));
    }

    void countErrors(const std::vector<double>& errorsMm) {
        for (const double error : errorsMm) {
            m_errorSum += error;
            m_errorCount += 1;
            m_result.maxErrorMm = std::max(m_result.maxErrorMm, error);
        }
    }

    void addCameras() {
        Dataset& dataset = m_result.dataset;
        if (m_options.camerasFile.empty()) {
            CameraRingOptions ring;
            ring.count = m_options.ringCameras;
            dataset.cameras = cameraRing(recordedVolume(dataset.hands, m_result.motions), ring);
        } else {
            dataset.cameras = readTzionasCameras(m_options.camerasFile, m_options.imageSize);
        }
        addRenderedViews(dataset);
    }

    const TzionasImportOptions& m_options;
    std::stop_token m_stop;
    const ImportProgress& m_progress;
    std::vector<Side> m_sides;
    std::vector<std::vector<Recording>> m_recordings; ///< [sequence][hand]
    ImportedDataset m_result;
    int m_totalFrames = 0;
    int m_framesDone = 0;
    double m_errorSum = 0;
    double m_errorCount = 0;
};

} // namespace

ImportedDataset importTzionas(const TzionasImportOptions& options, std::stop_token stop,
                              const ImportProgress& progress) {
    return Importer(options, std::move(stop), progress).run();
}

} // namespace core
