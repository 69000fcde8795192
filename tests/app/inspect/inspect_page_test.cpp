// SPDX-License-Identifier: MIT
// How the Inspect workspace lays out what it shows.
#include <cmath>
#include <fstream>

#include <QCheckBox>
#include <QLocale>
#include <QStyle>
#include <QTest>

#include <opencv2/imgproc.hpp>

#include "app/desktop/palettes.h"
#include "core/contour/rasteriser.h"
#include "core/hand/hand_model.h"
#include "core/hand/skeleton.h"
#include "core/io/dataset/dataset.h"
#include "core/io/demo/demo_dataset.h"
#include "tests/app/inspect/inspect_fixture.h"
#include "tests/support/pointer.h"

namespace {

using nlohmann::json;

class InspectPageTest : public test::InspectTest {};

QString millimetres(double mm) {
    return QLocale().toString(mm, 'f', 2) + QStringLiteral(" mm");
}

TEST_F(InspectPageTest, TheHeadOfAColumnHasTheErrorOfTheIterationThatIsShown) {
    fit("\"ch\",\"dch-thres\"");
    const auto& outcome = *session().fits.outcome();
    const auto& heads = page().columnBar()->heads();
    ASSERT_EQ(heads.size(), 2u);
    for (std::size_t column = 0; column < 2; ++column)
        EXPECT_EQ(heads[column]->error(), millimetres(outcome.methods[column].errorMm));
    page().setIteration(1);
    app::waitUntilIdle(*window);
    for (std::size_t column = 0; column < 2; ++column)
        EXPECT_EQ(heads[column]->error(), millimetres(outcome.methods[column].iterationErrorMm[0]));
    page().setIteration(0);
    EXPECT_EQ(heads[1]->error(), millimetres(outcome.initialErrorMm));
    EXPECT_TRUE(view(0).title().error.isEmpty()) << "not once more in every row";
    setLayer("difference", true);
    EXPECT_EQ(view(0).title().error, QStringLiteral("IoU ") + QLocale().toString(page().overlays()->iou(0), 'f', 3));
}

TEST_F(InspectPageTest, ViewsStayWhereTheyAreWhenTheFirstLayerAppears) {
    fit("\"ch\",\"dch-thres\"");
    const auto place = [&] { return QRect(view(0).mapTo(window.get(), QPoint()), view(0).size()); };
    const QRect before = place();
    for (const char* layer : {"contour", "field", "error"}) {
        setLayer(layer, true);
        EXPECT_FALSE(page().layerBar()->legend().entries().empty());
        EXPECT_EQ(place(), before) << layer;
        setLayer(layer, false);
    }
}

TEST_F(InspectPageTest, ViewsOfALargeWindowStayWhenTheLegendNeedsItsSecondLine) {
    fit("\"ch\",\"dch-thres\",\"dch-quant\",\"dch-dt3\"");
    run("{\"do\":\"resize\",\"size\":[1920,1080]}\n");
    page().setIteration(2); // while matches are refused
    app::waitUntilIdle(*window);
    const auto place = [&] { return QRect(view(0).mapTo(window.get(), QPoint()), view(0).size()); };
    const QRect before = place();
    for (const char* layer : {"contour", "rim", "matches", "difference", "uncertainty", "error"}) {
        setLayer(layer, true);
        EXPECT_EQ(place(), before) << layer;
    }
    const widgets::LegendStrip& legend = page().layerBar()->legend();
    widgets::LegendStrip alike;
    alike.setEntries(legend.entries());
    EXPECT_GT(alike.heightForWidth(legend.width()), alike.minimumSizeHint().height()) << "two lines are needed";
    EXPECT_GE(legend.height(), legend.heightForWidth(legend.width())) << "no line is cut off";
}

TEST_F(InspectPageTest, ThePinnedProbeCoversNoView) {
    fit("\"ch\",\"dch-thres\"");
    ASSERT_TRUE(page().jointErrors()->isVisible());
    QTest::mouseClick(view(0).viewport(), Qt::LeftButton, {}, view(0).viewport()->rect().center());
    app::waitUntilIdle(*window);
    const QWidget* card = page().probePin()->card();
    ASSERT_TRUE(card->isVisible());
    const QRect place(card->mapTo(window.get(), QPoint()), card->size());
    EXPECT_GT(place.width(), 200);
    EXPECT_LE(card->minimumSizeHint().width(), 440) << "small windows hold it beside the curves, in every language";
    for (const widgets::CameraView* one : page().grid()->views())
        EXPECT_FALSE(QRect(one->mapTo(window.get(), QPoint()), one->size()).intersects(place));
    for (const widgets::CurvePlot* plot : {page().errorPlot(), page().costPlot()})
        EXPECT_FALSE(QRect(plot->mapTo(window.get(), QPoint()), plot->size()).intersects(place));
    EXPECT_FALSE(page().jointErrors()->isVisible()) << "its room is taken";
    page().probePin()->unpin();
    EXPECT_TRUE(page().jointErrors()->isVisible());
}

TEST_F(InspectPageTest, ThePointersLineFollowsTheIteration) {
    fit("\"ch\"");
    const QPoint middle = view(0).viewport()->rect().center();
    test::moveTo(view(0).viewport(), middle + QPoint(20, 9));
    test::moveTo(view(0).viewport(), middle);
    const auto expected = [&] { // as the pointer would be told if it moved now
        const QString shown = page().layerBar()->probeText();
        test::moveTo(view(0).viewport(), middle + QPoint(20, 9));
        test::moveTo(view(0).viewport(), middle);
        return std::pair(shown, page().layerBar()->probeText());
    };
    const QString atEnd = page().layerBar()->probeText();
    ASSERT_TRUE(atEnd.contains(QStringLiteral("dch-quant"))) << atEnd.toStdString();
    page().setIteration(0);
    app::waitUntilIdle(*window);
    const auto [shown, told] = expected();
    EXPECT_EQ(shown, told);
}

TEST_F(InspectPageTest, TheErrorLayerDrawsItsMeshThoughMeshesAreOff) {
    fit("\"ch\"");
    page().setIteration(0);
    trigger("view.meshOff");
    const QImage without = view(0).grabPicture();
    setLayer("error", true);
    const QImage with = view(0).grabPicture();
    int changed = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x)
            changed += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
    EXPECT_GT(changed, 300);
    setLayer("error", false);
    EXPECT_EQ(view(0).grabPicture(), without);
}

