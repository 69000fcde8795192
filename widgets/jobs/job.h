// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <stop_token>

#include <QObject>
#include <QString>
#include <QThreadPool>

namespace widgets {

/// The threads that background work runs on, and the count of what has not been delivered yet.
class JobPool : public QObject {
    Q_OBJECT

public:
    /// `threads` of 0 takes the machine's own number.
    explicit JobPool(int threads = 0, QObject* parent = nullptr);
    ~JobPool() override;

    /// True when every foreground job has delivered its result, its error, or nothing because it was stopped. From any
    /// thread.
    bool isIdle() const { return m_foreground == 0; }

signals:
    void becameIdle();

private:
    friend class Job;
    QThreadPool m_threads;
    std::atomic<int> m_foreground = 0;
};

/// What running work may ask and say; used from the worker's thread.
struct JobContext {
    std::stop_token stop;
    std::function<void(double fraction, const QString& text)> report; ///< fraction in [0, 1]
};

/// A place for one piece of background work at a time. Starting again stops what runs and drops its result: a result
/// that is out of date is never delivered. All signals come on the thread that the job lives in.
class Job : public QObject {
    Q_OBJECT

public:
    /// Runs on the owner's thread and takes the result over; may be empty.
    using Delivery = std::function<void()>;
    /// Runs on a worker. It must hold (by value or shared pointer) all that it reads. May throw.
    using Work = std::function<Delivery(const JobContext&)>;

    /// Whether the pool counts it as work that a person waits for.
    enum class Kind { Foreground, Background };

    explicit Job(JobPool& pool, Kind kind = Kind::Foreground, QObject* parent = nullptr);
    ~Job() override;

    void start(Work work, int priority = 0);
    /// Asks the work to stop; `stopped` follows at once and nothing is delivered.
    void stop();
    /// Asks the work to end early and to deliver what it has.
    void requestEnd();
    bool isRunning() const { return m_running; }

signals:
    void started();
    void progressed(double fraction, const QString& text);
    void finished();
    void failed(const QString& message);
    void stopped();

private:
    struct Link;
    void deliver(quint64 generation, const Delivery& delivery, QString error);
    void release();

    JobPool& m_pool;
    Kind m_kind;
    std::shared_ptr<Link> m_link;
    std::stop_source m_stop;
    quint64 m_generation = 0;
    bool m_running = false;
};

} // namespace widgets
