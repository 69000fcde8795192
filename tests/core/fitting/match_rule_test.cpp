// SPDX-License-Identifier: MIT
#include "core/fitting/match_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/distance/circular_distance.h"
#include "core/fitting/method_name.h"
#include "tests/support/fitting_scene.h"

namespace {

using core::CameraTarget;
using core::DistanceKind;
using core::MatchRule;
using core::parseMethod;
using core::RimPoint;
using core::WeightedMatch;
using std::numbers::pi;

core::OrientedContour randomContour(test::RandomValues& random, int count, bool wholePixels) {
    core::OrientedContour contour;
    for (int i = 0; i < count; ++i) {
        const double x = random.between(0, 200), y = random.between(0, 150);
        contour.x.push_back(static_cast<float>(wholePixels ? std::round(x) : x));
        contour.y.push_back(static_cast<float>(wholePixels ? std::round(y) : y));
        contour.angleRad.push_back(static_cast<float>(random.between(-pi, pi)));
    }
    return contour;
}

CameraTarget makeTarget(const core::OrientedContour& contour, const MatchRule& rule) {
    return {0, {}, {}, contour, {}, Eigen::Vector3d::Zero(), core::ContourIndex(contour, rule.bins), std::nullopt};
}

RimPoint randomRim(test::RandomValues& random) {
    RimPoint rim;
    rim.px = {static_cast<float>(random.between(-20, 220)), static_cast<float>(random.between(-20, 170))};
    const double angle = random.between(-pi, pi);
    rim.normalPx = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    return rim;
}

double angleOf(const RimPoint& rim) {
    return std::atan2(static_cast<double>(rim.normalPx.y()), static_cast<double>(rim.normalPx.x()));
}

double distanceOf(const core::OrientedContour& contour, std::size_t i, const RimPoint& rim) {
    return std::hypot(static_cast<double>(contour.x[i] - rim.px.x()), static_cast<double>(contour.y[i] - rim.px.y()));
}

/// The least cost of all contour points; infinite if none is allowed.
template <typename Cost>
double leastCost(const core::OrientedContour& contour, Cost&& cost) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contour.size(); ++i)
        least = std::min(least, cost(i));
    return least;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Draws contours and rim points and hands the matches of each to `check(contour, rule, rim, matches)`.
template <typename Check>
void forRandomMatches(const char* method, bool wholePixels, Check&& check) {
    test::RandomValues random(method);
    const MatchRule rule = core::matchRule(parseMethod(method));
    for (int trial = 0; trial < 40; ++trial) {
        const core::OrientedContour contour = randomContour(random, trial < 5 ? 3 : 150, wholePixels);
        const CameraTarget target = makeTarget(contour, rule);
        for (int i = 0; i < 25; ++i) {
            const RimPoint rim = randomRim(random);
            std::vector<WeightedMatch> matches{{-7, 0.0f}}; // what is there already stays
            core::findMatches(target, rule, rim, matches);
            ASSERT_EQ(matches.front().index, -7);
            matches.erase(matches.begin());
            check(contour, rule, rim, matches);
        }
    }
}

TEST(MatchRule, HoldsTheDefaultsOfTheMethod) {
    const MatchRule ch = core::matchRule(parseMethod("ch"));
    EXPECT_EQ(ch.distance, DistanceKind::Ch);
    EXPECT_TRUE(std::isinf(ch.tauRad) && std::isinf(ch.gatePx));
    EXPECT_EQ(ch.truncatePx2, 0);
    const MatchRule thres = core::matchRule(parseMethod("dch-thres"));
    EXPECT_EQ(thres.distance, DistanceKind::DchThres);
    EXPECT_NEAR(thres.tauRad, 22.5 * pi / 180, 1e-6);
    EXPECT_TRUE(thres.bins.isSigned());
    EXPECT_TRUE(std::isinf(thres.gatePx));
    for (const char* name : {"dch-quant", "dch-quant2"}) {
        const MatchRule quant = core::matchRule(parseMethod(name));
        EXPECT_EQ(quant.gatePx, 60) << name;
        EXPECT_EQ(quant.bins.count(), 8);
        EXPECT_TRUE(std::isinf(quant.tauRad));
    }
    EXPECT_EQ(core::matchRule(parseMethod("dch-quant")).distance, DistanceKind::DchQuant);
    EXPECT_EQ(core::matchRule(parseMethod("dch-quant2")).distance, DistanceKind::DchQuant2);
    const MatchRule dt3 = core::matchRule(parseMethod("dch-dt3"));
    EXPECT_EQ(dt3.distance, DistanceKind::DchDt3);
    EXPECT_EQ(dt3.bins.count(), 16);
    EXPECT_EQ(dt3.lambdaPxPerRad, 25);
    EXPECT_TRUE(dt3.wholePixels);
    EXPECT_TRUE(std::isinf(dt3.gatePx));
}

