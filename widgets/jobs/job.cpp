// SPDX-License-Identifier: MIT
#include "widgets/jobs/job.h"

#include "widgets/text/error_text.h"

#include <exception>
#include <mutex>

#include <QMetaObject>
#include <QThread>

namespace widgets {

/// How a worker reaches its job, which may be gone by the time the work ends.
struct Job::Link {
    std::mutex mutex;
    Job* job = nullptr;

    void post(std::function<void(Job&)> call) {
        const std::lock_guard lock(mutex);
        if (!job)
            return;
        Job* target = job;
        QMetaObject::invokeMethod(
            target, [target, call = std::move(call)] { call(*target); }, Qt::QueuedConnection);
    }
};

JobPool::JobPool(int threads, QObject* parent)
    : QObject(parent) {
    m_threads.setMaxThreadCount(threads > 0 ? threads : QThread::idealThreadCount());
}

JobPool::~JobPool() {
    m_threads.clear();
    m_threads.waitForDone();
}

Job::Job(JobPool& pool, Kind kind, QObject* parent)
    : QObject(parent)
    , m_pool(pool)
    , m_kind(kind)
    , m_link(std::make_shared<Link>()) {
    m_link->job = this;
}

Job::~Job() {
    m_stop.request_stop();
    {
        const std::lock_guard lock(m_link->mutex);
        m_link->job = nullptr;
    }
    if (m_running)
        release();
}

void Job::start(Work work, int priority) {
    m_stop.request_stop();
    m_stop = std::stop_source();
    const quint64 generation = ++m_generation;
    if (!m_running && m_kind == Kind::Foreground)
        ++m_pool.m_foreground;
    m_running = true;
    emit started();
    m_pool.m_threads.start(
        [link = m_link, work = std::move(work), token = m_stop.get_token(), generation] {
            JobContext context{token, [&](double fraction, const QString& text) {
                                   link->post([=](Job& job) {
                                       if (job.m_generation == generation && job.m_running)
                                           emit job.progressed(fraction, text);
                                   });
                               }};
            Delivery delivery;
            QString error;
            try {
                delivery = work(context);
            } catch (const std::exception& e) {
                error = errorInWords(e);
            }
            link->post([=](Job& job) { job.deliver(generation, delivery, error); });
        },
        priority);
}

void Job::stop() {
    if (!m_running)
        return;
    m_stop.request_stop();
    ++m_generation;
    m_running = false;
    emit stopped();
    release();
}

void Job::requestEnd() {
    m_stop.request_stop();
}

void Job::deliver(quint64 generation, const Delivery& delivery, QString error) {
    if (generation != m_generation || !m_running)
        return;
    try {
        if (error.isEmpty() && delivery)
            delivery();
    } catch (const std::exception& e) {
        error = errorInWords(e);
    }
    if (generation != m_generation) // the delivery has started new work, or stopped it
        return;
    m_running = false;
    if (error.isEmpty())
        emit finished();
    else
        emit failed(error);
    release();
}

void Job::release() {
    if (m_kind == Kind::Foreground && --m_pool.m_foreground == 0)
        emit m_pool.becameIdle();
}

} // namespace widgets
