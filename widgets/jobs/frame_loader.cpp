// SPDX-License-Identifier: MIT
#include "widgets/jobs/frame_loader.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "core/contour/shaded_image.h"

namespace widgets {

namespace {

constexpr std::int64_t kDefaultBudget = std::int64_t(320) << 20;
constexpr int kAheadPriority = -1;

/// The posed hands of one frame, computed by the first worker that needs them.
struct PosedFrame {
    std::once_flag once;
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    std::vector<std::vector<Eigen::Vector3d>> normals;

    void ensure(const core::Dataset& dataset, const core::HandPoses& poses) {
        std::call_once(once, [&] {
            for (std::size_t i = 0; i < dataset.hands.size(); ++i) {
                vertices.push_back(core::posedVertices(dataset.hands[i], poses[i]));
                normals.push_back(core::vertexNormals(vertices.back(), dataset.hands[i].mesh.triangles));
            }
        });
    }
};

QImage toImage(const cv::Mat& bgr) {
    const QImage shared(bgr.data, bgr.cols, bgr.rows, static_cast<int>(bgr.step), QImage::Format_BGR888);
    return shared.convertToFormat(QImage::Format_RGB32);
}

} // namespace

/// What the workers read; never changes but for the posed frames, which have their own lock.
struct FrameLoader::Source {
    std::shared_ptr<const core::Dataset> dataset;
    const core::Sequence* sequence = nullptr;
    std::shared_ptr<const core::Motion> motion;
    std::mutex mutex;
    std::map<int, std::shared_ptr<PosedFrame>> posed;

    std::shared_ptr<PosedFrame> posedFrame(int frame) {
        std::shared_ptr<PosedFrame> found;
        {
            const std::lock_guard lock(mutex);
            if (posed.size() > 6 && !posed.count(frame))
                posed.clear();
            auto& entry = posed[frame];
            if (!entry)
                entry = std::make_shared<PosedFrame>();
            found = entry;
        }
        found->ensure(*dataset, (*motion)[static_cast<std::size_t>(frame)]);
        return found;
    }

    QImage rendered(int frame, const core::Camera& camera) {
        if (frame < 0 || frame >= static_cast<int>(motion->size()))
            return {};
        const auto hands = posedFrame(frame);
        std::vector<core::ShadedSurface> surfaces;
        for (std::size_t i = 0; i < dataset->hands.size(); ++i) {
            const core::HandModel& hand = dataset->hands[i];
            surfaces.push_back({{&hands->vertices[i], &hand.mesh.triangles}, &hands->normals[i], core::skinColour(hand.side)});
        }
        return toImage(core::renderShaded(camera, surfaces));
    }

    QImage picture(int frame, int cameraIndex) {
        const core::Camera& camera = dataset->cameras[static_cast<std::size_t>(cameraIndex)];
        const auto& views = sequence->views;
        const auto view = std::find_if(views.begin(), views.end(), [&](const auto& v) { return v.camera == camera.name; });
        if (view == views.end() || view->kind == core::ViewKind::None)
            return {};
        return rendered(frame, camera);
    }
};

FrameLoader::FrameLoader(JobPool& pool, QObject* parent) : QObject(parent), m_pool(pool), m_budget(kDefaultBudget) {}

FrameLoader::~FrameLoader() = default;

void FrameLoader::setSequence(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence,
                              std::shared_ptr<const core::Motion> motion) {
    m_jobs.clear();
    m_aheadJobs.clear();
    m_cache.clear();
    m_missing.clear();
    m_bytes = 0;
    m_frame = -1;
    m_source = std::make_shared<Source>();
    m_source->dataset = std::move(dataset);
    m_source->sequence = sequence;
    m_source->motion = std::move(motion);
    for (std::size_t i = 0; i < m_source->dataset->cameras.size(); ++i) {
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
    for (int camera = 0; camera < static_cast<int>(m_jobs.size()); ++camera) {
        if (m_cache.count({frame, camera}))
            cached.push_back(camera);
        else
            m_missing.insert(camera);
    }
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

QImage FrameLoader::picture(int camera) const {
    const auto at = m_cache.find({m_frame, camera});
    return at == m_cache.end() ? QImage() : at->second.picture;
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
            return [this, frame, camera, ahead, picture = source->picture(frame, camera)] {
                store(frame, camera, picture);
                if (!ahead) {
                    emit pictureLoaded(camera, picture);
                    finish(camera);
                }
            };
        },
        ahead ? kAheadPriority : 0);
}

void FrameLoader::store(int frame, int camera, const QImage& picture) {
    Entry& entry = m_cache[{frame, camera}];
    m_bytes += picture.sizeInBytes() - entry.picture.sizeInBytes();
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
    if (next < 0 || next >= m_source->sequence->frameCount || !m_missing.empty())
        return;
    for (int camera = 0; camera < static_cast<int>(m_aheadJobs.size()); ++camera) {
        if (!m_cache.count({next, camera}))
            startLoad(*m_aheadJobs[static_cast<std::size_t>(camera)], next, camera, true);
    }
}

void FrameLoader::trim() {
    while (m_bytes > m_budget) {
        auto oldest = m_cache.end();
        for (auto at = m_cache.begin(); at != m_cache.end(); ++at) {
            if (at->first.first != m_frame && (oldest == m_cache.end() || at->second.lastUse < oldest->second.lastUse))
                oldest = at;
        }
        if (oldest == m_cache.end())
            return;
        m_bytes -= oldest->second.picture.sizeInBytes();
        m_cache.erase(oldest);
    }
}

} // namespace widgets
