// SPDX-License-Identifier: MIT
#include <set>
#include <sstream>

#include <QImage>

#include <nlohmann/json.hpp>

#include "tests/app/window_fixture.h"

namespace {

using nlohmann::json;

class Script : public test::WindowTest {};

TEST_F(Script, AnswersEveryStepInOneLine) {
    EXPECT_EQ(play("{\"do\":\"goto\",\"sequence\":\"b\",\"frame\":3}\n\n"
                   "{\"do\":\"select\",\"hand\":\"left\",\"joint\":\"index_mcp\"}\n"
                   "{\"do\":\"print\",\"what\":\"joint\",\"hand\":\"left\",\"joint\":\"index_mcp\"}\n"),
              0)
        << errors.str();
    const auto lines = said();
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0]["step"], 1);
    EXPECT_EQ(lines[1]["step"], 3);
    EXPECT_EQ(lines[0]["do"], "goto");
    for (const json& line : lines)
        EXPECT_TRUE(line["ok"].get<bool>());
    EXPECT_TRUE(lines[2]["xyz"].is_null());
    EXPECT_EQ(lines[2]["status"], "none");
    EXPECT_EQ(session().selection.frame(), 3);
}

TEST_F(Script, KeysReachTheWindowAgainWhenADialogHasClosed) {
    for (const char* dialog : {"F1", "Ctrl+E", "Ctrl+U"}) {
        EXPECT_EQ(play(std::string("{\"do\":\"key\",\"keys\":\"") + dialog + "\"}\n"), 0) << errors.str();
        app::waitMs(300); // the dialog gets the keyboard
        EXPECT_EQ(play("{\"do\":\"key\",\"keys\":\"Escape\"}\n"), 0) << errors.str();
        app::waitMs(300); // the window gets it back
        EXPECT_EQ(play("{\"do\":\"key\",\"keys\":\"Ctrl+2\"}\n"), 0) << errors.str();
        EXPECT_EQ(window->workspaces().current(), widgets::Workspaces::Kind::Inspect) << dialog;
        EXPECT_EQ(play("{\"do\":\"key\",\"keys\":\"Ctrl+1\"}\n"), 0);
    }
}

TEST_F(Script, EscapeGivesUpWhatWasTypedIntoANote) {
    const auto type = [this](std::initializer_list<const char*> keys) {
        std::string lines;
        for (const char* key : keys)
            lines += std::string("{\"do\":\"key\",\"keys\":\"") + key + "\"}\n";
        EXPECT_EQ(play(lines), 0) << errors.str();
    };
    const int frame = session().selection.frame();
    const auto& notes = session().document.annotations().notes;
    type({"Ctrl+M", "A", "B", "Return"});
    EXPECT_EQ(notes.at(frame), "ab");
    type({"Ctrl+M", "C", "Return"});
    EXPECT_EQ(notes.at(frame), "abc") << "what was there is not replaced";
    type({"Ctrl+M", "X", "Escape", "D"});
    EXPECT_EQ(notes.at(frame), "abc");
    EXPECT_EQ(session().selection.frame(), frame + 1) << "the keyboard is the window's again";
}

struct BadStep {
    const char* line;
    const char* mentions;
};

