// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

namespace app {

class Actions;

/// Every action with its shortcut, searchable; a double click on a shortcut changes it.
class ShortcutPage : public QWidget {
    Q_OBJECT

public:
    explicit ShortcutPage(Actions& actions, QWidget* parent = nullptr);
};

} // namespace app