TEST(MatchRule, ChIsTheNearestContourPoint) {
    forRandomMatches(
        "ch", false,
        [](const auto& contour, const MatchRule&, const RimPoint& rim, const auto& matches) {
            ASSERT_EQ(matches.size(), 1u);
            EXPECT_EQ(matches[0].weight, 1);
            const double least = leastCost(
                contour, [&](std::size_t i) { return distanceOf(contour, i, rim); });
            EXPECT_NEAR(distanceOf(contour, static_cast<std::size_t>(matches[0].index), rim), least, 1e-4);
        });
}

TEST(MatchRule, GateAndTruncationDropFarMatches) {
    int kept = 0, dropped = 0;
    for (const char* method : {"ch:gate=9", "ch:truncate=81"}) {
        forRandomMatches(
            method, false,
            [&](const auto& contour, const MatchRule&, const RimPoint& rim, const auto& matches) {
                const double least = leastCost(
                    contour, [&](std::size_t i) { return distanceOf(contour, i, rim); });
                if (std::abs(least - 9) > 1e-3) {
                    EXPECT_EQ(matches.size(), least < 9 ? 1u : 0u);
                    (least < 9 ? kept : dropped) += 1;
                }
            });
    }
    EXPECT_GT(kept, 300);
    EXPECT_GT(dropped, 300);
}

TEST(MatchRule, ThresMatchesOnPositionAndThenRejects) {
    for (const char* method : {"dch-thres:tau=60", "dch-thres:tau=40:signed=0"}) {
        const double tau = std::string(method).find("60") != std::string::npos ? pi / 3 : 40 * pi / 180;
        int kept = 0, rejected = 0;
        forRandomMatches(
            method, false, [&](const auto& contour, const MatchRule& rule, const RimPoint& rim, const auto& matches) {
                std::size_t nearest = 0;
                for (std::size_t i = 1; i < contour.size(); ++i)
                    nearest = distanceOf(contour, i, rim) < distanceOf(contour, nearest, rim) ? i : nearest;
                const double apart = core::circularDistance(static_cast<double>(contour.angleRad[nearest]),
                                                            angleOf(rim), rule.bins.isSigned());
                if (std::abs(apart - tau) > 1e-4) {
                    EXPECT_EQ(matches.size(), apart < tau ? 1u : 0u)
                        << "a farther point of better direction is not a match";
                    (apart < tau ? kept : rejected) += 1;
                }
            });
        EXPECT_GT(kept, 200);
        EXPECT_GT(rejected, 200);
    }
}

TEST(MatchRule, QuantIsTheNearestInTheOwnBin) {
    for (const char* method : {"dch-quant:bins=6", "dch-quant:signed=0:bins=5", "dch-quant:centre=0.5"}) {
        int none = 0;
        forRandomMatches(method, false,
                         [&](const auto& contour, const MatchRule& rule, const RimPoint& rim, const auto& matches) {
                             const int bin = rule.bins.binOf(angleOf(rim));
                             const double least = leastCost(contour, [&](std::size_t i) {
                                 return rule.bins.binOf(static_cast<double>(contour.angleRad[i])) == bin
                                            ? distanceOf(contour, i, rim)
                                            : kInfinity;
                             });
                             ASSERT_EQ(matches.size(), least < 60 ? 1u : 0u);
                             none += matches.empty();
                             if (!matches.empty()) {
                                 const auto match = static_cast<std::size_t>(matches[0].index);
                                 EXPECT_NEAR(distanceOf(contour, match, rim), least, 1e-4);
                                 EXPECT_EQ(rule.bins.binOf(static_cast<double>(contour.angleRad[match])), bin);
                             }
                         });
        EXPECT_GT(none, 20);
    }
}

