// SPDX-License-Identifier: MIT
// What is drawn again, and how soon, while settings are tried and layers switched.
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "tests/app/inspect/inspect_fixture.h"
#include "widgets/panels/compare/what_if_panel.h"
#include "widgets/panels/fitting_panel.h"

namespace {

using nlohmann::json;

class WhatIfTest : public test::InspectTest {
protected:
    std::vector<QImage> pictures() {
        std::vector<QImage> taken;
        for (const widgets::CameraView* one : page().grid()->views())
            taken.push_back(one->grabPicture());
        return taken;
    }
};

/// Counts how often it is told to paint.
class PaintCount : public QObject {
public:
    explicit PaintCount(QWidget* watched) { watched->installEventFilter(this); }
    int count = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }
};

TEST_F(WhatIfTest, ATriedSettingIsDrawnAsIfTheViewsWereMadeAnew) {
    fit("\"dch-thres\",\"ch\"");
    for (const char* layer : {"matches", "difference"})
        setLayer(layer, true);
    const std::vector<QImage> before = pictures();
    run(R"({"do":"whatIf","method":"dch-thres","set":"tau","to":5})");
    ASSERT_TRUE(columns().isPreview(0));
    page().grid()->finishDrawing();
    const std::vector<QImage> tried = pictures();
    EXPECT_NE(tried[0], before[0]);
    EXPECT_EQ(tried[1], before[1]) << "the other column";
    EXPECT_EQ(view(0).title().name, QStringLiteral("dch-thres:tau=5?"));
    page().views()->layOut(); // every view anew
    app::waitUntilIdle(*window);
    page().grid()->finishDrawing();
    EXPECT_EQ(pictures(), tried);
    trigger("compare.resetSettings");
    EXPECT_EQ(pictures(), before);
    EXPECT_EQ(view(0).title().name, QStringLiteral("dch-thres"));
}

TEST_F(WhatIfTest, OnlyTheTriedColumnIsPaintedAgain) {
    fit("\"dch-thres\",\"ch\"");
    setLayer("matches", true);
    run(R"({"do":"whatIf","method":"dch-thres","set":"tau","to":20})"); // the panel is there
    QSignalSpy changed(&columns(), &widgets::InspectColumns::changed);
    QSignalSpy previewed(&columns(), &widgets::InspectColumns::previewed);
    PaintCount mine(view(0).viewport()), other(view(1).viewport());
    run(R"({"do":"whatIf","set":"tau","to":5})");
    EXPECT_EQ(changed.count(), 0);
    EXPECT_EQ(previewed.count(), 1);
    EXPECT_GE(mine.count, 1);
    EXPECT_EQ(other.count, 0);
}

TEST_F(WhatIfTest, IsPreparedBeforeThePanelIsOpened) {
    fit("\"ch\"");
    const widgets::WhatIfPanel& panel = *window->workspaces().whatIfPanel();
    ASSERT_FALSE(panel.isVisible());
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.isPrepared(); }, 10000));
    ASSERT_FALSE(panel.isVisible());
    run(R"({"do":"fit","start":5,"test":8,"methods":["ch"]})");
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.isPrepared(); }, 10000)) << "for the next pair";
}

TEST_F(WhatIfTest, AStepSaysWhenTheRealTimeVariantIsSeen) {
    fit("\"best\",\"ch\"");
    const json live = run(R"({"do":"whatIf","method":"best","set":"outlines","to":0.5})")[0];
    EXPECT_GT(live["liveMs"].get<double>(), 0);
    EXPECT_LE(live["liveMs"].get<double>(), live["ms"].get<double>());
    const json without = run(R"({"do":"whatIf","method":"ch","set":"gate","to":40})")[0];
    EXPECT_FALSE(without.contains("liveMs")) << "the parameter is none of the real-time variant's";
}

TEST_F(WhatIfTest, LayersThatStayAreNotMadeAgain) {
    fit("\"ch\"");
    setLayer("field", true);
    setLayer("matches", true);
    const qint64 field = page().overlays()->picture(0).cacheKey();
    const auto lines = [&] { return view(0).shapes().lines.data(); };
    setLayer("rim", true);
    EXPECT_EQ(page().overlays()->picture(0).cacheKey(), field);
    page().setIteration(0);
    app::waitUntilIdle(*window);
    EXPECT_EQ(page().overlays()->picture(0).cacheKey(), field) << "a field is the same at every pose";
    const void* const matches = lines();
    setLayer("error", true);
    EXPECT_EQ(lines(), matches) << "the colour of the meshes alone";
    const std::size_t withArrows = view(0).shapes().lines.size();
    setLayer("field", false);
    EXPECT_TRUE(page().overlays()->picture(0).isNull());
    EXPECT_LT(view(0).shapes().lines.size(), withArrows) << "its arrows go, too";
    const void* const alone = lines();
    setLayer("difference", true);
    EXPECT_EQ(lines(), alone);
    const qint64 difference = page().overlays()->picture(0).cacheKey();
    page().setIteration(page().lastIteration());
    app::waitUntilIdle(*window);
    EXPECT_NE(page().overlays()->picture(0).cacheKey(), difference) << "of another pose";
    EXPECT_NE(lines(), alone);
}

TEST_F(WhatIfTest, WhatWasSwitchedOffInAViewComesBackWithItsLayers) {
    fit("\"ch\",\"dch-thres\"");
    setLayer("matches", true);
    setLayer("difference", true);
    page().columns()->setCurrent(0);
    page().grid()->finishDrawing();
    const QImage before = view(0).grabPicture();
    trigger("compare.hideHere");
    EXPECT_TRUE(view(0).shapes().lines.empty());
    EXPECT_NE(view(0).grabPicture(), before);
    trigger("compare.hideHere");
    EXPECT_FALSE(view(0).shapes().lines.empty());
    EXPECT_EQ(view(0).grabPicture(), before);
}

TEST_F(WhatIfTest, CurvesStandOnceAndAreFoundByTheirNameEverywhere) {
    const auto plotOf = [&] { return window->workspaces().part(QStringLiteral("curves")); };
    widgets::CurvePlot* small = window->workspaces().fittingPanel()->plot();
    EXPECT_EQ(plotOf(), small);
    fit("\"ch\"");
    EXPECT_EQ(plotOf(), page().errorPlot());
    EXPECT_FALSE(small->isVisible()) << "Inspect has the same, and larger";
    EXPECT_TRUE(plotOf()->isVisible());
    run(R"({"do":"shot","of":"curves","path":"curves.png"})");
    run(R"({"do":"action","id":"workspace.annotate"})");
    EXPECT_EQ(plotOf(), small);
    EXPECT_FALSE(small->isHidden());
}

TEST_F(WhatIfTest, TheLegendNamesTheWhiteLine) {
    fit("\"ch\"");
    const auto texts = [&] { return page().layerBar()->legend().texts(); };
    EXPECT_EQ(texts(), QStringList{QStringLiteral("observed silhouette")});
    page().setLook(widgets::LayerLook(), false, false);
    EXPECT_EQ(texts(), QStringList());
    page().setLook(widgets::LayerLook(), false, true);
    EXPECT_EQ(texts().size(), 1);
}

} // namespace
