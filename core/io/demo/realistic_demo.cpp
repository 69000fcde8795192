// SPDX-License-Identifier: MIT
#include "core/io/demo/realistic_demo.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"
#include "core/io/footage/image_file.h"
#include "core/io/store/annotation_store.h"
#include "core/segmentation/background_difference.h"
#include "core/simulation/simulated_clicks.h"
#include "core/simulation/simulated_pictures.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr const char* kRater = "sim";
constexpr int kJpegQuality = 88;

const char* levelName(RealismLevel level) {
    return level == RealismLevel::Studio ? "studio" : "casual";
}

PictureOptions pictureOptions(RealismLevel level) {
    PictureOptions options;
    if (level == RealismLevel::Studio)
        options = {0.1, 2, 0.5, 1, 0.1};
    return options;
}

AnnotatorOptions annotatorOptions() {
    AnnotatorOptions options;
    options.rater = kRater;
    options.wrongShare = 0.01;
    options.seesOcclusion = true;
    return options;
}

/// Smaller pictures than the demo's, through a lens.
void useLenses(std::vector<Camera>& cameras) {
    for (Camera& camera : cameras) {
        camera = cropped(camera, {-0.5, -0.5}, {720, 1280}, 2.0 / 3);
        camera.distortion = {-0.11, 0.06, 0.0005, -0.0004, 0};
    }
}

std::vector<int> picturedFrames(int frameCount, int count) {
    constexpr int kFirst = 18; // start poses lie up to 15 frames before
    std::vector<int> frames;
    for (int k = 0; k < count; ++k)
        frames.push_back(kFirst + k * (frameCount - kFirst - 2) / count);
    return frames;
}

/// Every run of instants that has no picture.
std::vector<InstantRange> gapsBetween(const std::vector<int>& frames, int frameCount) {
    std::vector<InstantRange> gaps;
    int next = 0;
    for (std::size_t i = 0; i <= frames.size(); ++i) {
        const int frame = i < frames.size() ? frames[i] : frameCount;
        if (frame > next)
            gaps.push_back({next, frame - next});
        next = frame + 1;
    }
    return gaps;
}

/// What is made: the dataset, the world behind it, and the frames that are recorded.
struct Plan {
    NewDataset demo;
    SimulatedWorld world;
    std::vector<std::vector<int>> frames; ///< per sequence
    std::vector<cv::Mat> backgrounds;     ///< per camera, without noise
};

Plan planOf(const RealisticDemoOptions& options) {
    Plan plan{makeDemoDataset(), {}, {}, {}};
    Dataset& dataset = plan.demo.dataset;
    dataset.name = std::string("realistic demo, ") + levelName(options.level);
    useLenses(dataset.cameras);
    plan.world = simulatedWorld(dataset.hands, dataset.cameras, imperfectionOf(options.level), options.seed);
    for (Sequence& sequence : dataset.sequences) {
        plan.frames.push_back(picturedFrames(sequence.frameCount, options.framesPerSequence));
        sequence.masks = "masks/" + sequence.name + "/{camera}/{frame:06}.png";
        sequence.notes = {FootageNote{FootageNoteKind::Simulated}};
        for (ViewSource& view : sequence.views) {
            view.kind = ViewKind::Images;
            view.path = "images/" + sequence.name + "/" + view.camera + "/{frame:06}.jpg";
            view.missing = gapsBetween(plan.frames.back(), sequence.frameCount);
        }
    }
    for (const Camera& camera : plan.world.cameras)
        plan.backgrounds.push_back(backgroundPicture(camera, options.seed));
    return plan;
}

void writeJpeg(const fs::path& file, const cv::Mat& picture) {
    ensureFolder(file.parent_path());
    if (!cv::imwrite(file.string(), picture, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality}))
        throw Error(ErrorCode::Io, file.string(), "", "cannot be written");
}

