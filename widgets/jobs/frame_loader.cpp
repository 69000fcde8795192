// SPDX-License-Identifier: MIT
#include "widgets/jobs/frame_loader.h"

#include <algorithm>

#include <QThread>

#include "core/io/dataset/frames.h"

namespace widgets {

namespace {

constexpr std::int64_t kDefaultBudget = std::int64_t(1) << 30;
constexpr int kAheadPriority = -1, kFirstPriority = 1;

QImage toImage(const cv::Mat& bgr) {
    const QImage shared(bgr.data, bgr.cols, bgr.rows, static_cast<int>(bgr.step), QImage::Format_BGR888);
    return shared.convertToFormat(QImage::Format_RGB32);
}

std::int64_t bytesOf(const ImagePyramid& picture) {
    std::int64_t bytes = 0;
    for (int level = 0; level < picture.levelCount(); ++level)
        bytes += picture.level(level).sizeInBytes();
    return bytes;
}

} // namespace

FrameLoader::FrameLoader(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_pool(pool)
    , m_decodingPool(std::max(1, QThread::idealThreadCount() - 1))
    , m_budget(kDefaultBudget) {
    for (int i = 0; i < std::max(1, QThread::idealThreadCount() - 1); ++i)
        m_decodingJobs.push_back(std::make_unique<Job>(m_decodingPool, Job::Kind::Background));
}

FrameLoader::~FrameLoader() = default;

void FrameLoader::setSequence(const std::shared_ptr<const core::Dataset>& dataset, const core::Sequence* sequence,
                              const std::shared_ptr<const core::Motion>& motion) {
    m_jobs.clear();
    m_aheadJobs.clear();
    for (const std::unique_ptr<Job>& job : m_decodingJobs)
        job->stop();
    m_cache.clear();
    m_missing.clear();
    m_bytes = 0;
    m_frame = -1;
    m_frameCount = sequence->frameCount;
    m_source = std::make_shared<core::FrameSource>(*dataset, *sequence, *motion);
    shareBudget();
    for (std::size_t i = 0; i < dataset->cameras.size(); ++i) {
        m_jobs.push_back(std::make_unique<Job>(m_pool));
        m_aheadJobs.push_back(std::make_unique<Job>(m_pool, Job::Kind::Background));
        const int camera = static_cast<int>(i);
        connect(m_jobs.back().get(), &Job::failed, this, [this, camera](const QString& message) {
            emit pictureFailed(camera, message);
            finish(camera);
        });
    }
}

void FrameLoader::request(int frame) {
    if (!m_source || frame == m_frame)
        return;
    m_direction = frame < m_frame ? -1 : 1;
    m_frame = frame;
    m_missing.clear();
    for (std::size_t i = 0; i < m_jobs.size(); ++i) {
        m_jobs[i]->stop();
        m_aheadJobs[i]->stop();
    }
    for (const std::unique_ptr<Job>& job : m_decodingJobs)
        job->stop();
    std::vector<int> cached;
    for (int camera = 0; camera < static_cast<int>(m_jobs.size()); ++camera)
        if (m_cache.count({frame, camera}))
            cached.push_back(camera);
        else
            m_missing.insert(camera);
    const std::set<int> missing = m_missing;
    for (const int camera : camerasByUrgency())
        if (missing.contains(camera))
            startLoad(*m_jobs[static_cast<std::size_t>(camera)], frame, camera, false);
    for (const int camera : cached) {
        Entry& entry = m_cache[{frame, camera}];
        entry.lastUse = ++m_clock;
        emit pictureLoaded(camera, entry.picture);
    }
    if (m_missing.empty()) {
        emit frameCompleted(frame);
        prefetch();
    }
}

ImagePyramid FrameLoader::picture(int camera) const {
    const auto at = m_cache.find({m_frame, camera});
    return at == m_cache.end() ? ImagePyramid() : at->second.picture;
}

bool FrameLoader::lacksPicture(int camera) const {
    return m_source && m_frame >= 0 && m_source->kind(camera) != core::ViewKind::None &&
           !m_source->hasPicture(camera, m_frame);
}

void FrameLoader::setBudget(std::int64_t bytes) {
    m_budget = bytes;
    shareBudget();
    trim();
}

/// A picture that is ready to be drawn takes four times the memory of a decoded one.
void FrameLoader::shareBudget() {
    const bool decodes = m_source && m_source->hasVideos();
    m_drawableBudget = decodes ? m_budget / 4 : m_budget;
    if (decodes)
        m_source->setBudget(m_budget - m_drawableBudget);
}

std::vector<int> FrameLoader::camerasByUrgency() const {
    std::vector<int> cameras;
    if (m_firstCamera >= 0 && m_firstCamera < static_cast<int>(m_jobs.size()))
        cameras.push_back(m_firstCamera);
    for (int camera = 0; camera < static_cast<int>(m_jobs.size()); ++camera)
        if (camera != m_firstCamera)
            cameras.push_back(camera);
    return cameras;
}

void FrameLoader::startLoad(Job& job, int frame, int camera, bool ahead) {
    job.start(
        [this, source = m_source, frame, camera, ahead](const JobContext& context) -> Job::Delivery {
            if (context.stop.stop_requested())
                return {};
            const cv::Mat read = source->read(camera, frame, context.stop);
            if (read.empty())
                return {}; // stopped
            const ImagePyramid picture(toImage(read));
            return [this, frame, camera, ahead, picture] {
                store(frame, camera, picture);
                if (!ahead) {
                    emit pictureLoaded(camera, picture);
                    finish(camera);
                }
            };
        },
        ahead                     ? kAheadPriority
        : camera == m_firstCamera ? kFirstPriority
                                  : 0);
}

void FrameLoader::store(int frame, int camera, const ImagePyramid& picture) {
    Entry& entry = m_cache[{frame, camera}];
    m_bytes += bytesOf(picture) - bytesOf(entry.picture);
    entry = {picture, ++m_clock};
    trim();
}

void FrameLoader::finish(int camera) {
    m_missing.erase(camera);
    if (!m_missing.empty())
        return;
    emit frameCompleted(m_frame);
    prefetch();
}

void FrameLoader::prefetch() {
    const int next = m_frame + m_direction;
    if (!m_fetchesAhead || !m_missing.empty())
        return;
    if (next >= 0 && next < m_frameCount)
        for (const int camera : camerasByUrgency())
            if (!m_cache.count({next, camera}))
                startLoad(*m_aheadJobs[static_cast<std::size_t>(camera)], next, camera, true);
    decodeAhead();
}

/// Every thread has its cameras and decodes a picture of each in turn.
void FrameLoader::decodeAhead() {
    const std::vector<int> cameras = camerasByUrgency();
    for (std::size_t i = 0; i < m_decodingJobs.size(); ++i) {
        std::vector<int> mine;
        for (std::size_t c = i; c < cameras.size(); c += m_decodingJobs.size())
            mine.push_back(cameras[c]);
        m_decodingJobs[i]->start(
            [source = m_source, mine, direction = m_direction](const JobContext& context) -> Job::Delivery {
                for (bool isBusy = true; isBusy && !context.stop.stop_requested();) {
                    isBusy = false;
                    for (const int camera : mine)
                        isBusy = source->fetchAhead(camera, direction, context.stop) || isBusy;
                }
                return {};
            });
    }
}

void FrameLoader::trim() {
    while (m_bytes > m_drawableBudget) {
        auto oldest = m_cache.end();
        for (auto at = m_cache.begin(); at != m_cache.end(); ++at)
            if (at->first.first != m_frame && (oldest == m_cache.end() || at->second.lastUse < oldest->second.lastUse))
                oldest = at;
        if (oldest == m_cache.end())
            return;
        m_bytes -= bytesOf(oldest->second.picture);
        m_cache.erase(oldest);
    }
}

} // namespace widgets