TEST_F(InspectPageTest, EmptyBoxesAreSeenOnTheirGround) {
    const QString styleBefore = qApp->style()->objectName();
    const QPalette before = qApp->palette();
    app::applyLook(*qApp, app::Look::Dark);
    QCheckBox box(QStringLiteral("layer"));
    box.resize(box.sizeHint());
    const QImage picture = box.grab().toImage();
    const auto luminance = [](const QColor& c) {
        const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
    };
    double brightest = 0;
    for (int x = 0; x < 10; ++x) // the edge of the empty box, left of its name
        brightest = std::max(brightest, luminance(picture.pixelColor(x, picture.height() / 2)));
    const double ground = luminance(box.palette().color(QPalette::Window));
    EXPECT_GT((brightest + 0.05) / (ground + 0.05), 3) << "contrast of parts of controls (WCAG 1.4.11)";
    qApp->setStyle(styleBefore);
    qApp->setPalette(before);
}

/// What a camera sees of the hands, moved.
cv::Mat movedSilhouette(const core::Camera& camera, const std::vector<core::HandModel>& hands,
                        const core::HandPoses& poses, const Eigen::Vector3d& byMm) {
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    std::vector<core::PosedSurface> surfaces;
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        vertices.push_back(core::posedVertices(hands[hand], poses[hand]));
        for (Eigen::Vector3d& vertex : vertices.back())
            vertex += byMm;
    }
    for (std::size_t hand = 0; hand < hands.size(); ++hand)
        surfaces.push_back({&vertices[hand], &hands[hand].mesh.triangles});
    return core::renderMask(camera, surfaces);
}

TEST_F(InspectPageTest, ATrackerWithTooFewJointsSaysSo) {
    fit("\"ch\"");
    const auto& hands = session().opened.dataset()->hands;
    const core::JointPositions truth = session().fits.outcome()->reference;
    const auto column = [&](const char* name, const std::map<core::Side, int>& joints) {
        const std::string file = (folder / (std::string(name) + ".csv")).string();
        std::ofstream csv(file);
        csv << "sequence,start,test,hand,name,x,y,z\n";
        for (const core::HandModel& hand : hands) {
            int left = joints.count(hand.side) ? joints.at(hand.side) : 0;
            for (const auto& [joint, xyz] : truth)
                if (joint.hand == hand.side && left-- > 0)
                    csv << session().opened.sequence()->name << ",4,7," << core::sideName(joint.hand) << ','
                        << joint.joint << ',' << xyz.x() << ',' << xyz.y() << ',' << xyz.z() << '\n';
        }
        csv.close();
        run(std::string(R"({"do":"columns","trackers":[{"name":")") + name + R"(","file":")" + file +
            R"("}],"show":["ch","external:)" + name + R"("]})");
        return view(1).message();
    };
    using core::Side;
    const QString few = column("few", {{Side::Left, 2}, {Side::Right, 1}});
    EXPECT_TRUE(few.contains(QStringLiteral("fewer than three joints"))) << few.toStdString();
    EXPECT_TRUE(view(0).message().isEmpty());
}

