// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "core/fitting/method_name.h"
#include "widgets/presenters/inspect/inspect_difference.h"
#include "widgets/presenters/inspect/inspect_field.h"

namespace widgets {

namespace {

constexpr double kNormalPx = 8;
constexpr int kHues = 36; ///< orientation is drawn in steps of ten degrees
const QColor kRim(0xFF, 0xFF, 0xFF);

QPointF point(const Eigen::Vector2f& px) {
    return {static_cast<double>(px.x()), static_cast<double>(px.y())};
}

void addContour(const core::OrientedContour& contour, OverlayShapes& shapes) {
    std::map<int, OverlayShapes::Dots> byHue;
    for (std::size_t q = 0; q < contour.size(); ++q) {
        const double turn = static_cast<double>(contour.angleRad[q]) / (2 * std::numbers::pi);
        const int step = static_cast<int>(std::floor((turn - std::floor(turn)) * kHues));
        OverlayShapes::Dots& dots = byHue[step];
        dots.colour = directionColour((step + 0.5) / kHues * 2 * std::numbers::pi);
        dots.px.emplace_back(static_cast<double>(contour.x[q]), static_cast<double>(contour.y[q]));
    }
    for (auto& [step, dots] : byHue)
        shapes.dots.push_back(std::move(dots));
}

/// The part of a hand that a rim point belongs to.
HandPart partOf(const core::MatchRecord& match, const core::Dataset& dataset) {
    return match.hand < dataset.hands.size() ? handPart(dataset.hands[match.hand], match.bone) : HandPart::Palm;
}

void addRim(const core::Dataset& dataset, const std::vector<core::MatchRecord>& matches, MatchChoice choice,
            OverlayShapes& shapes) {
    OverlayShapes::Dots dots;
    dots.colour = kRim;
    for (const core::MatchRecord& match : matches) {
        const HandPart part = partOf(match, dataset);
        if (!isChosen(choice, part))
            continue;
        const QPointF px = point(match.rimPx);
        const auto angle = static_cast<double>(match.rimAngleRad);
        const QColor colour = choice == MatchChoice::ByFinger ? handPartColour(part) : kRim;
        dots.px.push_back(px);
        shapes.lines.push_back({px, px + kNormalPx * QPointF(std::cos(angle), std::sin(angle)), colour});
    }
    shapes.dots.push_back(std::move(dots));
}

/// The kept ones first; then those of one reason after the other, which are drawn at once.
void addMatches(const core::Dataset& dataset, const ShownMatches& shown, MatchChoice choice, InspectOverlay& overlay) {
    struct Refused {
        std::vector<OverlayShapes::Line> lines;
        OverlayShapes::Dots dots;
    };
    std::map<core::MatchVerdict, Refused> refused;
    for (const core::MatchRecord& match : *shown.matches) {
        const HandPart part = partOf(match, dataset);
        if (!isChosen(choice, part))
            continue;
        const core::MatchGeometry geometry = core::matchGeometry(match, shown.target->contour);
        const QPointF from = point(match.rimPx), to = point(geometry.contourPx);
        if (match.verdict == core::MatchVerdict::Kept) {
            const double share = static_cast<double>(geometry.residualPx) / kResidualScalePx;
            overlay.shapes.lines.push_back(
                {from, to, choice == MatchChoice::ByFinger ? handPartColour(part) : scaleColour(share)});
            continue;
        }
        const RefusalLook look = refusalLook(match.verdict);
        Refused& alike = refused[match.verdict];
        alike.dots.colour = look.colour;
        if (match.contourPoint < 0)
            alike.dots.px.push_back(from);
        else
            alike.lines.push_back({from, to, look.colour, look.line});
    }
    for (auto& [verdict, alike] : refused) {
        overlay.refusals.insert(verdict);
        overlay.shapes.lines.insert(overlay.shapes.lines.end(), alike.lines.begin(), alike.lines.end());
        overlay.shapes.dots.push_back(std::move(alike.dots));
    }
}

/// A pose that no method made leaves out what the methods do: the forearms where it has them.
std::vector<core::ConvexRegion> leftOutRegions(const MethodOutcome& method, const core::Dataset& dataset, int camera,
                                               const ShownMatches& shown) {
    if (method.isFixed)
        return core::forearmRegions(dataset.cameras[static_cast<std::size_t>(camera)], dataset.hands,
                                    method.result.poses, method.result.trace->forearms);
    return *shown.leftOut;
}

} // namespace

QString inspectLayerId(InspectLayer layer) {
    switch (layer) {
    case InspectLayer::Contour:
        return QStringLiteral("contour");
    case InspectLayer::Rim:
        return QStringLiteral("rim");
    case InspectLayer::Matches:
        return QStringLiteral("matches");
    case InspectLayer::Difference:
        return QStringLiteral("difference");
    case InspectLayer::Field:
        return QStringLiteral("field");
    case InspectLayer::Error:
        return QStringLiteral("error");
    case InspectLayer::Uncertainty:
        return QStringLiteral("uncertainty");
    }
    return {};
}

std::optional<InspectLayer> inspectLayerOf(const QString& id) {
    for (const InspectLayer layer : kInspectLayers)
        if (inspectLayerId(layer) == id)
            return layer;
    return std::nullopt;
}

QColor scaleColour(double share) {
    struct Stop {
        double r, g, b;
    };
    static constexpr std::array<Stop, 5> kStops{
        {{0.19, 0.20, 0.60}, {0.12, 0.50, 0.75}, {0.15, 0.72, 0.50}, {0.75, 0.83, 0.20}, {1.00, 0.90, 0.15}}};
    const double place = std::clamp(std::isnan(share) ? 1 : share, 0.0, 1.0) * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double t = place - static_cast<double>(below);
    const Stop &a = kStops[below], &b = kStops[below + 1];
    return QColor::fromRgbF(a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b));
}

