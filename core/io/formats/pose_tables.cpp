// SPDX-License-Identifier: MIT
#include "core/io/files/atomic_file.h"
#include "core/io/files/csv_text.h"
#include "core/io/formats/format_requests.h"
#include "core/text/number_text.h"

// Writes tables of one view with the header rows scorer, bodyparts, coords: label files for DeepLabCut and Lightning
// Pose with x and y, which name a picture in the first column, and Anipose's 2D tables, which have a likelihood too and
// count frames from 0. Missing values are empty.
namespace core {

namespace {

/// The joints that have a name in the map, with that name.
std::vector<std::pair<std::string, JointId>> namedJoints(const ExportRequest& job) {
    std::vector<std::pair<std::string, JointId>> joints;
    for (const JointId& joint : markedJoints(job))
        if (const auto name = job.map.sharedName(joint))
            joints.emplace_back(*name, joint);
    return joints;
}

std::string header(const ExportRequest& job, const std::vector<std::pair<std::string, JointId>>& joints,
                   const std::vector<std::string>& coords) {
    CsvRow scorer{"scorer"}, bodyparts{"bodyparts"}, names{"coords"};
    for (const auto& [name, joint] : joints) {
        for (const std::string& coord : coords) {
            scorer.push_back(job.rater);
            bodyparts.push_back(name);
            names.push_back(coord);
        }
    }
    return csvLine(scorer) + csvLine(bodyparts) + csvLine(names);
}

/// Without likelihoods nothing says that a mark lies outside the picture, so such a one is missing.
CsvRow cellsOf(const ExportRequest& job, int frame, const std::vector<std::pair<std::string, JointId>>& joints,
               const Camera& camera, bool withLikelihood) {
    CsvRow cells;
    for (const auto& [name, joint] : joints) {
        auto mark = placedMark(job, frame, joint, camera.name);
        if (mark && !withLikelihood && isOutside(*mark, camera))
            mark.reset();
        cells.push_back(mark ? exactText(mark->px.x()) : "");
        cells.push_back(mark ? exactText(mark->px.y()) : "");
        if (withLikelihood)
            cells.push_back(mark ? exactText(isSeen(*mark, camera) ? kVisibleLikelihood : kOccludedLikelihood) : "");
    }
    return cells;
}

std::string sixDigits(int number) {
    const std::string digits = std::to_string(number);
    return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

} // namespace

void writeDeepLabCut(const ExportRequest& job) {
    PendingFolder folder(job.path);
    const auto joints = namedJoints(job);
    const std::vector<int> frames = settledFrames(job.set, job.rater);
    for (const Camera& camera : job.dataset.cameras) {
        std::string text = header(job, joints, {"x", "y"});
        for (const int frame : frames) {
            CsvRow row{"labeled-data/" + job.sequence.name + "_" + camera.name + "/img" + sixDigits(frame) + ".png"};
            const CsvRow cells = cellsOf(job, frame, joints, camera, false);
            row.insert(row.end(), cells.begin(), cells.end());
            text += csvLine(row);
        }
        ensureFolder(folder.path() / camera.name);
        writeFileAtomically(folder.path() / camera.name / ("CollectedData_" + job.rater + ".csv"), text);
    }
    folder.commit();
}

void writeAnipose2d(const ExportRequest& job) {
    PendingFolder folder(job.path);
    const auto joints = namedJoints(job);
    for (const Camera& camera : job.dataset.cameras) {
        std::string text = header(job, joints, {"x", "y", "likelihood"});
        for (int frame = 0; frame < job.sequence.frameCount; ++frame) {
            CsvRow row{std::to_string(frame)};
            const CsvRow cells = cellsOf(job, frame, joints, camera, true);
            row.insert(row.end(), cells.begin(), cells.end());
            text += csvLine(row);
        }
        writeFileAtomically(folder.path() / (camera.name + ".csv"), text);
    }
    folder.commit();
}

} // namespace core
