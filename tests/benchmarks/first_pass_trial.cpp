// SPDX-License-Identifier: MIT
// Labels without a click and their review, on recordings that are simulated from a dataset's recorded motion: another
// person's hands, cameras that are off, clutter, blur, few views. Prints a line per hand (error, doubt), the summary
// with processor time, and the curve of the review: clicks, and the mean error of all frames. Usage:
// handlens_first_pass_trial DATASET SEQUENCE [--rig exact|studio|casual] [--scale S] [--girth MM] [--cameras N|--views
// I,I]
//        [--clutter] [--blur FRAMES] [--defocus PX] [--aside SHARE] [--first F] [--every N] [--frames N] [--seed N]
//        [--least-hidden SHARE] (frames with a hand of which that share is behind the other one, mean over the views)
//        [--floors] (only what the calibration itself is off by, and how much of each hand is hidden)
//        [--key-every N] [--same-hands] [--review MM] [--looks N] [--no-refit]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>

#include <Eigen/Geometry>

#include "core/error.h"
#include "core/io/detector/detector_files.h"
#include "core/numeric/median.h"
#include "core/rig/rig_refinement.h"
#include "tests/benchmarks/simulated_reviewer.h"

namespace {

constexpr double kBadMm = 5, kSureDoubt = 0.2, kTrustedDoubt = 0.5;

struct Arguments {
    std::string dataset, sequence;
    trial::RecordingOptions recording;
    core::PassOptions pass;
    double reviewMm = 0; ///< until the mean error is below; 0: no review
    trial::ReviewerOptions reviewer;
    bool floorsOnly = false;
};

const char* valueOf(int argc, char** argv, const char* option, const char* otherwise) {
    for (int i = 3; i + 1 < argc; ++i)
        if (std::strcmp(argv[i], option) == 0)
            return argv[i + 1];
    return otherwise;
}

bool has(int argc, char** argv, const char* option) {
    return std::any_of(
        argv + 3, argv + argc, [option](const char* text) { return std::strcmp(text, option) == 0; });
}

Arguments parsed(int argc, char** argv) {
    const auto number = [&](const char* option, const char* otherwise) {
        return std::atof(valueOf(argc, argv, option, otherwise));
    };
    Arguments result{argv[1], argv[2], {}, {}, number("--review", "0"), {}, has(argc, argv, "--floors")};
    trial::RecordingOptions& recording = result.recording;
    const std::string rig = valueOf(argc, argv, "--rig", "exact");
    recording.imperfection.rig = rig == "studio"   ? core::kStudioRig
                                 : rig == "casual" ? core::kCasualRig
                                                   : core::RigError{};
    recording.imperfection.scale = number("--scale", "1");
    recording.imperfection.girthMm = number("--girth", "0");
    recording.imperfection.forearm = recording.hasClutter = has(argc, argv, "--clutter");
    recording.cameras = static_cast<int>(number("--cameras", "8"));
    for (const char* text = valueOf(argc, argv, "--views", ""); *text != '\0'; text += *text == ',' ? 1 : 0) {
        char* end = nullptr;
        recording.views.push_back(static_cast<int>(std::strtol(text, &end, 10)));
        if (end == text)
            break;
        text = end;
    }
    recording.exposureFrames = number("--blur", "0");
    recording.defocusPx = number("--defocus", "0");
    recording.asideShare = number("--aside", "0");
    recording.firstFrame = static_cast<int>(number("--first", "18"));
    recording.every = static_cast<int>(number("--every", "14"));
    recording.leastHidden = number("--least-hidden", "0");
    recording.mostFrames = static_cast<int>(number("--frames", "1000"));
    recording.seed = static_cast<std::uint64_t>(number("--seed", "1"));
    result.pass.keyEveryFrames = static_cast<int>(number("--key-every", "10"));
    result.pass.measureHands = !has(argc, argv, "--same-hands");
    result.pass.threads = 2;
    result.reviewer.looksPerFrame = static_cast<int>(number("--looks", "1"));
    result.reviewer.refits = !has(argc, argv, "--no-refit");
    return result;
}

/// Processor time of the stages of a pass, drawing taken off.
class StageClock {
public:
    explicit StageClock(const trial::Recording& recording)
        : m_recording(recording)
        , m_last(now()) {}

