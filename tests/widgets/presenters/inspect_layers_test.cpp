// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/annotation/annotation_set.h"
#include "core/contour/rasteriser.h"
#include "core/fitting/pose_estimator.h"
#include "tests/support/fitting_scene.h"
#include "tests/widgets/views/lab_colour.h"
#include "widgets/presenters/inspect/inspect_difference.h"
#include "widgets/presenters/inspect/inspect_probe.h"
#include "widgets/presenters/inspect/inspected_poses.h"

namespace {

using widgets::InspectLayer;
using widgets::InspectOverlay;
using widgets::MatchChoice;
using widgets::MethodOutcome;

/// Two hands in front of a ring of cameras, fitted to masks with and without arms.
class InspectLayersTest : public testing::Test {
protected:
    InspectLayersTest() {
        dataset.cameras = scene.cameras;
        dataset.hands = scene.hands;
    }
    MethodOutcome fit(const std::string& method) const {
        widgets::FitPair pair;
        pair.masks = scene.masks;
        pair.startPoses = scene.start;
        return widgets::runMethod(estimator, dataset, pair, method, {}, 1, {}, false);
    }
    InspectOverlay difference(const MethodOutcome& outcome, int camera) const {
        widgets::MeshLayer posed;
        for (std::size_t hand = 0; hand < dataset.hands.size(); ++hand)
            posed.surfaces.push_back(widgets::makeViewSurface(dataset.hands[hand], outcome.result.poses[hand]));
        return inspectOverlay(outcome, dataset, camera, 1000, {{InspectLayer::Difference}}, posed);
    }
    /// Of the masks as they are, and of what lies outside the regions alone.
    std::pair<double, double> countedIou(const MethodOutcome& outcome, std::size_t camera) const {
        const cv::Mat drawn = core::renderHandsMask(dataset.cameras[camera], dataset.hands, outcome.result.poses);
        std::array<int, 2> both{}, either{};
        for (int y = 0; y < drawn.rows; ++y) {
            for (int x = 0; x < drawn.cols; ++x) {
                const bool covered = drawn.at<unsigned char>(y, x) != 0;
                const bool seen = scene.masks[camera].at<unsigned char>(y, x) != 0;
                bool isOut = false;
                for (const core::ConvexRegion& region : outcome.result.trace->finalMatches[camera].leftOut)
                    isOut = isOut || region.contains({static_cast<float>(x), static_cast<float>(y)});
                for (const std::size_t counted : {0u, 1u}) {
                    both[counted] += covered && seen && !(counted == 1 && isOut) ? 1 : 0;
                    either[counted] += (covered || seen) && !(counted == 1 && isOut) ? 1 : 0;
                }
            }
        }
        return {double(both[0]) / either[0], double(both[1]) / either[1]};
    }
    /// Pixels of the mask that no hand covers in truth, and how the difference draws them.
    struct Arm {
        int pixels = 0, missed = 0, hatched = 0;
    };
    Arm armIn(const InspectOverlay& overlay, std::size_t camera) const {
        const cv::Mat hands = core::renderHandsMask(dataset.cameras[camera], dataset.hands, scene.truth);
        Arm arm;
        for (int y = 0; y < hands.rows; y += 2) {
            for (int x = 0; x < hands.cols; x += 2) {
                if (!scene.masks[camera].at<unsigned char>(y, x) || hands.at<unsigned char>(y, x))
                    continue;
                ++arm.pixels;
                const QColor drawn = overlay.field.pixelColor(x / 2, y / 2);
                arm.missed += drawn.red() > 2 * drawn.green() ? 1 : 0;
                arm.hatched += drawn.alpha() > 0x80 && drawn.saturation() < 20 ? 1 : 0;
            }
        }
        return arm;
    }

