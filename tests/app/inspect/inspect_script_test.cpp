// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <QTest>

#include <nlohmann/json.hpp>

#include "app/desktop/script/workspace_file.h"
#include "app/desktop/script/workspace_player.h"
#include "core/distance/circular_distance.h"
#include "core/distance/orientation_bins.h"
#include "core/error.h"
#include "tests/app/window_fixture.h"
#include "tests/support/expect_error.h"

namespace {

using nlohmann::json;

/// The largest difference of two pictures in any channel of any pixel; 256 if their sizes differ.
int largestDifference(const QImage& a, const QImage& b) {
    if (a.isNull() || a.size() != b.size())
        return 256;
    int largest = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            largest = std::max(
                {largest, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    }
    return largest;
}

/// Scripts about a fitted pair: what is printed is checked against the silhouettes that the fit was to meet.
class InspectScript : public test::WindowTest {
protected:
    void fit(const std::string& methods) { run(R"({"do":"fit","start":4,"test":7,"methods":[)" + methods + "]}\n"); }
    json matches(const std::string& method, int iteration) {
        return run("{\"do\":\"iteration\",\"to\":" + std::to_string(iteration) +
                   "}\n{\"do\":\"print\",\"what\":\"matches\",\"camera\":\"cam0\",\"method\":\"" + method +
                   "\"}\n")[1]["matches"];
    }
    const cv::Mat& mask() { return session().fits.outcome()->masks.front(); }

    /// Distance from a point to the nearest pixel of the silhouette that has a neighbour outside it.
    double distanceToOutline(double x, double y) {
        double nearest = std::numeric_limits<double>::infinity();
        const cv::Mat& seen = mask();
        for (int v = 1; v + 1 < seen.rows; ++v)
            for (int u = 1; u + 1 < seen.cols; ++u)
                if (seen.at<unsigned char>(v, u) &&
                    (!seen.at<unsigned char>(v - 1, u) || !seen.at<unsigned char>(v + 1, u) ||
                     !seen.at<unsigned char>(v, u - 1) || !seen.at<unsigned char>(v, u + 1)))
                    nearest = std::min(nearest, std::hypot(u - x, v - y));
        return nearest;
    }
};

TEST_F(InspectScript, MatchesOfChAreTheNearestPixelsOfTheOutline) {
    fit("\"ch\"");
    for (const int iteration : {0, 3}) {
        const json found = matches("ch", iteration);
        ASSERT_GT(found.size(), 15u);
        for (std::size_t i = 0; i < found.size(); i += 3) {
            const json& match = found[i];
            EXPECT_TRUE(match["kept"].get<bool>());
            EXPECT_NEAR(match["residualPx"].get<double>(), distanceToOutline(match["p"][0], match["p"][1]), 0.75);
        }
    }
}

TEST_F(InspectScript, MatchesOfAFittedMethodArePrintedThoughItHasNoColumn) {
    fit("\"ch\",\"dch-thres\"");
    const json shown = matches("ch", 3);
    ASSERT_GT(shown.size(), 15u);
    run(R"({"do":"columns","show":["dch-thres"]})");
    EXPECT_EQ(matches("ch", 3), shown);
}

TEST_F(InspectScript, AClickPinsTheProbeAndAnotherTakesItAway) {
    fit("\"ch\",\"dch-thres\"");
    run("{\"do\":\"iteration\",\"to\":1}\n");
    widgets::InspectPage& page = *window->workspaces().inspectPage();
    widgets::CameraView* view = page.grid()->view(0);
    const QPoint place = view->viewport()->rect().center();
    const QPointF px = view->viewportToImage(place);
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, place);
    ASSERT_TRUE(page.probePin()->isPinned());
    EXPECT_TRUE(page.probePin()->card()->isVisible());
    for (const char* method : {"ch", "dch-thres", "dch-quant", "dch-dt3"})
        EXPECT_TRUE(page.probePin()->card()->text().contains(QLatin1String(method))) << method;
    ASSERT_EQ(view->residualArrows().size(), 1u);
    const QLineF arrow(view->residualArrows()[0].fromPx, view->residualArrows()[0].toPx);
    EXPECT_LT(QLineF(arrow.p1(), px).length(), 0.5);
    EXPECT_NEAR(arrow.length(), distanceToOutline(px.x(), px.y()), 0.75) << "ch goes to the nearest pixel";
    run("{\"do\":\"iteration\",\"to\":3}\n");
    EXPECT_EQ(view->residualArrows().size(), 1u) << "it stays while iterations go by";
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, place);
    EXPECT_FALSE(page.probePin()->isPinned());
    EXPECT_FALSE(page.probePin()->card()->isVisible());
    EXPECT_TRUE(view->residualArrows().empty());
    const std::string step = R"({"do":"probe","camera":"cam0","px":[200,200],"method":"dch-thres","pin":true})";
    run(step);
    EXPECT_TRUE(page.probePin()->isPinned());
    run("{\"do\":\"columns\",\"show\":[\"ch\"]}\n");
    EXPECT_FALSE(page.probePin()->card()->isVisible()) << "its column is gone";
}

