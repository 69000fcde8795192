// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

namespace app {

/// Asks for a range of frames, both ends included. It does not block the window.
class RangeWindow : public QDialog {
    Q_OBJECT

public:
    /// `button` says what will be done; both ends begin at `frame`.
    RangeWindow(const QString& title, const QString& button, int frame, int frameCount, QWidget* parent = nullptr);

signals:
    void chosen(int first, int last);
};

} // namespace app