TEST_F(Script, BadStepsEndTheRunWithAClearLine) {
    const BadStep steps[] = {
        {"{\"do\":\"dance\"}", "dance"},
        {"{}", "do"},
        {"[1]", "object"},
        {"{\"do\":", "JSON"},
        {"{\"do\":\"goto\",\"sequence\":\"nowhere\",\"frame\":1}", "nowhere"},
        {"{\"do\":\"goto\",\"frame\":300}", "300"},
        {"{\"do\":\"goto\",\"frame\":1.5}", "frame"},
        {"{\"do\":\"select\",\"hand\":\"middle\",\"joint\":\"index_mcp\"}", "hand"},
        {"{\"do\":\"select\",\"hand\":\"left\",\"joint\":\"elbow\"}", "elbow"},
        {"{\"do\":\"click\",\"camera\":\"cam99\",\"px\":[1,1]}", "cam99"},
        {"{\"do\":\"click\",\"camera\":\"cam0\",\"px\":[-500,1]}", "cam0"},
        {"{\"do\":\"click\",\"camera\":\"cam0\",\"px\":[1]}", "px"},
        {"{\"do\":\"key\",\"keys\":\"Hyper+Q\"}", "Hyper+Q"},
        {"{\"do\":\"action\",\"id\":\"no.such\"}", "no.such"},
        {"{\"do\":\"print\",\"what\":\"results\"}", "fitted"},
        {"{\"do\":\"fit\",\"start\":1,\"test\":500,\"methods\":[\"ch\"]}", "frame"},
        {"{\"do\":\"fit\",\"start\":1,\"test\":2,\"methods\":[\"magic\"]}", "magic"},
        {"{\"do\":\"export\",\"to\":\"nothing\",\"path\":\"x\"}", "nothing"},
        {"{\"do\":\"shot\",\"of\":\"moon\",\"path\":\"x.png\"}", "moon"},
        {"{\"do\":\"shot\",\"of\":\"window\",\"path\":\"/nowhere/x.png\"}", "/nowhere/x.png"},
        {"{\"do\":\"resize\",\"size\":[0,0]}", "size"},
    };
    for (const BadStep& step : steps) {
        EXPECT_EQ(play("{\"do\":\"timing\"}\n" + std::string(step.line) + "\n{\"do\":\"timing\"}\n"), 1) << step.line;
        const auto lines = said();
        ASSERT_EQ(lines.size(), 2u) << step.line;
        EXPECT_FALSE(lines[1]["ok"].get<bool>());
        EXPECT_NE(errors.str().find("line 2: "), std::string::npos) << errors.str();
        EXPECT_NE(errors.str().find(step.mentions), std::string::npos) << step.line << " said " << errors.str();
    }
}

TEST_F(Script, FitsAndPrintsResults) {
    EXPECT_EQ(play("{\"do\":\"fit\",\"start\":4,\"test\":7,\"methods\":[\"ch\",\"dch-thres\"]}\n"
                   "{\"do\":\"print\",\"what\":\"results\"}\n"),
              0)
        << errors.str();
    const json results = said()[1]["results"];
    ASSERT_EQ(results.size(), 2u);
    EXPECT_EQ(results[1]["method"], "dch-thres");
    const auto motion = test::tinyMotion(8);
    const double apart = core::meanJointDistanceMm(test::tinyHands(), motion[4], motion[7]);
    EXPECT_NEAR(results[1]["initialErrorMm"].get<double>(), apart, 1e-6);
    EXPECT_GT(results[1]["iterations"].get<int>(), 0);
    EXPECT_EQ(session().selection.frame(), 7);
}

TEST_F(Script, ShotsShowPictures) {
    EXPECT_EQ(play("{\"do\":\"resize\",\"size\":[1280,720]}\n"
                   "{\"do\":\"shot\",\"of\":\"window\",\"path\":\"window.png\"}\n"
                   "{\"do\":\"shot\",\"of\":\"scene\",\"path\":\"scene.png\"}\n"
                   "{\"do\":\"shot\",\"of\":\"cam3\",\"path\":\"cam3.png\"}\n"),
              0)
        << errors.str();
    EXPECT_EQ(QImage(path("out/window.png")).size(), QSize(1280, 720));
    const QImage scene(path("out/scene.png"));
    std::set<QRgb> colours;
    for (int y = 0; y < scene.height(); y += 2)
        for (int x = 0; x < scene.width(); x += 2)
            colours.insert(scene.pixel(x, y));
    EXPECT_GT(colours.size(), 20u);
    EXPECT_FALSE(QImage(path("out/cam3.png")).isNull());
}

} // namespace
