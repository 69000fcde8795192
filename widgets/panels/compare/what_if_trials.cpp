// SPDX-License-Identifier: MIT
// What the panel has fitted, and what of it the columns show.
#include <algorithm>
#include <cmath>

#include <QSignalBlocker>

#include "core/fitting/method_name.h"
#include "core/fitting/method_options.h"
#include "widgets/panels/compare/what_if_panel.h"
#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/text/local_text.h"
#include "widgets/text/method_text.h"

namespace widgets {

namespace {

constexpr const char* kWithoutKey = "without"; ///< a camera, whose index is the place

bool isBest(const std::string& method) {
    return method.substr(0, method.find(':')) == "best";
}

QString millimetres(double mm) {
    return WhatIfPanel::tr("%1 mm").arg(localNumber(mm, 2));
}

} // namespace

WhatIfCase WhatIfPanel::currentCase() const {
    WhatIfCase what;
    for (const QCheckBox* box : m_cameras)
        what.cameras.push_back(box->isChecked());
    if (std::find(what.cameras.begin(), what.cameras.end(), false) == what.cameras.end())
        what.cameras.clear();
    what.outlineNoisePx = m_noise->value();
    if (what.outlineNoisePx > 0)
        what.draw = m_draw->value();
    return what;
}

void WhatIfPanel::setCase(const WhatIfCase& what) {
    for (std::size_t camera = 0; camera < m_cameras.size(); ++camera) {
        const QSignalBlocker blocker(m_cameras[camera]);
        m_cameras[camera]->setChecked(!what.isLeftOut(camera));
    }
    const QSignalBlocker draw(m_draw), noise(m_noise), slider(m_noiseSlider);
    m_draw->setValue(what.draw);
    m_noise->setValue(what.outlineNoisePx);
    m_noiseSlider->setValue(noiseStep(what.outlineNoisePx));
}

const MethodOutcome* WhatIfPanel::fitted(const std::string& method) const {
    if (m_fits.outcome())
        for (const MethodOutcome& outcome : m_fits.outcome()->methods)
            if (outcome.method == method)
                return &outcome;
    return nullptr;
}

std::vector<std::string> WhatIfPanel::methodColumns() const {
    std::vector<std::string> names;
    for (const InspectColumn& column : m_columns.columns())
        if (column.kind == InspectColumn::Kind::Method && methodProblem(QString::fromStdString(column.name)).isEmpty())
            names.push_back(column.name);
    return names;
}

const std::string& WhatIfPanel::tried(const std::string& column) const {
    const auto found = m_tried.find(column);
    return found == m_tried.end() ? column : found->second;
}

bool WhatIfPanel::isAsFitted(const std::string& column) const {
    return currentCase() == WhatIfCase() && isSameMethod(tried(column), column);
}

bool WhatIfPanel::isUpToDate(const std::string& column) const {
    const auto shown = m_shown.find(column);
    if (isAsFitted(column))
        return shown == m_shown.end();
    return shown != m_shown.end() && shown->second.what == currentCase() &&
           shown->second.outcome.method == tried(column);
}

std::vector<std::string> WhatIfPanel::staleColumns() const {
    std::vector<std::string> stale;
    for (const std::string& column : methodColumns())
        if (!isUpToDate(column))
            stale.push_back(column);
    return stale;
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

/// Those of the form are the column's; other columns have the same value of what is dragged, if they have the option.
void WhatIfPanel::takeSettings(const std::string& key) {
    m_tried[m_base] = m_form->method();
    for (const std::string& column : methodColumns())
        if (const std::string method = column == m_base ? std::string() : withOption(tried(column), key);
            !method.empty() && !isSameMethod(method, tried(column)))
            m_tried[column] = method;
    std::erase_if(
        m_tried, [](const auto& one) { return isSameMethod(one.first, one.second); });
    if (std::erase_if(m_shown, [this](const auto& shown) { return isAsFitted(shown.first); }) > 0)
        showTrial();
}

WhatIfTrial WhatIfPanel::trialOf(const std::string& column) const {
    const std::string& method = tried(column);
    return {method, currentCase(), column, m_key, place(m_key, method), liveVariant(method) == method};
}

/// The quick ones first: the real-time variant where it has the parameter, then the column, then the other columns.
std::vector<WhatIfTrial> WhatIfPanel::trialsOf(const std::string& key) const {
    std::vector<WhatIfTrial> trials;
    const std::string mine = tried(m_base), live = liveVariant(mine);
    if ((isOfPair(key) || isBest(mine)) && live != mine && !isAsFitted(m_base))
        trials.push_back({live, currentCase(), isBest(mine) ? m_base : std::string(), key, place(key, mine), true});
    std::vector<std::string> stale = staleColumns();
    std::stable_partition(stale.begin(), stale.end(), [this](const std::string& column) { return column == m_base; });
    for (const std::string& column : stale)
        trials.push_back(trialOf(column));
    return trials;
}

void WhatIfPanel::explore(const std::string& key) {
    if (m_base.empty() || !fitted(m_base))
        return;
    if (std::none_of(m_cameras.begin(), m_cameras.end(), [](const QCheckBox* box) { return box->isChecked(); })) {
        m_answer->setText(tr("Leave at least one camera on."));
        return;
    }
    m_without.clear();
    showCameraTexts();
    takeSettings(key);
    if (key != m_key)
        startCurve(key);
    m_isSweeping = false; // what waits is forgotten
    showSweep();
    m_answer->setText(isAsFitted(m_base) ? tr("As it was fitted: %1").arg(millimetres(fitted(m_base)->errorMm))
                                         : tr("Fitting..."));
    showCurves();
    m_columns.setTrialComplete(staleColumns().empty());
    m_runner.run(trialsOf(key));
}

/// Other columns, or fits that were put off: what is tried is tried in all of them.
void WhatIfPanel::catchUp() {
    std::vector<WhatIfTrial> trials;
    for (const std::string& column : staleColumns())
        if (fitted(column))
            trials.push_back(trialOf(column));
    showTrial();
    if (trials.empty())
        return;
    m_isSweeping = false;
    showSweep();
    m_runner.run(trials);
}

void WhatIfPanel::tryAgain(const WhatIfCase& what, std::map<std::string, std::string> settings) {
    m_runner.stop();
    m_isSweeping = false;
    m_shown.clear();
    m_tried = std::move(settings);
    setCase(what);
    showSettings();
    showSweep();
    catchUp();
}

void WhatIfPanel::take(const WhatIfTrial& trial, const MethodOutcome& outcome) {
    if (!trial.curve.empty()) {
        takeSwept(trial, outcome);
        return;
    }
    if (!outcome.failure.isEmpty() && trial.column.empty()) {
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
    addPoint(trial, outcome.errorMm);
    showCurves();
    if (!outcome.failure.isEmpty())
        m_answer->setText(outcome.failure);
    else if (trial.column == m_base && trial.method == tried(m_base)) {
        const MethodOutcome* before = fitted(m_base);
        m_answer->setText(before && std::isfinite(before->errorMm)
                              ? tr("%1 instead of %2").arg(millimetres(outcome.errorMm), millimetres(before->errorMm))
                              : QString());
    }
    if (!trial.column.empty()) {
        m_shown[trial.column] = {trial.what, outcome};
        showTrial();
    }
    emit answered(trial.isLive);
}

void WhatIfPanel::showTrial() {
    ColumnTrial trial;
    trial.what = currentCase();
    for (const auto& [column, shown] : m_shown)
        trial.methods[column] = shown.outcome;
    for (const std::string& column : staleColumns())
        trial.stale.insert(column);
    trial.isComplete = trial.stale.empty();
    if (trial.what.outlineNoisePx > 0)
        trial.outlinesPx = m_runner.outlinesPx();
    m_columns.setTrial(std::move(trial));
}

/// Of what a column shows; NaN without an error.
double WhatIfPanel::shownErrorMm(const std::string& column) const {
    if (const auto shown = m_shown.find(column); shown != m_shown.end())
        return shown->second.outcome.errorMm;
    const MethodOutcome* own = fitted(column);
    return own ? own->errorMm : std::nan("");
}

void WhatIfPanel::showCameraTexts() {
    for (std::size_t c = 0; c < m_cameras.size(); ++c) {
        const auto without = m_without.find(static_cast<int>(c));
        QString text = m_cameras[c]->objectName();
        if (without != m_without.end()) {
            const double adds = without->second - shownErrorMm(m_base);
            text = tr("%1: %2").arg(text, (adds >= 0 ? QStringLiteral("+") : QString()) + millimetres(adds));
        }
        m_cameras[c]->setText(text);
    }
}

/// With the settings and the noise that are tried; of the cameras that take part.
void WhatIfPanel::measureCameras() {
    if (m_base.empty() || m_cameras.size() < 2)
        return;
    m_without.clear();
    showCameraTexts();
    std::vector<WhatIfTrial> trials;
    for (const std::string& column : staleColumns())
        trials.push_back(trialOf(column));
    for (std::size_t c = 0; c < m_cameras.size(); ++c) {
        if (!m_cameras[c]->isChecked())
            continue;
        WhatIfTrial without{tried(m_base), currentCase(), {}, kWithoutKey, static_cast<double>(c)};
        without.what.cameras.resize(m_cameras.size(), true);
        without.what.cameras[c] = false;
        if (std::count(without.what.cameras.begin(), without.what.cameras.end(), true) > 0)
            trials.push_back(without);
    }
    m_isSweeping = false;
    showSweep();
    m_answer->setText(tr("Fitting without each camera..."));
    m_runner.run(trials);
}

} // namespace widgets
