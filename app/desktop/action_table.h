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
    const char* menu;      ///< menu that holds it
    const char* text;      ///< with the menu's mnemonic
    const char* shortcut;  ///< default, portable text; empty for none
    const char* icon;      ///< of the icon theme; empty for none
    const char* tip;       ///< one sentence; empty if the text says it all
    ActionKind kind = ActionKind::Plain;
    bool separatorBefore = false;
};

/// Every action, in the order of the menus: the one table that menus, shortcuts and the shortcut page are made from.
const std::vector<ActionRow>& actionTable();
/// The menus in their order.
const std::vector<const char*>& menuTitles();

} // namespace app
