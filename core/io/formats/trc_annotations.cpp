// SPDX-License-Identifier: MIT
#include "core/io/files/atomic_file.h"
#include "core/io/files/csv_text.h"
#include "core/io/formats/format_requests.h"
#include "core/text/number_text.h"

// Motion Analysis' Track Row Column file: tab-separated, a header of five lines, frames counted from 1, millimetres.
namespace core {

namespace {

std::string joined(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
        line += (i > 0 ? "\t" : "") + cells[i];
    return line + "\n";
}

std::string header(const ExportRequest& job, const std::vector<std::pair<std::string, JointId>>& joints) {
    const std::string rate = exactText(job.sequence.framesPerSecond), frames = std::to_string(job.sequence.frameCount);
    std::vector<std::string> names{"Frame#", "Time"}, axes{"", ""};
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        names.insert(names.end(), {joints[i].first, "", ""});
        axes.insert(axes.end(), {"X" + number, "Y" + number, "Z" + number});
    }
    return joined({"PathFileType", "4", "(X/Y/Z)", job.path.filename().string()}) +
           joined({"DataRate", "CameraRate", "NumFrames", "NumMarkers", "Units", "OrigDataRate", "OrigDataStartFrame",
                   "OrigNumFrames"}) +
           joined({rate, rate, frames, std::to_string(joints.size()), "mm", rate, "1", frames}) + joined(names) +
           joined(axes);
}

} // namespace

void writeTrc(const ExportRequest& job) {
    std::vector<std::pair<std::string, JointId>> joints;
    for (const JointId& joint : markedJoints(job))
        if (const auto name = job.map.sharedName(joint))
            joints.emplace_back(*name, joint);
    std::string text = header(job, joints);
    for (int frame = 0; frame < job.sequence.frameCount; ++frame) {
        const auto points = pointsOf(job, frame);
        std::vector<std::string> row{std::to_string(frame + 1), exactText(frame / job.sequence.framesPerSecond)};
        for (const auto& [name, joint] : joints) {
            const auto found = points.find(joint);
            for (int axis = 0; axis < 3; ++axis)
                row.push_back(found == points.end() ? "" : exactText(found->second.result.point->pointInWorld[axis]));
        }
        text += joined(row);
    }
    writeFileAtomically(job.path, text);
}

} // namespace core
