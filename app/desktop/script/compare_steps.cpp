// SPDX-License-Identifier: MIT
#include "app/desktop/script/compare_steps.h"

#include <algorithm>
#include <cmath>

#include <QElapsedTimer>
#include <QEvent>
#include <QJsonArray>
#include <QTimer>

#include "app/desktop/main_window.h"
#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/step_fields.h"
#include "core/error.h"
#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/text/error_text.h"
#include "widgets/text/method_text.h"

namespace app {

namespace {

core::Error notPossible(const char* field, const QString& why) {
    return {core::ErrorCode::Usage, {}, field, why.toStdString()};
}

widgets::InspectPage& pageWithFit(MainWindow& window) {
    if (!window.session().fits.outcome())
        throw notPossible("do", QStringLiteral("nothing was fitted yet"));
    return *window.workspaces().inspectPage();
}

void readTrackers(MainWindow& window, const QJsonArray& trackers) {
    widgets::InspectColumns* columns = window.workspaces().inspectPage()->columns();
    for (const QJsonValue& value : trackers) {
        QString error;
        QObject scope;
        QObject::connect(columns, &widgets::InspectColumns::failed, &scope,
                         [&](const QString& message) { error = widgets::withDetailBehind(message); });
        columns->addTracker(textField(value.toObject(), "name").toStdString(), textField(value.toObject(), "file"));
        waitUntilIdle(window);
        if (!error.isEmpty())
            throw notPossible("trackers", error);
    }
}

void showColumns(MainWindow& window, const QStringList& ids) {
    widgets::InspectColumns* columns = window.workspaces().inspectPage()->columns();
    std::vector<widgets::InspectColumn> wanted;
    for (const QString& id : ids) {
        const widgets::InspectColumn column = widgets::columnOf(id.toStdString());
        if (column.kind == widgets::InspectColumn::Kind::Method) {
            if (const QString problem = widgets::methodProblem(id); !problem.isEmpty())
                throw notPossible("show", problem);
        } else if (!columns->isAvailable(column)) {
            throw notPossible("show", QStringLiteral("\"%1\" is not there").arg(id));
        }
        wanted.push_back(column);
    }
    columns->setColumns(wanted);
    waitUntilIdle(window);
    waitFor(window, [&] { return !window.workspaces().whatIfPanel()->isRunning(); }); // what is tried, in new columns
}

void showCameras(MainWindow& window, const QStringList& names) {
    std::vector<std::string> cameras;
    for (const QString& name : names) {
        cameras.push_back(name.toStdString());
        if (window.session().opened.dataset()->cameraIndex(cameras.back()) < 0)
            throw notPossible("cameras", QStringLiteral("unknown camera \"%1\"").arg(name));
    }
    window.workspaces().inspectPage()->views()->chooseCameras(cameras);
}

/// How long it takes from now until the views show what the real-time variant found, and nothing of it is still to be
/// painted.
class LiveClock : public QObject {
public:
    LiveClock(const widgets::InspectPage& page, widgets::WhatIfPanel& panel) {
        m_sinceWish.start();
        for (widgets::CameraView* view : page.grid()->views())
            view->viewport()->installEventFilter(this);
        connect(&panel, &widgets::WhatIfPanel::answered, this, [this](bool isLive) { m_isLive = isLive; });
    }

    /// NaN if no view showed it.
    double liveMs() const { return m_liveMs; }
    /// Nothing has been painted since for a while.
    bool isSettled() const { return m_liveMs + kSettledMs < static_cast<double>(m_sinceWish.elapsed()); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint && m_isLive)
            QTimer::singleShot(0, this, [this] { m_liveMs = static_cast<double>(m_sinceWish.nsecsElapsed()) / 1e6; });
        return QObject::eventFilter(watched, event);
    }

private:
    static constexpr double kSettledMs = 60;
    QElapsedTimer m_sinceWish;
    bool m_isLive = false; ///< it has answered last
    double m_liveMs = std::nan("");
};

QJsonObject pointsOf(const widgets::WhatIfPanel& panel) {
    QJsonObject points;
    for (const auto& [method, curve] : panel.points()) {
        QJsonArray list;
        for (const auto& [x, errorMm] : curve)
            list.append(QJsonArray{x, errorMm});
        points[QString::fromStdString(method)] = list;
    }
    return points;
}

double matchBytes(const widgets::FitOutcome& outcome) {
    std::size_t bytes = 0;
    for (const widgets::MethodOutcome& method : outcome.methods)
        for (const core::FitIteration& step : method.result.history)
            for (std::size_t c = 0; step.matchRecords && c < step.matchRecords->size(); ++c)
                bytes += (*step.matchRecords)[c].matches.capacity() * sizeof(core::MatchRecord);
    return static_cast<double>(bytes);
}

} // namespace

