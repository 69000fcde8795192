// SPDX-License-Identifier: MIT
#include "core/fitting/method_name.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/fitting/match_rule.h"

namespace {

using core::BestOptions;
using core::DistanceKind;
using core::Method;
using core::methodName;
using core::parseMethod;

const Method kBest{.best = BestOptions{}};

TEST(MethodName, PlainNamesAreTheSixMethodsWithTheirDefaults) {
    const std::vector<std::pair<std::string, Method>> methods{{"ch", {.distance = DistanceKind::Ch}},
                                                              {"dch-thres", {.distance = DistanceKind::DchThres}},
                                                              {"dch-quant", {.distance = DistanceKind::DchQuant}},
                                                              {"dch-quant2", {.distance = DistanceKind::DchQuant2}},
                                                              {"dch-dt3", {.distance = DistanceKind::DchDt3}},
                                                              {"best", kBest}};
    EXPECT_EQ(core::plainMethodNames().size(), methods.size());
    for (const auto& [name, method] : methods) {
        EXPECT_EQ(parseMethod(name), method);
        EXPECT_EQ(methodName(method), name);
        const auto names = core::plainMethodNames();
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1);
    }
}

TEST(MethodName, EveryOptionIsReadAndWrittenBack) {
    const std::vector<std::pair<std::string, Method>> cases{
        {"dch-thres:tau=45", {.distance = DistanceKind::DchThres, .tauDeg = 45}},
        {"dch-thres:tau=11.25:signed=0",
         {.distance = DistanceKind::DchThres, .tauDeg = 11.25, .signedOrientation = false}},
        {"dch-dt3:lambda=15.5:bins=32", {.distance = DistanceKind::DchDt3, .lambdaPxPerRad = 15.5, .bins = 32}},
        {"dch-dt3:backend=tensor", {.distance = DistanceKind::DchDt3, .backend = core::Dt3Backend::Tensor}},
        {"dch-quant:signed=0:bins=16", {.distance = DistanceKind::DchQuant, .signedOrientation = false, .bins = 16}},
        {"dch-quant:centre=0.5", {.distance = DistanceKind::DchQuant, .binCentre = 0.5}},
        {"dch-quant2:bins=4:weights=1:gate=40",
         {.distance = DistanceKind::DchQuant2, .bins = 4, .binWeights = true, .gatePx = 40}},
        {"ch:gate=30:truncate=900", {.distance = DistanceKind::Ch, .gatePx = 30, .truncatePx2 = 900}},
        {"ch:epsilon=1.5:tangent=chord", {.distance = DistanceKind::Ch, .polygonEpsilonPx = 1.5, .chordTangent = true}},
        {"ch:iterations=7:damping=0.1:schedule=paper",
         {.distance = DistanceKind::Ch, .maxIterations = 7, .damping = 0.1, .schedule = core::Schedule::Paper}},
        {"best:live=1", {.best = BestOptions{.live = true}}},
        {"best:palm=0:robust=5", {.best = BestOptions{.palm = false, .robustMm = 5}}},
        {"best:both=1:within=1", {.best = BestOptions{.bothWays = true, .withinTau = true}}},
        {"best:epsilon=0.7:tangent=chord", {.best = BestOptions{}, .polygonEpsilonPx = 0.7, .chordTangent = true}}};
    for (const auto& [text, method] : cases) {
        EXPECT_EQ(parseMethod(text), method) << text;
        EXPECT_EQ(methodName(method), text);
    }
}

TEST(MethodName, OptionsMayComeInAnyOrder) {
    EXPECT_EQ(parseMethod("dch-thres:signed=0:tau=45"), parseMethod("dch-thres:tau=45:signed=0"));
}

TEST(MethodName, DefaultsAreNotPartOfTheName) {
    EXPECT_EQ(methodName(parseMethod("dch-thres:tau=22.5:signed=1:iterations=25:damping=1e-3:schedule=rigid")),
              "dch-thres");
    EXPECT_EQ(methodName(parseMethod("dch-dt3:lambda=25:backend=direct:tangent=polygon")), "dch-dt3");
}

TEST(MethodName, NumbersSurviveTheirNameExactly) {
    const Method method{.distance = DistanceKind::DchThres, .tauDeg = 100.0 / 3, .damping = 1e-7};
    EXPECT_EQ(parseMethod(methodName(method)), method);
}

struct Bad {
    std::string text, field, detail;
};

