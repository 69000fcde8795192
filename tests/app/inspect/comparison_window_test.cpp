// SPDX-License-Identifier: MIT
// What leaves the window of a comparison: layers of the results, figures, films and pages; and results of a benchmark
// that are opened by scripts.
#include <cmath>

#include <nlohmann/json.hpp>
#include <opencv2/videoio.hpp>

#include <QAction>
#include <QCheckBox>
#include <QHeaderView>
#include <QTableView>

#include "app/desktop/script/workspace_file.h"
#include "core/io/benchmark/benchmark_folder.h"
#include "core/io/files/text_file.h"
#include "tests/app/window_fixture.h"
#include "widgets/presenters/inspect/inspect_scene_lines.h"
#include "widgets/presenters/inspect/inspect_uncertainty.h"

namespace {

using nlohmann::json;

class ComparisonWindow : public test::WindowTest {
protected:
    void fit(const std::string& methods) { run(R"({"do":"fit","start":4,"test":7,"methods":[)" + methods + "]}\n"); }
    std::filesystem::path out(const char* name) const { return folder / "out" / name; }
    const widgets::InspectPage& page() { return *window->workspaces().inspectPage(); }

    /// A finished benchmark of four pairs of "a" and one of "b" with made-up errors: A is worse in two of them.
    void writeResults() {
        core::BenchmarkFolder made;
        made.info.dataset = dataset().string();
        made.info.fingerprint = "0123456789abcdef";
        made.info.methods = {"ch", "dch-thres"};
        made.info.pairs = {{"a", 4, 7}, {"a", 10, 12}, {"a", 6, 16}, {"b", 2, 3}};
        made.info.joints = {{core::Side::Left, "index_mcp"}};
        made.results = {made.info.joints, made.info.pairs, made.info.methods, {}, {}, false, false};
        const double errorsMm[4][2] = {{2, 5}, {3, 1}, {4, 4}, {1, 9}};
        for (std::size_t pair = 0; pair < 4; ++pair)
            for (std::size_t method = 0; method < 2; ++method)
                made.results.rows.push_back({made.info.pairs[pair],
                                             made.info.methods[method],
                                             12,
                                             errorsMm[pair][method],
                                             7,
                                             0,
                                             0.25,
                                             {errorsMm[pair][method]}});
        core::writeBenchmarkFolder(folder / "results", made);
    }
};

TEST_F(ComparisonWindow, TheUncertaintyOfAResultIsDrawnAtItsEndAlone) {
    fit("\"ch\"");
    run("{\"do\":\"action\",\"id\":\"compare.lastIteration\"}\n");
    const QImage before = page().grid()->view(0)->grabPicture();
    run("{\"do\":\"layer\",\"id\":\"uncertainty\",\"on\":true}\n");
    EXPECT_NE(page().grid()->view(0)->grabPicture(), before);
    const auto& outcome = *page().columns()->outcome();
    const auto joints = widgets::jointUncertainties(*session().opened.dataset(), outcome.methods[0]);
    ASSERT_FALSE(joints.empty());
    const auto& lines = page().grid()->view(0)->shapes().lines;
    EXPECT_GE(lines.size(), joints.size()) << "an ellipse around every joint";
    run("{\"do\":\"iteration\",\"to\":0}\n");
    EXPECT_TRUE(page().grid()->view(0)->shapes().lines.empty()) << "the start has no uncertainty";
}

TEST_F(ComparisonWindow, TheSceneShowsDisplacementsRaysAndEllipsoids) {
    fit("\"ch\",\"dch-thres\"");
    run("{\"do\":\"iteration\",\"to\":1}\n");
    const widgets::InspectOverlays::Scene& scene = page().overlays()->scene();
    using Layer = widgets::InspectLayer;
    const auto displaced = widgets::inspectSceneLines(scene, 1, {Layer::Error});
    ASSERT_EQ(displaced.size(), scene.outcome->reference.size());
    double sum = 0;
    for (const widgets::SceneBone& line : displaced)
        sum += (line.to - line.from).norm();
    EXPECT_NEAR(sum / static_cast<double>(displaced.size()), scene.outcome->methods[1].iterationErrorMm[0], 1e-6)
        << "their mean length is the error of that iteration";
    const auto rays = widgets::inspectSceneLines(scene, 0, {Layer::Matches});
    ASSERT_GT(rays.size(), 20u);
    for (std::size_t i = 1; i < rays.size(); i += 2) { // from a vertex to the nearest place on the ray before it
        const Eigen::Vector3d along = (rays[i - 1].to - rays[i - 1].from).normalized();
        EXPECT_NEAR((rays[i].to - rays[i].from).dot(along), 0, 1e-6);
        EXPECT_NEAR((rays[i].to - (rays[i - 1].to + rays[i - 1].from) / 2).norm(), 0, 1e-6);
    }
    EXPECT_TRUE(widgets::inspectSceneLines(scene, 0, {Layer::Uncertainty}).empty());
    EXPECT_TRUE(widgets::inspectSceneLines(scene, 7, {Layer::Error}).empty());
}

TEST_F(ComparisonWindow, LayersAreCalledAsInTheTableOfActions) {
    fit("\"ch\"");
    window->workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    const auto boxes = page().layerBar()->findChildren<QCheckBox*>();
    ASSERT_EQ(boxes.size(), static_cast<int>(widgets::kInspectLayers.size()));
    for (const char* name : {"Contour", "Matches", "Difference", "Uncertainty"}) {
        const auto box = std::find_if(boxes.begin(), boxes.end(),
                                      [&](const QCheckBox* one) { return one->text() == QLatin1String(name); });
        ASSERT_NE(box, boxes.end()) << name;
        EXPECT_EQ((*box)->toolTip(),
                  window->actions().action(QStringLiteral("compare.layer") + QLatin1String(name))->toolTip());
    }
}

TEST_F(ComparisonWindow, AJointOfTheDrawingIsMarkedInEveryColumn) {
    fit("\"ch\",\"dch-thres\"");
    run("{\"do\":\"iteration\",\"to\":0}\n");
    widgets::JointErrorDiagram* diagram = page().jointErrors()->diagram();
    const core::JointId joint{core::Side::Right, "index_mcp"};
    const auto place = diagram->placeOf(joint);
    ASSERT_TRUE(place);
    QTest::mouseClick(diagram, Qt::LeftButton, {}, place->toPoint());
    EXPECT_EQ(session().selection.joint(), joint);
    for (int view = 0; view < page().grid()->count(); ++view) {
        const auto& marks = page().grid()->view(view)->marks();
        ASSERT_EQ(marks.size(), 1u) << view;
        EXPECT_EQ(marks[0].joint, joint);
        const core::Camera& camera = page().grid()->view(view)->camera();
        const auto names = session().opened.dataset()->hands[1].skeleton;
        const auto at = core::project(camera, truth(core::Side::Right, names.boneIndex("index_mcp"), 4));
        ASSERT_TRUE(at);
        EXPECT_NEAR(marks[0].px.x(), at->x(), 1e-6) << "at iteration 0, the start pose";
        EXPECT_NEAR(marks[0].px.y(), at->y(), 1e-6);
        const auto to = core::project(camera, truth(core::Side::Right, names.boneIndex("index_mcp"), 7));
        ASSERT_TRUE(marks[0].reprojectionPx && to);
        EXPECT_NEAR(marks[0].reprojectionPx->x(), to->x(), 1e-6) << "the line goes to the truth";
    }
    QTest::mouseClick(diagram, Qt::LeftButton, {}, place->toPoint());
    EXPECT_TRUE(page().grid()->view(0)->marks().empty()) << "a second click takes the marks away";
}

TEST_F(ComparisonWindow, IsSavedAsAPictureADrawingAndAPage) {
    fit("\"ch\",\"dch-thres\"");
    run("{\"do\":\"layer\",\"id\":\"matches\",\"on\":true}\n{\"do\":\"iteration\",\"to\":1}\n"
        "{\"do\":\"picture\",\"path\":\"c.png\"}\n{\"do\":\"picture\",\"path\":\"c.svg\"}\n"
        "{\"do\":\"picture\",\"path\":\"c.pdf\"}\n");
    const QImage picture(QString::fromStdString(out("c.png").string()));
    ASSERT_FALSE(picture.isNull());
    EXPECT_EQ(picture.pixelColor(2, 2), QColor(Qt::white)) << "paper";
    int coloured = 0;
    for (int y = 0; y < picture.height(); y += 3)
        for (int x = 0; x < picture.width(); x += 3)
            coloured += picture.pixelColor(x, y).saturation() > 100 ? 1 : 0;
    EXPECT_GT(coloured, 500) << "hands, curves";
    const std::string svg = core::readTextFile(out("c.svg"));
    EXPECT_NE(svg.find("overflow=\"hidden\""), std::string::npos) << "parts do not spill over";
    EXPECT_GT(std::count(svg.begin(), svg.end(), '<'), 300) << "matches are lines, not pixels";
    EXPECT_EQ(core::readTextFile(out("c.pdf")).substr(0, 5), "%PDF-");
    EXPECT_EQ(play("{\"do\":\"picture\",\"path\":\"nowhere/c.pdf\"}\n"), 1);
}

TEST_F(ComparisonWindow, TheFilmGoesFromTheStartToTheResult) {
    fit("\"ch\"");
    run("{\"do\":\"iteration\",\"to\":2}\n{\"do\":\"film\",\"path\":\"f.avi\"}\n");
    EXPECT_EQ(page().iteration(), 2) << "what was shown before comes back";
    cv::VideoCapture film(out("f.avi").string());
    ASSERT_TRUE(film.isOpened());
    std::vector<cv::Mat> pictures;
    for (cv::Mat picture; film.read(picture);)
        pictures.push_back(picture.clone());
    EXPECT_EQ(static_cast<int>(pictures.size()), page().lastIteration() + 8) << "the last one stays for a second";
    ASSERT_GT(pictures.size(), 9u);
    EXPECT_GT(cv::norm(pictures.front(), pictures.back(), cv::NORM_L1), 10000) << "the hands move";
    EXPECT_FALSE(std::filesystem::exists(out("f.part.avi")));
    EXPECT_EQ(play("{\"do\":\"film\",\"path\":\"f.gif\"}\n"), 1);
}

TEST_F(ComparisonWindow, ThePageHoldsPicturesTablesSettingsAndTheCommand) {
    fit("\"ch\",\"dch-thres:tau=45\"");
    run("{\"do\":\"report\",\"path\":\"page.html\"}\n");
    const std::string html = core::readTextFile(out("page.html"));
    std::size_t pictures = 0;
    for (std::size_t at = html.find("data:image/png"); at != std::string::npos;
         at = html.find("data:image/png", at + 1))
        ++pictures;
    EXPECT_EQ(static_cast<int>(pictures), page().grid()->count());
    EXPECT_NE(html.find("data:image/svg+xml"), std::string::npos);
    EXPECT_EQ(html.find("http://"), html.find("http://www.w3.org")) << "it needs no network";
    EXPECT_NE(html.find("--workspace page.json --offscreen --out"), std::string::npos);
    EXPECT_NE(html.find(dataset().string()), std::string::npos);
    EXPECT_NE(html.find("left index"), std::string::npos) << "joints by names that people read";
    EXPECT_NE(html.find("<td class=\"text\">tau</td><td class=\"text\">45</td>"), std::string::npos);
    EXPECT_EQ(app::readWorkspace(out("page.json")).methods, (std::vector<std::string>{"ch", "dch-thres:tau=45"}));
    run("{\"do\":\"report\",\"path\":\"page.html\"}\n");
    EXPECT_EQ(core::readTextFile(out("page.html")), html) << "the same for the same comparison";
}

TEST_F(ComparisonWindow, ScriptsOpenResultsFilterThemAndInspectAPair) {
    writeResults();
    EXPECT_EQ(play("{\"do\":\"pairs\",\"filter\":\"A-B>1\"}\n"), 1) << "there are no results yet";
    const auto lines = run("{\"do\":\"results\",\"open\":\"../results\"}\n"
                           "{\"do\":\"pairs\",\"a\":\"dch-thres\",\"b\":\"ch\",\"filter\":\"A-B>1\"}\n"
                           "{\"do\":\"print\",\"what\":\"pairs\"}\n"
                           "{\"do\":\"pairs\",\"filter\":\"\",\"sort\":\"ch\",\"ascending\":true}\n"
                           "{\"do\":\"print\",\"what\":\"pairs\",\"most\":1}\n");
    EXPECT_EQ(lines[0]["pairs"], 4);
    EXPECT_EQ(lines[0]["methods"], (json{"ch", "dch-thres"}));
    EXPECT_EQ(lines[1]["shown"], 2);
    EXPECT_EQ(lines[1]["of"], 4);
    ASSERT_EQ(lines[2]["pairs"].size(), 2u);
    EXPECT_EQ(lines[2]["pairs"][0]["sequence"], "b") << "A loses most there: 9 against 1";
    EXPECT_EQ(lines[2]["pairs"][1]["errorMm"]["dch-thres"], 5);
    EXPECT_EQ(lines[4]["pairs"][0]["errorMm"]["ch"], 1);
    EXPECT_EQ(play("{\"do\":\"pairs\",\"filter\":\"best>1\"}\n"), 1);
    EXPECT_NE(errors.str().find("best"), std::string::npos);
    run("{\"do\":\"pairs\",\"filter\":\"sequence=a\",\"sort\":\"A-B\",\"inspect\":0}\n");
    EXPECT_EQ(window->workspaces().current(), widgets::Workspaces::Kind::Inspect);
    ASSERT_TRUE(session().fits.outcome());
    EXPECT_EQ(session().fits.outcome()->request.start, 4);
    EXPECT_EQ(session().fits.outcome()->request.test, 7);
}

TEST_F(ComparisonWindow, TablesOfABenchmarkShowTheirRowsInASmallWindow) {
    writeResults();
    run("{\"do\":\"results\",\"open\":\"" + (folder / "results").string() + "\"}\n");
    window->workspaces().setCurrent(widgets::Workspaces::Kind::Benchmark);
    ASSERT_TRUE(app::waitUntilIdle(*window));
    QCoreApplication::processEvents();
    ASSERT_LE(window->height(), 768);
    const auto* summary = window->findChild<QTableView*>(QStringLiteral("benchmarkSummary"));
    const auto* pairs = window->findChild<QTableView*>(QStringLiteral("benchmarkPairs"));
    const QRect last = summary->visualRect(summary->model()->index(summary->model()->rowCount() - 1, 0));
    EXPECT_TRUE(summary->viewport()->rect().contains(last.adjusted(0, 0, -1, 0)));
    EXPECT_GE(pairs->viewport()->height(), 6 * pairs->verticalHeader()->defaultSectionSize());
}

} // namespace
