// SPDX-License-Identifier: MIT
#include "app/desktop/actions/number_keys.h"

#include <map>

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace app {

namespace {

constexpr quint32 kScanCodeOf1 = 10; // of X11 and Wayland: 1 to 9 and 0 lie side by side
constexpr int kDigits = 10;

/// What French and Belgian keys give without Shift. "-" (6, and 8 in Belgium) is left out: it is a key of its own
/// elsewhere.
const std::map<int, int> kFrenchKeys = {{Qt::Key_Ampersand, 1},  {Qt::Key_Eacute, 2},     {Qt::Key_QuoteDbl, 3},
                                        {Qt::Key_Apostrophe, 4}, {Qt::Key_ParenLeft, 5},  {Qt::Key_section, 6},
                                        {Qt::Key_Egrave, 7},     {Qt::Key_Underscore, 8}, {Qt::Key_Exclam, 8},
                                        {Qt::Key_Ccedilla, 9},   {Qt::Key_Agrave, 0}};

bool isDigit(int key) {
    return key >= Qt::Key_0 && key <= Qt::Key_9;
}

} // namespace

std::optional<int> digitOfKey(const QKeyEvent& event) {
    if (isDigit(event.key()) || (event.modifiers() & ~Qt::KeyboardModifiers(Qt::ControlModifier)))
        return std::nullopt;
    const quint32 place = event.nativeScanCode();
    if (place >= kScanCodeOf1 && place < kScanCodeOf1 + kDigits)
        return static_cast<int>(place - kScanCodeOf1 + 1) % kDigits;
    const auto known = kFrenchKeys.find(event.key());
    return place == 0 && known != kFrenchKeys.end() ? std::optional(known->second) : std::nullopt;
}

NumberKeys::NumberKeys(QWidget& window)
    : QObject(&window)
    , m_window(window) {
    qApp->installEventFilter(this);
}

QAction* NumberKeys::actionFor(const QKeyEvent& event) const {
    const QWidget* focus = QApplication::focusWidget();
    const bool isTyping = focus && focus->testAttribute(Qt::WA_InputMethodEnabled);
    if (isTyping || QApplication::activePopupWidget() || QApplication::activeModalWidget() ||
        QApplication::activeWindow() != &m_window)
        return nullptr;
    const auto digit = digitOfKey(event);
    if (!digit)
        return nullptr;
    const QKeySequence wanted(static_cast<int>(event.modifiers()) | (Qt::Key_0 + *digit));
    for (QAction* action : m_window.actions())
        if (action->shortcut() == wanted)
            return action;
    return nullptr;
}

bool NumberKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        if (actionFor(*static_cast<QKeyEvent*>(
                event))) { // comes back as a press of the key, whatever shortcut it would have been
            event->accept();
            return true;
        }
    } else if (event->type() == QEvent::KeyPress && watched->isWidgetType()) {
        if (QAction* action = actionFor(*static_cast<QKeyEvent*>(event))) {
            action->trigger();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace app
