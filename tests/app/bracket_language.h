// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>
#include <QTranslator>

#include <gtest/gtest.h>

namespace test {

/// A language in which every text is the English one in brackets: shows what is never asked to be translated. Spoken
/// while it exists.
class BracketLanguage : public QTranslator {
public:
    BracketLanguage() { QCoreApplication::installTranslator(this); }
    ~BracketLanguage() override { QCoreApplication::removeTranslator(this); }

    QString translate(const char*, const char* text, const char*, int) const override {
        return QLatin1Char('[') + QString::fromUtf8(text) + QLatin1Char(']');
    }
    bool isEmpty() const override { return false; }
};

inline void expectInBrackets(const QString& words) {
    EXPECT_TRUE(words.startsWith(QLatin1Char('['))) << words.toStdString();
    EXPECT_TRUE(words.endsWith(QLatin1Char(']'))) << words.toStdString();
}

} // namespace test
