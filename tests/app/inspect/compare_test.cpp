// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>

#include <QTest>

#include <nlohmann/json.hpp>

#include "app/desktop/script/workspace_player.h"
#include "core/fitting/method_name.h"
#include "tests/app/inspect/inspect_fixture.h"
#include "widgets/panels/compare/what_if_panel.h"

namespace {

using nlohmann::json;
using Ids = std::vector<std::string>;

/// The columns of the Inspect workspace.
class CompareTest : public test::InspectTest {
protected:
    json show(const std::string& ids) { return run("{\"do\":\"columns\",\"show\":[" + ids + "]}\n")[0]["columns"]; }
    Ids ids() {
        Ids names;
        for (const widgets::InspectColumn& column : columns().columns())
            names.push_back(widgets::columnId(column));
        return names;
    }
    double errorOf(const std::string& method) {
        for (const widgets::MethodOutcome& outcome : session().fits.outcome()->methods)
            if (outcome.method == method)
                return outcome.errorMm;
        return std::nan("");
    }
    widgets::WhatIfPanel& panel() { return *window->workspaces().whatIfPanel(); }
    /// Of the views: their height, and how many stand in the first row.
    struct CameraGridGeometry {
        int height = 0, rowLength = 0;
    };
    CameraGridGeometry geometry() {
        CameraGridGeometry found{page().grid()->view(0)->height(), 0};
        for (const widgets::CameraView* view : page().grid()->views())
            found.rowLength += view->y() == page().grid()->view(0)->y() ? 1 : 0;
        return found;
    }
    /// What a view shows on screen, with what lies over it.
    QImage screen(int view) { return page().grid()->view(view)->viewport()->grab().toImage(); }
};

TEST_F(CompareTest, ColumnsAreMethodsSettingsStartAndTruthInAnyOrder) {
    fit("\"ch\"");
    const double chMm = errorOf("ch"), chSeconds = session().fits.outcome()->methods[0].result.seconds;
    const json shown = show(R"("start","dch-thres:tau=45","ch","truth")");
    EXPECT_EQ(ids(), (Ids{"start", "dch-thres:tau=45", "ch", "truth"}));
    EXPECT_NEAR(shown[0]["errorMm"].get<double>(), session().fits.outcome()->initialErrorMm, 1e-9);
    EXPECT_NEAR(shown[3]["errorMm"].get<double>(), 0, 1e-6);
    EXPECT_EQ(shown[2]["errorMm"].get<double>(), chMm);
    EXPECT_EQ(session().fits.outcome()->methods[0].result.seconds, chSeconds) << "ch was not fitted again";
    EXPECT_EQ(page().grid()->count(), 2 * 4);
    page().setIteration(0);
    app::waitUntilIdle(*window);
    page().grid()->finishDrawing();
    const auto picture = [&](int view) { return page().grid()->view(view)->grabPicture(); };
    EXPECT_NE(picture(0), picture(3)) << "start and truth are other poses";
    page().setIteration(page().lastIteration());
    app::waitUntilIdle(*window);
    EXPECT_EQ(page().grid()->view(0)->title().name, QStringLiteral("Start"));
    EXPECT_EQ(page().grid()->view(1)->title().name, QStringLiteral("dch-thres:tau=45"));
    EXPECT_NE(columns().colour(1), columns().colour(2));
    EXPECT_EQ(play(R"({"do":"columns","show":["dch-thres:tau=400"]})"), 1);
    EXPECT_NE(errors.str().find("tau must be a number from 0 to 180"), std::string::npos) << errors.str();
}

TEST_F(CompareTest, TwoSettingsOfOneMethodHaveTwoColours) {
    fit("\"dch-thres\",\"dch-thres:tau=45\"");
    EXPECT_NE(columns().colour(0), columns().colour(1));
}

TEST_F(CompareTest, ColumnsChangePlacesByDragAndByKeysAndGo) {
    fit("\"ch\",\"dch-thres\",\"dch-quant\"");
    const auto& heads = page().columnBar()->heads();
    ASSERT_EQ(heads.size(), 3u);
    const QPoint grip(30, heads[0]->height() / 2);
    QTest::mousePress(heads[0], Qt::LeftButton, {}, grip);
    QTest::mouseMove(heads[0], grip + QPoint(40, 0));
    for (const int x : {60, 2 * heads[0]->width() + 40}) {
        QMouseEvent move(QEvent::MouseMove, QPointF(grip + QPoint(x, 0)), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(heads[0], &move);
    }
    QTest::mouseRelease(heads[0], Qt::LeftButton, {}, grip);
    app::waitUntilIdle(*window);
    EXPECT_EQ(ids(), (Ids{"dch-thres", "dch-quant", "ch"}));
    EXPECT_EQ(columns().current(), 2u);
    trigger("compare.columnLeft");
    EXPECT_EQ(ids(), (Ids{"dch-thres", "ch", "dch-quant"}));
    trigger("compare.previousColumn");
    trigger("compare.removeColumn");
    EXPECT_EQ(ids(), (Ids{"ch", "dch-quant"}));
    trigger("compare.addTruth");
    EXPECT_EQ(ids(), (Ids{"ch", "dch-quant", "truth"}));
    fit("\"best\"");
    EXPECT_EQ(ids(), (Ids{"truth", "best"})) << "what the new pair has, stays";
}

TEST_F(CompareTest, NothingOfThePairBeforeStaysInTheColumnsOfAnother) {
    fit("\"ch\",\"dch-thres\"");
    show("\"start\",\"ch\",\"dch-thres\",\"dch-thres:tau=45\"");
    run(R"({"do":"whatIf","method":"ch","set":"gate","to":8})");
    ASSERT_TRUE(columns().isPreview(1));
    ASSERT_EQ(panel().points().count("ch"), 1u);
    run("{\"do\":\"fit\",\"start\":1,\"test\":6,\"methods\":[\"ch\",\"dch-thres\"]}\n");
    EXPECT_EQ(ids(), (Ids{"start", "ch", "dch-thres"})) << "what was not fitted on this pair is gone";
    const auto& fitted = *session().fits.outcome();
    const auto& shown = *columns().outcome();
    EXPECT_EQ(shown.methods[0].errorMm, fitted.initialErrorMm);
    for (std::size_t method = 0; method < fitted.methods.size(); ++method) {
        EXPECT_FALSE(columns().isPreview(method + 1));
        EXPECT_EQ(shown.methods[method + 1].method, fitted.methods[method].method);
        EXPECT_EQ(shown.methods[method + 1].errorMm, fitted.methods[method].errorMm);
        EXPECT_TRUE(shown.methods[method + 1].result.poses == fitted.methods[method].result.poses);
    }
    EXPECT_TRUE(panel().points().empty()) << "the curve was of the pair before";
}

TEST_F(CompareTest, OneColumnOfManyCamerasIsAGridOfLargerViews) {
    fit("\"ch\",\"dch-thres\"");
    run(R"({"do":"columns","cameras":["cam0","cam1","cam2","cam3","cam4","cam5","cam6","cam7"]})");
    const CameraGridGeometry strips = geometry();
    show("\"ch\"");
    ASSERT_EQ(page().grid()->count(), 8);
    EXPECT_GT(geometry().height, 2 * strips.height);
    EXPECT_GT(geometry().rowLength, 1);
    for (int view = 0; view < 8; ++view)
        EXPECT_EQ(page().grid()->view(view)->camera().name, "cam" + std::to_string(view));
}

TEST_F(CompareTest, RowsAreTheCamerasThatAreChosen) {
    fit("\"ch\",\"dch-thres\"");
    const json answer = run(R"({"do":"columns","cameras":["cam5","cam1","cam0"]})")[0];
    EXPECT_EQ(answer["cameras"], (Ids{"cam5", "cam1", "cam0"}));
    ASSERT_EQ(page().grid()->count(), 6);
    EXPECT_EQ(page().grid()->view(0)->camera().name, "cam5");
    EXPECT_EQ(page().grid()->view(3)->camera().name, "cam1");
    session().selection.setCamera("cam7");
    EXPECT_EQ(page().grid()->view(0)->camera().name, "cam5") << "the choice stays";
    page().views()->chooseCameras({});
    EXPECT_EQ(page().grid()->view(0)->camera().name, "cam7");
    EXPECT_EQ(play(R"({"do":"columns","cameras":["cam77"]})"), 1);
}

TEST_F(CompareTest, AMethodIsSwitchedOffInOneView) {
    fit("\"ch\",\"dch-thres\"");
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":true}\n");
    columns().setCurrent(1);
    page().grid()->finishDrawing();
    const QImage here = page().grid()->view(1)->grabPicture(), beside = page().grid()->view(0)->grabPicture();
    trigger("compare.hideHere");
    EXPECT_NE(page().grid()->view(1)->grabPicture(), here);
    EXPECT_TRUE(page().grid()->view(1)->shapes().lines.empty()) << "no matches either";
    EXPECT_FALSE(page().grid()->view(3)->shapes().lines.empty()) << "the other camera's are there";
    EXPECT_EQ(page().grid()->view(0)->grabPicture(), beside);
    trigger("compare.hideHere");
    EXPECT_EQ(page().grid()->view(1)->grabPicture(), here);
}

TEST_F(CompareTest, AnotherTrackersEstimateIsAColumnWithItsOwnError) {
    fit("\"ch\"");
    const auto joints = core::namedJointPositions(test::tinyHands(), test::tinyMotion(8).back());
    const auto write = [&](int test, const char* last) {
        std::ofstream file(folder / "other.csv");
        file.precision(15);
        file << "sequence,start,test,hand,name,x,y,z\n";
        for (const auto& [joint, xyz] : joints)
            file << "a,4," << test << ',' << core::sideName(joint.hand) << ',' << joint.joint << ',' << xyz.x() + 3
                 << ',' << xyz.y() << ',' << xyz.z() << '\n';
        file << last;
    };
    const std::string step = R"({"do":"columns","trackers":[{"name":"other","file":")" +
                             (folder / "other.csv").string() + R"("}],"show":["ch","external:other"]})";
    write(7, "");
    const json shown = run(step)[0]["columns"];
    EXPECT_EQ(ids(), (Ids{"ch", "external:other"}));
    EXPECT_NEAR(shown[1]["errorMm"].get<double>(), 3, 1e-6);
    write(8, ""); // nothing of this pair
    run(step);
    EXPECT_EQ(page().grid()->view(1)->title().error, QStringLiteral("failed"));
    write(7, "a,4,7,left,nose,x,0,0\n");
    EXPECT_EQ(play(step), 1);
    EXPECT_NE(errors.str().find("other.csv"), std::string::npos) << errors.str();
}

