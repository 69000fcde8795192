// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include "core/io/dataset/dataset.h"
#include "widgets/jobs/image_pyramid.h"
#include "widgets/jobs/job.h"

namespace core {
class PictureSource;
}

namespace widgets {

/// Brings the pictures of all cameras of a frame, from files or drawn from the recorded motion, without keeping the
/// window waiting. Pictures of recent frames are kept within a budget: some ready to be drawn, those of videos mostly
/// as decoded. Time that nobody needs goes into the frames that lie ahead, on all cores but one, and then into small
/// pictures of the whole recording, which outlast the program.
///
/// A jump within a video shows something at once: the frame in a low resolution if it is kept, else a picture near it.
/// Frames that are asked for faster than they come are dropped: while one is on its way into all views, only the last
/// of the others is remembered.
class FrameLoader : public QObject {
    Q_OBJECT

public:
    explicit FrameLoader(JobPool& pool, QObject* parent = nullptr);
    ~FrameLoader() override;

    /// Forgets everything and serves another sequence. `sequence` belongs to `dataset`.
    void setSequence(const std::shared_ptr<const core::Dataset>& dataset, const core::Sequence* sequence,
                     const std::shared_ptr<const core::Motion>& motion);
    /// The same with pictures from elsewhere.
    void setSource(std::shared_ptr<core::PictureSource> source, const std::vector<QSize>& sizes, int frameCount);
    /// Wants this frame: each picture comes as pictureLoaded, some before this returns. A request before that is
    /// dropped.
    void request(int frame);
    int requestedFrame() const { return m_next.value_or(m_frame); }
    /// True when every picture of the requested frame has come, or failed.
    bool isComplete() const { return m_missing.empty() && !m_next; }
    /// The picture of the requested frame, if it has come.
    ImagePyramid picture(int camera) const;
    /// Whether this camera has footage, but no picture of the requested frame: what comes is a plain backdrop.
    bool lacksPicture(int camera) const;
    /// How much memory pictures may take. The requested frame is always kept.
    void setBudget(std::int64_t bytes);
    /// The camera whose picture is wanted before the others'; -1: none.
    void setFirstCamera(int camera);
    /// While frames follow each other (playback): pictures may come as drafts, and those of a frame come all at once.
    /// Afterwards the last frame comes whole.
    void setMoving(bool moving);
    /// How small drafts may be: 1, 2 or 4 times smaller than the pictures.
    void setDraftShrink(int shrink) { m_draftShrink = shrink; }
    /// How long the next frame waits for the views to show the one on its way, in milliseconds.
    void setPatience(int milliseconds) { m_patienceMs = milliseconds; }
    /// Whether the next frames are fetched before they are asked for; they are at first.
    void setFetchingAhead(bool on) { m_fetchesAhead = on; }

signals:
    /// Of the requested frame; after a draft the whole picture follows, unless frames are moving.
    void pictureLoaded(int camera, const widgets::ImagePyramid& picture);
    /// Of a frame near the requested one, whose picture follows.
    void standInLoaded(int camera, const widgets::ImagePyramid& picture);
    void pictureFailed(int camera, const QString& message);
    /// All pictures of the requested frame are there (or have failed).
    void frameCompleted(int frame);

private:
    using Key = std::pair<int, int>; ///< frame, camera
    struct Entry {
        ImagePyramid picture;
        std::uint64_t lastUse = 0;
    };

    void begin(int frame);
    bool isHere(int frame, int camera) const;
    void startLoad(int camera, bool mayGlance);
    void startAhead(int frame, int camera);
    Job::Delivery loaded(int camera, int frame, const ImagePyramid& picture);
    void readPostponed();
    void showGlance(int camera, const ImagePyramid& picture, bool isExact);
    void store(int frame, int camera, const ImagePyramid& picture);
    void see(int camera);
    void finish(int camera);
    void beginNext();
    void prefetch();
    void decodeAhead();
    std::vector<int> camerasByUrgency() const;
    void shareBudget();
    void trim();

    JobPool& m_pool;
    JobPool m_decodingPool; ///< for what is decoded ahead, which may take long
    std::shared_ptr<core::PictureSource> m_source;
    std::vector<QSize> m_sizes;                       ///< of the pictures, by camera
    std::vector<std::unique_ptr<Job>> m_jobs;         ///< one per camera
    std::vector<std::unique_ptr<Job>> m_aheadJobs;    ///< one per camera: the next frame
    std::vector<std::unique_ptr<Job>> m_decodingJobs; ///< one per thread: the frames after that
    std::map<Key, Entry> m_cache;
    std::set<int> m_missing;   ///< cameras without the wanted picture
    std::set<int> m_unseen;    ///< cameras that still show another frame
    std::set<int> m_postponed; ///< missing cameras that show the frame small, while frames follow each other quickly
    QTimer m_settling;         ///< until these are read whole
    QTimer m_surveyPause;      ///< while other work is done in the background
    QTimer m_patience;         ///< while it runs, a frame is not dropped before it was seen in all views
    std::optional<int> m_next;
    std::int64_t m_budget;
    std::int64_t m_drawableBudget = 0; ///< the part for pictures that are ready to be drawn
    std::int64_t m_bytes = 0;          ///< of those
    std::uint64_t m_clock = 0;
    int m_frame = -1;
    int m_frameCount = 0;
    int m_direction = 1;
    int m_firstCamera = -1;
    bool m_fetchesAhead = true;
    bool m_isMoving = false;
    int m_draftShrink = 4;
    int m_patienceMs = 400;
    QElapsedTimer m_sinceBegin;
    bool m_isHurrying = false; ///< the frame was asked for soon after the one before
};

} // namespace widgets
