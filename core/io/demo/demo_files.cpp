// SPDX-License-Identifier: MIT
#include "core/io/demo/demo_files.h"

#include <nlohmann/json.hpp>

namespace core {

using nlohmann::json;

namespace {

Eigen::Vector3d vectorFrom(const json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

std::vector<Eigen::Vector3d> pathFrom(const json& list) {
    std::vector<Eigen::Vector3d> points;
    for (const json& point : list)
        points.push_back(vectorFrom(point));
    return points;
}

SweptSolidShape sweepFrom(const json& value) {
    SweptSolidShape shape;
    for (const json& s : value["sections"])
        shape.sections.push_back({s[0].get<double>(), s[1].get<double>(), s[2].get<double>(), s[3].get<double>()});
    shape.capStartMm = value["capStart"].get<double>();
    shape.capEndMm = value["capEnd"].get<double>();
    return shape;
}

} // namespace

DemoHandShape demoHandShapeFromJson(const json& value) {
    DemoHandShape shape;
    for (const json& ray : value["rays"]) {
        shape.rays.push_back({ray["finger"].get<std::string>(), pathFrom(ray["joints"]), vectorFrom(ray["dorsal"]),
                              sweepFrom(ray["metacarpal"]), sweepFrom(ray["digit"]),
                              ray["bend"].get<std::vector<double>>()});
    }
    shape.forearmPath = pathFrom(value["forearm"]["path"]);
    shape.forearm = sweepFrom(value["forearm"]);
    for (const json& pad : value["pads"]) {
        shape.pads.push_back({pad["name"].get<std::string>(), vectorFrom(pad["centre"]), vectorFrom(pad["along"]),
                              vectorFrom(pad["dorsal"]), vectorFrom(pad["radii"])});
    }
    const json& blend = value["blend"];
    shape.palmBlendMm = blend["palm"].get<double>();
    shape.padBlendMm = blend["pad"].get<double>();
    shape.webBlendMm = blend["web"].get<double>();
    shape.fingerBlendMm = blend["finger"].get<double>();
    shape.thumbBlendMm = blend["thumb"].get<double>();
    shape.gridStepMm = value["surface"]["gridStep"].get<double>();
    shape.fingerEdgeMm = value["surface"]["fingerEdge"].get<double>();
    shape.palmEdgeMm = value["surface"]["palmEdge"].get<double>();
    shape.relaxations = value["surface"]["relaxations"].get<int>();
    return shape;
}

} // namespace core
