// SPDX-License-Identifier: MIT
#include "app/desktop/script/inspect_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QJsonArray>

#include "app/desktop/main_window.h"
#include "app/desktop/script/comparison_report.h"
#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/step_fields.h"
#include "core/error.h"
#include "widgets/text/error_text.h"
#include "widgets/text/local_text.h"
#include "widgets/views/picture_export.h"
#include "widgets/workspaces/inspect_film.h"
#include "widgets/workspaces/inspect_picture.h"

namespace app {

namespace {

constexpr int kFilmMs = 10 * 60 * 1000;

core::Error impossible(const char* field, const QString& why) {
    return {core::ErrorCode::Usage, {}, field, why.toStdString()};
}

double degrees(float rad) {
    return static_cast<double>(rad) * 180 / std::numbers::pi;
}

QJsonValue numberOrNull(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

QJsonValue pointOrNull(const Eigen::Vector2f& px) {
    if (!px.allFinite())
        return {};
    return QJsonArray{static_cast<double>(px.x()), static_cast<double>(px.y())};
}

widgets::InspectPage& fittedPage(MainWindow& window) {
    if (!window.session().fits.outcome())
        throw impossible("do", QStringLiteral("nothing was fitted yet"));
    return *window.workspaces().inspectPage();
}

/// What a step's "method" and "camera" mean.
struct MatchesOfStep {
    const widgets::MethodOutcome* method = nullptr;
    widgets::ShownMatches shown;
};
MatchesOfStep matchesOf(MainWindow& window, const QJsonObject& step) {
    const widgets::InspectPage& page = fittedPage(window);
    const QString method = textField(step, "method"), camera = textField(step, "camera");
    const auto isMethod = [&](const widgets::MethodOutcome& candidate) {
        return QString::fromStdString(candidate.method) == method;
    };
    const auto& fitted = window.session().fits.outcome()->methods;
    const auto known = std::find_if(fitted.begin(), fitted.end(), isMethod);
    if (known == fitted.end())
        throw impossible("method", QStringLiteral("\"%1\" was not fitted").arg(method));
    const auto& cameras = window.session().opened.dataset()->cameras;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        if (QString::fromStdString(cameras[c].name) != camera)
            continue;
        const auto& columns = page.columns()->outcome()->methods;
        const auto column = std::find_if(columns.begin(), columns.end(), isMethod);
        const widgets::MethodOutcome& asked = column == columns.end() ? *known : *column; // fitted, and no column
        return {&asked, widgets::shownMatches(asked, static_cast<int>(c), page.iteration())};
    }
    throw impossible("camera", QStringLiteral("unknown camera \"%1\"").arg(camera));
}

/// Adds "hand" and "bone": what moves the rim point most.
void addBone(const core::MatchRecord& match, const std::vector<core::HandModel>& hands, QJsonObject& row) {
    const auto bone = widgets::rimBone(match, hands);
    row[QStringLiteral("hand")] = bone ? QJsonValue(widgets::toQString(core::sideName(bone->hand))) : QJsonValue();
    row[QStringLiteral("bone")] = bone ? QJsonValue(QString::fromStdString(bone->joint)) : QJsonValue();
}

/// Pins the probe in the view of a method and a camera.
void pinProbe(MainWindow& window, const QString& method, const QString& camera, QPointF px) {
    const widgets::InspectPage& page = fittedPage(window);
    const auto& cameras = window.session().opened.dataset()->cameras;
    for (int view = 0; view < page.grid()->count(); ++view) {
        const auto& column = page.columns()->columns()[page.views()->columnOf(view)];
        const int shown = page.views()->cameraOf(view);
        if (shown >= 0 && QString::fromStdString(cameras[static_cast<std::size_t>(shown)].name) == camera &&
            QString::fromStdString(column.name) == method) {
            page.probePin()->pin(view, px);
            return;
        }
    }
    throw impossible("pin", QStringLiteral("no view of the method and the camera is shown"));
}

} // namespace

QJsonObject showIteration(MainWindow& window, const QJsonObject& step) {
    widgets::InspectPage& page = fittedPage(window);
    const int to = intField(step, "to");
    if (to < 0 || to > page.lastIteration())
        throw impossible("to", QStringLiteral("%1 is not within 0..%2").arg(to).arg(page.lastIteration()));
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    page.setIteration(to);
    return {};
}

QJsonObject showLayer(MainWindow& window, const QJsonObject& step) {
    const QString id = textField(step, "id");
    const auto layer = widgets::inspectLayerOf(id);
    if (!layer)
        throw impossible("id", QStringLiteral("unknown layer \"%1\"").arg(id));
    const QJsonValue on = step.value(QLatin1String("on"));
    if (!on.isBool())
        throw impossible("on", QStringLiteral("expected true or false"));
    widgets::InspectOverlays* overlays = fittedPage(window).overlays();
    if (step.contains(QLatin1String("of"))) {
        const auto choice = widgets::matchChoiceOf(textField(step, "of"));
        if (!choice)
            throw impossible("of", QStringLiteral("expected distance, finger, thumb, index, middle, ring, little or "
                                                  "palm"));
        overlays->setMatchChoice(*choice);
    }
    overlays->setShown(*layer, on.toBool());
    return {};
}

QJsonObject printMatches(MainWindow& window, const QJsonObject& step) {
    const widgets::ShownMatches shown = matchesOf(window, step).shown;
    const auto& hands = window.session().opened.dataset()->hands;
    QJsonArray matches;
    for (std::size_t i = 0; shown.matches && i < shown.matches->size(); ++i) {
        const core::MatchRecord& match = (*shown.matches)[i];
        const core::MatchGeometry geometry = core::matchGeometry(match, shown.target->contour);
        QJsonObject row;
        row[QStringLiteral("p")] = pointOrNull(match.rimPx);
        row[QStringLiteral("q")] = pointOrNull(geometry.contourPx);
        row[QStringLiteral("phiDeg")] = degrees(match.rimAngleRad);
        row[QStringLiteral("contourPhiDeg")] = numberOrNull(degrees(geometry.contourAngleRad));
        row[QStringLiteral("residualPx")] = numberOrNull(static_cast<double>(geometry.residualPx));
        row[QStringLiteral("weight")] = static_cast<double>(match.weight);
        row[QStringLiteral("kept")] = match.verdict == core::MatchVerdict::Kept;
        row[QStringLiteral("reason")] = widgets::toQString(core::matchVerdictName(match.verdict));
        addBone(match, hands, row);
        matches.append(row);
    }
    return {{QStringLiteral("method"), textField(step, "method")},
            {QStringLiteral("camera"), textField(step, "camera")},
            {QStringLiteral("iteration"), window.workspaces().inspectPage()->iteration()},
            {QStringLiteral("matches"), matches}};
}

QJsonObject probeAt(MainWindow& window, const QJsonObject& step) {
    const MatchesOfStep of = matchesOf(window, step);
    const QPointF px = pointField(step, "px");
    const auto row = of.method ? widgets::ownProbeRow(*of.method, of.shown, px) : std::nullopt;
    if (!row)
        throw impossible("camera", QStringLiteral("the method has no rim points there"));
    QJsonObject answer;
    answer[QStringLiteral("nearest")] =
        row->found() ? QJsonValue(QJsonArray{row->contourPx.x(), row->contourPx.y()}) : QJsonValue();
    answer[QStringLiteral("distancePx")] = numberOrNull(row->probe.distancePx);
    answer[QStringLiteral("phiDeg")] = degrees(row->rimAngleRad);
    answer[QStringLiteral("contourPhiDeg")] = row->found() ? QJsonValue(degrees(row->contourAngleRad)) : QJsonValue();
    answer[QStringLiteral("bin")] = row->probe.bin;
    answer[QStringLiteral("cost")] = numberOrNull(row->probe.cost);
    answer[QStringLiteral("kept")] = row->kept();
    answer[QStringLiteral("reason")] = widgets::toQString(core::matchVerdictName(row->probe.verdict));
    addBone(*widgets::nearestRimPoint(of.shown, px), window.session().opened.dataset()->hands, answer);
    if (step.value(QLatin1String("pin")).toBool())
        pinProbe(window, textField(step, "method"), textField(step, "camera"), px);
    return answer;
}

QJsonObject saveReport(MainWindow& window, const QString& path) {
    fittedPage(window);
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    waitUntilIdle(window);
    saveComparisonReport(window, path.toStdString());
    return {{QStringLiteral("path"), path}};
}

QJsonObject saveFilm(MainWindow& window, const QString& path) {
    fittedPage(window);
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    waitUntilIdle(window);
    auto* film = window.findChild<widgets::InspectFilm*>();
    QString error;
    bool ended = false;
    QObject scope;
    QObject::connect(film, &widgets::InspectFilm::finished, &scope, [&] { ended = true; });
    QObject::connect(film, &widgets::InspectFilm::stopped, &scope, [&] {
        error = QStringLiteral("it was stopped");
        ended = true;
    });
    QObject::connect(film, &widgets::InspectFilm::failed, &scope, [&](const QString& message) {
        error = widgets::withDetailBehind(message);
        ended = true;
    });
    film->save(path);
    waitFor(
        window, [&ended] { return ended; }, kFilmMs);
    if (!ended || !error.isEmpty())
        throw impossible("path", ended ? error : QStringLiteral("no answer in time"));
    return {{QStringLiteral("path"), path}};
}

QJsonObject saveComparison(MainWindow& window, const QString& path) {
    const widgets::InspectPage& page = fittedPage(window);
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    waitUntilIdle(window);
    if (!widgets::savePicture(widgets::comparisonSource(page), path))
        throw impossible("path", QStringLiteral("\"%1\" could not be written").arg(path));
    return {{QStringLiteral("path"), path}};
}

} // namespace app
