// SPDX-License-Identifier: MIT
#include "core/io/dataset/dataset_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include <nlohmann/json.hpp>

#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/calibration/calibration.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/dataset.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/dataset/footage_check.h"
#include "core/io/dataset/footage_presence.h"
#include "core/io/files/json_file.h"
#include "core/io/footage/image_file.h"
#include "core/io/hands/hand_file.h"
#include "core/io/hdf5/pandas_frame.h"
#include "core/io/hdf5/sleap_file.h"
#include "core/io/store/annotation_store.h"

namespace core {

namespace fs = std::filesystem;

namespace {

using Findings = std::vector<CheckFinding>;

/// Runs a step; what it throws becomes a finding.
void attempt(Findings& findings, const std::function<void()>& step) {
    try {
        step();
    } catch (const Error& error) {
        findings.push_back({false, error.what()});
    }
}

std::string oneDecimal(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// A closed mesh has a triangle on both sides of every edge.
void checkSurface(Findings& findings, const HandModel& hand, const std::string& file) {
    std::size_t open = 0;
    for (const MeshEdge& edge : meshEdges(hand.mesh.triangles))
        open += edge.triangleA < 0 || edge.triangleB < 0 ? 1 : 0;
    if (open > 0)
        findings.push_back({true, file + ": triangles: the surface is open along " + std::to_string(open) + " edges"});
    else if (signedVolume(hand.mesh) <= 0)
        findings.push_back({false, file + ": triangles: the surface is inside out"});
}

/// Recorded angles outside the limits, per degree of freedom: the most it leaves them.
void noteLimits(Findings& findings, const Dataset& dataset, const Sequence& sequence, const Motion& motion) {
    for (std::size_t h = 0; h < dataset.hands.size(); ++h) {
        const std::vector<DegreeOfFreedom>& dofs = dataset.hands[h].skeleton.dofs;
        for (std::size_t d = 0; d < dofs.size(); ++d) {
            double most = 0;
            int frames = 0;
            for (const HandPoses& poses : motion) {
                const double angle = poses[h][kRigidDofs + static_cast<Eigen::Index>(d)];
                const double excess = std::max(dofs[d].minRad - angle, angle - dofs[d].maxRad);
                frames += excess > 1e-6 ? 1 : 0;
                most = std::max(most, excess);
            }
            if (most * 180 / std::numbers::pi > 0.5) {
                findings.push_back({true, sequence.motion + ": " + std::string(sideName(dataset.hands[h].side)) + " " +
                                              dofs[d].name + ": up to " + oneDecimal(most * 180 / std::numbers::pi) +
                                              " degrees outside its limits in " + std::to_string(frames) + " frames"});
            }
        }
    }
}

/// Joints that a camera does not see: the calibration or the motion is of another world.
void checkVisible(Findings& findings, const Dataset& dataset, const Sequence& sequence, const Motion& motion) {
    for (const Camera& camera : dataset.cameras) {
        int seen = 0, all = 0;
        for (std::size_t f = 0; f < motion.size(); f += 10) {
            for (std::size_t h = 0; h < dataset.hands.size(); ++h) {
                for (const Eigen::Vector3d& joint : jointPositions(dataset.hands[h].skeleton, motion[f][h])) {
                    const std::optional<Eigen::Vector2d> px = project(camera, joint);
                    seen += px && isInside(camera.size, *px) ? 1 : 0;
                    ++all;
                }
            }
        }
        if (all > 0 && seen == 0) {
            findings.push_back(
                {false, "cameras.json: " + camera.name + ": sees nothing of sequence \"" + sequence.name + "\""});
        } else if (seen < all) {
            findings.push_back({true, "cameras.json: " + camera.name + ": " + std::to_string(100 * (all - seen) / all) +
                                          " % of the joints of sequence \"" + sequence.name +
                                          "\" lie outside its image"});
        }
    }
}

/// The file must be whole; marks of cameras or frames that are gone are worth knowing.
void checkAnnotations(Findings& findings, const Dataset& dataset, const Sequence& sequence) {
    const fs::path file = annotationFile(dataset, sequence);
    int lostFrames = 0, lostCameras = 0;
    std::map<std::string, int> outside; // by camera
    for (const auto& [key, mark] : readAnnotations(dataset, sequence).marks) {
        lostFrames += key.frame < 0 || key.frame >= sequence.frameCount ? 1 : 0;
        const int camera = dataset.cameraIndex(key.camera);
        lostCameras += camera < 0 ? 1 : 0;
        if (camera >= 0 && !mark.isProposal() && isOutside(mark, dataset.cameras[static_cast<std::size_t>(camera)]))
            ++outside[key.camera];
    }
    for (const auto& [camera, count] : outside) {
        findings.push_back({true, file.string() + ": " + std::to_string(count) +
                                      (count == 1 ? " mark lies" : " marks lie") + " outside the picture of " +
                                      camera});
    }
    if (lostFrames > 0) {
        findings.push_back({true, file.string() + ": " + std::to_string(lostFrames) +
                                      " marks lie in frames that the sequence does not have"});
    }
    if (lostCameras > 0) {
        findings.push_back({true, file.string() + ": " + std::to_string(lostCameras) +
                                      " marks are of cameras that the dataset does not have"});
    }
}

/// The files that dataset.json names, each by itself, so that one broken file does not hide the next.
void checkParts(Findings& findings, const fs::path& folder) {
    const nlohmann::json document = readOwnFile(folder / "dataset.json", "dataset");
    attempt(findings, [&] { readCameras(pathInside(folder, document["cameras"].get<std::string>(), "cameras")); });
    for (const nlohmann::json& hand : document["hands"]) {
        const std::string file = hand["file"].get<std::string>();
        attempt(findings, [&] { checkSurface(findings, readHandModel(pathInside(folder, file, "hands")), file); });
    }
}

bool hasProblem(const Findings& findings) {
    return std::any_of(
        findings.begin(), findings.end(), [](const CheckFinding& finding) { return !finding.isNote; });
}

void checkDataset(Findings& findings, const fs::path& folder) {
    checkParts(findings, folder);
    if (hasProblem(findings))
        return; // the sequences make no sense without cameras and hands
    const Dataset dataset = readDataset(folder);
    if (const std::string unit = unitNote(dataset.cameras); !unit.empty())
        findings.push_back({true, dataset.camerasFile + ": " + unit});
    for (const std::string& lens : lensNotes(dataset.cameras))
        findings.push_back({true, dataset.camerasFile + ": " + lens});
    for (const Sequence& sequence : dataset.sequences) {
        attempt(
            findings,
            [&] {
                const Motion motion = readMotion(dataset, sequence);
                noteLimits(findings, dataset, sequence, motion);
                checkVisible(findings, dataset, sequence, motion);
            });
        attempt(findings, [&] { checkAnnotations(findings, dataset, sequence); });
        for (const std::string& note : orientationNotes(dataset, sequence))
            findings.push_back({true, note});
        for (const auto& [isNote, text] : checkFootage(dataset, sequence))
            findings.push_back({isNote, text});
    }
    if (!hasProblem(findings))
        for (const std::string& sentence : datasetRigFindings(dataset))
            findings.push_back({true, dataset.camerasFile + ": " + sentence});
}

/// A calibration of any kind; what is worth knowing about it are notes.
void checkCalibration(Findings& findings, const fs::path& path) {
    CalibrationOptions options;
    options.assumeSize = true;
    const std::vector<Camera> cameras = readCalibration(path, options);
    for (const std::string& note : calibrationNotes(path, options, cameras))
        findings.push_back({true, path.string() + ": " + note});
}

bool isCalibration(const fs::path& path) {
    try {
        sniffCalibration(path);
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// What a file without a telling extension begins with.
bool isJson(const fs::path& file) {
    char first = 0;
    std::ifstream(file) >> first;
    return first == '{' || first == '[';
}

/// Annotations in HDF5: of SLEAP, else a data frame of pandas (DeepLabCut, Anipose).
void checkHdf5(Findings& findings, const fs::path& path) {
    if (const Hdf5File file(path); !file.has("metadata") && !file.has("tracks")) {
        readPandasFrame(file);
        return;
    }
    const SleapFile file = readSleapFile(path);
    std::set<std::pair<std::string, int>> pictures;
    std::set<std::string> nodes;
    std::size_t guesses = 0;
    for (const SleapInstance& instance : file.instances) {
        pictures.insert({instance.video, instance.frame});
        guesses += instance.isGuess ? 1 : 0;
        for (const SleapPoint& point : instance.points)
            nodes.insert(point.node);
    }
    findings.push_back({true, path.string() + ": " + std::to_string(file.instances.size() - guesses) +
                                  " labelled and " + std::to_string(guesses) + " guessed skeletons of " +
                                  std::to_string(nodes.size()) + " nodes in " + std::to_string(pictures.size()) +
                                  " pictures"});
}

void checkFile(Findings& findings, const fs::path& file) {
    if (file.extension() == ".sqlite") {
        AnnotationStore::open(file, StoreAccess::ReadOnly).annotations();
        return;
    }
    if (file.extension() == ".slp" || file.extension() == ".h5") {
        checkHdf5(findings, file);
        return;
    }
    if (file.extension() != ".json" && !isJson(file)) {
        checkCalibration(findings, file);
        return;
    }
    const nlohmann::json value = readJsonFile(file);
    const std::string format = value.is_object() && value.contains("format") && value["format"].is_string()
                                   ? value["format"].get<std::string>()
                                   : "";
    if (format == "handlens-hand")
        checkSurface(findings, readHandModel(file), file.string());
    else if (format == "handlens-dataset")
        checkDataset(findings, fs::absolute(file).parent_path());
    else if (format.starts_with("handlens-") && format != "handlens-cameras")
        readOwnFile(file, format.substr(9));
    else if (isCalibration(file))
        checkCalibration(findings, file);
    else
        throw Error(ErrorCode::Unsupported, file.string(), "format", "is none of Handlens's own");
}

} // namespace

std::vector<CheckFinding> checkPath(const fs::path& path) {
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw Error(ErrorCode::NotFound, path.string(), "", "no such file or folder");
    Findings findings;
    const bool isCalibrationFolder = !fs::exists(path / "dataset.json", ignored) && isCalibration(path);
    attempt(findings, [&] {
        if (!fs::is_directory(path))
            checkFile(findings, path);
        else if (isCalibrationFolder)
            checkCalibration(findings, path);
        else
            checkDataset(findings, path);
    });
    return findings;
}

} // namespace core
