// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

class QWidget;

namespace app {

/// The texts of one menu with letters to press (after &, or "(&X)" as languages write it whose letters are not on the
/// keyboard) of which no two are the same. A text keeps its letter unless one before it has the same; then it gets
/// another of its own letters, at the start of a word if it can be, or none if all are taken. Texts without a letter
/// stay without.
QStringList withDistinctMnemonics(const QStringList& texts);

/// Gives the entries of a menu, or of a menu bar, such letters.
void setDistinctMnemonics(QWidget& menu);

} // namespace app