TEST_F(CompareTest, DraggedTauFitsAgainAsTheCommandLineWould) {
    fit("\"dch-thres\",\"ch\"");
    const double before = errorOf("dch-thres");
    const json points = run(R"({"do":"whatIf","method":"dch-thres","set":"tau","to":10})")[0]["points"]["dch-thres"];
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[1], (std::vector<double>{22.5, before})) << "known from the start";
    EXPECT_EQ(points[0][0], 10);
    EXPECT_EQ(columns().title(0), QStringLiteral("dch-thres:tau=10?"));
    EXPECT_EQ(panel().line()->text(), QStringLiteral("dch-thres:tau=10"));
    EXPECT_EQ(errorOf("dch-thres"), before) << "the fit itself is untouched";
    panel().addColumn();
    app::waitUntilIdle(*window);
    EXPECT_EQ(ids(), (Ids{"dch-thres", "ch", "dch-thres:tau=10"}));
    EXPECT_EQ(errorOf("dch-thres:tau=10"), points[0][1].get<double>());
    EXPECT_NE(errorOf("dch-thres:tau=10"), before);
    EXPECT_EQ(columns().title(0), QStringLiteral("dch-thres"));
}

TEST_F(CompareTest, SettingsTakeTheColumnsPlace) {
    fit("\"dch-dt3\",\"ch\"");
    run(R"({"do":"whatIf","method":"dch-dt3","set":"lambda","to":10})");
    trigger("compare.useSettings");
    EXPECT_EQ(ids(), (Ids{"dch-dt3:lambda=10", "ch"}));
    EXPECT_EQ(panel().line()->text(), QStringLiteral("dch-dt3:lambda=10"));
}