QJsonObject chooseColumns(MainWindow& window, const QJsonObject& step) {
    pageWithFit(window);
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Inspect);
    if (step.contains(QLatin1String("trackers")))
        readTrackers(window, step.value(QLatin1String("trackers")).toArray());
    if (step.contains(QLatin1String("show")))
        showColumns(window, textsField(step, "show"));
    if (step.contains(QLatin1String("cameras")))
        showCameras(window, step.value(QLatin1String("cameras")).toArray().isEmpty() ? QStringList()
                                                                                     : textsField(step, "cameras"));
    return printColumns(window);
}

QJsonObject printColumns(MainWindow& window) {
    const widgets::InspectPage& page = pageWithFit(window);
    QJsonArray columns, cameras;
    for (std::size_t column = 0; column < page.columns()->count(); ++column) {
        const double errorMm = page.columns()->outcome()->methods[column].errorMm;
        columns.append(QJsonObject{
            {QStringLiteral("id"), QString::fromStdString(widgets::columnId(page.columns()->columns()[column]))},
            {QStringLiteral("errorMm"), std::isfinite(errorMm) ? QJsonValue(errorMm) : QJsonValue()}});
    }
    for (const int camera : page.views()->rowCameras())
        cameras.append(
            QString::fromStdString(window.session().opened.dataset()->cameras[static_cast<std::size_t>(camera)].name));
    return {{QStringLiteral("columns"), columns},
            {QStringLiteral("cameras"), cameras},
            {QStringLiteral("trial"), page.trialText()},
            {QStringLiteral("matchBytes"), matchBytes(*page.columns()->outcome())}};
}

widgets::CameraView& inspectedView(MainWindow& window, const QJsonObject& step) {
    const widgets::InspectPage& page = pageWithFit(window);
    const std::string column = textField(step, "column").toStdString(),
                      camera = textField(step, "camera").toStdString();
    for (int view = 0; view < page.grid()->count(); ++view)
        if (widgets::columnId(page.columns()->columns()[page.views()->columnOf(view)]) == column &&
            page.grid()->view(view)->camera().name == camera)
            return *page.grid()->view(view);
    throw notPossible("column", QStringLiteral("there is no such column, or no such row"));
}

QJsonObject tryWhatIf(MainWindow& window, const QJsonObject& step) {
    const widgets::InspectPage& page = pageWithFit(window);
    widgets::WhatIfPanel* panel = window.workspaces().whatIfPanel();
    window.workspaces().raisePanel(panel);
    if (step.contains(QLatin1String("method"))) {
        const std::string method = textField(step, "method").toStdString();
        const auto& columns = page.columns()->columns();
        const auto found = std::find_if(columns.begin(), columns.end(),
                                        [&](const auto& column) { return widgets::columnId(column) == method; });
        if (found == columns.end())
            throw notPossible("method", QStringLiteral("there is no such column"));
        page.columns()->setCurrent(static_cast<std::size_t>(found - columns.begin()));
        panel->showColumn(static_cast<std::size_t>(found - columns.begin()));
    }
    const LiveClock clock(page, *panel);
    if (step.contains(QLatin1String("camera"))) {
        const QString camera = textField(step, "camera");
        const auto& boxes = panel->cameras();
        const auto box =
            std::find_if(boxes.begin(), boxes.end(), [&](const auto* one) { return one->objectName() == camera; });
        if (box == boxes.end())
            throw notPossible("camera", QStringLiteral("unknown camera \"%1\"").arg(camera));
        (*box)->setChecked(step.value(QLatin1String("on")).toBool());
    }
    if (step.contains(QLatin1String("set"))) {
        const QString key = textField(step, "set");
        const QJsonValue to = step.value(QLatin1String("to"));
        if (!to.isDouble())
            throw notPossible("to", QStringLiteral("expected a number"));
        if (key == QLatin1String("outlines"))
            panel->setOutlineNoisePx(to.toDouble());
        else if (key == QLatin1String("draw"))
            panel->setNoiseDraw(to.toInt());
        else if (panel->form()->hasOption(key.toStdString()))
            panel->form()->setValue(key.toStdString(), to.toDouble());
        else
            throw notPossible("set", QStringLiteral("the method has no option \"%1\"").arg(key));
    }
    if (step.contains(QLatin1String("sweep"))) {
        const std::string key = textField(step, "sweep").toStdString();
        const bool isOfPair = key == widgets::kNoiseKey || key == widgets::kCamerasKey;
        if (!isOfPair && !panel->form()->hasOption(key))
            throw notPossible("sweep",
                              QStringLiteral("the method has no option \"%1\"").arg(QString::fromStdString(key)));
        panel->sweep(key);
    }
    const bool untilLive = step.value(QLatin1String("until")) == QLatin1String("live");
    if (!waitFor(window, [&] {
            return (untilLive && clock.isSettled()) || (!panel->isRunning() && window.session().pool.isIdle());
        }))
        throw notPossible("do", QStringLiteral("no answer in time"));
    QJsonObject answer{{QStringLiteral("points"), pointsOf(*panel)}};
    if (std::isfinite(clock.liveMs()))
        answer[QStringLiteral("liveMs")] = clock.liveMs();
    return answer;
}

} // namespace app
