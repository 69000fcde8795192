// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/benchmark/realism_report.h"
#include "core/benchmark/realism_scene.h"
#include "core/contour/rasteriser.h"
#include "tests/core/benchmark/hand_made_results.h"
#include "tests/core/benchmark/tiny_benchmark.h"

namespace core {
namespace {

RealismSetting settingNamed(const std::string& id) {
    for (const RealismSetting& setting : realismSettings())
        if (setting.id == id)
            return setting;
    ADD_FAILURE() << id;
    return {};
}

TEST(RealismSettings, HaveDifferentNamesAndBeginWithTheCleanOne) {
    std::set<std::string> names;
    for (const RealismSetting& setting : realismSettings())
        EXPECT_TRUE(names.insert(setting.id).second) << setting.id;
    EXPECT_EQ(realismSettings().front().world, Imperfection{});
    EXPECT_TRUE(settingNamed("casual-adapted").isAdapted);
    EXPECT_EQ(settingNamed("casual").world.rig, kCasualRig);
}

TEST(RealismScene, OfTheCleanSettingIsTheSyntheticSetup) {
    const BenchmarkScene clean = test::tinyScene();
    const std::vector<FramePair> pairs = test::tinyPairs(clean);
    const BenchmarkScene scene = realismScene(clean, settingNamed("clean"), pairs, 1);
    const FramePair& pair = pairs.front();
    const std::vector<cv::Mat> masks = scene.sequences[0].masks(pair.test);
    const HandPoses& poses = clean.sequences[0].motion[static_cast<std::size_t>(pair.test)];
    for (std::size_t c = 0; c < masks.size(); ++c)
        EXPECT_EQ(cv::countNonZero(masks[c] != renderHandsMask(clean.cameras[c], clean.hands, poses)), 0);
    const JointPositions truth = referenceJoints(clean, BenchmarkSetup::Synthetic, pair);
    for (const auto& [id, point] : referenceJoints(scene, BenchmarkSetup::Realistic, pair))
        EXPECT_EQ(point, truth.at(id)) << id.joint;
    BenchmarkOptions options;
    options.setup = BenchmarkSetup::Realistic;
    EXPECT_NO_THROW(requireRunnable(scene, pairs, options));
}

TEST(RealismScene, KeepsTheModelAndTheCalibrationThatTheLabHas) {
    const BenchmarkScene clean = test::tinyScene();
    const std::vector<FramePair> pairs = test::tinyPairs(clean);
    RealismSetting setting = settingNamed("casual");
    setting.isClicked = false;
    const BenchmarkScene scene = realismScene(clean, setting, pairs, 1);
    for (std::size_t c = 0; c < clean.cameras.size(); ++c)
        EXPECT_EQ(scene.cameras[c].cameraFromWorld.translation, clean.cameras[c].cameraFromWorld.translation);
    EXPECT_EQ(scene.hands[0].mesh.vertices, clean.hands[0].mesh.vertices);
    const JointPositions model = referenceJoints(clean, BenchmarkSetup::Synthetic, pairs.front());
    double sizeModel = 0, sizePerson = 0;
    for (const auto& [id, point] : referenceJoints(scene, BenchmarkSetup::Realistic, pairs.front())) {
        if (id.hand != Side::Left || id.joint == "forearm")
            continue;
        sizeModel = (model.at(id) - model.at({Side::Right, id.joint})).norm();
        const auto other = referenceJoints(scene, BenchmarkSetup::Realistic, pairs.front()).at({Side::Right, id.joint});
        sizePerson = (point - other).norm();
    }
    EXPECT_GT(sizeModel, 0);
    EXPECT_NEAR(sizePerson, sizeModel, 5) << "moved as a rigid body, hands a little larger";
}

TEST(RealismReport, ComparesEverySettingWithTheCleanOne) {
    BenchmarkResults clean = test::handMadeResults();
    clean.external.clear();
    clean.methods = {"ch", "best"};
    std::erase_if(clean.rows, [](const PairResult& row) { return row.method != "ch"; });
    BenchmarkResults worse = clean;
    for (const PairResult& row : std::vector<PairResult>(clean.rows)) {
        clean.rows.push_back(row);
        clean.rows.back().method = "best";
        clean.rows.back().errorMm /= 2;
        worse.rows.push_back(row);
        worse.rows.back().method = "best";
        worse.rows.back().errorMm *= 3;
    }
    std::vector<RealismResult> results{{settingNamed("clean"), clean, {}}, {settingNamed("contour-1.5"), worse, {}}};
    addAgreements(results, clean.methods);
    ASSERT_TRUE(results[1].agreement);
    EXPECT_FALSE(results[0].agreement);
    EXPECT_EQ(results[1].agreement->tau, -1);
    const std::string table = realismMarkdown(results, clean.methods);
    EXPECT_NE(table.find("| contour 1.5 px | 4.00 ± 2.24 | 12.00 ± 6.71 |"), std::string::npos) << table;
    const std::string csv = realismCsv(results, clean.methods);
    EXPECT_NE(csv.find("contour-1.5,contour,1.5,0,0,best,4,12.000000,"), std::string::npos) << csv;
    const std::vector<Figure> figures = realismFigures(results, clean.methods);
    ASSERT_EQ(figures.size(), 2u) << "one axis and the order";
    EXPECT_NE(figures[0].gnuplot.find("0 4.00000\n1.5 4.00000\n"), std::string::npos) << figures[0].gnuplot;
    const std::string html = realismReportHtml("d", results, clean.methods, figures, std::nullopt);
    EXPECT_NE(html.find("best &lt; ch"), std::string::npos);
}

} // namespace
} // namespace core