TEST_F(CompareTest, ACameraLessFitsWithoutItsSilhouette) {
    fit("\"dch-thres\"");
    const auto& outcome = *session().fits.outcome();
    std::vector<cv::Mat> masks = outcome.masks;
    masks[2] = cv::Mat();
    const core::PoseEstimator estimator(test::tinyHands(), session().opened.dataset()->cameras);
    const double without =
        widgets::errorAgainst(outcome, *session().opened.dataset(),
                              estimator.fit(masks, outcome.startPoses, core::parseMethod("dch-thres")).poses);
    const json points = run(R"({"do":"whatIf","camera":"cam2","on":false})")[0]["points"];
    EXPECT_EQ(points["dch-thres"][0], (std::vector<double>{7, without}));
    EXPECT_EQ(points["dch-thres"][1], (std::vector<double>{8, errorOf("dch-thres")}));
    EXPECT_EQ(points["best:live=1:restarts=0"].size(), 1u) << "the quick one, too";
    trigger("compare.resetSettings");
    EXPECT_TRUE(panel().cameras()[2]->isChecked());
    EXPECT_FALSE(columns().isPreview(0));
    trigger("compare.measureCameras");
    const QString said = panel().cameras()[2]->text();
    EXPECT_TRUE(said.contains(QLocale().toString(std::abs(without - errorOf("dch-thres")), 'f', 2)))
        << said.toStdString();
}