TEST_F(InspectScript, DchThresKeepsWhatPassesItsAngleAndQuantWhatLiesInTheBin) {
    fit("\"dch-thres\",\"dch-quant\"");
    int refused = 0;
    for (const json& match : matches("dch-thres", 0)) {
        const double apart =
            core::signedCircularDistance(match["phiDeg"].get<double>() * std::numbers::pi / 180,
                                         match["contourPhiDeg"].get<double>() * std::numbers::pi / 180);
        EXPECT_EQ(match["kept"].get<bool>(), apart < 22.5 * std::numbers::pi / 180);
        EXPECT_EQ(match["reason"], match["kept"].get<bool>() ? "" : "orientation");
        refused += match["kept"].get<bool>() ? 0 : 1;
    }
    EXPECT_GT(refused, 0);
    const core::OrientationBins bins(8, true);
    int kept = 0;
    for (const json& match : matches("dch-quant", 0)) {
        if (!match["kept"].get<bool>())
            continue;
        ++kept;
        EXPECT_EQ(bins.binOf(match["phiDeg"].get<double>() * std::numbers::pi / 180),
                  bins.binOf(match["contourPhiDeg"].get<double>() * std::numbers::pi / 180));
    }
    EXPECT_GT(kept, 10);
}

TEST_F(InspectScript, TheProbeFindsTheNearestOutlineAndItsCost) {
    fit("\"ch\",\"dch-dt3\"");
    const json at = matches("ch", 2)[7]["p"];
    const std::string px =
        "[" + std::to_string(at[0].get<double>() + 5) + "," + std::to_string(at[1].get<double>()) + "]";
    const std::string probe = "{\"do\":\"probe\",\"camera\":\"cam0\",\"px\":" + px + ",\"method\":";
    const auto lines = run(probe + "\"ch\"}\n" + probe + "\"dch-dt3\"}\n");
    EXPECT_NEAR(lines[0]["distancePx"].get<double>(), distanceToOutline(at[0].get<double>() + 5, at[1]), 0.75);
    EXPECT_EQ(lines[0]["cost"], lines[0]["distancePx"]);
    const core::OrientationBins bins(16, true);
    const int bin = bins.binOf(lines[1]["phiDeg"].get<double>() * std::numbers::pi / 180);
    EXPECT_EQ(lines[1]["bin"], bin);
    const double turned =
        bins.distanceRad(bin, bins.binOf(lines[1]["contourPhiDeg"].get<double>() * std::numbers::pi / 180));
    EXPECT_NEAR(lines[1]["cost"].get<double>(), lines[1]["distancePx"].get<double>() + 25 * turned, 1e-3);
}

TEST_F(InspectScript, LayersAreDrawnOverTheViewsAndTakenAway) {
    fit("\"ch\",\"dch-thres\"");
    run("{\"do\":\"iteration\",\"to\":0}\n");
    widgets::CameraGrid* grid = window->workspaces().inspectPage()->grid();
    for (const char* id : {"contour", "rim", "matches", "difference", "field", "error"}) {
        const QImage before = grid->view(0)->grabPicture();
        run(std::string("{\"do\":\"layer\",\"id\":\"") + id + "\",\"on\":true}\n");
        const QImage with = grid->view(0)->grabPicture();
        EXPECT_NE(with, before) << id;
        run(std::string("{\"do\":\"layer\",\"id\":\"") + id + "\",\"on\":false}\n");
        EXPECT_EQ(grid->view(0)->grabPicture(), before) << id;
    }
    run("{\"do\":\"layer\",\"id\":\"field\",\"on\":true}\n{\"do\":\"layer\",\"id\":\"difference\",\"on\":true}\n");
    EXPECT_FALSE(window->workspaces().inspectPage()->overlays()->isShown(widgets::InspectLayer::Field));
    EXPECT_EQ(play("{\"do\":\"layer\",\"id\":\"moon\",\"on\":true}\n"), 1);
    EXPECT_NE(errors.str().find("moon"), std::string::npos);
}