    test::FittingScene scene{"inspect layers"};
    core::Dataset dataset;
    core::PoseEstimator estimator{scene.hands, scene.cameras};
};

TEST_F(InspectLayersTest, TheDifferenceCountsEverythingWhereNoForearmIsCut) {
    for (const char* const method : {"dch-thres", "dch-thres:forearm=ignore"}) {
        const MethodOutcome clean = fit(method);
        for (const std::size_t camera : {0u, 3u}) {
            const InspectOverlay overlay = difference(clean, static_cast<int>(camera));
            EXPECT_DOUBLE_EQ(overlay.iou, countedIou(clean, camera).first) << method;
            EXPECT_FALSE(overlay.isWithoutForearm) << method;
        }
    }
    test::drawForearms(scene, scene.masks);
    const MethodOutcome ignored = fit("dch-thres:forearm=ignore");
    const InspectOverlay overlay = difference(ignored, 0);
    EXPECT_DOUBLE_EQ(overlay.iou, countedIou(ignored, 0).first);
    EXPECT_FALSE(overlay.isWithoutForearm);
    EXPECT_GT(armIn(overlay, 0).missed, 0.5 * armIn(overlay, 0).pixels);
}

TEST_F(InspectLayersTest, TheDifferenceLeavesOutTheForearmThatTheFitLeavesOut) {
    test::drawForearms(scene, scene.masks);
    const MethodOutcome cut = fit("dch-thres");
    Arm arms;
    double gain = 0;
    for (std::size_t camera = 0; camera < scene.cameras.size(); ++camera) {
        const InspectOverlay overlay = difference(cut, static_cast<int>(camera));
        const auto [all, outside] = countedIou(cut, camera);
        EXPECT_NEAR(overlay.iou, outside, 2e-3) << camera;
        EXPECT_TRUE(overlay.isWithoutForearm) << camera;
        gain += (overlay.iou - all) / static_cast<double>(scene.cameras.size());
        const Arm arm = armIn(overlay, camera);
        arms.pixels += arm.pixels;
        arms.missed += arm.missed;
        arms.hatched += arm.hatched;
    }
    EXPECT_GT(gain, 0.1) << "the arms are a large part of the masks";
    ASSERT_GT(arms.pixels, 3000);
    EXPECT_LT(arms.missed, 0.05 * arms.pixels);
    EXPECT_GT(arms.hatched, 0.2 * arms.pixels) << "neutral lines";
}

TEST_F(InspectLayersTest, APoseThatNoMethodMadeIsComparedWithoutTheForearmToo) {
    test::drawForearms(scene, scene.masks);
    const MethodOutcome cut = fit("dch-thres");
    MethodOutcome truth;
    truth.isFixed = true;
    truth.result.poses = scene.truth;
    truth.result.trace = cut.result.trace;
    const auto meanIou = [&] {
        double sum = 0;
        for (int camera = 0; camera < 6; ++camera)
            sum += difference(truth, camera).iou;
        return sum / 6;
    };
    const double without = meanIou();
    EXPECT_GT(without, 0.92); // the arms that were drawn begin with a disc, which covers some of the palm's side
    auto plain = std::make_shared<core::FitTrace>(*cut.result.trace);
    plain->forearms.clear();
    truth.result.trace = plain;
    EXPECT_LT(meanIou(), without - 0.1) << "with the arms";
}

TEST_F(InspectLayersTest, MatchesAreThoseOfTheChosenFinger) {
    const MethodOutcome outcome = fit("dch-thres");
    const auto lines = [&](MatchChoice choice) {
        return inspectOverlay(outcome, dataset, 0, 1000, {{InspectLayer::Matches}, 0, choice}, {}).shapes;
    };
    const auto count = [](const widgets::OverlayShapes& shapes) {
        std::size_t dots = 0;
        for (const auto& one : shapes.dots)
            dots += one.px.size();
        return shapes.lines.size() + dots;
    };
    const std::size_t all = count(lines(MatchChoice::ByDistance));
    std::size_t sum = 0;
    int parts = 0;
    for (const MatchChoice choice : widgets::kMatchChoices) {
        if (choice == MatchChoice::ByDistance || choice == MatchChoice::ByFinger)
            continue;
        const std::size_t ofPart = count(lines(choice));
        sum += ofPart;
        parts += ofPart > 0 ? 1 : 0;
    }
    EXPECT_EQ(sum, all) << "every match belongs to one part";
    EXPECT_GE(parts, 3) << "two fingers and the palm";
    EXPECT_EQ(count(lines(MatchChoice::ByFinger)), all);
    for (const core::MatchRecord& match : outcome.result.trace->finalMatches[0].matches) {
        const std::string& bone = scene.hands[match.hand].skeleton.bones[match.bone].name;
        const widgets::HandPart part = widgets::handPart(scene.hands[match.hand], match.bone);
        EXPECT_EQ(part == widgets::HandPart::Thumb, bone.rfind("thumb", 0) == 0) << bone;
        EXPECT_EQ(part == widgets::HandPart::Index, bone.rfind("index", 0) == 0) << bone;
    }
}

/// What dichromats see (Vienot, Brettel and Mollon 1999, on linear RGB).
QColor seenBy(const Eigen::Matrix3d& vision, const QColor& colour) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    const auto coded = [](double v) {
        const double c = std::clamp(v, 0.0, 1.0);
        return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    };
    const Eigen::Vector3d rgb =
        vision * Eigen::Vector3d(linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF()));
    return QColor::fromRgbF(coded(rgb[0]), coded(rgb[1]), coded(rgb[2]));
}