TEST(MatchRule, Quant2IsTheNearestInEachOfTheTwoNearestBins) {
    for (const char* method : {"dch-quant2:bins=6", "dch-quant2:bins=6:weights=1"}) {
        const bool weighted = std::string(method).ends_with("weights=1");
        int both = 0;
        forRandomMatches(
            method, false, [&](const auto& contour, const MatchRule& rule, const RimPoint& rim, const auto& matches) {
                std::vector<int> bins(6);
                for (int b = 0; b < 6; ++b)
                    bins[static_cast<std::size_t>(b)] = b;
                const auto apart = [&](int b) {
                    return core::signedCircularDistance(rule.bins.centreRad(b), angleOf(rim));
                };
                std::sort(bins.begin(), bins.end(), [&](int a, int b) { return apart(a) < apart(b); });
                std::size_t k = 0;
                for (std::size_t n = 0; n < 2; ++n) {
                    const double least = leastCost(contour, [&](std::size_t i) {
                        return rule.bins.binOf(static_cast<double>(contour.angleRad[i])) == bins[n]
                                   ? distanceOf(contour, i, rim)
                                   : kInfinity;
                    });
                    if (least < 60) {
                        ASSERT_LT(k, matches.size());
                        EXPECT_NEAR(distanceOf(contour, static_cast<std::size_t>(matches[k].index), rim), least, 1e-4);
                        EXPECT_NEAR(matches[k].weight, weighted ? 1 - apart(bins[n]) / (pi / 3) : 1, 1e-5);
                        ++k;
                    }
                }
                EXPECT_EQ(matches.size(), k);
                both += k == 2;
            });
        EXPECT_GT(both, 300);
    }
}