TEST_F(CompareTest, TheRealTimeVariantWaitsForNoOtherFit) {
    fit("\"best\"");
    widgets::WhatIf whatIf(session().fits, session().opened, session().pool);
    std::vector<std::string> order;
    std::vector<bool> judged;
    QObject::connect(&whatIf, &widgets::WhatIf::found,
                     [&](const widgets::WhatIfTrial& trial, const widgets::MethodOutcome& outcome) {
                         order.push_back(trial.method);
                         judged.push_back(outcome.result.confidence.has_value());
                     });
    whatIf.run({{"dch-thres", {}, "", "tau", 1}});
    whatIf.run({{"best:live=1", {}, "", "tau", 2, true}, {"ch", {}, "", "tau", 2}});
    app::waitFor(*window, [&] { return !order.empty(); });
    EXPECT_TRUE(whatIf.isRunning()) << "what comes next waits for a moment";
    app::waitFor(*window, [&] { return !whatIf.isRunning(); });
    EXPECT_EQ(order, (std::vector<std::string>{"best:live=1", "ch"})) << "what ran before is out of date";
    EXPECT_EQ(judged, (std::vector<bool>{false, true}));
}

TEST_F(CompareTest, NoisierOutlinesMakeOtherFits) {
    fit("\"ch\"");
    const json points = run(R"({"do":"whatIf","set":"outlines","to":1.5})")[0]["points"]["ch"];
    ASSERT_EQ(points.size(), 2u);
    EXPECT_NE(points[0][1], points[1][1]);
    panel().goBack();
    EXPECT_EQ(run(R"({"do":"whatIf","set":"outlines","to":1.5})")[0]["points"]["ch"], points) << "by the same seed";
}

TEST_F(CompareTest, ASweepFillsTheCurveOfEveryColumnThatHasTheSetting) {
    fit("\"dch-thres\",\"ch\",\"dch-thres:noise=0\"");
    const json points = run(R"({"do":"whatIf","method":"dch-thres","sweep":"tau"})")[0]["points"];
    for (const char* method : {"dch-thres", "dch-thres:noise=0"}) {
        std::vector<double> taus;
        for (const json& point : points[method])
            taus.push_back(point[0]);
        EXPECT_EQ(taus, (std::vector<double>{5, 11.25, 22.5, 45, 90, 180})) << method;
    }
    EXPECT_FALSE(points.contains("ch")) << "it has no tau";
    EXPECT_EQ(points["dch-thres"][2][1], errorOf("dch-thres")) << "known before";
    for (std::size_t column = 0; column < 3; ++column)
        EXPECT_FALSE(columns().isPreview(column)) << "the views stay as they are";
    EXPECT_FALSE(panel().isSweeping());
    show("\"dch-thres:tau=45\",\"dch-thres:tau=180\"");
    EXPECT_EQ(points["dch-thres"][3][1], errorOf("dch-thres:tau=45")) << "as the command line would";
    EXPECT_EQ(points["dch-thres"][5][1], errorOf("dch-thres:tau=180"));
}

TEST_F(CompareTest, ASweepIsOnePressAndAnotherStopsIt) {
    fit("\"dch-quant\"");
    EXPECT_EQ(panel().sweptKey(), "bins") << "its first number";
    QAction* sweep = window->actions().action(QStringLiteral("compare.sweep"));
    sweep->trigger();
    EXPECT_TRUE(panel().isSweeping());
    sweep->trigger();
    EXPECT_FALSE(panel().isSweeping());
    app::waitUntilIdle(*window);
    EXPECT_FALSE(panel().isRunning());
    EXPECT_LT(panel().points().at("dch-quant").size(), 4u);
    trigger("compare.sweep");
    EXPECT_EQ(panel().points().at("dch-quant").size(), 4u);
    run(R"({"do":"whatIf","set":"outlines","to":0.25})");
    EXPECT_EQ(panel().sweptKey(), "outlines") << "what was changed last";
    run(R"({"do":"whatIf","sweep":"cameras"})");
    const auto& byCameras = panel().points().at("dch-quant");
    EXPECT_EQ(byCameras.size(), 7u) << "two to eight";
    EXPECT_EQ(play(R"({"do":"whatIf","sweep":"lambda"})"), 1);
}