TEST(RefusalLook, ReasonsAreToldApartWithEveryColourVision) {
    Eigen::Matrix3d protan, deutan;
    protan << 0.11238, 0.88762, 0, 0.11238, 0.88762, 0, 0.00401, -0.00401, 1;
    deutan << 0.29275, 0.70725, 0, 0.29275, 0.70725, 0, -0.02234, 0.02234, 1;
    for (const Eigen::Matrix3d& vision : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), protan, deutan}) {
        for (std::size_t a = 0; a < widgets::kRefusals.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const auto one = widgets::refusalLook(widgets::kRefusals[a]);
                const auto other = widgets::refusalLook(widgets::kRefusals[b]);
                EXPECT_GT(test::labDistance(seenBy(vision, one.colour), seenBy(vision, other.colour)), 15)
                    << widgets::verdictInWords(widgets::kRefusals[a]).toStdString() << " and "
                    << widgets::verdictInWords(widgets::kRefusals[b]).toStdString();
                EXPECT_NE(one.line, other.line) << "by the pattern of the line, too";
            }
        }
    }
}

TEST_F(InspectLayersTest, AProbePreparesEveryOutlineOnce) {
    const MethodOutcome outcome = fit("dch-thres");
    widgets::ProbeTargets prepared;
    const auto probeAt = [&](int iteration, QPointF px) {
        return inspectProbe(outcome, widgets::shownMatches(outcome, 0, iteration), px, scene.hands, prepared);
    };
    const auto probe = probeAt(1000, {270, 480});
    ASSERT_TRUE(probe && probe->rim);
    EXPECT_EQ(probe->rows.size(), 4u);
    EXPECT_EQ(prepared.size(), 3u) << "all but its own";
    const auto own = ownProbeRow(outcome, widgets::shownMatches(outcome, 0, 1000), {270, 480});
    ASSERT_TRUE(own);
    EXPECT_EQ(own->contourPx, probe->rows[0].contourPx);
    probeAt(0, {200, 400});
    EXPECT_EQ(prepared.size(), 3u) << "nothing anew at another point and iteration";
}

TEST_F(InspectLayersTest, ErrorsAreColouredByTheRecordedPoseThoughMaskFilesAreTheTarget) {
    widgets::FitOutcome outcome;
    outcome.request.target = widgets::FitTarget::Masks;
    outcome.startPoses = scene.start;
    outcome.truePoses = scene.truth;
    outcome.methods = {fit("ch")};
    const widgets::InspectedPoses posed = inspectedPoses(dataset, outcome, 0, {});
    EXPECT_TRUE(posed.recorded.surfaces.empty()) << "the observed outline is drawn instead";
    const widgets::ViewSurface &start = *posed.methodsByError[0].surfaces[0], &truth = *posed.truth.surfaces[0];
    ASSERT_EQ(start.coloursRgb.size(), start.verticesInWorld.size());
    for (std::size_t v = 0; v < start.verticesInWorld.size(); v += 50) {
        const double mm = (start.verticesInWorld[v] - truth.verticesInWorld[v]).norm();
        EXPECT_NEAR(start.coloursRgb[v].x(), widgets::scaleColour(mm / widgets::kErrorScaleMm).redF(), 1e-4) << v;
    }
}

TEST_F(InspectLayersTest, OnlyWhatMovedIsPosedAnew) {
    widgets::FitOutcome outcome;
    outcome.request.target = widgets::FitTarget::Recorded;
    outcome.startPoses = scene.start;
    outcome.truePoses = scene.truth;
    outcome.methods = {fit("ch"), fit("dch-thres")};
    const widgets::InspectedPoses before = inspectedPoses(dataset, outcome, 1000, {});
    outcome.methods[1].result.poses = scene.truth;
    outcome.methods[1].method = "dch-thres:tau=45";
    const widgets::InspectedPoses after = inspectedPoses(dataset, outcome, 1000, {}, &before);
    const widgets::InspectedPoses alone = inspectedPoses(dataset, outcome, 1000, {});
    EXPECT_EQ(after.start, before.start);
    EXPECT_EQ(after.recorded, before.recorded);
    EXPECT_EQ(after.methods[0], before.methods[0]) << "the same surfaces: views have nothing to draw";
    EXPECT_EQ(after.methodsByError[0], before.methodsByError[0]);
    EXPECT_NE(after.methods[1].surfaces, before.methods[1].surfaces);
    for (std::size_t column = 0; column < 2; ++column) {
        EXPECT_EQ(after.methods[column].name, alone.methods[column].name);
        EXPECT_EQ(after.methods[column].colour, alone.methods[column].colour);
        for (std::size_t hand = 0; hand < dataset.hands.size(); ++hand) {
            EXPECT_EQ(after.methods[column].surfaces[hand]->verticesInWorld,
                      alone.methods[column].surfaces[hand]->verticesInWorld);
            EXPECT_EQ(after.methodsByError[column].surfaces[hand]->coloursRgb,
                      alone.methodsByError[column].surfaces[hand]->coloursRgb);
        }
    }
}

} // namespace
