// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/detection/frame_detection.h"
#include "core/labelling/frame_fitter.h"
#include "core/subject/subject_measures.h"

namespace core {

/// Where a pass takes pictures and detections from, and where it keeps what took long. Distances are in the
/// calibration's unit.
class PassSource {
public:
    virtual ~PassSource() = default;
    /// How many cameras have pictures or silhouettes at all.
    virtual int viewCount() const = 0;
    /// The pictures of a frame and the silhouettes that are given.
    virtual FrameEvidence evidence(int frame) = 0;
    /// What the detector sees in a frame. `known`: hands as they were in another frame.
    virtual ViewDetections detect(int frame, const KnownHands& known) = 0;
    /// A step of the same pass that was done before it was stopped; none: it is to be done.
    virtual std::optional<FrameFit> recall(const std::string& step, int frame) = 0;
    virtual void remember(const std::string& step, int frame, const FrameFit& fit) = 0;
};

struct PassOptions {
    int keyEveryFrames = 10; ///< the detector looks at frames that are so far apart; it tracks between them
    /// False: landmarks alone, in every frame; as with fewer views than kFewestSilhouetteViews, which can track
    /// nothing.
    bool withSilhouettes = true;
    /// The models become this person's hands; cameras that are off are adjusted by the same silhouettes.
    bool measureHands = true;
    bool landmarksAreJoints = false; ///< LandmarkFitOptions::areJoints; hands are measured from landmarks, too
    std::size_t mostPilots = 12;     ///< frames that hands are measured from
    double leastDoubt = 0.5;         ///< from which on a fit is doubted: tracking ends, the detector looks again
    int mostGapFrames = 30;          ///< frames that lie farther apart are not tracked into each other
    int threads = 1;                 ///< results do not depend on it
};

enum class PassStage { Detecting, Measuring, Fitting, Tracking };

struct PassResult {
    std::map<int, FrameFit> fits; ///< mm
    std::map<int, std::vector<std::optional<SpatialHand>>>
        detected;                      ///< per hand, of the frames that were looked at; mm
    std::vector<HandModel> hands;      ///< whose poses the fits hold: with bones for tips, measured
    std::vector<SubjectHand> measured; ///< empty: of the models at most the size was changed, as landmarks show it
    double unitMm = 1;                 ///< of the calibration
    /// That the hands were fitted with, in the calibration's unit: as given, or adjusted to how silhouettes lie beside
    /// hands (camerasByOutlines).
    std::vector<Camera> cameras;
    double camerasOffPx = 0; ///< by how much silhouettes lay beside the hands, if that is why cameras were adjusted
    bool isFinished = false; ///< else it was stopped
};

/// Counts steps; `total` may change as the pass learns what is to be done.
using PassProgress = std::function<void(PassStage stage, int done, int total)>;
/// A frame is done; it may come again when it was improved.
using PassSink = std::function<void(const PassResult& soFar, int frame)>;

/// What the detector sees in frames (ascending), each looked at with what is known from the one before: a pass' first
/// step. `mostGapFrames`: hands of frames that are farther apart are not where they were. `done` is called after every
/// frame. What was seen until then if it is stopped.
std::map<int, ViewDetections> detectFrames(const std::vector<Camera>& cameras, const std::vector<int>& frames,
                                           PassSource& source, int mostGapFrames, const std::stop_token& stop,
                                           const std::function<void()>& done);

/// Labels frames (ascending) without a click: the detector looks at key frames, hand models are brought to its
/// landmarks and then to the silhouettes, the person's hands are measured from the surest of these frames, and all
/// other frames are tracked from the surest neighbours, forwards and backwards; where a tracked frame is in doubt the
/// detector looks again. Deterministic.
PassResult runLabelPass(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                        const std::vector<int>& frames, PassSource& source, const PassOptions& options,
                        std::stop_token stop = {}, const PassProgress& progress = {}, const PassSink& sink = {});

} // namespace core
