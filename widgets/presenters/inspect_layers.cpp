// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "core/distance/generalized_chamfer.h"
#include "core/fitting/method_name.h"

namespace widgets {

namespace {

constexpr double kNormalPx = 8;
constexpr int kHues = 36;     ///< orientation is drawn in steps of ten degrees
constexpr int kReduction = 4; ///< pictures of fields have a quarter of the image's resolution
const QColor kRefused(0xFF, 0x5A, 0x5A);
const QColor kRim(0xFF, 0xFF, 0xFF);
constexpr QRgb kMissed = 0xD0E0402A; ///< premultiplied: seen, but not covered by the hands
constexpr QRgb kExtra = 0xD02A60E0;  ///< covered, but not seen

QPointF point(const Eigen::Vector2f& px) {
    return {static_cast<double>(px.x()), static_cast<double>(px.y())};
}

/// One colour per direction; opposite directions have opposite hues.
QColor hueOf(double angleRad) {
    const double turn = angleRad / (2 * std::numbers::pi);
    return QColor::fromHsvF(turn - std::floor(turn), 0.9, 1);
}

void addContour(const core::OrientedContour& contour, OverlayShapes& shapes) {
    std::map<int, OverlayShapes::Dots> byHue;
    for (std::size_t q = 0; q < contour.size(); ++q) {
        const double turn = static_cast<double>(contour.angleRad[q]) / (2 * std::numbers::pi);
        const int step = static_cast<int>(std::floor((turn - std::floor(turn)) * kHues));
        OverlayShapes::Dots& dots = byHue[step];
        dots.colour = hueOf((step + 0.5) / kHues * 2 * std::numbers::pi);
        dots.px.emplace_back(static_cast<double>(contour.x[q]), static_cast<double>(contour.y[q]));
    }
    for (auto& [step, dots] : byHue)
        shapes.dots.push_back(std::move(dots));
}

void addRim(const std::vector<core::MatchRecord>& matches, OverlayShapes& shapes) {
    OverlayShapes::Dots dots;
    dots.colour = kRim;
    for (const core::MatchRecord& match : matches) {
        const QPointF px = point(match.rimPx);
        const auto angle = static_cast<double>(match.rimAngleRad);
        dots.px.push_back(px);
        shapes.lines.push_back({px, px + kNormalPx * QPointF(std::cos(angle), std::sin(angle)), kRim});
    }
    shapes.dots.push_back(std::move(dots));
}

void addMatches(const core::OrientedContour& contour, const std::vector<core::MatchRecord>& matches,
                OverlayShapes& shapes) {
    OverlayShapes::Dots unmatched;
    unmatched.colour = kRefused;
    for (const core::MatchRecord& match : matches) {
        const core::MatchGeometry geometry = core::matchGeometry(match, contour);
        const bool isKept = match.verdict == core::MatchVerdict::Kept;
        if (match.contourPoint < 0) {
            unmatched.px.push_back(point(match.rimPx));
            continue;
        }
        const double share = static_cast<double>(geometry.residualPx) / kResidualScalePx;
        shapes.lines.push_back(
            {point(match.rimPx), point(geometry.contourPx), isKept ? scaleColour(share) : kRefused, !isKept});
    }
    shapes.dots.push_back(std::move(unmatched));
}

/// Where the observed silhouette and that of the hands differ, at half the resolution, and how well they agree at full.
void addDifference(const core::Camera& camera, const cv::Mat& observed, const MeshLayer& posed,
                   InspectOverlay& overlay) {
    std::vector<core::PosedSurface> surfaces;
    for (const ViewSurfacePtr& surface : posed.surfaces)
        surfaces.push_back({&surface->verticesInWorld, &surface->triangles});
    const cv::Mat mine = core::renderMask(camera, surfaces);
    if (mine.size() != observed.size())
        return;
    const cv::Mat seen = observed != 0, covered = mine != 0;
    const int both = cv::countNonZero(seen & covered), either = cv::countNonZero(seen | covered);
    overlay.iou = either > 0 ? static_cast<double>(both) / either : std::numeric_limits<double>::quiet_NaN();
    QImage picture((seen.cols + 1) / 2, (seen.rows + 1) / 2, QImage::Format_ARGB32_Premultiplied);
    picture.fill(0);
    for (int y = 0; y < picture.height(); ++y) {
        const auto* seenRow = seen.ptr<unsigned char>(2 * y);
        const auto* coveredRow = covered.ptr<unsigned char>(2 * y);
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x)
            if (seenRow[2 * x] != coveredRow[2 * x])
                row[x] = seenRow[2 * x] ? kMissed : kExtra;
    }
    overlay.field = picture;
}

core::DirectionalDistance reducedDistance(const core::MatchRule& rule) {
    core::DirectionalDistance distance;
    distance.kind = rule.distance;
    distance.tauRad = static_cast<double>(rule.tauRad);
    distance.isSigned = rule.bins.isSigned();
    distance.bins = rule.bins.count();
    distance.lambdaPxPerRad = static_cast<double>(rule.lambdaPxPerRad) / kReduction;
    distance.gatePx = static_cast<double>(rule.gatePx) / kReduction;
    return distance;
}

/// scaleColour in 256 steps, for pictures.
QRgb scaleRgb(double share) {
    static const auto steps = [] {
        std::array<QRgb, 256> colours{};
        for (std::size_t i = 0; i < colours.size(); ++i)
            colours[i] = scaleColour(static_cast<double>(i) / (colours.size() - 1)).rgba();
        return colours;
    }();
    return steps[static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * (steps.size() - 1) + 0.5)];
}

