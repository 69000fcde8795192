// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>

#include "widgets/jobs/first_pass.h"

namespace test {

/// A stiff hand with the detector's 21 joints that moves 2 mm a frame, mm.
inline std::vector<std::pair<std::string, Eigen::Vector3d>> madeUpHand(core::Side side, int frame) {
    const double across = side == core::Side::Left ? -70 : 30;
    std::vector<std::pair<std::string, Eigen::Vector3d>> joints;
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i) {
        const double finger = i == 0 ? 2 : double((i - 1) / 4), along = i == 0 ? -60 : 22.0 * double((i - 1) % 4);
        joints.emplace_back(core::landmarkName(i), Eigen::Vector3d(across + 12 * finger + 2.0 * frame, along, 3));
    }
    return joints;
}

/// What the fake does; shared with the test.
struct FakeFirstPass {
    bool installed = true;
    std::map<int, double> doubts{}; ///< of both hands in these frames; 0.05 in others
    double camerasOffPx = 0;
    std::function<void(int)> beforeFrame{}; ///< on the worker's thread
    std::vector<int> followed{};            ///< frames that were followed from
    std::vector<int> refitted{};            ///< frames in which joints were placed
};

inline core::AutoHand madeUpLabel(core::Side side, int frame, double doubt) {
    core::AutoHand label;
    label.side = side;
    label.doubt = doubt;
    for (const auto& [name, place] : madeUpHand(side, frame)) {
        core::AutoJoint joint;
        joint.name = name;
        joint.pointInWorld = place;
        label.joints.push_back(joint);
    }
    return label;
}

/// Labels that are made up, without a detector. What is done is noted in the journal file, one line a frame.
inline widgets::FirstPassProgram fakeFirstPass(const std::shared_ptr<FakeFirstPass>& fake) {
    widgets::FirstPassProgram program;
    program.isInstalled = [fake] { return fake->installed; };
    program.install = [fake](const std::filesystem::path& package) {
        if (package.extension() != ".tgz")
            throw std::runtime_error("not a package");
        fake->installed = true;
        return std::string("@mediapipe/hands 1.2.3");
    };
    program.label = [fake](const widgets::FirstPassWork& work, std::stop_token stop, const auto& progress) {
        widgets::FirstPassLabels result;
        core::AutoLabels& labels = result.labels;
        std::ofstream journal(work.journal);
        for (const int frame : work.frames) {
            if (stop.stop_requested())
                break;
            if (fake->beforeFrame)
                fake->beforeFrame(frame);
            const auto doubt = fake->doubts.find(frame);
            for (const core::Side side : {core::Side::Left, core::Side::Right})
                labels[frame].push_back(madeUpLabel(side, frame, doubt == fake->doubts.end() ? 0.05 : doubt->second));
            journal << frame << std::endl;
            progress(core::PassStage::Detecting, static_cast<int>(labels.size()), static_cast<int>(work.frames.size()));
        }
        result.isFinished = labels.size() == work.frames.size();
        result.camerasOffPx = fake->camerasOffPx;
        return result;
    };
    program.follow = [fake](const widgets::FirstPassWork&, const core::AnnotationSet&, const std::string&, int frame,
                            std::stop_token) {
        fake->followed.push_back(frame);
        core::AutoLabels labels;
        labels[frame + 1].push_back(madeUpLabel(core::Side::Left, frame + 1, 0.01));
        return labels;
    };
    program.refit = [fake](const widgets::FirstPassWork&, const core::AnnotationSet&, const std::string&, int frame,
                           std::stop_token) {
        fake->refitted.push_back(frame);
        core::AutoLabels labels;
        labels[frame].push_back(madeUpLabel(core::Side::Left, frame + 1, 0.02)); // 2 mm farther on
        return labels;
    };
    return program;
}

} // namespace test