/// One picture of one camera, and its mask. The empty room was recorded by the same camera, and saved like the others.
void writePicture(const Plan& plan, std::size_t sequence, int frame, std::size_t camera, const PictureOptions& options,
                  const fs::path& folder) {
    const std::string& sequenceName = plan.demo.dataset.sequences[sequence].name;
    const std::string place = sequenceName + "/" + plan.world.cameras[camera].name + "/";
    std::string digits = std::to_string(frame);
    digits.insert(0, 6 - std::min<std::size_t>(6, digits.size()), '0');
    const cv::Mat picture = simulatedPicture(plan.world, camera, plan.demo.motions[sequence], frame,
                                             plan.backgrounds[camera], options, sequenceName + "/" + digits);
    const fs::path file = folder / "images" / (place + digits + ".jpg");
    writeJpeg(file, picture);
    const cv::Mat empty = readImage(folder / "background" / (plan.world.cameras[camera].name + ".jpg"));
    const fs::path mask = folder / "masks" / (place + digits + ".png");
    ensureFolder(mask.parent_path());
    writePng(mask, differenceMask(readImage(file), empty));
}

/// Draws all pictures, several at once. False if it was stopped.
bool writePictures(const Plan& plan, const RealisticDemoOptions& options, const fs::path& folder,
                   const std::function<void(int, int)>& progress, const std::stop_token& stop) {
    struct Task {
        std::size_t sequence;
        int frame;
        std::size_t camera;
    };
    std::vector<Task> tasks;
    for (std::size_t s = 0; s < plan.frames.size(); ++s)
        for (const int frame : plan.frames[s])
            for (std::size_t c = 0; c < plan.world.cameras.size(); ++c)
                tasks.push_back({s, frame, c});
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    int finished = 0;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < tasks.size() && !stop.stop_requested(); i = next++) {
                writePicture(plan, tasks[i].sequence, tasks[i].frame, tasks[i].camera, pictureOptions(options.level),
                             folder);
                const std::scoped_lock lock(mutex);
                ++finished;
                if (progress)
                    progress(finished, static_cast<int>(tasks.size()));
            }
        } catch (...) {
            const std::scoped_lock lock(mutex);
            failure = failure ? failure : std::current_exception();
            next = tasks.size();
        }
    };
    {
        std::vector<std::jthread> workers;
        for (int i = 1; i < options.threads; ++i)
            workers.emplace_back(work);
        work();
    }
    if (failure)
        std::rethrow_exception(failure);
    return finished == static_cast<int>(tasks.size());
}

ordered_json jointsJson(const SimulatedWorld& world, const HandPoses& poses) {
    ordered_json joints = ordered_json::array();
    for (std::size_t h = 0; h < world.hands.size(); ++h) {
        const Skeleton& skeleton = world.hands[h].skeleton;
        const std::vector<Eigen::Vector3d> points = jointPositions(skeleton, poses[h]);
        for (std::size_t b = 0; b < points.size(); ++b) {
            joints.push_back({{"hand", sideName(world.hands[h].side)},
                              {"name", skeleton.bones[b].name},
                              {"xyz", jsonOf(points[b])}});
        }
    }
    return joints;
}

/// Clicks all frames of a sequence into its annotation file, step by step; returns what truth.json says of them.
ordered_json clickSequence(const Plan& plan, std::size_t s, const Dataset& written, RealisticDemoSummary& summary) {
    const Sequence& sequence = plan.demo.dataset.sequences[s];
    AnnotationStore store = AnnotationStore::open(annotationFile(written, sequence));
    AnnotationSet set;
    ordered_json frames = ordered_json::array();
    for (const int frame : plan.frames[s]) {
        const HandPoses& poses = plan.demo.motions[s][static_cast<std::size_t>(frame)];
        const SimulatedClicks clicks = annotateFrame(set, plan.world, poses, frame, sequence.name, annotatorOptions());
        for (const Edit& edit : clicks.edits)
            store.commit(edit, kRater);
        ordered_json wrong = ordered_json::array();
        for (const MarkKey& key : clicks.wrong)
            wrong.push_back({{"hand", sideName(key.joint.hand)}, {"name", key.joint.joint}, {"camera", key.camera}});
        frames.push_back({{"sequence", sequence.name},
                          {"frame", frame},
                          {"wrongClicks", wrong},
                          {"joints", jointsJson(plan.world, poses)}});
        summary.clicks += clicks.placed;
        summary.wrongClicks += static_cast<int>(clicks.wrong.size());
        ++summary.frames;
    }
    return frames;
}

