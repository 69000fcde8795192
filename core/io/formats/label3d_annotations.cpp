// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include <matio.h>

#include "core/error.h"
#include "core/io/formats/format_requests.h"

// Reads the MATLAB files of Label3D: its own saves (skeleton, handLabeled2D, data_3D) and what it exports for DANNCE
// (labelData per camera). Pixels count from 1 there, frames of videos from 0. handLabeled2D holds clicks; data_2d of an
// export are reprojections of its 3D points, which are not evidence.
namespace core {

namespace fs = std::filesystem;

namespace {

using MatFile = std::unique_ptr<mat_t, decltype(&Mat_Close)>;
using MatVariable = std::unique_ptr<matvar_t, decltype(&Mat_VarFree)>;

/// An array of numbers as MATLAB keeps it: the first index runs fastest.
struct Numbers {
    std::vector<std::size_t> shape;
    std::vector<double> values;
    std::size_t size(std::size_t axis) const { return axis < shape.size() ? shape[axis] : 1; }
    double at(std::size_t row, std::size_t column) const { return values[row + column * size(0)]; }
};

template <class Type>
void copyNumbers(const matvar_t& variable, std::vector<double>& values) {
    const auto* data = static_cast<const Type*>(variable.data);
    values.assign(data, data + values.size());
}

/// The file, with errors that name it.
class Source {
public:
    explicit Source(const fs::path& path)
        : m_name(path.string())
        , m_file(nullptr, &Mat_Close) {
        Mat_LogInit("handlens");
        Mat_LogInitFunc("handlens", [](int, char*) {}); // its messages are ours to give
        constexpr std::uintmax_t kHeaderBytes = 128;
        std::error_code ignored;
        if (fs::is_regular_file(path) && fs::file_size(path, ignored) >= kHeaderBytes)
            m_file.reset(Mat_Open(m_name.c_str(), MAT_ACC_RDONLY));
        if (!m_file)
            throw Error(fs::exists(path) ? ErrorCode::BadInput : ErrorCode::NotFound, m_name, "",
                        fs::exists(path) ? "is not a readable MATLAB file" : "there is no such file");
    }
    [[noreturn]] void refuse(const std::string& field, const std::string& what) const {
        throw Error(ErrorCode::BadInput, m_name, field, what);
    }
    /// Null if there is none.
    MatVariable find(const char* variable) const { return {Mat_VarRead(m_file.get(), variable), &Mat_VarFree}; }
    MatVariable read(const char* variable) const {
        MatVariable found = find(variable);
        if (!found || !found->data)
            refuse(variable, "is missing");
        return found;
    }
    Numbers numbers(const matvar_t* variable, const std::string& field) const {
        if (!variable || variable->isComplex)
            refuse(field, variable ? "real numbers are expected" : "is missing");
        Numbers numbers{{variable->dims, variable->dims + variable->rank}, {}};
        std::size_t count = 1;
        for (const std::size_t size : numbers.shape)
            count *= size;
        numbers.values.resize(count);
        if (count == 0)
            return numbers;
        switch (variable->data ? variable->class_type : MAT_C_EMPTY) {
        case MAT_C_DOUBLE:
            copyNumbers<double>(*variable, numbers.values);
            break;
        case MAT_C_SINGLE:
            copyNumbers<float>(*variable, numbers.values);
            break;
        case MAT_C_INT64:
            copyNumbers<std::int64_t>(*variable, numbers.values);
            break;
        case MAT_C_INT32:
            copyNumbers<std::int32_t>(*variable, numbers.values);
            break;
        case MAT_C_UINT32:
            copyNumbers<std::uint32_t>(*variable, numbers.values);
            break;
        default:
            refuse(field, "numbers are expected");
        }
        return numbers;
    }
    std::string text(const matvar_t* variable, const std::string& field) const {
        if (!variable || variable->class_type != MAT_C_CHAR)
            refuse(field, "a text is expected");
        std::string text;
        const std::size_t length = variable->nbytes / std::max<std::size_t>(1, std::size_t(variable->data_size));
        for (std::size_t i = 0; variable->data && i < length; ++i)
            text += variable->data_size == 2 ? static_cast<char>(static_cast<const std::uint16_t*>(variable->data)[i])
                                             : static_cast<const char*>(variable->data)[i];
        return text;
    }
    std::vector<std::string> texts(const matvar_t* cell, const std::string& field) const {
        std::vector<std::string> list;
        for (std::size_t i = 0; i < cells(cell, field); ++i)
            list.push_back(text(Mat_VarGetCell(const_cast<matvar_t*>(cell), static_cast<int>(i)),
                                field + "{" + std::to_string(i + 1) + "}"));
        return list;
    }
    /// How many a cell array has.
    std::size_t cells(const matvar_t* cell, const std::string& field) const {
        if (!cell || cell->class_type != MAT_C_CELL)
            refuse(field, cell ? "a cell array is expected" : "is missing");
        std::size_t count = 1;
        for (int axis = 0; axis < cell->rank; ++axis)
            count *= cell->dims[axis];
        return count;
    }
    /// A member of the i-th structure in a cell array.
    Numbers member(const matvar_t* cell, const std::string& field, std::size_t i, const char* name) const {
        const std::string place = field + "{" + std::to_string(i + 1) + "}";
        matvar_t* item = Mat_VarGetCell(const_cast<matvar_t*>(cell), static_cast<int>(i));
        if (!item || item->class_type != MAT_C_STRUCT)
            refuse(place, "a structure is expected");
        return numbers(Mat_VarGetStructFieldByName(item, name, 0), place + "." + name);
    }

private:
    std::string m_name;
    MatFile m_file;
};

/// The dataset's cameras in the file's order: by their names, else in the dataset's order, which is said.
std::vector<std::string> camerasOf(ImportRequest& job, const Source& source, std::size_t count) {
    std::vector<std::string> names;
    if (const MatVariable cell = source.find("camnames"); cell && cell->class_type == MAT_C_CELL)
        names = source.texts(cell.get(), "camnames");
    const auto isKnown = [&job](const std::string& name) { return job.dataset.cameraIndex(name) >= 0; };
    if (names.size() == count && std::any_of(names.begin(), names.end(), isKnown))
        return names;
    if (job.dataset.cameras.size() != count) {
        source.refuse("camnames", "names none of the dataset's cameras, and there are " + std::to_string(count) +
                                      ", not " + std::to_string(job.dataset.cameras.size()));
    }
    std::string list;
    names.clear();
    for (const Camera& camera : job.dataset.cameras) {
        names.push_back(camera.name);
        list += (list.empty() ? "" : ", ") + camera.name;
    }
    job.notes.remark("the file names none of the dataset's cameras: they are taken in the dataset's order, " + list);
    return names;
}

/// The joints of a file in its order; empty for a body part that stands for none.
using JointList = std::vector<std::optional<JointId>>;

/// The i-th entry of the joint map is the i-th joint of a file without names.
JointList jointsOfMap(const ImportRequest& job, const Source& source, const std::string& field, std::size_t count) {
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

std::vector<std::string> jointNames(const Source& source, std::size_t count) {
    const MatVariable skeleton = source.read("skeleton");
    const matvar_t* names =
        skeleton->class_type == MAT_C_STRUCT ? Mat_VarGetStructFieldByName(skeleton.get(), "joint_names", 0) : nullptr;
    std::vector<std::string> list = source.texts(names, "skeleton.joint_names");
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
void readDannceLabels(ImportRequest& job, const Source& source) {
    const MatVariable labels = source.read("labelData");
    const std::vector<std::string> cameras = camerasOf(job, source, source.cells(labels.get(), "labelData"));
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        const std::string field = "labelData{" + std::to_string(c + 1) + "}";
        const Numbers places = source.member(labels.get(), "labelData", c, "data_2d"),
                      frames = source.member(labels.get(), "labelData", c, "data_frame");
        if (places.size(0) != frames.values.size() || places.size(1) % 2 != 0)
            source.refuse(field + ".data_2d",
                          "a row per frame of data_frame, and x and y of every joint, are expected");
        const JointList joints = jointsOfMap(job, source, "labelData", places.size(1) / 2);
        for (std::size_t row = 0; row < frames.values.size(); ++row)
            for (std::size_t j = 0; j < joints.size(); ++j)
                addClick(job, frames.values[row], *joints[j], cameras[c], places.at(row, 2 * j),
                         places.at(row, 2 * j + 1), Placement::Proposed);
    }
    job.notes.remark("data_2d are reprojections of 3D points, not clicks: they come as proposals");
}

/// The frame of every labelled picture of a session: framesToLabel counts from 1 in sync's data_frame, which counts the
/// frames of the videos from 0.
std::vector<double> framesOf(const ImportRequest& job, const Source& source, std::size_t count) {
    const MatVariable wanted = source.find("framesToLabel");
    std::vector<double> frames;
    if (!wanted) {
        if (count != static_cast<std::size_t>(std::max(0, job.sequence.frameCount))) {
            source.refuse("framesToLabel", "is missing: nothing says which frames the " + std::to_string(count) +
                                               " labelled pictures are");
        }
        for (std::size_t i = 0; i < count; ++i)
            frames.push_back(static_cast<double>(i));
        return frames;
    }
    frames = source.numbers(wanted.get(), "framesToLabel").values;
    if (frames.size() != count)
        source.refuse("framesToLabel",
                      "has " + std::to_string(frames.size()) + " frames, " + std::to_string(count) + " are expected");
    const MatVariable sync = source.find("sync");
    const Numbers numbers =
        sync && source.cells(sync.get(), "sync") > 0 ? source.member(sync.get(), "sync", 0, "data_frame") : Numbers();
    for (double& frame : frames) {
        const bool isThere = frame >= 1 && frame <= static_cast<double>(numbers.values.size());
        if (sync && !isThere)
            source.refuse("framesToLabel", "holds a frame that sync does not have");
        frame = sync ? numbers.values[static_cast<std::size_t>(frame) - 1] : frame - 1;
    }
    return frames;
}

/// Points of a session without clicks: a row per frame, x, y, z of every joint.
void readPoints(ImportRequest& job, const Source& source) {
    const Numbers points = source.numbers(source.read("data_3D").get(), "data_3D");
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
void readClicks(ImportRequest& job, const Source& source, const Numbers& clicks) {
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

void readSession(ImportRequest& job, const Source& source) {
    const MatVariable clicked = source.find("handLabeled2D");
    const Numbers clicks = clicked ? source.numbers(clicked.get(), "handLabeled2D") : Numbers();
    if (std::any_of(clicks.values.begin(), clicks.values.end(), [](double value) { return std::isfinite(value); })) {
        readClicks(job, source, clicks);
        return;
    }
    readPoints(job, source);
    job.notes.remark("the file holds 3D points without clicks: they come as proposals");
}

} // namespace

void readLabel3d(ImportRequest& job) {
    const Source source(job.path);
    if (source.find("labelData"))
        readDannceLabels(job, source);
    else if (source.find("skeleton"))
        readSession(job, source);
    else
        source.refuse("labelData", "is missing: this is neither an export for DANNCE nor a session of Label3D");
}

} // namespace core
