// SPDX-License-Identifier: MIT
#include "core/io/files/json_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

using enum core::ErrorCode;

class JsonFile : public testing::Test {
protected:
    void expectRefused(const std::string& text, const std::string& word) {
        test::writeText(m_file, text);
        test::expectError([&] { core::readJsonFile(m_file); }, BadInput, m_file.string(), word);
    }

    test::TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "file.json";
};

TEST_F(JsonFile, SaysWhatIsWrongAndWhere) {
    expectRefused("", "is empty");
    expectRefused(" \n ", "is empty");
    expectRefused("{\"a\": [1, 2", "ends too early");
    expectRefused("{\n  \"a\": x}", "line 2, column 8: not JSON");
    expectRefused("{\"a\": NaN}", "line 1");
    expectRefused("{\"a\": 1e999}", "too large");
    expectRefused(std::string("\x01\xff\xfe\x00\x80 binary", 12), "not JSON");
    expectRefused(std::string(100000, '['), "nested");
    expectRefused(std::string(65, '[') + std::string(65, ']'), "nested");
}

TEST_F(JsonFile, ReadsWhatIsNestedDeepButNotTooDeep) {
    test::writeText(m_file, std::string(64, '[') + std::string(64, ']'));
    EXPECT_NO_THROW(core::readJsonFile(m_file));
    test::writeText(m_file, "[\"" + std::string(200, '[') + "\\\"" + std::string(200, '{') + "\"]");
    EXPECT_NO_THROW(core::readJsonFile(m_file)); // brackets in a string do not nest
}

TEST_F(JsonFile, RefusesOtherFormatsAndNewerVersions) {
    const auto read = [&] { core::readOwnFile(m_file, "cameras"); };
    test::writeText(m_file, R"({"format": "handlens-hand", "version": 1})");
    test::expectError(read, BadInput, "file.json: format", "handlens-cameras");
    test::writeText(m_file, R"({"format": "handlens-cameras", "version": 2, "anything": 1})");
    test::expectError(read, Newer, "file.json: version", "newer");
    for (const char* other : {"[]", "null", "3", "\"text\"", "{}"}) {
        test::writeText(m_file, other);
        test::expectError(read, BadInput, "file.json: format", "handlens-cameras");
    }
}

TEST_F(JsonFile, NamesTheFieldThatBreaksTheSchema) {
    test::writeText(
        m_file,
        R"({"format": "handlens-cameras", "version": 1, "units": "mm", "cameras": [{"name": "a", "size": [4, "x"],
        "K": [[1,0,0],[0,1,0],[0,0,1]], "R": [[1,0,0],[0,1,0],[0,0,1]], "t": [0,0,0]}]})");
    test::expectError([&] { core::readOwnFile(m_file, "cameras"); }, BadInput, "file.json: cameras[0].size[1]", "");
}

TEST_F(JsonFile, WritesNumbersThatReadBackExactly) {
    const std::vector<double> values{1 / 3.0, -1e-300, 1.7976931348623157e308, 5e-324, 0.1, 12345678.9, 0};
    core::writeJsonFile(m_file, {{"values", values}, {"text", "a \"b\"\n\xC3\xA4"}});
    const nlohmann::json read = core::readJsonFile(m_file);
    EXPECT_EQ(read["values"].get<std::vector<double>>(), values);
    EXPECT_EQ(read["text"], "a \"b\"\n\xC3\xA4");
}

TEST(FormatJson, KeepsListsOfNumbersOnOneLine) {
    const nlohmann::ordered_json value{
        {"K", {{1, 0}, {0, 1}}}, {"list", {1, 2}}, {"empty", nlohmann::ordered_json::array()}};
    EXPECT_EQ(core::formatJson(value), "{\n \"K\": [[1,0],[0,1]],\n \"list\": [1,2],\n \"empty\": []\n}\n");
}

TEST(JsonNumbers, ChecksCountsAndContents) {
    const nlohmann::json list{1, 2.5, 3};
    EXPECT_EQ(core::jsonNumbers(list, 3, "f", "x"), (std::vector<double>{1, 2.5, 3}));
    test::expectError([&] { core::jsonNumbers(list, 4, "f", "x"); }, BadInput, "f: x", "4 numbers");
    test::expectError([&] { core::jsonNumbers({1, "a"}, 2, "f", "x"); }, BadInput, "f: x[1]", "finite");
    test::expectError([&] { core::jsonIntegers(list, 3, 0, 9, "f", "x"); }, BadInput, "f: x[1]", "whole number");
    test::expectError([&] { core::jsonIntegers({1, 10}, 2, 0, 9, "f", "x"); }, BadInput, "f: x[1]", "0 to 9");
    test::expectError([&] { core::jsonMatrix({{1, 2, 3}, {1, 2}}, "f", "x"); }, BadInput, "f: x", "three rows");
}

} // namespace