/// The world as a dataset of its own: true cameras and hands, rendered views.
void writeTruth(const Plan& plan, const RealisticDemoOptions& options, const ordered_json& frames,
                const fs::path& folder) {
    Dataset truth = plan.demo.dataset;
    truth.name += " (truth)";
    truth.cameras = plan.world.cameras;
    truth.hands = plan.world.hands;
    for (Sequence& sequence : truth.sequences) {
        sequence.masks.clear();
        sequence.notes.clear();
        sequence.views.clear();
    }
    addRenderedViews(truth);
    writeDataset(truth, plan.demo.motions, folder);
    const Imperfection world = imperfectionOf(options.level);
    const ordered_json document = {
        {"format", "handlens-truth"},
        {"version", 1},
        {"units", "mm"},
        {"level", levelName(options.level)},
        {"seed", options.seed},
        {"subject", {{"scale", world.scale}, {"girthMm", world.girthMm}, {"lengthShare", world.lengthShare}}},
        {"rig", {{"turnDeg", world.rig.turnDeg}, {"shiftMm", world.rig.shiftMm}, {"focalShare", world.rig.focalShare}}},
        {"frames", frames}};
    checkSchema(nlohmann::json(document), "truth", (folder / "truth.json").string());
    writeJsonFile(folder / "truth.json", document);
}

} // namespace

Imperfection imperfectionOf(RealismLevel level) {
    Imperfection imperfection;
    imperfection.forearm = true;
    if (level == RealismLevel::Studio) {
        imperfection.scale = 1.01;
        imperfection.girthMm = 0.3;
        imperfection.lengthShare = 0.01;
        imperfection.rig = kStudioRig;
    } else {
        imperfection.scale = 1.03;
        imperfection.girthMm = 1;
        imperfection.lengthShare = 0.02;
        imperfection.rig = kCasualRig;
    }
    return imperfection;
}

RealisticDemoSummary writeRealisticDemo(const fs::path& folder, const RealisticDemoOptions& options,
                                        const std::function<void(int, int)>& progress, std::stop_token stop) {
    PendingFolder pending(folder);
    const Plan plan = planOf(options);
    writeDataset(plan.demo.dataset, plan.demo.motions, pending.path());
    for (std::size_t c = 0; c < plan.world.cameras.size(); ++c) {
        const std::string& name = plan.world.cameras[c].name;
        writeJpeg(pending.path() / "background" / (name + ".jpg"),
                  withSensorNoise(plan.backgrounds[c], pictureOptions(options.level),
                                  drawSeed(options.seed, "empty/" + name)));
    }
    RealisticDemoSummary summary;
    summary.stopped = !writePictures(plan, options, pending.path(), progress, stop);
    if (summary.stopped)
        return summary;
    Dataset written = plan.demo.dataset;
    written.folder = pending.path();
    ordered_json frames = ordered_json::array();
    for (std::size_t s = 0; s < written.sequences.size(); ++s)
        for (ordered_json& frame : clickSequence(plan, s, written, summary))
            frames.push_back(std::move(frame));
    writeTruth(plan, options, frames, pending.path() / "truth");
    summary.pictures = summary.frames * static_cast<int>(written.cameras.size());
    pending.commit();
    return summary;
}

} // namespace core
