// SPDX-License-Identifier: MIT
#include "core/error.h"

#include <gtest/gtest.h>

namespace {

using core::Error;
using core::ErrorCode;

TEST(Error, SaysFileThenFieldThenDetail) {
    const Error error(ErrorCode::BadInput, "hand.json", "bones[3].parent", "must come before its child");
    EXPECT_STREQ(error.what(), "hand.json: bones[3].parent: must come before its child");
    EXPECT_EQ(error.code(), ErrorCode::BadInput);
    EXPECT_EQ(error.file(), "hand.json");
    EXPECT_EQ(error.field(), "bones[3].parent");
    EXPECT_EQ(error.detail(), "must come before its child");
}

TEST(Error, LeavesOutWhatIsNotKnown) {
    EXPECT_STREQ(Error(ErrorCode::Io, "a.json", "", "no space left").what(), "a.json: no space left");
    EXPECT_STREQ(Error(ErrorCode::Usage, "", "tau", "must be positive").what(), "tau: must be positive");
    EXPECT_STREQ(Error(ErrorCode::Newer, "", "", "too new").what(), "too new");
}

TEST(Error, IsCaughtAsAStandardException) {
    try {
        throw Error(ErrorCode::NotFound, "dataset", "sequence", "there is no 05");
    } catch (const std::exception& caught) {
        EXPECT_STREQ(caught.what(), "dataset: sequence: there is no 05");
    }
}

} // namespace
