// SPDX-License-Identifier: MIT
// What is tried under "What if" stands with its circumstances wherever its numbers stand.
#include <cmath>
#include <filesystem>

#include <opencv2/core.hpp>

#include "app/desktop/script/workspace_file.h"
#include "app/desktop/script/workspace_player.h"
#include "core/fitting/method_name.h"
#include "core/io/files/text_file.h"
#include "core/simulation/simulated_world.h"
#include "tests/app/inspect/inspect_fixture.h"
#include "widgets/panels/compare/what_if_panel.h"

namespace {

using nlohmann::json;

constexpr double kNoisePx = 2;
constexpr int kDraw = 3, kLeftOut = 2;
const char* const kCircumstances = "outlines with 2 px of noise (draw 3), without cam2";

class TrialTest : public test::InspectTest {
protected:
    widgets::WhatIfPanel& panel() { return *window->workspaces().whatIfPanel(); }
    const widgets::FitOutcome& fitted() { return *session().fits.outcome(); }
    const widgets::MethodOutcome& shown(std::size_t column) { return columns().outcome()->methods[column]; }
    std::string said() { return page().trialText().toStdString(); }

    void tryNoiseWithoutACamera() {
        run(R"({"do":"whatIf","set":"draw","to":3})"
            "\n"
            R"({"do":"whatIf","set":"outlines","to":2})"
            "\n"
            R"({"do":"whatIf","camera":"cam2","on":false})"
            "\n");
    }
    /// The silhouettes of that trial, made here.
    std::vector<cv::Mat> noisyMasks() {
        std::vector<cv::Mat> masks;
        for (std::size_t camera = 0; camera < fitted().masks.size(); ++camera)
            masks.push_back(
                core::ContourNoise(fitted().masks[camera], widgets::kMostOutlineNoisePx, core::drawSeed(camera, "a/3"))
                    .applied(kNoisePx));
        return masks;
    }
    /// The error of a method on them.
    double noisyErrorMm(const std::string& method) {
        std::vector<cv::Mat> masks = noisyMasks();
        masks[kLeftOut] = cv::Mat();
        const core::PoseEstimator estimator(test::tinyHands(), session().opened.dataset()->cameras);
        return widgets::errorAgainst(fitted(), *session().opened.dataset(),
                                     estimator.fit(masks, fitted().startPoses, core::parseMethod(method)).poses);
    }
    bool hasText(const std::string& file, const std::string& text) {
        return core::readTextFile(file).find(text) != std::string::npos;
    }
};

TEST_F(TrialTest, PageFigureAndFileNameItsCircumstancesAndTheFileMakesItAgain) {
    fit("\"ch\",\"dch-thres\"");
    EXPECT_EQ(said(), "");
    run(R"({"do":"whatIf","method":"ch","set":"gate","to":30})");
    tryNoiseWithoutACamera();
    const std::vector<std::string> tried{"ch:gate=30", "dch-thres"};
    std::vector<double> errorsMm;
    for (std::size_t column = 0; column < tried.size(); ++column) {
        EXPECT_TRUE(columns().isPreview(column));
        EXPECT_EQ(core::methodName(core::parseMethod(shown(column).method)).substr(0, tried[column].size()),
                  tried[column]);
        errorsMm.push_back(shown(column).errorMm);
        EXPECT_DOUBLE_EQ(errorsMm.back(), noisyErrorMm(shown(column).method));
        EXPECT_NE(errorsMm.back(), fitted().methods[column].errorMm);
    }
    EXPECT_NE(said().find(kCircumstances), std::string::npos) << said();
    EXPECT_NE(said().find(", ch:gate=30, dch-thres:gate=30"), std::string::npos) << said();
    EXPECT_NE(page().errorPlot()->settings().xLabel.toStdString().find(kCircumstances), std::string::npos)
        << "a plot leaves the window alone, too";
    const json saved = run(R"({"do":"report","path":"page.html"})"
                           "\n"
                           R"({"do":"picture","path":"figure.svg"})"
                           "\n");
    const std::string out = std::filesystem::path(saved[0]["path"].get<std::string>()).parent_path().string();
    EXPECT_TRUE(hasText(out + "/page.html", kCircumstances));
    EXPECT_TRUE(hasText(out + "/page.html", "&quot;outlineNoisePx&quot;: 2"));
    EXPECT_TRUE(hasText(out + "/figure.svg", "without cam2"));
    trigger("compare.resetSettings");
    EXPECT_EQ(said(), "");
    EXPECT_EQ(page().errorPlot()->settings().xLabel, QStringLiteral("Iteration"));
    EXPECT_EQ(shown(0).errorMm, fitted().methods[0].errorMm);
    run(R"({"do":"workspace","path":"plain.json"})");
    app::restoreWorkspace(*window, app::readWorkspace(out + "/page.json"));
    for (std::size_t column = 0; column < tried.size(); ++column)
        EXPECT_DOUBLE_EQ(shown(column).errorMm, errorsMm[column]);
    EXPECT_NE(said().find(kCircumstances), std::string::npos) << said();
    app::restoreWorkspace(*window, app::readWorkspace(out + "/plain.json"));
    EXPECT_EQ(said(), "") << "a file without a trial ends it";
    app::Workspace wrong = app::readWorkspace(out + "/page.json");
    wrong.trial->without = {"cam99"};
    EXPECT_ANY_THROW(app::restoreWorkspace(*window, wrong));
}

TEST_F(TrialTest, ColumnsAndPanelAgreeWhenColumnsChange) {
    fit("\"ch\",\"dch-thres\"");
    tryNoiseWithoutACamera();
    const double errorMm = shown(0).errorMm;
    run(R"({"do":"columns","show":["dch-quant","ch","truth"]})");
    EXPECT_EQ(shown(1).errorMm, errorMm) << "it stays";
    EXPECT_TRUE(columns().isPreview(0)) << "a new column is tried in the same way";
    EXPECT_DOUBLE_EQ(shown(0).errorMm, noisyErrorMm("dch-quant"));
    panel().showColumn(0);
    app::waitUntilIdle(*window);
    EXPECT_EQ(panel().currentCase().outlineNoisePx, kNoisePx) << "another column of the panel keeps the case";
    EXPECT_TRUE(columns().isPreview(1));
    run(R"({"do":"whatIf","set":"outlines","to":0})"
        "\n"
        R"({"do":"whatIf","camera":"cam2","on":true})"
        "\n");
    EXPECT_FALSE(columns().isPreview(0)) << "as it was fitted";
    EXPECT_EQ(said(), "");
}

TEST_F(TrialTest, StartTruthAndTheWhiteLineAreOfTheSameSilhouettes) {
    fit("\"ch\"");
    run(R"({"do":"columns","show":["ch","truth"],"cameras":["cam0","cam2"]})");
    setLayer("difference", true);
    EXPECT_DOUBLE_EQ(page().overlays()->iou(1), 1);
    page().grid()->finishDrawing();
    tryNoiseWithoutACamera();
    const cv::Mat seen = noisyMasks()[0], truth = fitted().masks[0];
    EXPECT_DOUBLE_EQ(page().overlays()->iou(1),
                     double(cv::countNonZero(seen & truth)) / cv::countNonZero(seen | truth));
    EXPECT_TRUE(std::isnan(page().overlays()->iou(3))) << "nothing was met there";
    EXPECT_EQ(view(1).title().detail, QStringLiteral("cam0"));
    EXPECT_EQ(view(3).title().detail, QStringLiteral("cam2, left out"));
    EXPECT_EQ(page().layerBar()->legend().texts().front(), QStringLiteral("observed silhouette, with noise"));
    const auto& outlines = *columns().trial().outlinesPx;
    const auto drawn = widgets::outlinesOf(seen);
    EXPECT_EQ(outlines[0], drawn);
    // Where the noise has moved the outline, the white line runs through it, and not where the recorded pose's is.
    setLayer("difference", false);
    run(R"({"do":"action","id":"view.meshOff"})");
    constexpr double kZoom = 4; // screen px per image px
    constexpr int kMovedPx = 2;
    view(1).lookAt(fitted().handsPx[0].center(), kZoom);
    page().grid()->finishDrawing();
    const auto isMoved = [&](const QPointF& px) {
        const cv::Rect around(int(px.x()) - kMovedPx, int(px.y()) - kMovedPx, 2 * kMovedPx + 1, 2 * kMovedPx + 1);
        const int inside = cv::countNonZero(truth(around & cv::Rect({}, truth.size())));
        return inside == 0 || inside == around.area();
    };
    const auto whiteShare = [&](const QImage& picture) {
        int white = 0, all = 0;
        for (const QLineF& line : drawn) {
            const QPoint at = view(1).imageToViewport(line.p1()).toPoint();
            if (!picture.rect().adjusted(2, 2, -2, -2).contains(at) || !isMoved(line.p1()))
                continue;
            int brightest = 0;
            for (int y = at.y() - 1; y <= at.y() + 1; ++y)
                for (int x = at.x() - 1; x <= at.x() + 1; ++x)
                    brightest = std::max(brightest, qGray(picture.pixel(x, y)));
            ++all;
            white += brightest > 200 ? 1 : 0;
        }
        EXPECT_GT(all, 10);
        return double(white) / std::max(1, all);
    };
    EXPECT_GT(whiteShare(view(1).grabPicture()), 0.9);
    trigger("compare.resetSettings");
    EXPECT_EQ(page().layerBar()->legend().texts().front(), QStringLiteral("observed silhouette"));
    view(1).lookAt(fitted().handsPx[0].center(), kZoom);
    page().grid()->finishDrawing();
    EXPECT_LT(whiteShare(view(1).grabPicture()), 0.3);
}

TEST_F(TrialTest, CurvesAreNamedByTheirSettingsAndSayWhatIsHeld) {
    fit("\"ch\",\"dch-quant\"");
    run(R"({"do":"whatIf","method":"ch","set":"gate","to":30})");
    EXPECT_TRUE(panel().points().count("ch")) << "the gate itself is the axis";
    const json points = run(R"({"do":"whatIf","camera":"cam2","on":false})")[0]["points"];
    EXPECT_TRUE(points.contains("ch:gate=30"));
    EXPECT_TRUE(points.contains("dch-quant:gate=30")) << "it goes on as it was tried";
    EXPECT_FALSE(points.contains("ch"));
    EXPECT_EQ(shown(1).method, "dch-quant:gate=30");
    EXPECT_NE(panel().heldText().toStdString().find("7: cam0, cam1, cam3"), std::string::npos)
        << panel().heldText().toStdString();
    run(R"({"do":"whatIf","set":"outlines","to":1})");
    EXPECT_NE(panel().heldText().toStdString().find("without cam2"), std::string::npos);
    EXPECT_EQ(panel().points().at("ch:gate=30").size(), 1u) << "no point of all cameras among those of seven";
}

TEST_F(TrialTest, AnotherSetOfAsManyCamerasIsNotMixedIn) {
    fit("\"ch\"");
    run(R"({"do":"whatIf","camera":"cam2","on":false})");
    const double without2 = panel().points().at("ch").at(7);
    run(R"({"do":"whatIf","camera":"cam2","on":true})"
        "\n"
        R"({"do":"whatIf","camera":"cam3","on":false})"
        "\n");
    EXPECT_NE(panel().points().at("ch").at(7), without2);
    EXPECT_NE(panel().heldText().toStdString().find("7: cam0, cam1, cam2, cam4"), std::string::npos)
        << panel().heldText().toStdString();
    EXPECT_EQ(panel().heldText().count(QStringLiteral("7:")), 1);
}

} // namespace
