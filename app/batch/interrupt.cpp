// SPDX-License-Identifier: MIT
#include "app/batch/interrupt.h"

#include <atomic>
#include <csignal>
#include <pthread.h>
#include <thread>
#include <unistd.h>

namespace app {

namespace {

std::stop_source& stopSource() {
    static std::stop_source source;
    return source;
}

std::atomic<int> firstSignal = 0;

sigset_t endingSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

} // namespace

void watchForInterrupts() {
    // Blocked in every thread that starts from here on, and taken by one that waits for them: no code runs in a signal
    // handler.
    const sigset_t signals = endingSignals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread([signals] {
        int signal = 0;
        sigwait(&signals, &signal);
        firstSignal = signal;
        stopSource().request_stop();
        sigwait(&signals, &signal);
        _exit(128 + signal);
    }).detach();
}

std::stop_token interruptToken() {
    return stopSource().get_token();
}

int interruptStatus() {
    return firstSignal == 0 ? 0 : 128 + firstSignal;
}

} // namespace app
