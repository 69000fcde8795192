// SPDX-License-Identifier: MIT
#include <opencv2/imgcodecs.hpp>

#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/presenters/camera_colours.h"
#include "widgets/text/advice.h"
#include "widgets/workspaces/workspaces.h"

namespace {

using core::Side;

class HandFramingTest : public test::PanelTest {
protected:
    HandFramingTest() {
        spaces.resize(1366, 700);
        spaces.show();
        reopen("dataset");
    }
    void reopen(const char* name) {
        session.opened.openDataset(QString::fromStdString((folder / name).string()), QStringLiteral("a"), 12);
        settle();
    }
    widgets::CameraView& view(int camera) { return *spaces.grid()->view(camera); }
    QPointF pixel(const core::JointId& joint, int camera) const {
        const Eigen::Vector2d px =
            *core::project(session.opened.dataset()->cameras[static_cast<std::size_t>(camera)], truth(joint, 12));
        return {px.x(), px.y()};
    }
    static double wholeScale(const widgets::CameraView& view) {
        return std::min(view.viewport()->width() / double(view.camera().size.width),
                        view.viewport()->height() / double(view.camera().size.height));
    }
    /// The tiny dataset without a recorded motion, as footage is.
    void writeFootage(const char* name, const std::string& masks) {
        core::Dataset dataset = test::tinyDataset();
        for (core::Sequence& sequence : dataset.sequences) {
            sequence.motion.clear();
            sequence.masks = masks;
            for (core::ViewSource& view : sequence.views)
                view.kind = core::ViewKind::None;
        }
        core::writeDataset(dataset, {{}, {}}, folder / name);
    }
    const core::JointId right{Side::Right, "index_mcp"};
    widgets::Workspaces spaces{session};
};

TEST_F(HandFramingTest, ASequenceOpensWithTheHandsFillingEveryView) {
    for (int camera = 0; camera < 8; ++camera) {
        EXPECT_GT(view(camera).scale(), 1.15 * wholeScale(view(camera))) << camera;
        for (const core::JointId& joint : {index, right})
            EXPECT_TRUE(
                QRectF(view(camera).viewport()->rect()).contains(view(camera).imageToViewport(pixel(joint, camera))))
                << camera;
    }
}

TEST_F(HandFramingTest, ZoomAndPanStayWhenTheFrameChanges) {
    const double scale = view(3).scale();
    const QPointF corner = view(3).viewportToImage({0, 0});
    session.selection.setFrame(20);
    settle();
    EXPECT_DOUBLE_EQ(view(3).scale(), scale);
    EXPECT_EQ(view(3).viewportToImage({0, 0}), corner);
}

TEST_F(HandFramingTest, ViewsShowWholeImagesAndTheHandsAgain) {
    const double framed = view(1).scale();
    spaces.options()->showWholeImages();
    EXPECT_NEAR(view(1).scale(), wholeScale(view(1)), 1e-9);
    view(1).zoomAt({20, 20}, 9);
    EXPECT_TRUE(spaces.framing()->frameHands());
    EXPECT_DOUBLE_EQ(view(1).scale(), framed);
}

TEST_F(HandFramingTest, AMaximisedViewIsFilledByTheHands) {
    spaces.grid()->setMaximised(2);
    EXPECT_GT(view(2).scale(), 1.15 * wholeScale(view(2)));
    const QRectF seen(view(2).viewport()->rect());
    EXPECT_TRUE(seen.contains(view(2).imageToViewport(pixel(index, 2))));
    EXPECT_TRUE(seen.contains(view(2).imageToViewport(pixel(right, 2))));
}

TEST_F(HandFramingTest, EveryHandIsNamedBeforeTheFirstClick) {
    ASSERT_TRUE(session.document.annotations().marks.empty());
    for (int camera = 0; camera < 8; ++camera) {
        const auto& labels = view(camera).handLabels();
        ASSERT_EQ(labels.size(), 2u) << camera;
        EXPECT_EQ(labels[0].side, Side::Left);
        EXPECT_EQ(labels[0].text, QStringLiteral("L"));
        EXPECT_EQ(labels[1].text, QStringLiteral("R"));
        const auto distance = [&](const widgets::HandLabel& label, const core::JointId& joint) {
            return QLineF(label.px, pixel(joint, camera)).length();
        };
        EXPECT_LT(distance(labels[0], index) + distance(labels[1], right),
                  distance(labels[0], right) + distance(labels[1], index))
            << camera;
    }
    spaces.framing()->setHandShown(Side::Left, false);
    ASSERT_EQ(view(0).handLabels().size(), 1u);
    EXPECT_EQ(view(0).handLabels()[0].side, Side::Right);
    spaces.framing()->setLabelsShown(false);
    EXPECT_TRUE(view(0).handLabels().empty());
}

TEST_F(HandFramingTest, FootageIsFramedByMarksOnceThereAreSome) {
    writeFootage("footage", "");
    reopen("footage");
    EXPECT_NEAR(view(0).scale(), wholeScale(view(0)), 1e-9) << "nothing is known";
    EXPECT_TRUE(view(0).handLabels().empty());
    EXPECT_FALSE(spaces.framing()->frameHands());
    core::Mark made;
    for (const int camera : {0, 3}) {
        made.px = {pixel(index, camera).x(), pixel(index, camera).y()};
        session.document.push(core::placeEdit(session.document.annotations(),
                                              {12, "ann", index, "cam" + std::to_string(camera)}, made.px));
    }
    EXPECT_TRUE(spaces.framing()->frameHands());
    for (const int camera : {0, 3, 5}) {
        EXPECT_GT(view(camera).scale(), 1.05 * wholeScale(view(camera))) << camera;
        EXPECT_TRUE(
            QRectF(view(camera).viewport()->rect()).contains(view(camera).imageToViewport(pixel(index, camera))))
            << camera;
    }
    EXPECT_EQ(view(0).handLabels().size(), 1u);
}

TEST_F(HandFramingTest, HandsThatAreFoundLaterFillTheViewsThatNobodyZoomed) {
    writeFootage("footage", "");
    reopen("footage");
    view(1).zoomAt({20, 20}, 3);
    const double zoomed = view(1).scale();
    spaces.framing()->showHands();
    EXPECT_NEAR(view(0).scale(), wholeScale(view(0)), 1e-9) << "nothing is known";
    const auto propose = [&](const core::JointId& joint, int camera, QPointF px) {
        core::Mark mark;
        mark.px = {px.x(), px.y()};
        mark.placement = core::Placement::Proposed;
        core::Edit edit;
        edit.marks.push_back({{12, "ann", joint, "cam" + std::to_string(camera)}, std::nullopt, mark});
        session.document.push(edit);
    };
    for (const int camera : {0, 1, 3})
        for (const core::JointId& joint : {index, core::JointId{Side::Left, "index_pip"}})
            propose(joint, camera, pixel(joint, camera));
    spaces.framing()->showHands();
    for (const int camera : {0, 3, 5}) {
        EXPECT_GT(view(camera).scale(), 1.5 * wholeScale(view(camera))) << camera;
        EXPECT_TRUE(
            QRectF(view(camera).viewport()->rect()).contains(view(camera).imageToViewport(pixel(index, camera))))
            << camera;
    }
    EXPECT_DOUBLE_EQ(view(1).scale(), zoomed);
    const QRectF home = view(0).home();
    view(0).setHome(home.adjusted(-2, -2, 2, 2)); // they fill nearly all of it
    spaces.framing()->showHands();
    EXPECT_EQ(view(0).home(), home.adjusted(-2, -2, 2, 2));
}

TEST_F(HandFramingTest, FootageIsFramedByItsMasks) {
    writeFootage("masked", "masks/{camera}_{frame}.png");
    cv::Mat mask = cv::Mat::zeros(480, 270, CV_8U);
    mask(cv::Rect(100, 200, 60, 80)) = 255;
    std::filesystem::create_directories(folder / "masked" / "masks");
    cv::imwrite((folder / "masked" / "masks" / "cam4_12.png").string(), mask);
    reopen("masked");
    EXPECT_GT(view(4).scale(), 2 * wholeScale(view(4)));
    EXPECT_LT(
        QLineF(view(4).viewportToImage(QRectF(view(4).viewport()->rect()).center()), QPointF(129.5, 239.5)).length(),
        1);
    EXPECT_NEAR(view(0).scale(), wholeScale(view(0)), 1e-9) << "it has no mask";
}

TEST_F(HandFramingTest, AHiddenHandLeavesThePicture) {
    for (const int camera : {0, 3}) {
        click(index, camera);
        click(right, camera);
    }
    session.selection.setJoint({Side::Right, "forearm"});
    const auto marksOf = [&](Side hand) {
        const auto& marks = view(0).marks();
        return std::count_if(marks.begin(), marks.end(),
                             [&](const widgets::ViewMark& mark) { return mark.joint.hand == hand; });
    };
    EXPECT_EQ(marksOf(Side::Left), 1);
    spaces.marks()->setHandShown(Side::Left, false);
    EXPECT_EQ(marksOf(Side::Left), 0);
    EXPECT_EQ(marksOf(Side::Right), 1);
    session.selection.setJoint(index);
    EXPECT_EQ(marksOf(Side::Left), 1) << "what is worked on is seen";
    spaces.marks()->setHandShown(Side::Left, true);
    EXPECT_EQ(marksOf(Side::Left), 1);
}

TEST_F(HandFramingTest, TheTitleOfTheViewToClickNextSaysSo) {
    const auto asking = [&] {
        QStringList names;
        for (const widgets::CameraView* view : spaces.grid()->views())
            if (!view->title().next.isEmpty())
                names << view->title().name;
        return names;
    };
    EXPECT_TRUE(asking().isEmpty());
    click(index, 0);
    EXPECT_TRUE(asking().isEmpty()) << "one click does not tell which view helps most";
    for (const int camera : {3, 5}) {
        click(index, camera);
        const QString advice = widgets::adviceText(index, session.reconstructions.selected());
        ASSERT_EQ(asking().size(), 1) << advice.toStdString();
        EXPECT_TRUE(advice.contains(asking().front())) << advice.toStdString();
    }
}

TEST_F(HandFramingTest, TitlesHaveTheColoursOfTheGuides) {
    click(index, 2);
    for (int camera = 0; camera < 8; ++camera)
        EXPECT_EQ(view(camera).title().colour, widgets::cameraColour(camera));
}

} // namespace
