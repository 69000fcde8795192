// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/io/formats/format_requests.h"
#include "core/io/matlab/mat_file.h"

// Reads the MATLAB files of Label3D: its own saves (skeleton, handLabeled2D, data_3D) and what it exports for DANNCE
// (labelData per camera). Pixels count from 1 there, frames of videos from 0. handLabeled2D holds clicks; data_2d of an
// export are reprojections of its 3D points, which are not evidence.
namespace core {

namespace {

/// The dataset's cameras in the file's order: by their names, else in the dataset's order, which is said.
std::vector<std::string> camerasOf(ImportRequest& job, const MatFile& source, std::size_t count) {
    std::vector<std::string> names;
    if (const MatValue named = source.read("camnames"); named.count() > 0)
        names = named.texts();
    const auto isKnown = [&job](const std::string& name) { return job.dataset.cameraIndex(name) >= 0; };
    if (names.size() == count && std::any_of(names.begin(), names.end(), isKnown))
        return names;
    if (job.dataset.cameras.size() != count) {
        source.refuse("camnames", "names none of the dataset's cameras, and there are " + std::to_string(count) +
                                      ", not " + std::to_string(job.dataset.cameras.size()));
    }
    names.clear();
    for (const Camera& camera : job.dataset.cameras)
        names.push_back(camera.name);
    job.notes.remark(ImportNoteKind::CamerasByOrder, names);
    return names;
}

/// The joints of a file in its order; empty for a body part that stands for none.
using JointList = std::vector<std::optional<JointId>>;

/// The i-th entry of the joint map is the i-th joint of a file without names.
JointList jointsOfMap(const ImportRequest& job, const MatFile& source, const std::string& field, std::size_t count) {
    if (job.map.entries().size() != count) {
        source.refuse(field, "names no joints: --map must list the " + std::to_string(count) +
                                 " of them in the file's order, each with its hand");
    }
    JointList joints;
    for (const JointMapEntry& entry : job.map.entries()) {
        if (!entry.hand)
            source.refuse(field, "names no joints, and the joint map does not say the hand of \"" + entry.name + "\"");
        joints.push_back(JointId{*entry.hand, entry.joint});
    }
    return joints;
}

std::vector<std::string> jointNames(const MatFile& source, std::size_t count) {
    std::vector<std::string> list = source.read("skeleton").member("joint_names").texts();
    if (list.size() != count) {
        source.refuse("skeleton.joint_names",
                      "has " + std::to_string(list.size()) + " names, " + std::to_string(count) + " are expected");
    }
    return list;
}

void addClick(ImportRequest& job, double frame, const JointId& joint, const std::string& camera, double x, double y,
              Placement placement) {
    if (std::isfinite(x) && std::isfinite(y) && frame >= 0 && frame < 1e9)
        addMark(job, static_cast<int>(frame), joint, camera, {{x - 1, y - 1}, placement, MarkState::Visible});
}

/// What Label3D exports for DANNCE: per camera, a row per labelled frame.
void readDannceLabels(ImportRequest& job, const MatFile& source) {
    const MatValue labels = source.read("labelData");
    const std::vector<std::string> cameras = camerasOf(job, source, labels.count());
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        const MatValue view = labels.element(c);
        const MatNumbers places = view.member("data_2d").numbers(), frames = view.member("data_frame").numbers();
        if (places.size(0) != frames.values.size() || places.size(1) % 2 != 0)
            view.member("data_2d").refuse("a row per frame of data_frame, and x and y of every joint, are expected");
        const JointList joints = jointsOfMap(job, source, "labelData", places.size(1) / 2);
        for (std::size_t row = 0; row < frames.values.size(); ++row)
            for (std::size_t j = 0; j < joints.size(); ++j)
                addClick(job, frames.values[row], *joints[j], cameras[c], places.at(row, 2 * j),
                         places.at(row, 2 * j + 1), Placement::Proposed);
    }
    job.notes.remark(ImportNoteKind::Reprojections);
}

/// The frame of every labelled picture of a session: framesToLabel counts from 1 in sync's data_frame, which counts the
/// frames of the videos from 0.
std::vector<double> framesOf(const ImportRequest& job, const MatFile& source, std::size_t count) {
    const MatValue wanted = source.read("framesToLabel");
    std::vector<double> frames;
    if (wanted.isMissing()) {
        if (count != static_cast<std::size_t>(std::max(0, job.sequence.frameCount))) {
            source.refuse("framesToLabel", "is missing: nothing says which frames the " + std::to_string(count) +
                                               " labelled pictures are");
        }
        for (std::size_t i = 0; i < count; ++i)
            frames.push_back(static_cast<double>(i));
        return frames;
    }
    frames = wanted.numbers().values;
    if (frames.size() != count)
        wanted.refuse("has " + std::to_string(frames.size()) + " frames, " + std::to_string(count) + " are expected");
    const MatValue sync = source.read("sync");
    const bool isSynchronised = sync.count() > 0;
    const MatNumbers numbers = isSynchronised ? sync.element(0).member("data_frame").numbers() : MatNumbers();
    for (double& frame : frames) {
        const bool isThere = frame >= 1 && frame <= static_cast<double>(numbers.values.size());
        if (isSynchronised && !isThere)
            wanted.refuse("holds a frame that sync does not have");
        frame = isSynchronised ? numbers.values[static_cast<std::size_t>(frame) - 1] : frame - 1;
    }
    return frames;
}

/// Points of a session without clicks: a row per frame, x, y, z of every joint.
void readPoints(ImportRequest& job, const MatFile& source) {
    const MatNumbers points = source.read("data_3D").numbers();
    if (points.size(1) % 3 != 0)
        source.refuse("data_3D", "x, y and z of every joint are expected");
    const std::vector<std::string> names = jointNames(source, points.size(1) / 3);
    const std::vector<double> frames = framesOf(job, source, points.size(0));
    for (std::size_t row = 0; row < frames.size(); ++row) {
        for (std::size_t j = 0; j < names.size(); ++j) {
            const Eigen::Vector3d point(points.at(row, 3 * j), points.at(row, 3 * j + 1), points.at(row, 3 * j + 2));
            const auto joint = jointOfPart(job, names[j], "");
            if (!point.allFinite() || !(frames[row] >= 0 && frames[row] < 1e9))
                continue;
            if (joint)
                addPoint(job, static_cast<int>(frames[row]), *joint, point);
            else
                leaveOutPart(job, names[j]);
        }
    }
}

/// The clicks of a session: joint x camera x 2 x frame.
void readClicks(ImportRequest& job, const MatFile& source, const MatNumbers& clicks) {
    const std::size_t jointCount = clicks.size(0), cameraCount = clicks.size(1);
    if (clicks.size(2) != 2)
        source.refuse("handLabeled2D", "joints x cameras x 2 x frames are expected");
    const std::vector<std::string> names = jointNames(source, jointCount);
    const std::vector<std::string> cameras = camerasOf(job, source, cameraCount);
    const std::vector<double> frames = framesOf(job, source, clicks.size(3));
    for (std::size_t f = 0; f < frames.size(); ++f) {
        for (std::size_t c = 0; c < cameraCount; ++c) {
            for (std::size_t j = 0; j < jointCount; ++j) {
                const std::size_t at = j + jointCount * (c + cameraCount * 2 * f);
                const double x = clicks.values[at], y = clicks.values[at + jointCount * cameraCount];
                const auto joint = jointOfPart(job, names[j], "");
                if (joint)
                    addClick(job, frames[f], *joint, cameras[c], x, y, Placement::Manual);
                else if (std::isfinite(x))
                    leaveOutPart(job, names[j]);
            }
        }
    }
}

void readSession(ImportRequest& job, const MatFile& source) {
    const MatValue clicked = source.read("handLabeled2D");
    const MatNumbers clicks = clicked.isMissing() ? MatNumbers() : clicked.numbers();
    if (std::any_of(clicks.values.begin(), clicks.values.end(), [](double value) { return std::isfinite(value); })) {
        readClicks(job, source, clicks);
        return;
    }
    readPoints(job, source);
    job.notes.remark(ImportNoteKind::PointsWithoutClicks);
}

} // namespace

void readLabel3d(ImportRequest& job) {
    const MatFile source(job.path);
    if (!source.read("labelData").isMissing())
        readDannceLabels(job, source);
    else if (!source.read("skeleton").isMissing())
        readSession(job, source);
    else
        source.refuse("labelData", "is missing: this is neither an export for DANNCE nor a session of Label3D");
}

} // namespace core
