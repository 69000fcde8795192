// SPDX-License-Identifier: MIT
#include "core/benchmark/realism_settings.h"

#include "core/text/number_text.h"

namespace core {

namespace {

constexpr double kContourPx = 1.5, kScale = 1.03, kGirthMm = 1;

RealismSetting onAxis(const std::string& axis, double value, const std::string& unit, const Imperfection& world) {
    const std::string text = exactText(value);
    return {axis + "-" + text, axis + " " + text + " " + unit, axis, value, world, false, false};
}

void addLadder(std::vector<RealismSetting>& settings, bool isAdapted) {
    const std::string suffix = isAdapted ? "-adapted" : "";
    const std::string after = isAdapted ? ", adapted" : "";
    Imperfection world;
    double step = 0;
    const auto add = [&](const std::string& id, const std::string& title) {
        settings.push_back({id + suffix, title + after, "ladder", ++step, world, true, isAdapted});
    };
    world.contourPx = kContourPx;
    add("noise", "contour noise only");
    world.forearm = true;
    add("forearm", "+ forearm");
    world.scale = kScale;
    world.girthMm = kGirthMm;
    add("other-hand", "+ other hand");
    world.rig = kCasualRig;
    add("casual", "+ casual rig");
}

} // namespace

std::vector<RealismSetting> realismSettings() {
    std::vector<RealismSetting> settings{{"clean", "synthetic: nothing is wrong", "clean", 0, {}, false, false}};
    for (const double px : {0.5, 1.0, 1.5, 2.5}) {
        Imperfection world;
        world.contourPx = px;
        settings.push_back(onAxis("contour", px, "px", world));
    }
    for (const double share : {0.25, 0.5, 1.0, 1.5}) {
        Imperfection world;
        world.rig = {share * kCasualRig.turnDeg, share * kCasualRig.shiftMm, share * kCasualRig.focalShare};
        settings.push_back(onAxis("rig", world.rig.turnDeg, "degrees", world));
    }
    for (const double percent : {1.5, 3.0, 4.5, 6.0}) {
        Imperfection world;
        world.scale = 1 + percent / 100;
        world.girthMm = kGirthMm * percent / 3;
        settings.push_back(onAxis("hand", percent, "%", world));
    }
    addLadder(settings, false);
    addLadder(settings, true);
    return settings;
}

std::string realismAxisLabel(const std::string& axis) {
    if (axis == "contour")
        return "contour noise (px)";
    if (axis == "rig")
        return "rig error (degrees per axis; mm and focal length in proportion)";
    if (axis == "hand")
        return "other hand (% larger; 1 mm thicker at 3 %)";
    return "step";
}

} // namespace core
