// SPDX-License-Identifier: MIT
#include "core/fitting/method_options.h"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/fitting/method_name.h"

namespace {

TEST(MethodOptions, HaveOneRowPerKeyWithMeaningDefaultAndSource) {
    std::set<std::string_view> keys;
    for (const core::MethodOption& option : core::methodOptions()) {
        EXPECT_TRUE(keys.insert(option.key).second) << option.key;
        EXPECT_FALSE(option.meaning.empty()) << option.key;
        EXPECT_FALSE(option.defaultText.empty()) << option.key;
        EXPECT_FALSE(option.source.empty()) << option.key;
    }
}

TEST(MethodOptions, DefaultsAreThoseOfTheMethodsThatHaveThem) {
    for (const core::MethodOption& option : core::methodOptions()) {
        int methods = 0;
        for (const std::string& name : core::plainMethodNames()) {
            core::Method method = core::parseMethod(name);
            if (!option.appliesTo(method))
                continue;
            ++methods;
            if (option.key == "bins" || option.key == "gate") {
                EXPECT_EQ(option.print(method), "0") << "depends on the distance";
                continue;
            }
            EXPECT_EQ(option.print(method), option.defaultText) << option.key;
            EXPECT_EQ(option.parse(method, option.defaultText), "") << option.key;
            EXPECT_EQ(core::methodName(method), name) << option.key;
        }
        EXPECT_GT(methods, 0) << option.key;
    }
}

TEST(MethodOptions, ApplyToTheirMethodsOnly) {
    const auto applies = [](const char* key, const char* method) {
        return core::methodOption(key).appliesTo(core::parseMethod(method));
    };
    EXPECT_TRUE(applies("tau", "dch-thres"));
    EXPECT_FALSE(applies("tau", "best")); // its phases have their own
    EXPECT_FALSE(applies("tau", "ch"));
    EXPECT_TRUE(applies("epsilon", "best"));
    EXPECT_TRUE(applies("weights", "dch-quant2"));
    EXPECT_FALSE(applies("weights", "dch-quant"));
    EXPECT_TRUE(applies("palm", "best:live=1"));
    EXPECT_FALSE(applies("palm", "dch-thres"));
    EXPECT_THROW(core::methodOption("nonsense"), std::out_of_range);
}

} // namespace
