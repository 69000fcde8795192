// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <QObject>
#include <QString>

#include "core/io/dataset/dataset.h"
#include "widgets/jobs/image_pyramid.h"
#include "widgets/jobs/job.h"

namespace core {
class FrameSource;
}

namespace widgets {

/// Brings the pictures of all cameras of a frame, from files or drawn from the recorded motion, without keeping the
/// window waiting. Pictures of recent frames are kept within a budget: some ready to be drawn, those of videos mostly
/// as decoded. Time that nobody needs goes into the frames that lie ahead, on all cores but one.
class FrameLoader : public QObject {
    Q_OBJECT

public:
    explicit FrameLoader(JobPool& pool, QObject* parent = nullptr);
    ~FrameLoader() override;

    /// Forgets everything and serves another sequence. `sequence` belongs to `dataset`.
    void setSequence(const std::shared_ptr<const core::Dataset>& dataset, const core::Sequence* sequence,
                     const std::shared_ptr<const core::Motion>& motion);
    /// Wants this frame: each picture comes as pictureLoaded, some before this returns. A request before that is
    /// dropped.
    void request(int frame);
    int requestedFrame() const { return m_frame; }
    /// True when every picture of the requested frame has come, or failed.
    bool isComplete() const { return m_missing.empty(); }
    /// The picture of the requested frame, if it has come.
    ImagePyramid picture(int camera) const;
    /// Whether this camera has footage, but no picture of the requested frame: what comes is a plain backdrop.
    bool lacksPicture(int camera) const;
    /// How much memory pictures may take. The requested frame is always kept.
    void setBudget(std::int64_t bytes);
    /// The camera whose picture is wanted before the others'; -1: none.
    void setFirstCamera(int camera) { m_firstCamera = camera; }
    /// Whether the next frames are fetched before they are asked for; they are at first.
    void setFetchingAhead(bool on) { m_fetchesAhead = on; }

signals:
    void pictureLoaded(int camera, const widgets::ImagePyramid& picture);
    void pictureFailed(int camera, const QString& message);
    /// All pictures of the requested frame are there (or have failed).
    void frameCompleted(int frame);

private:
    using Key = std::pair<int, int>; ///< frame, camera
    struct Entry {
        ImagePyramid picture;
        std::uint64_t lastUse = 0;
    };

    void startLoad(Job& job, int frame, int camera, bool ahead);
    void store(int frame, int camera, const ImagePyramid& picture);
    void finish(int camera);
    void prefetch();
    void decodeAhead();
    std::vector<int> camerasByUrgency() const;
    void shareBudget();
    void trim();

    JobPool& m_pool;
    JobPool m_decodingPool; ///< for what is decoded ahead, which may take long
    std::shared_ptr<core::FrameSource> m_source;
    std::vector<std::unique_ptr<Job>> m_jobs;         ///< one per camera
    std::vector<std::unique_ptr<Job>> m_aheadJobs;    ///< one per camera: the next frame
    std::vector<std::unique_ptr<Job>> m_decodingJobs; ///< one per thread: the frames after that
    std::map<Key, Entry> m_cache;
    std::set<int> m_missing;
    std::int64_t m_budget;
    std::int64_t m_drawableBudget = 0; ///< the part for pictures that are ready to be drawn
    std::int64_t m_bytes = 0;          ///< of those
    std::uint64_t m_clock = 0;
    int m_frame = -1;
    int m_frameCount = 0;
    int m_direction = 1;
    int m_firstCamera = -1;
    bool m_fetchesAhead = true;
};

} // namespace widgets
