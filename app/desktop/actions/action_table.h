// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace app {

/// How an action behaves.
enum class ActionKind {
    Plain,
    Check, ///< on or off
    Hold   ///< on while its key is held down
};

/// One action of the window. Texts are English sources for app::ActionTable's translations.
struct ActionRow {
    const char* id;
    const char* menu;     ///< menu that holds it
    const char* text;     ///< with its letter in the menu; a later entry with the same letter gets another one
    const char* shortcut; ///< default, portable text; empty for none
    const char* icon;     ///< of the icon theme; empty for none
    const char* tip;      ///< one sentence; empty if the text says it all
    ActionKind kind = ActionKind::Plain;
    bool separatorBefore = false;
    bool inMenu = true; ///< false: it has a key and a place in a window of its own
};

/// One menu, or a part of one.
struct MenuRow {
    const char* title;
    const char* parent; ///< title of the menu that holds it; null for the menu bar's own
};

/// Every action, in the order of the menus: the one table that menus, shortcuts and the shortcut page are made from.
const std::vector<ActionRow>& actionTable();
/// The menus; those of the menu bar in their order. A part of a menu stands where its first action does.
const std::vector<MenuRow>& menuTable();

} // namespace app
