// SPDX-License-Identifier: MIT
#include "core/fitting/method.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/fitting/match_rule.h"

namespace {

using core::Method;
using core::MethodKind;
using core::methodName;
using core::parseMethod;

TEST(Method, PlainNamesAreTheSixMethodsWithTheirDefaults) {
    const std::vector<std::pair<std::string, MethodKind>> kinds{{"ch", MethodKind::Ch},
                                                                {"dch-thres", MethodKind::DchThres},
                                                                {"dch-quant", MethodKind::DchQuant},
                                                                {"dch-quant2", MethodKind::DchQuant2},
                                                                {"dch-dt3", MethodKind::DchDt3},
                                                                {"best", MethodKind::Best}};
    EXPECT_EQ(core::plainMethodNames().size(), kinds.size());
    for (const auto& [name, kind] : kinds) {
        EXPECT_EQ(parseMethod(name), Method{.kind = kind});
        EXPECT_EQ(methodName(parseMethod(name)), name);
        const auto names = core::plainMethodNames();
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1);
    }
}

TEST(Method, EveryOptionIsReadAndWrittenBack) {
    const std::vector<std::pair<std::string, Method>> cases{
        {"dch-thres:tau=45", {.kind = MethodKind::DchThres, .tauDeg = 45}},
        {"dch-thres:tau=11.25:signed=0", {.kind = MethodKind::DchThres, .tauDeg = 11.25, .signedOrientation = false}},
        {"dch-dt3:lambda=15.5:bins=32", {.kind = MethodKind::DchDt3, .lambdaPxPerRad = 15.5, .bins = 32}},
        {"dch-dt3:backend=tensor", {.kind = MethodKind::DchDt3, .backend = core::Dt3Backend::Tensor}},
        {"dch-quant:signed=0:bins=16", {.kind = MethodKind::DchQuant, .signedOrientation = false, .bins = 16}},
        {"dch-quant:centre=0.5", {.kind = MethodKind::DchQuant, .binCentre = 0.5}},
        {"dch-quant2:bins=4:weights=1:gate=40",
         {.kind = MethodKind::DchQuant2, .bins = 4, .binWeights = true, .gatePx = 40}},
        {"ch:gate=30:truncate=900", {.kind = MethodKind::Ch, .gatePx = 30, .truncatePx2 = 900}},
        {"ch:epsilon=1.5:tangent=chord", {.kind = MethodKind::Ch, .polygonEpsilonPx = 1.5, .chordTangent = true}},
        {"ch:iterations=7:damping=0.1:schedule=paper",
         {.kind = MethodKind::Ch, .maxIterations = 7, .damping = 0.1, .schedule = core::Schedule::Paper}},
        {"best:live=1", {.kind = MethodKind::Best, .live = true}},
        {"best:palm=0:robust=5", {.kind = MethodKind::Best, .ideas = {.palm = false, .robustMm = 5}}},
        {"best:both=1:within=1", {.kind = MethodKind::Best, .ideas = {.bothWays = true, .withinTau = true}}},
        {"best:epsilon=0.7:tangent=chord", {.kind = MethodKind::Best, .polygonEpsilonPx = 0.7, .chordTangent = true}}};
    for (const auto& [text, method] : cases) {
        EXPECT_EQ(parseMethod(text), method) << text;
        EXPECT_EQ(methodName(method), text);
    }
}

TEST(Method, OptionsMayComeInAnyOrder) {
    EXPECT_EQ(parseMethod("dch-thres:signed=0:tau=45"), parseMethod("dch-thres:tau=45:signed=0"));
}

TEST(Method, DefaultsAreNotPartOfTheName) {
    EXPECT_EQ(methodName(parseMethod("dch-thres:tau=22.5:signed=1:iterations=25:damping=1e-3:schedule=rigid")),
              "dch-thres");
    EXPECT_EQ(methodName(parseMethod("dch-dt3:lambda=25:backend=direct:tangent=polygon")), "dch-dt3");
}

TEST(Method, NumbersSurviveTheirNameExactly) {
    const Method method{.kind = MethodKind::DchThres, .tauDeg = 100.0 / 3, .damping = 1e-7};
    EXPECT_EQ(parseMethod(methodName(method)), method);
}

struct Bad {
    std::string text, field, detail;
};

const std::vector<Bad> kBadOptions{{"", "", "no such method"},
                                   {"CH", "CH", "no such method"},
                                   {"dch", "dch", "ch, dch-thres, dch-quant, dch-quant2, dch-dt3 and best"},
                                   {"ch:tau=22.5", "tau", "is no option of this method, which has gate, truncate"},
                                   {"ch:signed=1", "signed", "is no option"},
                                   {"ch:lambda=3", "lambda", "is no option"},
                                   {"ch:live=1", "live", "is no option"},
                                   {"dch-thres:bins=8", "bins", "is no option"},
                                   {"dch-thres:centre=0.5", "centre", "is no option"},
                                   {"dch-quant:weights=1", "weights", "is no option"},
                                   {"dch-quant:backend=tensor", "backend", "is no option"},
                                   {"dch-thres:palm=0", "palm", "is no option"},
                                   {"best:palm=2", "palm", "must be 0 or 1"},
                                   {"best:iterations=5", "iterations", "is no option"},
                                   {"best:gate=5", "gate", "is no option"},
                                   {"best:damping=1", "damping", "is no option"},
                                   {"best:schedule=paper", "schedule", "is no option"},
                                   {"best:truncate=4", "truncate", "is no option"},
                                   {"dch-thres:Tau=3", "Tau", "is no option"},
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
                                   {"dch-dt3:backend=gpu", "backend", "must be tensor or direct"},
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

TEST(Method, EveryBadOptionIsNamedWithWhatIsWrong) {
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

TEST(Method, WhatIsAcceptedMakesAMatchingRule) {
    for (const char* text : {"dch-quant:bins=1", "dch-quant:bins=256", "dch-dt3:bins=256:signed=0", "dch-dt3:lambda=0",
                             "dch-quant2:centre=0.999", "dch-thres:tau=0", "dch-thres:tau=180", "ch:gate=1000000"}) {
        EXPECT_NO_THROW(core::matchRule(parseMethod(text))) << text;
    }
}

} // namespace
