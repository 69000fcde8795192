// SPDX-License-Identifier: MIT
#include "core/io/dataset/measured_footage.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/files/file_pattern.h"
#include "core/io/footage/image_file.h"
#include "core/io/footage/image_folder.h"
#include "core/io/footage/video_file.h"

namespace core {

namespace fs = std::filesystem;

MeasuredFootage measureVideo(const fs::path& file, const fs::path& indexFile) {
    const VideoInfo info = readVideoInfo(file, indexFile);
    MeasuredFootage measured{
        ViewKind::Video, file.string(), info.size, info.framesPerSecond, {info.rotationDegrees, false}};
    measured.frames = info.frames;
    measured.timing = analyseTimes(info.timesSec);
    return measured;
}

MeasuredFootage measureImages(const std::string& pattern, const std::string& camera) {
    MeasuredFootage measured{ViewKind::Images, pattern, {}};
    measured.numbers = imageNumbers(pattern, camera);
    // If there is none, reading the first one says so.
    const fs::path first = fillPattern(pattern, camera, measured.numbers.empty() ? 0 : measured.numbers.front());
    const cv::Mat image = readImage(first);
    measured.size = {image.cols, image.rows};
    measured.orientation = readOrientation(first);
    return measured;
}

fs::path videoIndexFile(const fs::path& datasetFolder, const std::string& sequence, const std::string& camera) {
    return cacheFile(datasetFolder, sequence + "-" + camera + ".videoindex");
}

FootageLayout layOut(const MeasuredFootage& footage, int first, bool byTime) {
    FootageLayout layout;
    if (footage.kind == ViewKind::Images) {
        int next = first;
        for (const int number : footage.numbers) {
            if (number > next)
                layout.missing.push_back({next - first, number - next});
            next = std::max(next, number + 1);
        }
        layout.instants = footage.numbers.back() < first ? 0 : next - first;
        return layout;
    }
    layout.instants = footage.frames - first;
    for (const FrameGap& gap : byTime ? footage.timing.gaps : std::vector<FrameGap>()) {
        if (gap.after >= first) {
            layout.missing.push_back({gap.after + 1 - first + (layout.instants - (footage.frames - first)), gap.count});
            layout.instants += gap.count;
        }
    }
    return layout;
}

std::vector<InstantRange> within(const std::vector<InstantRange>& ranges, int count) {
    std::vector<InstantRange> result;
    for (const InstantRange& range : ranges)
        if (range.first < count)
            result.push_back({range.first, std::min(range.count, count - range.first)});
    return result;
}

std::string timeProblem(const std::map<std::string, MeasuredFootage>& measured) {
    double rate = 0;
    for (const auto& [camera, one] : measured) {
        if (one.kind != ViewKind::Video)
            continue;
        if (!one.timing.isSane)
            return camera + ": its time stamps are uneven or missing";
        rate = rate > 0 ? rate : one.framesPerSecond;
        if (std::abs(one.framesPerSecond - rate) > 0.002 * rate)
            return camera + " was recorded at another frame rate than the others";
    }
    return "";
}

} // namespace core
