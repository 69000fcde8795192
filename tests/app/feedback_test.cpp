// SPDX-License-Identifier: MIT
// Nothing that a person does goes without an answer.
#include <sstream>

#include <QDesktopServices>
#include <QKeyEvent>
#include <QPushButton>
#include <QStatusTipEvent>
#include <QTextBrowser>

#include <nlohmann/json.hpp>

#include "app/desktop/actions/number_keys.h"
#include "app/desktop/script/real_input.h"
#include "tests/app/window_fixture.h"
#include "tests/support/wait_until.h"

namespace {

using core::Side;
using nlohmann::json;

using test::kIndex;

class Feedback : public test::WindowTest {
protected:
    Feedback() { session().selection.setJoint(kIndex); }

    json lastAnswer() const {
        std::istringstream stream(answers.str());
        json last;
        for (std::string line; std::getline(stream, line);)
            last = json::parse(line);
        return last;
    }
    void click(int index) {
        const Eigen::Vector2d px = *core::project(camera(index), truth(Side::Left, 1, 12));
        session().annotator.place(camera(index).name, px);
    }
    std::size_t marks() { return session().document.annotations().marks.size(); }
    /// Presses the visible button of that text.
    bool press(const QString& text) {
        for (QPushButton* button : window->findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == text) {
                button->click();
                return true;
            }
        }
        return false;
    }
    /// The same window as a person starts it: it may ask.
    void startForAPerson() {
        settings->setValue(QStringLiteral("hintsSeen"), true);
        window.reset();
        window = app::makeMainWindow(*settings, app::WindowOptions{"ann", true});
        window->setGeometry(0, 0, 1366, 768);
        window->show();
        window->activateWindow();
        window->openDataset(QString::fromStdString(dataset().string()), QStringLiteral("a"), 12);
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
};

TEST_F(Feedback, AClickBesideThePictureIsRefusedInAScript) {
    widgets::CameraView& view = *window->workspaces().grid()->view(0);
    view.lookAt({10, 240}, 0.5); // the left half of the view lies beside the picture
    EXPECT_EQ(play(R"({"do":"click","camera":"cam0","px":[-20,240]})"), 1);
    EXPECT_FALSE(lastAnswer()["ok"].get<bool>());
    EXPECT_NE(lastAnswer()["error"].get<std::string>().find("outside the picture of cam0"), std::string::npos)
        << lastAnswer();
    EXPECT_EQ(marks(), 0u);
    EXPECT_EQ(play(R"({"do":"click","camera":"cam0","px":[20,240]})"), 0) << errors.str();
    EXPECT_EQ(marks(), 1u);
    EXPECT_EQ(play(R"({"do":"drag","camera":"cam0","from":[20,240],"to":[-20,240]})"), 1);
    const auto mark = core::markAt(session().document.annotations(), {12, "ann", kIndex, "cam0"});
    ASSERT_TRUE(mark);
    EXPECT_NEAR(mark->px.x(), 20, 0.5);
}

TEST_F(Feedback, KeysThatDidNothingSayWhy) {
    for (const char* key : {"Ctrl+Space", "Space", "Shift+Space", "X", "Shift+X", "Left"}) {
        EXPECT_EQ(play(std::string("{\"do\":\"key\",\"keys\":\"") + key + "\"}"), 0) << errors.str();
        EXPECT_TRUE(lastAnswer().contains("said")) << key;
    }
    EXPECT_EQ(session().document.undoStack()->count(), 0);
}

TEST_F(Feedback, ARepeatRoundAsksFirstAndSaysHowFarItIs) {
    startForAPerson();
    session().selection.setJoint(kIndex);
    click(0);
    click(3);
    QAction* repeat = window->actions().action(QStringLiteral("annotation.repeat"));
    repeat->trigger();
    EXPECT_FALSE(window->question().isEmpty());
    EXPECT_FALSE(session().raters.isRepeating());
    ASSERT_TRUE(press(QStringLiteral("Not now")));
    EXPECT_TRUE(window->question().isEmpty());
    EXPECT_FALSE(session().raters.isRepeating());
    repeat->trigger();
    ASSERT_TRUE(press(QStringLiteral("Start the repeat round")));
    ASSERT_TRUE(test::waitUntil([&] { return session().raters.isRepeating(); }));
    EXPECT_TRUE(window->banner().message().contains(QStringLiteral("0 of 1 joints")))
        << window->banner().message().toStdString();
    click(0);
    click(3);
    EXPECT_TRUE(window->banner().message().contains(QStringLiteral("1 of 1 joints")))
        << window->banner().message().toStdString();
    ASSERT_TRUE(press(QStringLiteral("End")));
    EXPECT_FALSE(session().raters.isRepeating());
    EXPECT_TRUE(window->banner().message().isEmpty());
    EXPECT_EQ(session().document.rater(), "ann");
}

TEST_F(Feedback, AScriptBeginsARepeatRoundWithoutAQuestion) {
    click(0);
    click(3);
    EXPECT_EQ(play(R"({"do":"action","id":"annotation.repeat"})"), 0) << errors.str();
    EXPECT_TRUE(session().raters.isRepeating());
    EXPECT_TRUE(window->question().isEmpty());
    EXPECT_FALSE(window->banner().message().isEmpty());
}

TEST_F(Feedback, AReportCanBeOpened) {
    click(0);
    const QString page = path("report.html");
    session().files.report(page, 2);
    ASSERT_TRUE(app::waitUntilIdle(*window));
    QTextBrowser browser; // stands in for the person's own
    QDesktopServices::setUrlHandler(QStringLiteral("file"), &browser, "setSource");
    EXPECT_TRUE(window->question().contains(QStringLiteral("report.html")));
    EXPECT_TRUE(press(QStringLiteral("Open")));
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    EXPECT_EQ(browser.source(), QUrl::fromLocalFile(page));
}

TEST_F(Feedback, StatusTipsOfThePartsAppearInTheStatusLine) {
    QString said;
    QObject::connect(&window->statusLine(), &widgets::StatusLine::said, window.get(),
                     [&](const QString& text) { said = text; });
    QStatusTipEvent tip(QStringLiteral("Saved to picture.png"));
    QCoreApplication::sendEvent(window->workspaces().grid()->view(0), &tip);
    EXPECT_EQ(said, QStringLiteral("Saved to picture.png"));
}

TEST_F(Feedback, AFrameBeyondTheEndOpensTheLastOne) {
    window->openDataset(QString::fromStdString(dataset().string()), QStringLiteral("a"), 9999);
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_EQ(session().selection.frame(), 29);
    EXPECT_TRUE(window->message().contains(QStringLiteral("0-29"))) << window->message().toStdString();
    click(0); // which is saved
    EXPECT_FALSE(window->message().isEmpty()) << "a saved edit takes no other message away";
}

TEST_F(Feedback, DigitsWorkOnKeyboardsThatNeedShiftForThem) {
    app::RealInput input(*window);
    const std::pair<const char*, int> french[] = {{"&", 0}, {"\u00e9", 1}, {"\"", 2}, {"'", 3},
                                                  {"(", 4}, {"\u00e8", 6}, {"_", 7}};
    for (const auto& [key, view] : french) {
        input.key(QString::fromUtf8(key), 0);
        EXPECT_EQ(window->workspaces().grid()->maximised(), view) << key;
    }
    const auto digit = [](int key, Qt::KeyboardModifiers modifiers, quint32 scanCode) {
        return app::digitOfKey(QKeyEvent(QEvent::KeyPress, key, modifiers, scanCode, 0, 0));
    };
    EXPECT_EQ(digit(Qt::Key_Minus, Qt::NoModifier, 15), 6) << "by the place of the key";
    EXPECT_FALSE(digit(Qt::Key_Minus, Qt::NoModifier, 82)) << "the keypad's";
    EXPECT_FALSE(digit(Qt::Key_Minus, Qt::NoModifier, 0));
    EXPECT_FALSE(digit(Qt::Key_Ampersand, Qt::ShiftModifier, 16)) << "Shift+7 of an English keyboard";
    EXPECT_FALSE(digit(Qt::Key_1, Qt::NoModifier, 10)) << "has its shortcut already";
    EXPECT_EQ(digit(Qt::Key_Agrave, Qt::ControlModifier, 19), 0);
}

} // namespace
