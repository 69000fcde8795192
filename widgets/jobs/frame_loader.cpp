// SPDX-License-Identifier: MIT
#include "widgets/jobs/frame_loader.h"

#include <algorithm>
#include <utility>

#include <QThread>

#include "core/io/dataset/frames.h"
#include "core/io/footage/video_file.h"

namespace widgets {

namespace {

constexpr std::int64_t kDefaultBudget = std::int64_t(1) << 30;
constexpr int kSurveyPauseMs = 1000, kHurryMs = 80;
constexpr int kAheadPriority = -1, kGlancePriority = 1, kFirstPriority = 2;

QImage toImage(const cv::Mat& bgr) {
    const QImage shared(bgr.data, bgr.cols, bgr.rows, static_cast<int>(bgr.step), QImage::Format_BGR888);
    return shared.convertToFormat(QImage::Format_RGB32);
}

std::int64_t bytesOf(const ImagePyramid& picture) {
    std::int64_t bytes = 0;
    for (int level = picture.firstLevel(); level < picture.levelCount(); ++level)
        bytes += picture.level(level).sizeInBytes();
    return bytes;
}

ImagePyramid pyramidOf(const cv::Mat& picture, QSize size) {
    return picture.cols < size.width() ? ImagePyramid(toImage(picture), size) : ImagePyramid(toImage(picture));
}

/// Does something for each camera, again and again, while any has something to do.
template <typename Work>
void repeatForEach(const std::vector<int>& cameras, const Work& work) {
    for (bool isBusy = true; isBusy;) {
        isBusy = false;
        for (const int camera : cameras)
            isBusy = work(camera) || isBusy;
    }
}

/// What is kept of the frame, if a draft may be as small.
cv::Mat keptDraft(const core::PictureSource& source, int camera, int frame, int shrink) {
    return shrink == core::kGlanceShrink ? source.keptSmall(camera, frame) : cv::Mat();
}

} // namespace

FrameLoader::FrameLoader(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_pool(pool)
    , m_decodingPool(std::max(1, QThread::idealThreadCount() - 1))
    , m_budget(kDefaultBudget) {
    for (int i = 0; i < std::max(1, QThread::idealThreadCount() - 1); ++i)
        m_decodingJobs.push_back(std::make_unique<Job>(m_decodingPool, Job::Kind::Background));
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, &FrameLoader::beginNext);
    m_settling.setSingleShot(true);
    m_settling.setInterval(kHurryMs);
    connect(&m_settling, &QTimer::timeout, this, &FrameLoader::readPostponed);
    m_surveyPause.setSingleShot(true);
    m_surveyPause.setInterval(kSurveyPauseMs);
    connect(&m_surveyPause, &QTimer::timeout, this, [this] {
        if (m_fetchesAhead && m_source && m_missing.empty())
            decodeAhead();
    });
}

FrameLoader::~FrameLoader() = default;

void FrameLoader::setSequence(const std::shared_ptr<const core::Dataset>& dataset, const core::Sequence* sequence,
                              const std::shared_ptr<const core::Motion>& motion) {
    std::vector<QSize> sizes;
    for (const core::Camera& camera : dataset->cameras)
        sizes.emplace_back(camera.size.width, camera.size.height);
    setSource(std::make_shared<core::FrameSource>(*dataset, *sequence, *motion), sizes, sequence->frameCount);
}

void FrameLoader::setSource(std::shared_ptr<core::PictureSource> source, const std::vector<QSize>& sizes,
                            int frameCount) {
    m_jobs.clear();
    m_aheadJobs.clear();
    for (const std::unique_ptr<Job>& job : m_decodingJobs)
        job->stop();
    m_cache.clear();
    m_missing.clear();
    m_unseen.clear();
    m_postponed.clear();
    m_next.reset();
    m_bytes = 0;
    m_frame = -1;
    m_frameCount = frameCount;
    m_sizes = sizes;
    m_source = std::move(source);
    m_source->setFirstCamera(m_firstCamera);
    shareBudget();
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        m_jobs.push_back(std::make_unique<Job>(m_pool));
        m_aheadJobs.push_back(std::make_unique<Job>(m_pool, Job::Kind::Background));
        const int camera = static_cast<int>(i);
        connect(m_jobs.back().get(), &Job::failed, this, [this, camera](const QString& message) {
            emit pictureFailed(camera, message);
            finish(camera);
        });
    }
}

