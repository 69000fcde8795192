// SPDX-License-Identifier: MIT
// How the panel goes over a row of values; the rest of what it does stands in what_if_panel.cpp.
#include "widgets/panels/compare/what_if_panel.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QLocale>

#include "core/fitting/method_name.h"
#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/text/local_text.h"

namespace widgets {

std::string WhatIfPanel::sweptKey() const {
    if (m_base.empty())
        return {};
    const bool isKnown = !m_key.empty() && !sweepValues(m_key, m_cameras.size()).empty();
    return isKnown ? m_key : usualSweep(core::parseMethod(m_form->method()));
}

/// All columns at one value before the next value: curves grow side by side. What is on a curve already is not fitted
/// again; columns that were not fitted yet as they are tried come first.
std::vector<WhatIfTrial> WhatIfPanel::sweepTrials(const std::string& key) const {
    std::vector<std::string> columns = methodColumns();
    std::stable_partition(columns.begin(), columns.end(),
                          [this](const std::string& column) { return column == m_base; });
    std::vector<WhatIfTrial> trials;
    for (const std::string& column : staleColumns())
        trials.push_back(trialOf(column));
    for (const double value : sweepValues(key, m_cameras.size())) {
        WhatIfCase what = currentCase();
        if (key == kNoiseKey) {
            what.outlineNoisePx = value;
            what.draw = value > 0 ? m_draw->value() : 0;
        }
        if (key == kCamerasKey)
            what.cameras = spreadCameras(static_cast<std::size_t>(value), m_cameras.size());
        const auto set = m_cameraSets.find(value);
        const bool isOtherSet = key == kCamerasKey && (set == m_cameraSets.end() || set->second != what.cameras);
        std::set<std::string> curves; // two columns may be one
        for (const std::string& column : columns) {
            const std::string curve = withoutOption(tried(column), key);
            const auto known = m_points.find(curve);
            const std::string method = isOfPair(key) ? tried(column) : withValue(tried(column), key, value);
            if (!method.empty() && curves.insert(curve).second &&
                (isOtherSet || known == m_points.end() || known->second.count(value) == 0))
                trials.push_back({method, what, {}, key, value, false, curve});
        }
    }
    return trials;
}

void WhatIfPanel::sweep(const std::string& wanted) {
    const std::string key = wanted.empty() ? sweptKey() : wanted;
    if (key.empty() || !fitted(m_base) || !m_problem->text().isEmpty())
        return;
    if (key != m_key)
        startCurve(key);
    m_isSweeping = true;
    m_swept = 0;
    const std::vector<WhatIfTrial> trials = sweepTrials(key);
    m_progress->setRange(0, std::max(1, static_cast<int>(trials.size())));
    m_answer->clear();
    showSweep();
    m_runner.run(trials);
}

void WhatIfPanel::sweepOrStop() {
    if (!m_isSweeping) {
        sweep();
        return;
    }
    m_runner.stop();
    endSweep();
    catchUp();
}

void WhatIfPanel::takeSwept(const WhatIfTrial& trial, const MethodOutcome& outcome) {
    ++m_swept;
    if (trial.key == m_key && outcome.failure.isEmpty())
        addPoint(trial, outcome.errorMm);
    showCurves();
    showSweep();
}

/// What was found so far stays on the curves.
void WhatIfPanel::endSweep() {
    if (!m_isSweeping)
        return;
    m_isSweeping = false;
    showSweep();
    const auto curve = m_points.find(withoutOption(tried(m_base), m_key));
    if (curve == m_points.end() || curve->second.empty())
        return;
    const auto least = std::min_element(curve->second.begin(), curve->second.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
    m_answer->setText(tr("%1: least error %2 mm at %3")
                          .arg(QString::fromStdString(curve->first), localNumber(least->second, 2),
                               QLocale().toString(least->first, 'g', 6)));
}

void WhatIfPanel::showSweep() {
    const QString key = QString::fromStdString(sweptKey());
    m_sweep->setText(m_isSweeping         ? tr("Stop")
                     : key == kNoiseKey   ? tr("Sweep the noise")
                     : key == kCamerasKey ? tr("Sweep the cameras")
                                          : tr("Sweep %1").arg(key));
    m_progress->setVisible(m_isSweeping);
    m_progress->setValue(m_swept);
    m_progress->setFormat(tr("%1 of %2 fits").arg(m_swept).arg(m_progress->maximum()));
}

} // namespace widgets