/// The cost of a rim point at every pixel, where the method would keep it; clear where it would not.
QImage fieldPicture(const core::CameraTarget& target, const core::MatchRule& rule, const core::Camera& camera,
                    double angleRad) {
    core::OrientedContour reduced = target.contour;
    for (std::size_t q = 0; q < reduced.size(); ++q) {
        reduced.x[q] /= kReduction;
        reduced.y[q] /= kReduction;
    }
    const cv::Rect region(0, 0, camera.size.width / kReduction, camera.size.height / kReduction);
    constexpr double kRefusedCost = 1e6;
    const cv::Mat cost = core::chamferField(reduced, reducedDistance(rule), {core::PenaltyKind::Absolute, kRefusedCost},
                                            region, angleRad);
    QImage picture(region.width, region.height, QImage::Format_ARGB32_Premultiplied);
    picture.fill(0);
    for (int y = 0; y < region.height; ++y) {
        const auto* from = cost.ptr<float>(y);
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < region.width; ++x)
            if (static_cast<double>(from[x]) < kRefusedCost / 2)
                row[x] = scaleRgb(static_cast<double>(from[x]) * kReduction / kFieldScalePx);
    }
    return picture;
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
            return {&trace->targets[v], &(*cameras)[v].matches};
    return {};
}

InspectOverlay inspectOverlay(const MethodOutcome& method, const core::Camera& camera, int cameraIndex, int iteration,
                              const std::set<InspectLayer>& shown, const MeshLayer& posed, double fieldAngleRad) {
    InspectOverlay overlay;
    const auto [target, matches] = shownMatches(method, cameraIndex, iteration);
    if (!target)
        return overlay;
    if (shown.count(InspectLayer::Field) && !method.isFixed)
        overlay.field = fieldPicture(*target, core::matchRule(core::parseMethod(method.method)), camera, fieldAngleRad);
    if (shown.count(InspectLayer::Difference))
        addDifference(camera, target->mask, posed, overlay);
    if (shown.count(InspectLayer::Contour))
        addContour(target->contour, overlay.shapes);
    if (shown.count(InspectLayer::Rim))
        addRim(*matches, overlay.shapes);
    if (shown.count(InspectLayer::Matches))
        addMatches(target->contour, *matches, overlay.shapes);
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

std::optional<float> rimAngleAt(const ShownMatches& shown, QPointF px) {
    std::optional<float> angle;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; shown.matches && i < shown.matches->size(); ++i) {
        const core::MatchRecord& match = (*shown.matches)[i];
        const QPointF offset = point(match.rimPx) - px;
        const double distance = std::hypot(offset.x(), offset.y());
        if (distance < nearest) {
            nearest = distance;
            angle = match.rimAngleRad;
        }
    }
    return angle;
}

} // namespace widgets