void FrameLoader::setFirstCamera(int camera) {
    m_firstCamera = camera;
    if (m_source)
        m_source->setFirstCamera(camera);
}

void FrameLoader::request(int frame) {
    if (!m_source || frame == requestedFrame())
        return;
    if (frame != m_frame && !m_unseen.empty() && m_patience.isActive())
        m_next = frame;
    else if (frame == m_frame)
        m_next.reset(); // back to what is on its way
    else
        begin(frame);
}

void FrameLoader::beginNext() {
    if (m_next)
        begin(*m_next);
}

/// Whether the picture is kept as it is wanted now.
bool FrameLoader::isHere(int frame, int camera) const {
    const auto found = m_cache.find({frame, camera});
    return found != m_cache.end() && (m_isMoving || !found->second.picture.isDraft());
}

void FrameLoader::begin(int frame) {
    m_next.reset();
    m_direction = frame < m_frame ? -1 : 1;
    m_frame = frame;
    m_isHurrying = m_sinceBegin.isValid() && m_sinceBegin.elapsed() < kHurryMs;
    m_sinceBegin.start();
    m_missing.clear();
    m_postponed.clear();
    for (std::size_t i = 0; i < m_jobs.size(); ++i) {
        m_jobs[i]->stop();
        m_aheadJobs[i]->stop();
    }
    for (const std::unique_ptr<Job>& job : m_decodingJobs)
        job->stop();
    std::vector<int> here;
    for (int camera = 0; camera < static_cast<int>(m_jobs.size()); ++camera)
        if (isHere(frame, camera))
            here.push_back(camera);
        else
            m_missing.insert(camera);
    m_unseen = m_missing;
    m_patience.start(m_patienceMs);
    const std::set<int> missing = m_missing;
    std::vector<int> drafts;
    for (const int camera : camerasByUrgency()) {
        const bool hasDraft = m_cache.count({frame, camera}) > 0;
        if (missing.contains(camera))
            startLoad(camera, !m_isMoving && !hasDraft);
        if (missing.contains(camera) && hasDraft)
            drafts.push_back(camera);
    }
    for (const int camera : drafts) {
        emit pictureLoaded(camera, m_cache[{frame, camera}].picture);
        m_unseen.erase(camera);
    }
    for (const int camera : here) {
        Entry& entry = m_cache[{frame, camera}];
        entry.lastUse = ++m_clock;
        if (!m_isMoving || missing.empty())
            emit pictureLoaded(camera, entry.picture);
    }
    if (missing.empty()) {
        emit frameCompleted(frame);
        prefetch();
    }
}

