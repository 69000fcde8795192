// SPDX-License-Identifier: MIT
#include "widgets/presenters/what_if_case.h"

#include <algorithm>

#include <QLocale>
#include <QStringList>

#include "core/simulation/simulated_world.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText words{"widgets::WhatIfCase"};

/// The shorter list of both: those that are left out, or those that take part.
QString camerasText(const WhatIfCase& what, const std::vector<core::Camera>& cameras) {
    QStringList out, in;
    for (std::size_t camera = 0; camera < cameras.size(); ++camera)
        (what.isLeftOut(camera) ? out : in) << QString::fromStdString(cameras[camera].name);
    if (out.isEmpty())
        return {};
    return in.size() < out.size()
               ? words(QT_TRANSLATE_NOOP("widgets::WhatIfCase", "only %1")).arg(in.join(QStringLiteral(", ")))
               : words(QT_TRANSLATE_NOOP("widgets::WhatIfCase", "without %1")).arg(out.join(QStringLiteral(", ")));
}

} // namespace

std::uint64_t outlineNoiseSeed(int draw, std::size_t camera, const std::string& sequence) {
    return core::drawSeed(camera, draw == 0 ? sequence : sequence + "/" + std::to_string(draw));
}

QString caseText(const WhatIfCase& what, const std::vector<core::Camera>& cameras) {
    QStringList parts;
    if (what.outlineNoisePx > 0)
        parts << words(QT_TRANSLATE_NOOP("widgets::WhatIfCase", "outlines with %1 px of noise (draw %2)"))
                     .arg(QLocale().toString(what.outlineNoisePx, 'g', 4))
                     .arg(what.draw);
    if (const QString without = camerasText(what, cameras); !without.isEmpty())
        parts << without;
    return parts.join(QStringLiteral(", "));
}

QString trialText(const ColumnTrial& trial, const std::vector<core::Camera>& cameras) {
    if (!trial.isOn())
        return {};
    QStringList parts, settings;
    if (const QString text = caseText(trial.what, cameras); !text.isEmpty())
        parts << text;
    for (const auto& [column, outcome] : trial.methods)
        if (outcome.method.rfind(column + ":", 0) == 0)
            settings << QString::fromStdString(outcome.method);
        else if (outcome.method != column)
            settings << words(QT_TRANSLATE_NOOP("widgets::WhatIfCase", "%1 in the place of %2"))
                            .arg(QString::fromStdString(outcome.method), QString::fromStdString(column));
    parts << settings;
    const QString text = parts.join(QStringLiteral(", "));
    if (trial.isComplete)
        return text;
    return text.isEmpty() ? words(QT_TRANSLATE_NOOP("widgets::WhatIfCase", "being fitted"))
                          : words(QT_TRANSLATE_NOOP("widgets::WhatIfCase", "%1 (being fitted)")).arg(text);
}

} // namespace widgets
