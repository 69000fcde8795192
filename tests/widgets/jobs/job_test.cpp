// SPDX-License-Identifier: MIT
#include "widgets/jobs/job.h"

#include <atomic>
#include <semaphore>
#include <stdexcept>

#include <QCoreApplication>
#include <QSignalSpy>
#include <QThread>

#include <gtest/gtest.h>

namespace {

using namespace widgets;

TEST(Job, DeliversOnItsOwnThread) {
    JobPool pool;
    Job job(pool);
    QThread* worker = nullptr;
    QThread* receiver = nullptr;
    QSignalSpy finished(&job, &Job::finished);
    job.start([&](const JobContext&) -> Job::Delivery {
        worker = QThread::currentThread();
        return [&] { receiver = QThread::currentThread(); };
    });
    EXPECT_FALSE(pool.isIdle());
    ASSERT_TRUE(finished.wait(60000));
    EXPECT_EQ(receiver, QThread::currentThread());
    EXPECT_NE(worker, receiver);
    EXPECT_TRUE(pool.isIdle());
    EXPECT_FALSE(job.isRunning());
}

TEST(Job, NeverDeliversAnOutdatedResult) {
    JobPool pool;
    Job job(pool);
    std::vector<int> delivered;
    std::counting_semaphore<> gate(0);
    QSignalSpy finished(&job, &Job::finished);
    for (int i = 0; i < 3; ++i) {
        job.start([&, i](const JobContext&) -> Job::Delivery {
            if (i < 2)
                gate.acquire();
            return [&, i] { delivered.push_back(i); };
        });
    }
    gate.release(2);
    ASSERT_TRUE(finished.wait(60000));
    QCoreApplication::processEvents();
    EXPECT_EQ(delivered, std::vector<int>{2});
    EXPECT_EQ(finished.count(), 1);
}

TEST(Job, StopTellsTheWorkAndDropsItsResult) {
    JobPool pool;
    Job job(pool);
    std::atomic<bool> sawStop = false;
    bool delivered = false;
    std::binary_semaphore running(0);
    job.start([&](const JobContext& context) -> Job::Delivery {
        running.release();
        while (!context.stop.stop_requested())
            QThread::msleep(1);
        sawStop = true;
        return [&] { delivered = true; };
    });
    running.acquire();
    QSignalSpy stopped(&job, &Job::stopped);
    job.stop();
    EXPECT_EQ(stopped.count(), 1);
    EXPECT_TRUE(pool.isIdle());
    for (int i = 0; i < 10000 && !sawStop; ++i)
        QThread::msleep(5);
    QCoreApplication::processEvents();
    EXPECT_TRUE(sawStop);
    EXPECT_FALSE(delivered);
}

TEST(Job, RequestedEndKeepsTheResult) {
    JobPool pool;
    Job job(pool);
    int delivered = 0;
    QSignalSpy finished(&job, &Job::finished);
    job.start([&](const JobContext& context) -> Job::Delivery {
        while (!context.stop.stop_requested())
            QThread::msleep(1);
        return [&] { delivered = 7; };
    });
    job.requestEnd();
    ASSERT_TRUE(finished.wait(60000));
    EXPECT_EQ(delivered, 7);
}

TEST(Job, ErrorsBecomeMessages) {
    JobPool pool;
    Job job(pool);
    QSignalSpy failed(&job, &Job::failed);
    job.start([](const JobContext&) -> Job::Delivery { throw std::runtime_error("a.json: K: not finite"); });
    ASSERT_TRUE(failed.wait(60000));
    EXPECT_EQ(failed[0][0].toString(), "a.json: K: not finite");
    EXPECT_TRUE(pool.isIdle());
}

TEST(Job, ReportsProgress) {
    JobPool pool;
    Job job(pool);
    QSignalSpy progressed(&job, &Job::progressed);
    QSignalSpy finished(&job, &Job::finished);
    job.start([](const JobContext& context) -> Job::Delivery {
        context.report(0.5, QStringLiteral("half"));
        return {};
    });
    ASSERT_TRUE(finished.wait(60000));
    ASSERT_EQ(progressed.count(), 1);
    EXPECT_EQ(progressed[0][0].toDouble(), 0.5);
    EXPECT_EQ(progressed[0][1].toString(), "half");
}

TEST(Job, MayBeDestroyedWhileItRuns) {
    JobPool pool;
    std::binary_semaphore running(0);
    bool delivered = false;
    {
        Job job(pool);
        job.start([&](const JobContext& context) -> Job::Delivery {
            running.release();
            while (!context.stop.stop_requested())
                QThread::msleep(1);
            return [&] { delivered = true; };
        });
        running.acquire();
    }
    QThread::msleep(20);
    QCoreApplication::processEvents();
    EXPECT_FALSE(delivered);
    EXPECT_TRUE(pool.isIdle());
}

TEST(Job, BackgroundWorkDoesNotCount) {
    JobPool pool;
    Job job(pool, Job::Kind::Background);
    QSignalSpy finished(&job, &Job::finished);
    job.start([](const JobContext&) -> Job::Delivery { return {}; });
    EXPECT_TRUE(pool.isIdle());
    ASSERT_TRUE(finished.wait(60000));
}

} // namespace
