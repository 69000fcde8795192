// SPDX-License-Identifier: MIT
#include <opencv2/core.hpp>

#include "core/io/dataset/dataset.h"
#include "core/io/footage/image_file.h"
#include "tests/app/window_fixture.h"
#include "tests/support/expect_error.h"
#include "widgets/views/message_bar.h"

namespace {

class FootageInTheWindow : public test::WindowTest {
protected:
    /// Changes sequence "a" and opens it anew.
    void change(const std::function<void(core::Sequence&)>& change) {
        window.reset();
        core::Dataset data = core::readDataset(dataset());
        change(data.sequences[0]);
        core::rewriteDatasetFile(data);
        start();
    }
    void goTo(int frame) {
        session().selection.setFrame(frame);
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
    widgets::CameraView& view(int camera) { return *window->workspaces().grid()->view(camera); }
    widgets::MessageBar* notice() { return window->findChild<widgets::MessageBar*>(QStringLiteral("footage")); }
};

TEST_F(FootageInTheWindow, SaysWhereACameraHasNoPicture) {
    change([](core::Sequence& sequence) { sequence.views[1].missing = {{12, 2}}; });
    EXPECT_EQ(view(1).message(), "No picture at this instant.");
    EXPECT_EQ(view(0).message(), "");
    goTo(13);
    EXPECT_EQ(view(1).message(), "No picture at this instant.");
    goTo(14);
    EXPECT_EQ(view(1).message(), "");
}

TEST_F(FootageInTheWindow, RepeatsTheNotesOnceWhenItOpens) {
    EXPECT_EQ(notice()->message(), "");
    change([](core::Sequence& sequence) {
        using Kind = core::FootageNoteKind;
        const auto written = [](const char* text) { return core::FootageNote{Kind::Text, {}, {}, {}, text}; };
        sequence.notes = {{Kind::LostFrames, {sequence.views[1].camera}, {{500, 8}}},
                          written("two"),
                          written("three"),
                          written("four"),
                          written("five")};
    });
    EXPECT_TRUE(notice()->message().contains("missing after frame 499")) << notice()->message().toStdString();
    EXPECT_TRUE(notice()->message().contains("three")) << "written as text by versions of before";
    EXPECT_FALSE(notice()->message().contains("four"));
    notice()->setMessage({});
    goTo(20);
    EXPECT_EQ(notice()->message(), "");
}

TEST_F(FootageInTheWindow, ShowsNoOtherFramesPictureWhereOneIsDamaged) {
    core::writePng(folder / "12.png", cv::Mat(480, 270, CV_8UC3, cv::Scalar::all(250)));
    test::writeText(folder / "13.png", "damaged");
    change([](core::Sequence& sequence) {
        sequence.views[0] = {sequence.views[0].camera, core::ViewKind::Images, "../{frame}.png", 0};
    });
    const auto greyOf = [&] { return qGray(view(0).grabPicture().scaled(1, 1).pixel(0, 0)); };
    EXPECT_GT(greyOf(), 150);
    goTo(13);
    EXPECT_TRUE(view(0).message().contains("13.png")) << view(0).message().toStdString();
    EXPECT_LT(greyOf(), 120) << "a plain view under its message";
}

} // namespace
