// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QObject>

class QAction;
class QKeyEvent;
class QWidget;

namespace app {

/// The digit that stands on the key that was pressed where the layout gives something else without Shift (French: "&"
/// for 1). By the place of the key where the window system tells it, else by what French keyboards give there; nothing
/// for any other key.
std::optional<int> digitOfKey(const QKeyEvent& event);

/// Shortcuts with digits work on keyboards whose digits need Shift: the key is taken for its digit, with Ctrl and
/// without.
class NumberKeys : public QObject {
    Q_OBJECT

public:
    /// For the actions of `window`; keys that other windows or text fields get are left alone.
    explicit NumberKeys(QWidget& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction* actionFor(const QKeyEvent& event) const;

    QWidget& m_window;
};

} // namespace app
