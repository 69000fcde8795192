// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <set>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"
#include "core/io/formats/format_requests.h"
#include "core/text/number_text.h"

// The annotation files of the method's authors: per camera a folder with NNN.txt per frame, lines "id<TAB>x<TAB>y",
// whole pixels, 0 0 for what cannot be seen, no line end after the last line.
namespace core {

namespace fs = std::filesystem;

namespace {

std::string frameFileName(int frame) {
    std::string digits = std::to_string(frame);
    digits.insert(0, digits.size() < 3 ? 3 - digits.size() : 0, '0');
    return digits + ".txt";
}

std::string frameText(const ExportRequest& job, int frame, const Camera& camera) {
    std::string text;
    for (const JointMapEntry& entry : job.map.entries()) {
        const auto mark = placedMark(job, frame, {entry.hand.value_or(Side::Right), entry.joint}, camera.name);
        const bool isVisible = mark && isSeen(*mark, camera);
        const long x = isVisible ? std::lround(mark->px.x()) : 0, y = isVisible ? std::lround(mark->px.y()) : 0;
        text += (text.empty() ? "" : "\n") + entry.name + "\t" + std::to_string(x) + "\t" + std::to_string(y);
    }
    return text;
}

/// One line of a file: a joint of the map, and where it is seen.
struct Line {
    JointId joint;
    Eigen::Vector2d px;
};

std::vector<Line> readLines(const ImportRequest& job, const fs::path& file) {
    std::vector<Line> lines;
    std::set<JointId> seen;
    LineReader reader(file);
    while (!reader.atEnd()) {
        const std::string line(reader.next("id, x and y"));
        const auto words = splitWords(line);
        Line entry{{}, {}};
        if (words.size() != 3 || !parseNumber(words[1], entry.px.x()) || !parseNumber(words[2], entry.px.y()))
            throw reader.errorHere("id, x and y are expected");
        const std::string id(words[0]);
        std::optional<JointId> joint;
        for (const JointMapEntry& known : job.map.entries())
            if (known.name == id)
                joint = JointId{known.hand.value_or(Side::Right), known.joint};
        if (!joint)
            throw reader.errorHere("id " + id + " is not one of the map's");
        if (!seen.insert(*joint).second)
            throw reader.errorHere("id " + id + " occurs twice");
        entry.joint = *joint;
        lines.push_back(std::move(entry));
    }
    return lines;
}

} // namespace

void writeTzionasAnnotations(const ExportRequest& job) {
    PendingFolder folder(job.path);
    const std::vector<int> frames = settledFrames(job.set, job.rater);
    for (const Camera& camera : job.dataset.cameras) {
        ensureFolder(folder.path() / camera.name);
        for (const int frame : frames)
            writeFileAtomically(folder.path() / camera.name / frameFileName(frame), frameText(job, frame, camera));
    }
    folder.commit();
}

void readTzionasAnnotations(ImportRequest& job) {
    for (const fs::path& file : viewFiles(job.path, ".txt")) {
        const auto frame = trailingNumber(file.filename().string());
        if (!frame) {
            throw Error(ErrorCode::BadInput, file.string(), "",
                        "the file's name must be the number of its frame, such as 041.txt");
        }
        const std::string camera = cameraOfFile(job, file);
        const std::vector<Line> lines = readLines(job, file);
        std::set<Side> visibleHands;
        for (const Line& line : lines)
            if (!line.px.isZero())
                visibleHands.insert(line.joint.hand);
        for (const Line& line : lines) {
            // 0 0 in a hand that was annotated says that the joint cannot be placed; a hand of zeros was not looked at.
            if (!line.px.isZero()) {
                addMark(job, *frame, line.joint, camera, Mark{line.px});
            } else if (visibleHands.contains(line.joint.hand)) {
                addMark(job, *frame, line.joint, camera,
                        Mark{Eigen::Vector2d::Zero(), Placement::Manual, MarkState::Unplaceable});
            }
        }
    }
}

} // namespace core