const std::vector<Bad> kBadOptions{
    {"", "", "unknown method"},
    {"CH", "CH", "unknown method"},
    {"dch", "dch", "the methods are ch, dch-dt3, dch-quant, dch-quant2, dch-thres, best"},
    {"ch:tau=22.5", "tau",
     "unknown option; the options of ch are noise, gate, truncate, epsilon, tangent, forearm, iterations, damping, "
     "schedule"},
    {"ch:signed=1", "signed", "unknown option"},
    {"ch:lambda=3", "lambda", "unknown option"},
    {"ch:live=1", "live", "unknown option"},
    {"dch-thres:bins=8", "bins", "unknown option"},
    {"dch-thres:centre=0.5", "centre", "unknown option"},
    {"dch-quant:weights=1", "weights", "unknown option"},
    {"dch-quant:backend=tensor", "backend", "unknown option"},
    {"dch-thres:palm=0", "palm", "unknown option"},
    {"best:palm=2", "palm", "must be 0 or 1"},
    {"best:iterations=5", "iterations", "unknown option"},
    {"best:gate=5", "gate", "unknown option"},
    {"best:damping=1", "damping", "unknown option"},
    {"best:schedule=paper", "schedule", "unknown option"},
    {"best:truncate=4", "truncate", "unknown option"},
    {"dch-thres:Tau=3", "Tau", "unknown option"},
    {"dch-thres:tau", "tau", "name=value"},
    {"dch-thres:", "", "name=value"},
    {"dch-thres:tau=", "tau", "not a number"},
    {"dch-thres:tau=wide", "tau", "'wide' is not a number from 0"},
    {"dch-thres:tau=22.5deg", "tau", "not a number"},
    {"dch-thres:tau= 22", "tau", "not a number"},
    {"dch-thres:tau=nan", "tau", "not a number"},
    {"dch-thres:tau=1e999", "tau", "not a number"},
    {"dch-thres:tau=-1", "tau", "from 0"},
    {"dch-thres:tau=181", "tau", "180"},
    {"dch-thres:signed=yes", "signed", "must be 0 or 1"},
    {"dch-dt3:lambda=-2", "lambda", "not a number from 0"},
    {"dch-dt3:lambda=1001", "lambda", "1000"},
    {"dch-dt3:bins=0", "bins", "from 1"},
    {"dch-dt3:bins=257", "bins", "256"},
    {"dch-dt3:bins=7.5", "bins", "whole number"},
    {"dch-dt3:centre=1", "centre", "not a number from 0"},
    {"dch-dt3:backend=gpu", "backend", "must be direct or tensor"},
    {"dch-quant2:weights=2", "weights", "must be 0 or 1"},
    {"best:live=maybe", "live", "must be 0 or 1"},
    {"ch:gate=-1", "gate", "from 0"},
    {"ch:truncate=x", "truncate", "not a number"},
    {"ch:epsilon=0", "epsilon", "from 0.1"},
    {"ch:tangent=curve", "tangent", "must be polygon or chord"},
    {"ch:iterations=0", "iterations", "from 1"},
    {"ch:iterations=2.5", "iterations", "whole number"},
    {"ch:damping=11", "damping", "10"},
    {"ch:schedule=fast", "schedule", "must be rigid or paper"}};

TEST(MethodName, EveryBadOptionIsNamedWithWhatIsWrong) {
    for (const Bad& bad : kBadOptions) {
        try {
            parseMethod(bad.text);
            ADD_FAILURE() << "accepted: " << bad.text;
        } catch (const core::Error& error) {
            EXPECT_EQ(error.code(), core::ErrorCode::Usage);
            EXPECT_EQ(error.field(), bad.field) << bad.text;
            EXPECT_NE(error.detail().find(bad.detail), std::string::npos) << bad.text << ": " << error.detail();
            EXPECT_NE(error.file().find("--method"), std::string::npos);
        }
    }
}

TEST(MethodName, WhatIsAcceptedMakesAMatchingRule) {
    for (const char* text : {"dch-quant:bins=1", "dch-quant:bins=256", "dch-dt3:bins=256:signed=0", "dch-dt3:lambda=0",
                             "dch-quant2:centre=0.999", "dch-thres:tau=0", "dch-thres:tau=180", "ch:gate=1000000"})
        EXPECT_NO_THROW(core::matchRule(parseMethod(text))) << text;
}

} // namespace
