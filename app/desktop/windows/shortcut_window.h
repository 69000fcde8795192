// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

namespace app {

class Actions;

/// The page of all actions and their shortcuts: to read, to search, and to change by a double click. It does not block
/// the window.
class ShortcutWindow : public QDialog {
    Q_OBJECT

public:
    explicit ShortcutWindow(Actions& actions, QWidget* parent = nullptr);
};

} // namespace app