TEST_F(InspectScript, TheFieldHasArrowsBelowTheOtherLayersLines) {
    fit("\"ch\"");
    const auto lines = [this] { return window->workspaces().inspectPage()->grid()->view(0)->shapes().lines.size(); };
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":true}\n");
    const std::size_t matches = lines();
    run("{\"do\":\"layer\",\"id\":\"field\",\"on\":true}\n");
    const std::size_t both = lines();
    EXPECT_GT(both, matches + 5);
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":false}\n");
    EXPECT_EQ(lines(), both - matches);
    run("{\"do\":\"layer\",\"id\":\"field\",\"on\":false}\n");
    EXPECT_EQ(lines(), 0u);
    EXPECT_EQ(play("{\"do\":\"print\",\"what\":\"matches\",\"camera\":\"cam0\",\"method\":\"best\"}\n"), 1);
}

TEST_F(InspectScript, AFigureHasTheSequenceAndTheLegendOfItsLayers) {
    fit("\"ch\"");
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":true}\n");
    const std::string with = run("{\"do\":\"picture\",\"path\":\"with.svg\"}\n")[0]["path"];
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":false}\n");
    const std::string without = run("{\"do\":\"picture\",\"path\":\"without.svg\"}\n")[0]["path"];
    const std::string legend = "matches 0\u201320+ px";
    EXPECT_NE(test::readText(with).find(legend), std::string::npos);
    EXPECT_EQ(test::readText(without).find(legend), std::string::npos);
    EXPECT_NE(test::readText(with).find("observed silhouette"), std::string::npos);
    EXPECT_NE(test::readText(with).find(session().fits.outcome()->sequence + ": Frame 7"), std::string::npos);
}

TEST_F(InspectScript, TheDifferenceSaysHowWellTheSilhouettesAgree) {
    fit("\"best\"");
    run("{\"do\":\"layer\",\"id\":\"difference\",\"on\":true}\n{\"do\":\"iteration\",\"to\":0}\n");
    const double atStart = window->workspaces().inspectPage()->overlays()->iou(0);
    run("{\"do\":\"action\",\"id\":\"compare.lastIteration\"}\n");
    const double atEnd = window->workspaces().inspectPage()->overlays()->iou(0);
    EXPECT_GT(atStart, 0.3);
    EXPECT_GT(atEnd, 0.9);
    EXPECT_GT(atEnd, atStart);
}

TEST_F(InspectScript, AWorkspaceFileBringsTheSameViewsBack) {
    fit("\"ch\",\"dch-thres\"");
    run("{\"do\":\"iteration\",\"to\":3}\n{\"do\":\"layer\",\"id\":\"matches\",\"on\":true}\n"
        "{\"do\":\"layer\",\"id\":\"difference\",\"on\":true}\n{\"do\":\"workspace\",\"path\":\"w.json\"}\n");
    const std::string file = run("{\"do\":\"workspace\",\"path\":\"w.json\"}\n")[0]["path"].get<std::string>();
    const app::Workspace saved = app::readWorkspace(file);
    EXPECT_EQ(saved.methods, (std::vector<std::string>{"ch", "dch-thres"}));
    EXPECT_EQ(saved.iteration, 3);
    EXPECT_EQ(saved.layers, (std::vector<std::string>{"matches", "difference"}));
    const QDir first(QString::fromStdString(file + ".1")), second(QString::fromStdString(file + ".2"));
    QDir().mkpath(first.path());
    QDir().mkpath(second.path());
    app::restoreWorkspace(*window, saved);
    const QStringList names = app::saveWorkspacePictures(*window, first);
    EXPECT_TRUE(names.contains(QStringLiteral("ch_cam0.png"))) << names.join(' ').toStdString();
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":false}\n{\"do\":\"iteration\",\"to\":0}\n");
    fit("\"best\"");
    app::restoreWorkspace(*window, saved);
    EXPECT_EQ(app::saveWorkspacePictures(*window, second), names);
    for (const QString& name : names)
        EXPECT_LE(largestDifference(QImage(first.filePath(name)), QImage(second.filePath(name))), 3)
            << name.toStdString() << ": Qt rounds blends by where an image lies in memory, one level per layer";
    app::Workspace lost = saved;
    lost.camera = "cam77";
    EXPECT_THROW(app::restoreWorkspace(*window, lost), core::Error);
}

