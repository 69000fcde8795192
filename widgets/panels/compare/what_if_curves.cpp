// SPDX-License-Identifier: MIT
// The curves of the error over what is dragged.
#include <algorithm>
#include <cmath>

#include "core/fitting/method_name.h"
#include "widgets/panels/compare/what_if_panel.h"
#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/text/local_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

/// Where the curve has what is set now.
double WhatIfPanel::place(const std::string& key, const std::string& method) const {
    if (key == kNoiseKey)
        return m_noise->value();
    if (key == kCamerasKey)
        return static_cast<double>(
            std::count_if(m_cameras.begin(), m_cameras.end(), [](const QCheckBox* box) { return box->isChecked(); }));
    return key.empty() ? std::nan("") : optionValue(core::parseMethod(method), key);
}

QString WhatIfPanel::heldText() const {
    const auto& dataset = m_datasets.dataset();
    if (m_key.empty() || !dataset)
        return {};
    WhatIfCase held = currentCase();
    if (m_key == kNoiseKey)
        held.outlineNoisePx = 0;
    if (m_key == kCamerasKey)
        held.cameras.clear();
    QStringList parts;
    if (m_key == kNoiseKey && m_draw->value() > 0)
        parts << tr("Draw %1").arg(m_draw->value());
    if (const QString text = caseText(held, dataset->cameras); !text.isEmpty())
        parts << tr("Of all points: %1").arg(text);
    if (m_key != kCamerasKey)
        return parts.join(QLatin1Char('\n'));
    for (const auto& [count, cameras] : m_cameraSets) {
        QStringList names;
        for (std::size_t camera = 0; camera < cameras.size(); ++camera)
            if (cameras[camera])
                names << QString::fromStdString(dataset->cameras[camera].name);
        if (count < static_cast<double>(m_cameras.size()))
            parts << tr("%1: %2").arg(QLocale().toString(count), names.join(QStringLiteral(", ")));
    }
    return parts.join(QLatin1Char('\n'));
}

/// What is known already stands on the curve from the start: of columns whose settings, and of a case that is the
/// pair's own but for what is dragged.
void WhatIfPanel::startCurve(const std::string& key) {
    m_key = key;
    m_points.clear();
    m_cameraSets.clear();
    WhatIfCase held = currentCase();
    if (key == kNoiseKey)
        held.outlineNoisePx = 0, held.draw = 0;
    if (key == kCamerasKey)
        held.cameras.clear();
    for (const std::string& column : methodColumns()) {
        const MethodOutcome* outcome = fitted(column);
        const std::string curve = withoutOption(column, key);
        if (key.empty() || held != WhatIfCase() || !outcome || curve != withoutOption(tried(column), key))
            continue;
        WhatIfTrial known{column, {}, column, key, 0};
        known.x = key == kNoiseKey     ? 0
                  : key == kCamerasKey ? static_cast<double>(m_cameras.size())
                                       : optionValue(core::parseMethod(column), key);
        addPoint(known, outcome->errorMm);
    }
    CurvePlotSettings settings;
    settings.xLabel = key == kCamerasKey ? tr("Cameras")
                      : key == kNoiseKey ? tr("Noise of the outlines, px")
                                         : QString::fromStdString(key);
    settings.xWhole = key == kCamerasKey;
    settings.yLabel = tr("Error, mm");
    settings.emptyText = tr("Drag a setting: the error over it appears here.");
    m_plot->setSettings(settings);
    showCurves();
}

/// A number of cameras means one set of them: points of another set go.
void WhatIfPanel::addPoint(const WhatIfTrial& trial, double errorMm) {
    if (m_key.empty() || !std::isfinite(errorMm) || !std::isfinite(trial.x))
        return;
    if (m_key == kCamerasKey) {
        std::vector<bool> cameras = trial.what.cameras;
        cameras.resize(m_cameras.size(), true);
        if (std::vector<bool>& set = m_cameraSets[trial.x]; set != cameras) {
            set = cameras;
            for (auto& [curve, points] : m_points)
                points.erase(trial.x);
        }
    }
    m_points[withoutOption(trial.method, m_key)][trial.x] = errorMm;
}

/// In the order of the columns, the real-time variant last.
void WhatIfPanel::showCurves() {
    std::vector<Curve> curves;
    const auto add = [&](const std::string& name, const QColor& colour, bool isDashed) {
        const auto points = m_points.find(name);
        const QString title = QString::fromStdString(name);
        const bool isThere =
            std::any_of(curves.begin(), curves.end(), [&](const Curve& curve) { return curve.name == title; });
        if (points == m_points.end() || isThere)
            return;
        Curve curve{title, colour, isDashed, true, {}};
        for (const auto& [x, errorMm] : points->second)
            curve.points.emplace_back(x, errorMm);
        curves.push_back(std::move(curve));
    };
    const std::vector<std::string> names = methodColumns();
    for (std::size_t column = 0; column < m_columns.count(); ++column)
        if (const std::string id = columnId(m_columns.columns()[column]);
            std::find(names.begin(), names.end(), id) != names.end())
            add(withoutOption(tried(id), m_key), m_columns.colour(column), false);
    for (const auto& [name, points] : m_points)
        add(name, methodColour(name), true);
    m_plot->setCurves(curves);
    m_plot->setCursor(m_base.empty() ? std::nan("") : place(m_key, tried(m_base)));
    m_held->setText(heldText());
    m_held->setVisible(!m_held->text().isEmpty());
}

} // namespace widgets
