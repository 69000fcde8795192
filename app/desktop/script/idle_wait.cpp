// SPDX-License-Identifier: MIT
#include "app/desktop/script/idle_wait.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>

#include "app/desktop/main_window.h"

namespace app {

namespace {

constexpr int kLookAgainMs = 20;

/// One turn of the event loop: what is posted now is done when it returns.
void turnOnce() {
    QEventLoop loop;
    QTimer::singleShot(0, &loop, &QEventLoop::quit);
    loop.exec();
}

} // namespace

bool waitFor(MainWindow& window, const std::function<bool()>& condition, int timeoutMs) {
    if (condition())
        return true;
    QEventLoop loop;
    const auto look = [&] {
        if (condition())
            loop.exit(0);
    };
    QTimer limit;
    limit.setSingleShot(true);
    QObject::connect(&limit, &QTimer::timeout, &loop, [&loop] { loop.exit(1); });
    limit.start(timeoutMs);
    QObject::connect(&window.session().pool, &widgets::JobPool::becameIdle, &loop, look, Qt::QueuedConnection);
    QObject::connect(&window.session().frames, &widgets::FrameLoader::frameCompleted, &loop, look,
                     Qt::QueuedConnection);
    QTimer again; // not everything that can be waited for says so
    QObject::connect(&again, &QTimer::timeout, &loop, look);
    again.start(kLookAgainMs);
    QTimer::singleShot(0, &loop, look);
    return loop.exec() == 0;
}

bool waitUntilIdle(MainWindow& window, int timeoutMs) {
    const auto idle = [&window] { return window.session().isIdle(); };
    do {
        if (!waitFor(window, idle, timeoutMs))
            return false;
        turnOnce(); // deliveries may have started new work
    } while (!idle());
    drawNow(window);
    return true;
}

void waitMs(int milliseconds) {
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
}

void drawNow(MainWindow& window) {
    window.workspaces().grid()->finishDrawing();
    window.workspaces().inspectPage()->grid()->finishDrawing();
    QCoreApplication::sendPostedEvents();
}

} // namespace app