TEST_F(InspectScript, MatchesAndProbesSayWhichBoneOfTheHand) {
    fit("\"ch\"");
    const json found = matches("ch", 2);
    std::set<std::string> bones;
    for (const json& match : found) {
        EXPECT_TRUE(match["hand"] == "left" || match["hand"] == "right");
        bones.insert(match["bone"].get<std::string>());
    }
    EXPECT_EQ(bones, (std::set<std::string>{"forearm", "index_mcp"})) << "the palm and the finger";
    const json& some = found[found.size() / 2];
    const json probe = run(json{{"do", "probe"}, {"camera", "cam0"}, {"px", some["p"]}, {"method", "ch"}}.dump())[0];
    for (const char* field : {"hand", "bone", "phiDeg", "contourPhiDeg"})
        EXPECT_EQ(probe[field], some[field]) << field;
    EXPECT_EQ(probe["nearest"], some["q"]);
}

TEST_F(InspectScript, TheMatchesOfOneFingerAreDrawnAlone) {
    fit("\"ch\"");
    run("{\"do\":\"iteration\",\"to\":2}\n{\"do\":\"layer\",\"id\":\"matches\",\"on\":true}\n");
    const widgets::CameraView* view = window->workspaces().inspectPage()->grid()->view(0);
    const std::size_t all = view->shapes().lines.size();
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":true,\"of\":\"index\"}\n");
    std::size_t index = 0;
    for (const json& match : matches("ch", 2))
        index += match["bone"] == "index_mcp" ? 1 : 0;
    EXPECT_EQ(view->shapes().lines.size(), index);
    EXPECT_LT(index, all);
    EXPECT_GT(index, 0u);
    window->actions().action(QStringLiteral("compare.nextMatches"))->trigger();
    app::waitUntilIdle(*window);
    EXPECT_TRUE(view->shapes().lines.empty()) << "these hands have no middle finger";
    const std::string file = run("{\"do\":\"workspace\",\"path\":\"w.json\"}\n")[0]["path"];
    EXPECT_EQ(app::readWorkspace(file).matches, "middle");
    EXPECT_EQ(play("{\"do\":\"layer\",\"id\":\"matches\",\"on\":true,\"of\":\"toe\"}\n"), 1);
}

TEST_F(InspectScript, CurvesHaveMarksWhereThePhasesOfTheCurrentColumnBegin) {
    fit("\"dch-thres\",\"dch-thres:schedule=paper\"");
    const widgets::InspectPage& page = *window->workspaces().inspectPage();
    page.columns()->setCurrent(0);
    const auto& history = session().fits.outcome()->methods[0].result.history;
    const auto& marks = page.errorPlot()->marks();
    ASSERT_GE(marks.size(), 2u);
    EXPECT_EQ(marks[0].x, 0);
    EXPECT_EQ(marks[0].name, QStringLiteral("rigid"));
    EXPECT_EQ(marks[1].name, QStringLiteral("medium mesh"));
    const auto first = static_cast<std::size_t>(marks[1].x); // that moves fingers
    ASSERT_LT(first, history.size());
    for (std::size_t i = 0; i <= first; ++i) {
        const auto& before = i == 0 ? session().fits.outcome()->startPoses : history[i - 1].poses;
        const bool fingersStay = before[0].tail(before[0].size() - 6) == history[i].poses[0].tail(before[0].size() - 6);
        EXPECT_EQ(fingersStay, i < first) << i;
    }
    EXPECT_EQ(page.costPlot()->marks(), marks);
    page.columns()->setCurrent(1);
    EXPECT_EQ(page.errorPlot()->marks().size(), 1u) << "the paper's schedule has one phase";
}

} // namespace