TEST_F(InspectPageTest, ATrackersHandsAreDrawnWhereItSawThem) {
    const core::NewDataset demo = core::makeDemoDataset(); // whose hands have fingers that joints can tell
    core::writeDataset(demo.dataset, demo.motions, folder / "demo");
    const std::string sequence = demo.dataset.sequences[0].name;
    window->openDataset(path("demo"), QString::fromStdString(sequence), 7);
    ASSERT_TRUE(app::waitUntilIdle(*window));
    fit("\"ch\"");
    const core::HandPoses& truth = demo.motions[0][7];
    const Eigen::Vector3d offMm(30, 0, 0);
    std::ofstream file(folder / "other.csv");
    file.precision(15);
    std::ofstream right(folder / "right.csv"); // sees one hand alone
    for (std::ofstream* csv : {&file, &right})
        *csv << "sequence,start,test,hand,name,x,y,z\n";
    for (const auto& [joint, xyz] : core::namedJointPositions(demo.dataset.hands, truth)) {
        if (joint.hand == core::Side::Right)
            right << sequence << ",4,7,right," << joint.joint << ',' << xyz.x() << ',' << xyz.y() << ',' << xyz.z()
                  << '\n';
        file << sequence << ",4,7," << core::sideName(joint.hand) << ',' << joint.joint << ',' << xyz.x() + offMm.x()
             << ',' << xyz.y() + offMm.y() << ',' << xyz.z() + offMm.z() << '\n';
    }
    file.close();
    right.close();
    run(R"({"do":"columns","trackers":[{"name":"right","file":")" + (folder / "right.csv").string() +
        R"("}],"show":["ch","external:right"]})");
    EXPECT_TRUE(view(1).message().isEmpty()) << view(1).message().toStdString();
    run(R"({"do":"columns","trackers":[{"name":"other","file":")" + (folder / "other.csv").string() +
        R"("}],"show":["ch","external:other"]})");
    page().columns()->setCurrent(1);
    page().grid()->finishDrawing();
    const QImage shown = view(1).grabPicture(), other = view(0).grabPicture();
    trigger("compare.hideHere");
    const QImage blank = view(1).grabPicture();
    EXPECT_NE(shown, other);
    constexpr int kEdge = 41; // image pixels, in which the edge is drawn and the pose may be off by two millimetres
    const cv::Mat around = cv::getStructuringElement(cv::MORPH_RECT, {kEdge, kEdge});
    cv::Mat inside, reach;
    const cv::Mat seen = movedSilhouette(view(1).camera(), demo.dataset.hands, truth, offMm);
    cv::erode(seen, inside, around);
    cv::dilate(seen, reach, around);
    int covered = 0, wrong = 0, free = 0;
    for (int y = 0; y < shown.height(); ++y) {
        for (int x = 0; x < shown.width(); ++x) {
            const QPointF px = view(1).viewportToImage(QPointF(x + 0.5, y + 0.5));
            const int u = static_cast<int>(std::lround(px.x())), v = static_cast<int>(std::lround(px.y()));
            constexpr int kBright = 200; // the white outline of what was to be met lies over everything
            if (u < 0 || v < 0 || u >= seen.cols || v >= seen.rows || qGreen(blank.pixel(x, y)) > kBright)
                continue;
            const bool isDrawn = shown.pixel(x, y) != blank.pixel(x, y);
            covered += inside.at<unsigned char>(v, u) ? 1 : 0;
            free += reach.at<unsigned char>(v, u) ? 0 : 1;
            wrong += (inside.at<unsigned char>(v, u) && !isDrawn) || (!reach.at<unsigned char>(v, u) && isDrawn);
        }
    }
    EXPECT_GT(covered, 300);
    EXPECT_GT(free, 300);
    EXPECT_EQ(wrong, 0) << "of " << covered << " covered and " << free << " free ones";
}

} // namespace
