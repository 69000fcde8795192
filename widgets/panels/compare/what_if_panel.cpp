// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/what_if_panel.h"

#include <algorithm>
#include <cmath>

#include <QSignalBlocker>

#include "core/fitting/match_rule.h"
#include "core/fitting/method_name.h"
#include "core/fitting/method_options.h"
#include "core/text/number_text.h"
#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/text/local_text.h"
#include "widgets/text/method_text.h"
#include "widgets/views/joint_colours.h"
#include "widgets/views/method_chip.h"

namespace widgets {

namespace {

/// The real-time variant, from one start: others take many times longer, and the method itself looks at them
/// afterwards.
constexpr const char* kLive = "best:live=1:restarts=0";
constexpr const char* kWithoutKey = "without"; ///< a camera, whose index is the place

bool isBest(const std::string& method) {
    return method.substr(0, method.find(':')) == "best";
}

/// The real-time variant with the same settings.
std::string liveOf(const std::string& method) {
    core::Method live = core::parseMethod(method);
    if (!live.best)
        return kLive;
    live.best->live = true;
    live.best->restarts = false;
    return core::methodName(live);
}

/// What an option is in a method, with the method's own defaults; NaN without that option, or without a gate.
double optionValue(const core::Method& method, const std::string& key) {
    for (const core::MethodOption& option : core::methodOptions()) {
        if (option.key != key || !option.appliesTo(method))
            continue;
        if (key == "bins")
            return core::matchRule(method).bins.count();
        const auto gatePx = static_cast<double>(core::matchRule(method).gatePx);
        if (key == "gate")
            return std::isfinite(gatePx) ? gatePx : std::nan("");
        const std::string text = option.print(method);
        double value = 0;
        if (option.domain.isNumber())
            return core::parseNumber(text, value) ? value : std::nan("");
        return text == option.domain.words[1] ? 1 : 0;
    }
    return std::nan("");
}

QString millimetres(double mm) {
    return WhatIfPanel::tr("%1 mm").arg(localNumber(mm, 2));
}

} // namespace

void WhatIfPanel::showColumn(std::size_t column) {
    if (column >= m_columns.count() || m_columns.columns()[column].kind != InspectColumn::Kind::Method)
        return;
    m_column->setCurrentIndex(m_column->findData(QString::fromStdString(m_columns.columns()[column].name)));
}

/// The columns have changed: what is changed here stays, if its column does.
void WhatIfPanel::takeColumns() {
    QStringList methods;
    for (const InspectColumn& column : m_columns.columns())
        if (column.kind == InspectColumn::Kind::Method && methodProblem(QString::fromStdString(column.name)).isEmpty())
            methods << QString::fromStdString(column.name);
    QStringList before;
    for (int i = 0; i < m_column->count(); ++i)
        before << m_column->itemData(i).toString();
    m_hint->setVisible(methods.isEmpty());
    m_content->setVisible(!methods.isEmpty());
    if (methods != before) {
        const QSignalBlocker blocker(m_column);
        m_column->clear();
        for (const QString& method : methods)
            m_column->addItem(methodChip(method.toStdString()), method, method);
        const QString next = QString::fromStdString(methods.contains(QString::fromStdString(m_next)) ? m_next : m_base);
        m_column->setCurrentIndex(std::max(0, methods.indexOf(next)));
        if (next != QString::fromStdString(m_base))
            m_next.clear();
        makeCameraBoxes();
    }
    const bool isOther = m_fits.outcome() && !(m_pair && isSamePair(*m_pair, *m_fits.outcome()));
    if (m_fits.outcome())
        m_pair = m_fits.outcome();
    if (isOther && isVisible())
        m_runner.prepare();
    if (const std::string chosen = m_column->currentData().toString().toStdString(); chosen != m_base || isOther) {
        m_base = chosen; // of another pair, nothing stays
        goBack();
    } else if (!m_columns.hasPreviews()) {
        m_columns.setPreviews(m_previews, m_circumstances); // the columns have changed, what is tried has not
    }
    showSweep();
}

void WhatIfPanel::makeCameraBoxes() {
    const auto& dataset = m_datasets.dataset();
    const std::size_t count = dataset ? dataset->cameras.size() : 0;
    bool isSame = m_cameras.size() == count;
    for (std::size_t c = 0; isSame && c < count; ++c)
        isSame = m_cameras[c]->objectName().toStdString() == dataset->cameras[c].name;
    if (isSame)
        return;
    qDeleteAll(m_cameras);
    m_cameras.clear();
    m_without.clear();
    constexpr int kAcross = 2;
    for (std::size_t c = 0; c < count; ++c) {
        const QString name = QString::fromStdString(dataset->cameras[c].name);
        auto* box = new QCheckBox(name, this);
        box->setObjectName(name);
        box->setChecked(true);
        box->setFocusPolicy(Qt::NoFocus);
        box->setToolTip(tr("Whether this camera's silhouette takes part"));
        m_cameraGrid->addWidget(box, static_cast<int>(c) / kAcross, static_cast<int>(c) % kAcross);
        connect(box, &QCheckBox::toggled, this, [this] { explore(kCamerasKey); });
        m_cameras.push_back(box);
    }
}

void WhatIfPanel::takeLine() {
    const QString written = m_line->text().trimmed();
    const QString problem = methodProblem(written);
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_apply->setEnabled(problem.isEmpty());
    m_add->setEnabled(problem.isEmpty());
    if (!problem.isEmpty())
        return;
    m_form->setMethod(written.toStdString());
    explore({});
}

void WhatIfPanel::edit(const std::string& key) {
    const QSignalBlocker blocker(m_line);
    m_line->setText(QString::fromStdString(m_form->method()));
    m_problem->hide();
    m_apply->setEnabled(true);
    m_add->setEnabled(true);
    explore(key);
}

WhatIfCase WhatIfPanel::currentCase() const {
    WhatIfCase what;
    for (const QCheckBox* box : m_cameras)
        what.cameras.push_back(box->isChecked());
    what.outlineNoisePx = m_noise->value();
    return what;
}

/// Where the curve has what is set now.
double WhatIfPanel::place(const std::string& key) const {
    if (key == kNoiseKey)
        return m_noise->value();
    if (key == kCamerasKey)
        return static_cast<double>(
            std::count_if(m_cameras.begin(), m_cameras.end(), [](const QCheckBox* box) { return box->isChecked(); }));
    return optionValue(core::parseMethod(m_form->method()), key);
}

const MethodOutcome* WhatIfPanel::fitted(const std::string& method) const {
    if (m_fits.outcome())
        for (const MethodOutcome& outcome : m_fits.outcome()->methods)
            if (outcome.method == method)
                return &outcome;
    return nullptr;
}

/// The method with the value that the form has for an option; empty if it has no such option.
std::string WhatIfPanel::withOption(const std::string& method, const std::string& key) const {
    core::Method parsed = core::parseMethod(method);
    const core::Method mine = core::parseMethod(m_form->method());
    for (const core::MethodOption& option : core::methodOptions()) {
        if (option.key != key || !option.appliesTo(parsed))
            continue;
        const std::string text = option.print(mine);
        const core::Method plain = core::parseMethod(method.substr(0, method.find(':')));
        if (text != option.print(plain) || text != option.print(parsed))
            option.parse(parsed, text);
        return core::methodName(parsed);
    }
    return {};
}

/// The quick ones first: the real-time variant where it has the parameter, then the column, then the other columns.
std::vector<WhatIfTrial> WhatIfPanel::trialsOf(const std::string& key) const {
    const bool isOfPair = key == kCamerasKey || key == kNoiseKey;
    const double x = place(key);
    const std::string mine = m_form->method();
    const WhatIfCase what = currentCase();
    std::vector<WhatIfTrial> trials;
    const std::string live = liveOf(mine);
    if ((isOfPair || isBest(mine)) && live != mine)
        trials.push_back({live, what, isBest(mine) ? m_base : std::string(), key, x, true});
    trials.push_back({mine, what, m_base, key, x, live == mine});
    for (const InspectColumn& column : m_columns.columns()) {
        if (key.empty() || column.kind != InspectColumn::Kind::Method || column.name == m_base)
            continue;
        const std::string method = isOfPair ? column.name : withOption(column.name, key);
        if (!method.empty())
            trials.push_back({method, what, column.name, key, x});
    }
    return trials;
}

/// Whether all else is as it was fitted: only then do the fits of before belong to the curve.
bool WhatIfPanel::isOnlyChange(const std::string& key) const {
    const WhatIfCase what = currentCase();
    const bool hasAll = std::find(what.cameras.begin(), what.cameras.end(), false) == what.cameras.end();
    if ((key != kCamerasKey && !hasAll) || (key != kNoiseKey && what.outlineNoisePx > 0))
        return false;
    const std::string mine = m_form->method();
    return key == kCamerasKey || key == kNoiseKey ? mine == m_base : withOption(m_base, key) == mine;
}

void WhatIfPanel::explore(const std::string& key) {
    if (m_base.empty() || !fitted(m_base))
        return;
    const WhatIfCase what = currentCase();
    if (std::find(what.cameras.begin(), what.cameras.end(), true) == what.cameras.end()) {
        m_answer->setText(tr("Leave at least one camera on."));
        return;
    }
    if (key != m_key)
        startCurve(key);
    m_isSweeping = false; // what waits is forgotten
    showSweep();
    m_answer->setText(tr("Fitting..."));
    m_runner.run(trialsOf(key));
}

/// What is known already stands on the curve from the start.
void WhatIfPanel::startCurve(const std::string& key) {
    m_key = key;
    m_points.clear();
    const bool isOfPair = key == kCamerasKey || key == kNoiseKey;
    for (const InspectColumn& column : m_columns.columns()) {
        const MethodOutcome* outcome = column.kind == InspectColumn::Kind::Method ? fitted(column.name) : nullptr;
        if (!outcome || std::isnan(outcome->errorMm) || key.empty() || !isOnlyChange(key))
            continue;
        if (isOfPair) {
            m_points[column.name][key == kNoiseKey ? 0 : static_cast<double>(m_cameras.size())] = outcome->errorMm;
            continue;
        }
        if (const double x = optionValue(core::parseMethod(column.name), key); std::isfinite(x))
            m_points[column.name][x] = outcome->errorMm;
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

void WhatIfPanel::take(const WhatIfTrial& trial, const MethodOutcome& outcome) {
    if (!trial.curve.empty()) {
        takeSwept(trial, outcome);
        return;
    }
    if (!outcome.failure.isEmpty()) {
        m_answer->setText(outcome.failure);
        return;
    }
    if (trial.key == kWithoutKey) {
        m_without[static_cast<int>(trial.x)] = outcome.errorMm;
        showCameraTexts();
        return;
    }
    if (trial.key != m_key)
        return; // of what was dragged before
    const bool isLive = trial.column.empty() || (trial.column == m_base && trial.method != m_form->method());
    const bool isAnswer = trial.column == m_base && !isLive;
    const std::string curve = isLive ? kLive : trial.column;
    if (!m_key.empty() && std::isfinite(outcome.errorMm) && std::isfinite(trial.x))
        m_points[curve][trial.x] = outcome.errorMm;
    showCurves();
    if (isAnswer) {
        const MethodOutcome* before = fitted(m_base);
        m_answer->setText(before && std::isfinite(before->errorMm)
                              ? tr("%1 instead of %2").arg(millimetres(outcome.errorMm), millimetres(before->errorMm))
                              : QString());
    }
    if (!trial.column.empty()) {
        m_previews[trial.column] = outcome;
        m_circumstances = circumstancesText(trial.what, m_datasets.dataset()->cameras);
        m_columns.setPreviews(m_previews, m_circumstances);
    }
    emit answered(trial.isLive);
}

void WhatIfPanel::showCurves() {
    std::vector<Curve> curves;
    for (const auto& [name, points] : m_points) {
        Curve curve{QString::fromStdString(name), methodColour(name), name == kLive, true, {}};
        for (std::size_t column = 0; column < m_columns.count(); ++column)
            if (columnId(m_columns.columns()[column]) == name)
                curve.colour = m_columns.colour(column);
        for (const auto& [x, errorMm] : points)
            curve.points.emplace_back(x, errorMm);
        curves.push_back(std::move(curve));
    }
    m_plot->setCurves(curves);
    m_plot->setCursor(m_key.empty() ? std::nan("") : place(m_key));
}

void WhatIfPanel::showCameraTexts() {
    const MethodOutcome* all = fitted(m_base);
    for (std::size_t c = 0; c < m_cameras.size(); ++c) {
        const auto without = m_without.find(static_cast<int>(c));
        QString text = m_cameras[c]->objectName();
        if (without != m_without.end() && all) {
            const double adds = without->second - all->errorMm;
            text = tr("%1: %2").arg(text, (adds >= 0 ? QStringLiteral("+") : QString()) + millimetres(adds));
        }
        m_cameras[c]->setText(text);
    }
}

void WhatIfPanel::measureCameras() {
    if (m_base.empty() || m_cameras.size() < 2)
        return;
    m_without.clear();
    showCameraTexts();
    std::vector<WhatIfTrial> trials;
    for (std::size_t c = 0; c < m_cameras.size(); ++c) {
        WhatIfTrial without{
            m_base, {std::vector<bool>(m_cameras.size(), true), 0}, {}, kWithoutKey, static_cast<double>(c)};
        without.what.cameras[c] = false;
        trials.push_back(without);
    }
    m_isSweeping = false;
    showSweep();
    m_answer->setText(tr("Fitting without each camera..."));
    m_runner.run(trials);
}

void WhatIfPanel::apply() {
    const std::string method = m_form->method(), base = m_base;
    goBack();
    for (std::size_t column = 0; column < m_columns.count(); ++column) {
        if (columnId(m_columns.columns()[column]) == base) {
            m_next = method; // once it is fitted
            m_columns.replace(column, method);
            return;
        }
    }
}

void WhatIfPanel::addColumn() {
    const std::string method = m_form->method();
    goBack();
    m_next = method;
    m_columns.add({InspectColumn::Kind::Method, method});
}

void WhatIfPanel::goBack() {
    m_runner.stop();
    m_isSweeping = false;
    m_previews.clear();
    m_key.clear();
    for (QCheckBox* box : m_cameras) {
        const QSignalBlocker blocker(box);
        box->setChecked(true);
    }
    {
        const QSignalBlocker noise(m_noise), slider(m_noiseSlider);
        m_noise->setValue(0);
        m_noiseSlider->setValue(0);
    }
    m_without.clear();
    showCameraTexts();
    if (!m_base.empty()) {
        m_form->setMethod(m_base);
        m_line->setText(QString::fromStdString(m_base));
    }
    m_problem->hide();
    m_answer->clear();
    startCurve({});
    showSweep();
    m_columns.setPreviews({});
}

} // namespace widgets