    void step(core::PassStage stage) {
        const double time = now();
        auto& [seconds, steps] = m_stages[static_cast<std::size_t>(stage)];
        seconds += time - m_last;
        ++steps;
        m_last = time;
    }
    void print() const {
        constexpr std::array kNames{"detecting", "measuring", "fitting key frames", "tracking"};
        for (std::size_t i = 0; i < kNames.size(); ++i)
            if (m_stages[i].second > 0)
                std::printf("%s: %.2f processor seconds a frame (%d frames)\n", kNames[i],
                            m_stages[i].first / m_stages[i].second, m_stages[i].second);
    }

private:
    double now() const { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC - m_recording.drawingSeconds(); }
    const trial::Recording& m_recording;
    double m_last;
    std::array<std::pair<double, int>, 4> m_stages{};
};

struct Errors {
    std::vector<double> jointsMm, alignedMm;
    std::vector<double> handMm, handDoubt;
    int hands = 0, bad = 0, badSure = 0, badTrusted = 0, trusted = 0, sure = 0, lacking = 0;
};

void countHand(Errors& errors, int frame, const core::AutoHand& hand, const std::vector<double>& mm, double hidden) {
    double mean = 0;
    for (const double one : mm)
        mean += one / static_cast<double>(mm.size());
    const bool isBad = mean > kBadMm;
    errors.handMm.push_back(mean);
    errors.handDoubt.push_back(hand.doubt);
    ++errors.hands;
    errors.bad += isBad;
    errors.badSure += isBad && hand.doubt < kSureDoubt;
    errors.badTrusted += isBad && hand.doubt < kTrustedDoubt;
    errors.sure += hand.doubt < kSureDoubt;
    errors.trusted += hand.doubt < kTrustedDoubt;
    double statedMm = 0;
    for (const core::AutoJoint& joint : hand.joints)
        statedMm += std::sqrt(joint.covariance.trace()) / static_cast<double>(hand.joints.size());
    std::printf("hand,%d,%s,%d,%.2f,%.2f,%.4f,%.2f,%.3f\n", frame, std::string(core::sideName(hand.side)).c_str(),
                static_cast<int>(hand.source), mean, *std::max_element(mm.begin(), mm.end()), hand.doubt, statedMm,
                hidden);
    errors.jointsMm.insert(errors.jointsMm.end(), mm.begin(), mm.end());
}

/// Errors after the best rigid motion of all joints.
void align(Errors& errors, const std::vector<Eigen::Vector3d>& found, const std::vector<Eigen::Vector3d>& truth) {
    Eigen::Matrix3Xd from(3, found.size()), to(3, found.size());
    for (Eigen::Index i = 0; i < from.cols(); ++i) {
        from.col(i) = found[static_cast<std::size_t>(i)];
        to.col(i) = truth[static_cast<std::size_t>(i)];
    }
    if (from.cols() > 3) {
        const Eigen::Matrix4d motion = Eigen::umeyama(from, to, false);
        const Eigen::Matrix3Xd moved = (motion.topLeftCorner<3, 3>() * from).colwise() + motion.col(3).head<3>();
        for (Eigen::Index i = 0; i < to.cols(); ++i)
            errors.alignedMm.push_back((moved.col(i) - to.col(i)).norm());
    }
}

/// Errors of all labelled joints that people click, as they are and after the best rigid motion of them all.
Errors errorsOf(const trial::Recording& recording, const core::AutoLabels& labels) {
    Errors errors;
    std::vector<Eigen::Vector3d> found, truth;
    std::printf("hand,frame,side,source,error mm,worst joint mm,doubt,stated mm,hidden\n");
    for (const auto& [frame, hands] : labels) {
        for (const core::AutoHand& hand : hands) {
            std::vector<double> mm;
            for (const core::AutoJoint& joint : hand.joints) {
                const core::JointId id{hand.side, joint.name};
                if (std::find(recording.joints().begin(), recording.joints().end(), id) == recording.joints().end())
                    continue;
                found.push_back(joint.pointInWorld);
                truth.push_back(recording.truth(frame, id));
                mm.push_back((found.back() - truth.back()).norm());
            }
            countHand(errors, frame, hand, mm, recording.hiddenShare(frame, hand.side));
        }
    }
    errors.lacking = 2 * static_cast<int>(recording.frames().size()) - errors.hands;
    align(errors, found, truth);
    return errors;
}
double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double share95(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[static_cast<std::size_t>(0.95 * static_cast<double>(values.size() - 1))];
}

/// Places in ascending order, equal values sharing theirs.
std::vector<double> ranksOf(const std::vector<double>& values) {
    std::vector<double> ranks;
    for (const double value : values) {
        double rank = 0;
        for (const double other : values)
            rank += other < value ? 1 : other == value ? 0.5 : 0;
        ranks.push_back(rank);
    }
    return ranks;
}

/// Spearman's rank correlation.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double> x = ranksOf(a), y = ranksOf(b);
    const double meanX = meanOf(x), meanY = meanOf(y);
    double xy = 0, xx = 0, yy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (x[i] - meanX) * (y[i] - meanY);
        xx += (x[i] - meanX) * (x[i] - meanX);
        yy += (y[i] - meanY) * (y[i] - meanY);
    }
    return xx * yy > 0 ? xy / std::sqrt(xx * yy) : 0;
}

void printErrors(const Errors& errors, std::size_t frames) {
    std::printf("%zu frames, %d hands, %d lacking; joints: mean %.2f mm, 95 %% below %.2f, worst %.2f; after the best "
                "rigid motion %.2f\n",
                frames, errors.hands, errors.lacking, meanOf(errors.jointsMm), share95(errors.jointsMm),
                errors.jointsMm.empty() ? 0 : *std::max_element(errors.jointsMm.begin(), errors.jointsMm.end()),
                meanOf(errors.alignedMm));
    std::printf("hands off by more than %g mm: %d; of these with a doubt below %g: %d (of %d), below %g: %d (of %d)\n",
                kBadMm, errors.bad, kTrustedDoubt, errors.badTrusted, errors.trusted, kSureDoubt, errors.badSure,
                errors.sure);
    std::printf("rank correlation of doubt and error over the hands: %.2f\n",
                rankCorrelation(errors.handDoubt, errors.handMm));
}

