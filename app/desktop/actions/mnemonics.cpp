// SPDX-License-Identifier: MIT
#include "app/desktop/actions/mnemonics.h"

#include <QAction>
#include <QSet>
#include <QWidget>

namespace app {

namespace {

using Letters = QSet<QChar>;

/// Where the letter of a text stands, behind its & (&& is an ampersand); -1 if it has none.
int letterPlace(const QString& text) {
    for (int i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != QLatin1Char('&'))
            continue;
        ++i;
        if (text[i] != QLatin1Char('&'))
            return i;
    }
    return -1;
}

/// Whether a key makes this letter: not those with accents.
bool isOnAKey(QChar letter) {
    return letter.isLetterOrNumber() && letter.decomposition().isEmpty() && letter.script() != QChar::Script_Han;
}

QString inBracketsAnew(QString text, int place, const Letters& taken) {
    for (char letter = 'A'; letter <= 'Z'; ++letter)
        if (!taken.contains(QChar(letter).toLower()))
            return text.replace(place, 1, QChar(letter));
    return text;
}

/// The text with another of its letters, or without any.
QString withFreeLetter(QString text, const Letters& taken) {
    const int place = letterPlace(text);
    if (place >= 2 && text[place - 2] == QLatin1Char('(') && text.mid(place + 1, 1) == QLatin1String(")"))
        return inBracketsAnew(text, place, taken);
    text.remove(place - 1, 1);
    for (const bool atStartOfWord : {true, false}) {
        for (int i = 0; i < text.size(); ++i) {
            const bool isStart = i == 0 || text[i - 1].isSpace();
            if ((isStart || !atStartOfWord) && isOnAKey(text[i]) && !taken.contains(text[i].toLower()))
                return text.insert(i, QLatin1Char('&'));
        }
    }
    return text;
}

} // namespace

QStringList withDistinctMnemonics(const QStringList& texts) {
    QStringList result = texts;
    Letters taken;
    QList<int> later;
    for (int i = 0; i < texts.size(); ++i) {
        const int place = letterPlace(texts[i]);
        if (place < 0)
            continue;
        const QChar letter = texts[i][place].toLower();
        if (taken.contains(letter))
            later << i;
        taken << letter;
    }
    for (const int i : later) {
        result[i] = withFreeLetter(texts[i], taken);
        if (const int place = letterPlace(result[i]); place >= 0)
            taken << result[i][place].toLower();
    }
    return result;
}

void setDistinctMnemonics(QWidget& menu) {
    QStringList texts;
    for (const QAction* action : menu.actions())
        texts << action->text();
    const QStringList distinct = withDistinctMnemonics(texts);
    for (int i = 0; i < distinct.size(); ++i)
        if (distinct[i] != texts[i])
            menu.actions()[i]->setText(distinct[i]);
}

} // namespace app