TEST(MatchRule, WeightsOfTheTwoBinsSumToOne) {
    const core::OrientationBins bins(8, true);
    test::RandomValues random("bin weights");
    for (int trial = 0; trial < 50; ++trial) {
        const double angle = random.between(-pi, pi);
        const auto two = bins.nearestTwo(angle);
        const double sum = 2 - (core::signedCircularDistance(angle, bins.centreRad(two[0])) +
                                core::signedCircularDistance(angle, bins.centreRad(two[1]))) /
                                   bins.widthRad();
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(MatchRule, Dt3IsTheLeastMixedCost) {
    for (const char* method : {"dch-dt3", "dch-dt3:lambda=60:bins=12:signed=0"}) {
        forRandomMatches(
            method, true,
            [](const auto& contour, const MatchRule& rule, const RimPoint& rim, const auto& matches) {
                RimPoint atPixel = rim;
                atPixel.px = rim.px.array().round();
                const int bin = rule.bins.binOf(angleOf(rim));
                const auto cost = [&](std::size_t i) {
                    return distanceOf(contour, i, atPixel) +
                           static_cast<double>(rule.lambdaPxPerRad) *
                               rule.bins.distanceRad(bin, rule.bins.binOf(static_cast<double>(contour.angleRad[i])));
                };
                ASSERT_EQ(matches.size(), 1u);
                EXPECT_NEAR(cost(static_cast<std::size_t>(matches[0].index)), leastCost(contour, cost), 1e-3);
            });
    }
}

TEST(MatchRule, Dt3FindsTheSameInTheTensor) {
    const test::FittingScene scene("tensor", 2);
    test::RandomValues random("tensor matches");
    for (const char* method : {"dch-dt3", "dch-dt3:lambda=50:bins=24:signed=0:centre=0.5", "dch-dt3:gate=12"}) {
        const MatchRule rule = core::matchRule(parseMethod(method));
        core::FitTargetOptions options;
        options.bins = rule.bins;
        options.wholePixels = true;
        const auto direct = core::makeFitTargets(scene.cameras, scene.masks, options, 1);
        options.tensorLambdaPxPerRad = static_cast<double>(rule.lambdaPxPerRad);
        const auto tensor = core::makeFitTargets(scene.cameras, scene.masks, options, 1);
        for (std::size_t c = 0; c < direct.size(); ++c) {
            const core::OrientedContour& contour = direct[c].contour;
            for (int i = 0; i < 300; ++i) {
                const cv::Rect& area = direct[c].maskBounds;
                RimPoint rim = randomRim(random);
                rim.px = {static_cast<float>(random.between(area.x - 50, area.br().x + 50)),
                          static_cast<float>(random.between(area.y - 50, area.br().y + 50))};
                const auto cost = [&](const CameraTarget& target) {
                    std::vector<WeightedMatch> matches;
                    core::findMatches(target, rule, rim, matches);
                    if (matches.size() != 1) {
                        return kInfinity;
                    }
                    const auto q = static_cast<std::size_t>(matches[0].index);
                    const double dx = static_cast<double>(std::round(rim.px.x()) - std::round(contour.x[q]));
                    const double dy = static_cast<double>(std::round(rim.px.y()) - std::round(contour.y[q]));
                    return std::hypot(dx, dy) +
                           static_cast<double>(rule.lambdaPxPerRad) *
                               rule.bins.distanceRad(rule.bins.binOf(angleOf(rim)),
                                                     rule.bins.binOf(static_cast<double>(contour.angleRad[q])));
                };
                const double expected = cost(direct[c]);
                if (std::isinf(expected))
                    EXPECT_EQ(cost(tensor[c]), kInfinity) << method << ": nothing within the gate";
                else
                    EXPECT_NEAR(cost(tensor[c]), expected, 1e-3) << method;
            }
        }
    }
}

TEST(MatchRule, WithinTauSkipsPointsOfOtherDirections) {
    test::RandomValues random("within tau");
    MatchRule rule;
    rule.withinTau = true;
    rule.tauRad = 0.5f;
    const core::OrientedContour contour = randomContour(random, 120, false);
    const CameraTarget target = makeTarget(contour, rule);
    for (int i = 0; i < 300; ++i) {
        const RimPoint rim = randomRim(random);
        std::vector<WeightedMatch> matches;
        core::findMatches(target, rule, rim, matches);
        const double least = leastCost(contour, [&](std::size_t k) {
            const double apart = core::signedCircularDistance(static_cast<double>(contour.angleRad[k]), angleOf(rim));
            return apart < 0.5 ? distanceOf(contour, k, rim) : kInfinity;
        });
        ASSERT_EQ(matches.size(), 1u);
        EXPECT_NEAR(distanceOf(contour, static_cast<std::size_t>(matches[0].index), rim), least, 1e-4);
    }
}

/// What a reader of the candidate's verdict may rely on, judged from the whole contour.
void checkVerdict(const core::OrientedContour& contour, const MatchRule& rule, const RimPoint& rim,
                  const core::MatchCandidate& candidate) {
    using core::MatchVerdict;
    const auto q = static_cast<std::size_t>(std::max(0, candidate.index));
    const double apart = candidate.index < 0 ? 0
                                             : core::circularDistance(static_cast<double>(contour.angleRad[q]),
                                                                      angleOf(rim), rule.bins.isSigned());
    const double distance = candidate.index < 0 ? 0 : distanceOf(contour, q, rim);
    switch (candidate.verdict) {
    case MatchVerdict::Kept:
        EXPECT_LE(distance, static_cast<double>(rule.gatePx) + 1e-4);
        break;
    case MatchVerdict::Orientation:
        EXPECT_GE(apart, static_cast<double>(rule.tauRad));
        EXPECT_NEAR(distance, leastCost(contour, [&](std::size_t k) { return distanceOf(contour, k, rim); }), 1e-4);
        break;
    case MatchVerdict::Gate:
        EXPECT_GT(distance, static_cast<double>(rule.gatePx) - 1e-4);
        break;
    case MatchVerdict::Truncated:
        EXPECT_GT(distance * distance, static_cast<double>(rule.truncatePx2) - 1e-3);
        break;
    case MatchVerdict::EmptyBin:
        EXPECT_EQ(candidate.index, -1);
        EXPECT_TRUE(std::none_of(contour.angleRad.begin(), contour.angleRad.end(), [&](float angle) {
            return rule.bins.binOf(static_cast<double>(angle)) == rule.bins.binOf(angleOf(rim));
        }));
        break;
    case MatchVerdict::Forearm:
        FAIL() << "no rule knows forearms";
    }
}

TEST(MatchRule, ExplainsWhatItRefusesAndKeepsTheSame) {
    std::set<core::MatchVerdict> seen;
    for (const char* method : {"ch:gate=30", "ch:truncate=400", "dch-thres", "dch-thres:gate=30", "dch-quant:bins=24",
                               "dch-quant:bins=8:gate=20", "dch-quant2:weights=1:gate=25", "dch-dt3:gate=12"}) {
        forRandomMatches(
            method, false,
            [&](const core::OrientedContour& contour, const MatchRule& rule, const RimPoint& rim,
                const std::vector<WeightedMatch>& matches) {
                std::vector<core::MatchCandidate> candidates;
                core::explainMatches(makeTarget(contour, rule), rule, rim, candidates);
                std::size_t kept = 0;
                for (const core::MatchCandidate& candidate : candidates) {
                    seen.insert(candidate.verdict);
                    if (candidate.verdict == core::MatchVerdict::Kept) {
                        ASSERT_LT(kept, matches.size()) << method;
                        EXPECT_EQ(candidate.index, matches[kept].index) << method;
                        EXPECT_EQ(candidate.weight, matches[kept++].weight) << method;
                    } else {
                        EXPECT_EQ(candidate.weight, 0);
                    }
                    if (rule.distance != DistanceKind::DchDt3 && rule.distance != DistanceKind::DchQuant2)
                        checkVerdict(contour, rule, rim, candidate);
                }
                EXPECT_EQ(kept, matches.size()) << method;
                EXPECT_FALSE(candidates.empty()) << method << ": a refusal is told, too";
            });
    }
    EXPECT_EQ(seen.size(), 5u) << "every reason but the forearm has been met";
}

} // namespace