void FrameLoader::setMoving(bool moving) {
    if (std::exchange(m_isMoving, moving) == moving || moving || !m_source || m_frame < 0)
        return;
    const int frame = requestedFrame(), direction = m_direction;
    bool isWhole = frame == m_frame && m_missing.empty();
    for (int camera = 0; camera < static_cast<int>(m_jobs.size()) && isWhole; ++camera)
        isWhole = isHere(frame, camera) || m_cache.count({frame, camera}) == 0; // or it failed
    if (isWhole)
        return;
    begin(frame);
    m_direction = direction;
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

/// A glance, if it may be one and the picture takes long; else the picture.
void FrameLoader::startLoad(int camera, bool mayGlance) {
    const int shrink = m_isMoving ? m_draftShrink : 1;
    const QSize size = m_sizes[static_cast<std::size_t>(camera)];
    m_jobs[static_cast<std::size_t>(camera)]->start(
        [this, source = m_source, frame = m_frame, camera, size, mayGlance, hurried = m_isHurrying,
         shrink](const JobContext& context) -> Job::Delivery {
            if (context.stop.stop_requested())
                return {};
            if (const cv::Mat small = keptDraft(*source, camera, frame, shrink); !small.empty())
                return loaded(camera, frame, pyramidOf(small, size));
            if (const auto glance = mayGlance ? source->glance(camera, frame, hurried, context.stop) : std::nullopt) {
                const ImagePyramid picture = pyramidOf(glance->picture, size);
                return [this, camera, picture, isExact = glance->isExact] { showGlance(camera, picture, isExact); };
            }
            const cv::Mat read = source->read(camera, frame, context.stop, shrink);
            if (read.empty())
                return {}; // stopped
            return loaded(camera, frame, pyramidOf(read, size));
        },
        camera == m_firstCamera ? kFirstPriority
        : mayGlance             ? kGlancePriority
                                : 0);
}

Job::Delivery FrameLoader::loaded(int camera, int frame, const ImagePyramid& picture) {
    return [this, camera, frame, picture] {
        store(frame, camera, picture);
        if (!m_isMoving)
            emit pictureLoaded(camera, picture);
        finish(camera);
    };
}

void FrameLoader::readPostponed() {
    for (const int camera : camerasByUrgency())
        if (m_postponed.erase(camera) > 0)
            startLoad(camera, false);
}

/// While frames follow each other quickly, decoding a whole picture would hold up the next one.
void FrameLoader::showGlance(int camera, const ImagePyramid& picture, bool isExact) {
    if (isExact && m_isHurrying) {
        m_postponed.insert(camera);
        m_settling.start();
    } else {
        startLoad(camera, false);
    }
    if (isExact)
        emit pictureLoaded(camera, picture);
    else
        emit standInLoaded(camera, picture);
    see(camera);
}

void FrameLoader::startAhead(int frame, int camera) {
    const int shrink = m_isMoving ? m_draftShrink : 1;
    m_aheadJobs[static_cast<std::size_t>(camera)]->start(
        [this, source = m_source, frame, camera, shrink,
         size = m_sizes[static_cast<std::size_t>(camera)]](const JobContext& context) -> Job::Delivery {
            if (context.stop.stop_requested())
                return {};
            cv::Mat read = keptDraft(*source, camera, frame, shrink);
            if (read.empty())
                read = source->read(camera, frame, context.stop, shrink);
            if (read.empty())
                return {};
            return [this, frame, camera, picture = pyramidOf(read, size)] { store(frame, camera, picture); };
        },
        kAheadPriority);
}

void FrameLoader::store(int frame, int camera, const ImagePyramid& picture) {
    Entry& entry = m_cache[{frame, camera}];
    m_bytes += bytesOf(picture) - bytesOf(entry.picture);
    entry = {picture, ++m_clock};
    trim();
}

/// The view of this camera shows something of the frame; once all do, the next one may come.
void FrameLoader::see(int camera) {
    m_unseen.erase(camera);
    if (m_unseen.empty())
        beginNext();
}

void FrameLoader::finish(int camera) {
    m_missing.erase(camera);
    if (m_missing.empty()) {
        m_unseen.clear();
        if (m_isMoving)
            for (int each = 0; each < static_cast<int>(m_jobs.size()); ++each)
                if (m_cache.count({m_frame, each}))
                    emit pictureLoaded(each, m_cache[{m_frame, each}].picture);
        const int frame = m_frame;
        emit frameCompleted(frame);
        if (frame != m_frame)
            return; // another one is wanted by now
        if (!m_next) {
            prefetch();
            return;
        }
    }
    see(camera);
}

void FrameLoader::prefetch() {
    const int next = m_frame + m_direction;
    if (!m_fetchesAhead || !m_missing.empty())
        return;
    if (next >= 0 && next < m_frameCount)
        for (const int camera : camerasByUrgency())
            if (!isHere(next, camera))
                startAhead(next, camera);
    decodeAhead();
}

/// Every thread has its cameras and decodes a picture of each in turn; then, if nothing else is to be done, small
/// pictures of the whole recording.
void FrameLoader::decodeAhead() {
    const std::vector<int> cameras = camerasByUrgency();
    for (std::size_t i = 0; i < m_decodingJobs.size(); ++i) {
        std::vector<int> mine;
        for (std::size_t c = i; c < cameras.size(); c += m_decodingJobs.size())
            mine.push_back(cameras[c]);
        m_decodingJobs[i]->start([this, source = m_source, mine, direction = m_direction, isMoving = m_isMoving,
                                  &pool = std::as_const(m_pool)](const JobContext& context) -> Job::Delivery {
            repeatForEach(mine, [&](int camera) { return source->fetchAhead(camera, direction, context.stop); });
            if (isMoving)
                return {};
            const auto survey = [&](int camera) { return pool.isIdle() && source->survey(camera, context.stop); };
            repeatForEach(mine, survey);
            return pool.isIdle() ? Job::Delivery() : [this] { m_surveyPause.start(); };
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
