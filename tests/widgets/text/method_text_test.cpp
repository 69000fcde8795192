// SPDX-License-Identifier: MIT
#include "widgets/text/method_text.h"

#include <set>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/fitting/method_name.h"
#include "core/fitting/method_options.h"

namespace {

TEST(MethodText, EveryOptionHasAMeaningOfItsOwn) {
    std::set<QString> meanings;
    for (const core::MethodOption& option : core::methodOptions()) {
        const QString meaning = widgets::optionMeaning(option.key);
        EXPECT_FALSE(meaning.isEmpty()) << option.key;
        EXPECT_TRUE(meanings.insert(meaning).second) << option.key;
    }
    EXPECT_TRUE(widgets::optionMeaning("nonsense").isEmpty());
}

/// What the window refuses is what the command line refuses.
TEST(MethodText, ProblemsAreThoseOfTheCommandLine) {
    for (const std::string& name : core::plainMethodNames()) {
        for (const core::MethodOption& option : core::methodOptions()) {
            for (const char* value :
                 {"0", "1", "2.5", "-1", "22.5", "300", "1e9", "rigid", "paper", "chord", "cut", "tensor", "", "x"}) {
                const std::string method = name + ":" + std::string(option.key) + "=" + value;
                bool isRefused = false;
                try {
                    core::parseMethod(method);
                } catch (const core::Error&) {
                    isRefused = true;
                }
                EXPECT_EQ(widgets::methodProblem(QString::fromStdString(method)).isEmpty(), !isRefused) << method;
            }
        }
    }
    EXPECT_FALSE(widgets::methodProblem(QStringLiteral("dch")).isEmpty());
    EXPECT_FALSE(widgets::methodProblem(QString()).isEmpty());
    EXPECT_FALSE(widgets::methodProblem(QStringLiteral("ch:gate")).isEmpty());
}

TEST(MethodText, SaysWhichValuesAnOptionTakes) {
    EXPECT_EQ(widgets::methodProblem(QStringLiteral("dch-thres:tau=400")),
              QStringLiteral("tau must be a number from 0 to 180, not \"400\"."));
    EXPECT_EQ(widgets::methodProblem(QStringLiteral("ch:schedule=slow")),
              QStringLiteral("schedule must be rigid or paper, not \"slow\"."));
    const QString unknown = widgets::methodProblem(QStringLiteral("ch:tau=3"));
    EXPECT_TRUE(unknown.startsWith(QStringLiteral("ch has no option \"tau\"; it has noise, gate")))
        << unknown.toStdString();
}

} // namespace