QColor directionColour(double angleRad) {
    const double turn = angleRad / (2 * std::numbers::pi);
    return QColor::fromHsvF(turn - std::floor(turn), 0.9, 1);
}

ShownMatches shownMatches(const MethodOutcome& method, int camera, int iteration) {
    const auto& trace = method.result.trace;
    if (!trace)
        return {};
    const auto& history = method.result.history;
    const auto next = static_cast<std::size_t>(std::max(0, iteration));
    const core::IterationMatches* cameras =
        next < history.size() ? history[next].matchRecords.get() : &trace->finalMatches;
    for (std::size_t v = 0; cameras && v < cameras->size(); ++v)
        if ((*cameras)[v].camera == camera)
            return {&trace->targets[v], &(*cameras)[v].matches, &(*cameras)[v].leftOut};
    return {};
}

InspectOverlay inspectOverlay(const MethodOutcome& method, const core::Dataset& dataset, int camera, int iteration,
                              const OverlayChoice& choice, const MeshLayer& posed) {
    InspectOverlay overlay;
    const ShownMatches shown = shownMatches(method, camera, iteration);
    if (!shown.target)
        return overlay;
    const core::Camera& seen = dataset.cameras[static_cast<std::size_t>(camera)];
    if (choice.isShown(InspectLayer::Field) && !method.isFixed) {
        FieldOverlay field = fieldOverlay(*shown.target, core::matchRule(core::parseMethod(method.method)), seen,
                                          choice.fieldAngleRad, {kFieldScalePx, scaleColour});
        overlay.field = std::move(field.picture);
        overlay.shapes = std::move(field.arrows);
    }
    if (choice.isShown(InspectLayer::Difference)) {
        const SilhouetteDifference difference =
            silhouetteDifference(seen, shown.target->mask, posed, leftOutRegions(method, dataset, camera, shown));
        overlay.field = difference.picture;
        overlay.iou = difference.iou;
        overlay.isWithoutForearm = difference.leftOutPx > 0;
    }
    if (choice.isShown(InspectLayer::Contour))
        addContour(shown.target->contour, overlay.shapes);
    if (choice.isShown(InspectLayer::Rim))
        addRim(dataset, *shown.matches, choice.matches, overlay.shapes);
    if (choice.isShown(InspectLayer::Matches))
        addMatches(dataset, shown, choice.matches, overlay);
    return overlay;
}

MeshLayer colouredByError(MeshLayer posed, const MeshLayer& truth) {
    if (posed.surfaces.size() != truth.surfaces.size())
        return posed;
    for (std::size_t s = 0; s < posed.surfaces.size(); ++s) {
        const auto& here = posed.surfaces[s]->verticesInWorld;
        const auto& there = truth.surfaces[s]->verticesInWorld;
        if (here.size() != there.size())
            continue;
        auto coloured = std::make_shared<ViewSurface>(*posed.surfaces[s]);
        coloured->coloursRgb.reserve(here.size());
        for (std::size_t v = 0; v < here.size(); ++v) {
            const QColor colour = scaleColour((here[v] - there[v]).norm() / kErrorScaleMm);
            coloured->coloursRgb.emplace_back(static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                                              static_cast<float>(colour.blueF()));
        }
        posed.surfaces[s] = std::move(coloured);
    }
    return posed;
}

const core::MatchRecord* nearestRimPoint(const ShownMatches& shown, QPointF px) {
    const core::MatchRecord* found = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; shown.matches && i < shown.matches->size(); ++i) {
        const core::MatchRecord& match = (*shown.matches)[i];
        const QPointF offset = point(match.rimPx) - px;
        const double distance = std::hypot(offset.x(), offset.y());
        if (distance < nearest) {
            nearest = distance;
            found = &match;
        }
    }
    return found;
}

} // namespace widgets
