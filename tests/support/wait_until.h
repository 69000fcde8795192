// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtTest/QTest>

namespace test {

/// Lets the event loop run until the condition holds; false if it does not within the time.
inline bool waitUntil(const std::function<bool()>& condition, int milliseconds = 60000) {
    return QTest::qWaitFor(condition, milliseconds);
}

} // namespace test