/// What joints are off by whose true pixels are triangulated: the calibration's own part of any label's error.
void printFloor(const trial::Recording& recording, const std::vector<core::Camera>& cameras, const char* name) {
    Errors errors;
    std::vector<Eigen::Vector3d> found, truth;
    for (const int frame : recording.frames())
        for (const core::JointId& id : recording.joints()) {
            std::vector<core::Observation> seen;
            for (std::size_t c = 0; c < cameras.size(); ++c)
                if (const auto px = recording.truePx(frame, id, c))
                    seen.push_back({static_cast<int>(c), *px, 1});
            const auto point = core::refinePoint(cameras, seen, recording.truth(frame, id));
            if (!point)
                continue;
            found.push_back(*point);
            truth.push_back(recording.truth(frame, id));
            errors.jointsMm.push_back((found.back() - truth.back()).norm());
        }
    align(errors, found, truth);
    std::printf("floor %s: mean %.2f mm, after the best rigid motion %.2f\n", name, meanOf(errors.jointsMm),
                meanOf(errors.alignedMm));
}

void printFloors(const trial::Recording& recording) {
    const auto& cameras = recording.dataset().cameras;
    printFloor(recording, cameras, "as calibrated");
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0, 1.5);
    std::vector<core::RigJoint> joints;
    for (const int frame : recording.frames())
        for (const core::JointId& id : recording.joints()) {
            core::RigJoint joint{0, frame, "sim", id, {}};
            for (std::size_t c = 0; c < cameras.size(); ++c)
                if (const auto px = recording.truePx(frame, id, c))
                    joint.clicks.push_back(
                        {static_cast<int>(c), *px + Eigen::Vector2d(noise(random), noise(random)), 0});
            joints.push_back(joint);
        }
    if (const auto refined = core::refineRig(cameras, joints))
        printFloor(recording, refined->cameras, "refined by clicks on every joint in every view");
}

void review(trial::Recording& recording, core::PassResult pass, const Arguments& arguments) {
    trial::SimulatedReviewer reviewer(recording, std::move(pass), arguments.pass, arguments.reviewer);
    const double before = reviewer.errorMm();
    std::printf("review,looks,frame,act,clicks,frame before mm,frame after mm,all mm\n");
    while (reviewer.errorMm() >= arguments.reviewMm) {
        std::map<int, double> was;
        for (const int frame : recording.frames())
            was[frame] = reviewer.errorMm(frame);
        if (!reviewer.reviewOne())
            break;
        const int frame = reviewer.lastFrame();
        std::printf("review,%d,%d,%s,%d,%.2f,%.2f,%.3f\n", reviewer.reviewed(), frame, reviewer.lastAct().c_str(),
                    reviewer.clicks(), was[frame], reviewer.errorMm(frame), reviewer.errorMm());
        std::fflush(stdout);
    }
    const double frames = static_cast<double>(recording.frames().size());
    std::printf("review: %.2f mm before, %.2f after %d looks and %d clicks: %.2f clicks per frame\n", before,
                reviewer.errorMm(), reviewer.reviewed(), reviewer.clicks(), reviewer.clicks() / frames);
}

void run(const Arguments& arguments) {
    trial::Recording recording(core::readDataset(arguments.dataset), arguments.sequence, core::readDetector(),
                               arguments.recording);
    printFloors(recording);
    if (arguments.floorsOnly) {
        for (const int frame : recording.frames())
            std::printf("hidden,%d,%.3f,%.3f\n", frame, recording.hiddenShare(frame, core::Side::Left),
                        recording.hiddenShare(frame, core::Side::Right));
        return;
    }
    StageClock clock(recording);
    core::PassResult pass =
        core::runLabelPass(recording.dataset().hands, recording.dataset().cameras, recording.frames(), recording,
                           arguments.pass, {}, [&clock](core::PassStage stage, int, int) { clock.step(stage); });
    const Errors errors = errorsOf(recording, core::autoLabels(pass, recording.dataset().cameras));
    for (const core::SubjectHand& hand : pass.measured)
        std::printf("%s hand: %.3f of the model's size, %+.1f mm thicker\n",
                    std::string(core::sideName(hand.hand.side)).c_str(), hand.scale.value, hand.girthMm.value);
    clock.print();
    printErrors(errors, recording.frames().size());
    if (arguments.reviewMm > 0)
        review(recording, std::move(pass), arguments);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "usage: handlens_first_pass_trial DATASET SEQUENCE [options as its source says]\n");
        return 2;
    }
    try {
        run(parsed(argc, argv));
    } catch (const core::Error& error) {
        std::fprintf(stderr, "handlens_first_pass_trial: %s\n", error.what());
        return 1;
    }
    return 0;
}