TEST_F(CompareTest, TheWrittenMethodIsTakenOrRefusedInOneSentence) {
    fit("\"dch-quant\"");
    window->workspaces().raisePanel(&panel());
    const auto write = [&](const char* text) {
        panel().line()->selectAll();
        QTest::keyClicks(panel().line(), QString::fromLatin1(text));
        QTest::keyClick(panel().line(), Qt::Key_Return);
        app::waitUntilIdle(*window);
    };
    write("dch-quant:bins=2.5");
    EXPECT_EQ(panel().problem(), QStringLiteral("bins must be a whole number from 1 to 256, not \"2.5\"."));
    EXPECT_EQ(columns().title(0), QStringLiteral("dch-quant"));
    write("dch-quant:bins=4");
    EXPECT_EQ(panel().form()->value("bins"), 4);
    EXPECT_EQ(columns().title(0), QStringLiteral("dch-quant:bins=4?"));
}

TEST_F(CompareTest, AWipeShowsTheNextColumnBehindItsLine) {
    fit("\"ch\",\"dch-dt3\"");
    page().setIteration(1);
    app::waitUntilIdle(*window);
    columns().setCurrent(0);
    page().grid()->finishDrawing();
    const QImage left = screen(0), right = screen(1);
    ASSERT_NE(left, right);
    trigger("compare.wipe");
    const QImage wiped = screen(0);
    const int middle = wiped.width() / 2, width = std::min(right.width(), wiped.width());
    constexpr int kNameBox = 24; // at the top of what lies over the view: whose it is
    EXPECT_EQ(wiped.pixelColor(middle + 12, kNameBox / 2 - 3), columns().colour(1));
    const auto differing = [&](const QImage& other, int from, int to) {
        int count = 0;
        for (int y = kNameBox; y < wiped.height(); ++y)
            for (int x = from; x < to; ++x)
                count += std::abs(qGreen(wiped.pixel(x, y)) - qGreen(other.pixel(x, y))) > 3 ? 1 : 0;
        return count;
    };
    EXPECT_EQ(differing(left, 0, middle - 4), 0);
    EXPECT_EQ(differing(right, middle + 4, width), 0);
    EXPECT_GT(differing(left, middle + 4, width), 100);
    trigger("compare.wipeLeft");
    EXPECT_NE(screen(0), wiped);
    trigger("compare.blink");
    EXPECT_FALSE(window->actions().action(QStringLiteral("compare.wipe"))->isChecked());
    const auto shows = [&](const QImage& one) {
        return app::waitFor(*window, [&] {
            const QRect below(0, kNameBox, width, wiped.height() - kNameBox);
            return screen(0).copy(below) == one.copy(below);
        });
    };
    EXPECT_TRUE(shows(right)) << "by turns";
    EXPECT_TRUE(shows(left));
    EXPECT_TRUE(shows(right));
    trigger("compare.blink");
    EXPECT_EQ(screen(0), left);
}

TEST_F(CompareTest, AWorkspaceFileKeepsColumnsCamerasAndWhatIsOff) {
    fit("\"ch\"");
    run(R"({"do":"columns","show":["truth","ch","dch-thres:tau=45"],"cameras":["cam4","cam0"]})");
    columns().setShown(1, 4, false);
    const std::string file = run("{\"do\":\"workspace\",\"path\":\"w.json\"}\n")[0]["path"];
    columns().setShown(1, 4, true);
    show("\"ch\"");
    page().views()->chooseCameras({});
    app::restoreWorkspace(*window, app::readWorkspace(file));
    EXPECT_EQ(ids(), (Ids{"truth", "ch", "dch-thres:tau=45"}));
    EXPECT_EQ(page().views()->chosenCameras(), (Ids{"cam4", "cam0"}));
    EXPECT_FALSE(columns().isShown(1, 4));
    EXPECT_TRUE(columns().isShown(1, 0));
    std::ofstream(folder / "old.json")
        << R"({"format":"handlens-workspace","version":1,"sequence":"a","start":4,"test":7,"methods":["ch","best"],"rows":1})";
    app::restoreWorkspace(*window, app::readWorkspace(folder / "old.json"));
    EXPECT_EQ(ids(), (Ids{"ch", "best"}));
    EXPECT_EQ(page().grid()->count(), 2);
}

} // namespace
