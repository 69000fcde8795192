// SPDX-License-Identifier: MIT
#include "widgets/jobs/frame_loader.h"

#include "core/io/dataset/frames.h"

namespace widgets {

namespace {

constexpr std::int64_t kDefaultBudget = std::int64_t(320) << 20;
constexpr int kAheadPriority = -1;

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
    , m_budget(kDefaultBudget) {}

FrameLoader::~FrameLoader() = default;

void FrameLoader::setSequence(const std::shared_ptr<const core::Dataset>& dataset, const core::Sequence* sequence,
                              const std::shared_ptr<const core::Motion>& motion) {
    m_jobs.clear();
    m_aheadJobs.clear();
    m_cache.clear();
    m_missing.clear();
    m_bytes = 0;
    m_frame = -1;
    m_frameCount = sequence->frameCount;
    m_source = std::make_shared<const core::FrameSource>(*dataset, *sequence, *motion);
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
    std::vector<int> cached;
    for (int camera = 0; camera < static_cast<int>(m_jobs.size()); ++camera)
        if (m_cache.count({frame, camera}))
            cached.push_back(camera);
        else
            m_missing.insert(camera);
    for (const int camera : m_missing)
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
    trim();
}

void FrameLoader::startLoad(Job& job, int frame, int camera, bool ahead) {
    job.start(
        [this, source = m_source, frame, camera, ahead](const JobContext& context) -> Job::Delivery {
            if (context.stop.stop_requested())
                return {};
            const ImagePyramid picture(toImage(source->read(camera, frame)));
            return [this, frame, camera, ahead, picture] {
                store(frame, camera, picture);
                if (!ahead) {
                    emit pictureLoaded(camera, picture);
                    finish(camera);
                }
            };
        },
        ahead ? kAheadPriority : 0);
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
    if (!m_fetchesAhead || next < 0 || next >= m_frameCount || !m_missing.empty())
        return;
    for (int camera = 0; camera < static_cast<int>(m_aheadJobs.size()); ++camera)
        if (!m_cache.count({next, camera}))
            startLoad(*m_aheadJobs[static_cast<std::size_t>(camera)], next, camera, true);
}

void FrameLoader::trim() {
    while (m_bytes > m_budget) {
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
