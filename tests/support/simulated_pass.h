// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

#include "core/contour/shaded_image.h"
#include "core/io/demo/demo_dataset.h"
#include "core/labelling/label_pass.h"
#include "core/labelling/landmark_fit.h"
#include "core/subject/hand_tips.h"
#include "tests/support/random_values.h"

namespace test {

/// A sequence of the demo as a pass sees it: rendered pictures of a quarter of the size, and a detector that is a few
/// pixels off, the same for a seed.
class SimulatedPass : public core::PassSource {
public:
    explicit SimulatedPass(std::string seed, int cameraCount = 8, double noisePx = 3)
        : m_seed(std::move(seed))
        , m_noisePx(noisePx)
        , hands(demo().dataset.hands)
        , person(hands)
        , motion(demo().motions.front()) {
        const auto& all = demo().dataset.cameras;
        for (std::size_t c = 0; c < all.size(); c += all.size() / static_cast<std::size_t>(cameraCount))
            cameras.push_back(core::cropped(all[c], {0, 0}, {540, 960}, 0.5));
    }

    int viewCount() const override { return static_cast<int>(cameras.size()); }
    core::FrameEvidence evidence(int frame) override {
        ++evidenceCalls;
        core::FrameEvidence evidence;
        for (const core::Camera& camera : cameras)
            evidence.pictures.push_back(
                core::renderHandsShaded(camera, person, motion[static_cast<std::size_t>(frame)]));
        return evidence;
    }
    core::ViewDetections detect(int frame, const core::KnownHands&) override {
        ++detectCalls;
        RandomValues random(m_seed + std::to_string(frame));
        core::ViewDetections views;
        for (const core::Camera& camera : cameras) {
            auto& list = views.emplace_back();
            for (std::size_t h = 0; h < person.size() && lost.count(frame) == 0; ++h)
                list.push_back(seen(camera, h, frame, random));
        }
        return views;
    }
    std::optional<core::FrameFit> recall(const std::string& step, int frame) override {
        const auto found = kept.find({step, frame});
        return found == kept.end() ? std::nullopt : std::optional(found->second);
    }
    void remember(const std::string& step, int frame, const core::FrameFit& fit) override { kept[{step, frame}] = fit; }

    /// Mean distance of the joints of all hands to the true ones, mm; those that are not there are 100 mm off.
    double errorMm(const core::FrameFit& fit, const std::vector<core::HandModel>& fitted, int frame) const {
        double sum = 0;
        int count = 0;
        for (std::size_t h = 0; h < person.size(); ++h) {
            const auto truth = core::jointPositions(person[h].skeleton, motion[static_cast<std::size_t>(frame)][h]);
            for (std::size_t b = 0; b < truth.size(); ++b, ++count)
                sum += fit.hands[h].pose.size() == 0
                           ? 100
                           : (core::jointPositions(fitted[h].skeleton, fit.hands[h].pose)[b] - truth[b]).norm();
        }
        return sum / count;
    }

private:
    static const core::NewDataset& demo() {
        static const core::NewDataset made = core::makeDemoDataset();
        return made;
    }
    core::DetectedHand seen(const core::Camera& camera, std::size_t hand, int frame, RandomValues& random) const {
        auto joints = core::jointPositions(person[hand].skeleton, motion[static_cast<std::size_t>(frame)][hand]);
        for (std::size_t i = joints.size(); i-- > 0;)
            joints[i] = joints.front() + seenScale * (joints[i] - joints.front());
        core::DetectedHand found;
        for (std::size_t i = 0; i < core::kLandmarkCount; ++i) {
            const int bone = person[hand].skeleton.boneIndex(core::landmarkName(i));
            found.px[i] = *core::project(camera, joints[static_cast<std::size_t>(bone)]) +
                          m_noisePx * Eigen::Vector2d(random.normal(), random.normal());
        }
        found.presence = 0.99;
        found.rightness = person[hand].side == core::Side::Right ? 0.9 : 0.1;
        found.sidePx = core::placeOf(found.px).sidePx;
        return found;
    }

    std::string m_seed;
    double m_noisePx;

public:
    std::vector<core::HandModel> hands;  ///< the models
    std::vector<core::HandModel> person; ///< whose hands the pictures show
    core::Motion motion;
    std::vector<core::Camera> cameras;
    std::set<int> lost;   ///< frames in which the detector sees nothing
    double seenScale = 1; ///< of what the detector sees, about the wrists
    int evidenceCalls = 0, detectCalls = 0;
    std::map<std::pair<std::string, int>, core::FrameFit> kept;
};

} // namespace test
