// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace widgets {

/// A private X server (Xvfb) for windows that are not shown to a person: scripts and tests on machines without a
/// display. Construct it on the main thread *before* QApplication; it sets DISPLAY and QT_QPA_PLATFORM=xcb for this
/// process and asks Mesa for software rendering. The server ends with the object, and with the process however that
/// ends.
class PrivateDisplay {
public:
    /// Starts the server with one 24-bit screen. Throws core::Error(NotFound or Io) with what to do if it cannot.
    explicit PrivateDisplay(int widthPx = 1920, int heightPx = 1080);
    ~PrivateDisplay();
    PrivateDisplay(const PrivateDisplay&) = delete;
    PrivateDisplay& operator=(const PrivateDisplay&) = delete;

    /// The display's name, such as ":3".
    const std::string& name() const { return m_name; }
    int processId() const { return m_process; }

private:
    std::string m_name;
    int m_process = -1;
};

} // namespace widgets
