// SPDX-License-Identifier: MIT
#include "core/io/segmentation/segment_frames.h"

#include <chrono>
#include <exception>
#include <mutex>

#include "core/contour/side_by_side.h"
#include "core/io/files/atomic_file.h"
#include "core/io/footage/image_file.h"
#include "core/io/segmentation/mask_record.h"

namespace core {

namespace {

/// Counts from several threads.
class Tally {
public:
    Tally(int total, const std::function<void(int, int)>& progress)
        : m_total(total)
        , m_progress(progress) {}

    void add(int SegmentationSummary::*what) {
        const std::scoped_lock lock(m_mutex);
        ++(m_summary.*what);
        step();
    }
    void addMade(bool isEmpty, double seconds) {
        const std::scoped_lock lock(m_mutex);
        ++m_summary.made;
        m_summary.empty += isEmpty ? 1 : 0;
        m_seconds += seconds;
        step();
    }
    void skip() {
        const std::scoped_lock lock(m_mutex);
        step();
    }
    void fail(std::exception_ptr failure) {
        const std::scoped_lock lock(m_mutex);
        m_failure = m_failure ? m_failure : failure;
    }
    bool hasFailed() {
        const std::scoped_lock lock(m_mutex);
        return m_failure != nullptr;
    }
    SegmentationSummary summary() {
        if (m_failure)
            std::rethrow_exception(m_failure);
        m_summary.stopped = m_done < m_total;
        m_summary.secondsPerMask = m_summary.made > 0 ? m_seconds / m_summary.made : 0;
        return m_summary;
    }

private:
    void step() {
        ++m_done;
        if (m_progress)
            m_progress(m_done, m_total);
    }

    std::mutex m_mutex;
    SegmentationSummary m_summary;
    std::exception_ptr m_failure;
    double m_seconds = 0;
    int m_done = 0;
    int m_total;
    const std::function<void(int, int)>& m_progress;
};

void segmentPicture(const SegmentationWork& work, const FrameSource& source, const HandEvidence& evidence, int index,
                    int frame, const std::stop_token& stop, Tally& tally) {
    using Clock = std::chrono::steady_clock;
    const Camera& camera = work.dataset->cameras[static_cast<std::size_t>(index)];
    const std::filesystem::path file = madeMaskFile(work.folder, camera.name, frame);
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
        tally.add(&SegmentationSummary::kept);
        return;
    }
    if (!source.hasPicture(index, frame)) {
        tally.skip();
        return;
    }
    const cv::Mat picture = source.read(index, frame, stop);
    if (picture.empty())
        return;
    const auto begin = Clock::now();
    const auto at = static_cast<std::size_t>(index);
    const cv::Mat room = at < work.roomPictures.size() ? work.roomPictures[at] : cv::Mat();
    const auto found = findSilhouette(picture, camera, work.dataset->hands, evidence, room, work.options);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (!found) {
        tally.add(&SegmentationSummary::unknown);
        return;
    }
    ensureFolder(file.parent_path());
    writePng(file, found->mask);
    tally.addMade(cv::countNonZero(found->mask) == 0, seconds);
}

} // namespace

SegmentationSummary segmentFrames(const SegmentationWork& work, const FrameSource& source, std::stop_token stop,
                                  const std::function<void(int done, int total)>& progress) {
    const std::size_t cameras = work.dataset->cameras.size();
    Tally tally(static_cast<int>(cameras * work.frames.size()), progress);
    for (const int frame : work.frames) {
        if (stop.stop_requested() || tally.hasFailed())
            break;
        const HandEvidence evidence = work.evidence ? work.evidence->at(frame, work.options.method) : HandEvidence();
        forEachSideBySide(cameras, [&](std::size_t camera) {
            if (stop.stop_requested())
                return;
            try {
                segmentPicture(work, source, evidence, static_cast<int>(camera), frame, stop, tally);
            } catch (...) {
                tally.fail(std::current_exception());
            }
        });
    }
    return tally.summary();
}

} // namespace core
