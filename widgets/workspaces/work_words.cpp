// SPDX-License-Identifier: MIT
#include "widgets/workspaces/work_words.h"

#include <cmath>

#include <QLocale>
#include <QStringList>

#include "core/benchmark/metrics.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText words{"widgets::WorkWords"};

QString methodError(const std::string& method, double errorMm) {
    return words(QT_TRANSLATE_NOOP("widgets::WorkWords", "%1 %2 mm"))
        .arg(QString::fromStdString(method), QLocale().toString(errorMm, 'f', 2));
}

} // namespace

WorkWords fitWords(const FitOutcome* outcome) {
    if (!outcome)
        return {{}, words(QT_TRANSLATE_NOOP("widgets::WorkWords", "Fit the current frame: F"))};
    QStringList errors;
    if (!std::isnan(outcome->initialErrorMm))
        errors << methodError(words(QT_TRANSLATE_NOOP("widgets::WorkWords", "start")).toStdString(),
                              outcome->initialErrorMm);
    for (const MethodOutcome& method : outcome->methods)
        if (!method.failure.isEmpty())
            errors << words(QT_TRANSLATE_NOOP("widgets::WorkWords", "%1 failed"))
                          .arg(QString::fromStdString(method.method));
        else if (!std::isnan(method.errorMm))
            errors << methodError(method.method, method.errorMm);
    return {words(QT_TRANSLATE_NOOP("widgets::WorkWords", "Frame %1 from frame %2"))
                .arg(outcome->request.test)
                .arg(outcome->request.start),
            errors.isEmpty()
                ? words(QT_TRANSLATE_NOOP("widgets::WorkWords", "There is nothing to measure the error against."))
                : errors.join(QStringLiteral(", "))};
}

WorkWords benchmarkWords(const core::BenchmarkResults* results) {
    if (!results)
        return {{}, words(QT_TRANSLATE_NOOP("widgets::WorkWords", "Choose methods and sequences, then Run"))};
    QStringList errors;
    for (const std::string& method : results->methods) {
        const core::ErrorStatistics found = core::errorStatistics(*results, method);
        if (found.pairs > 0)
            errors << methodError(method, found.meanMm);
    }
    return {words(QT_TRANSLATE_NOOP("widgets::WorkWords", "%1 pairs"))
                .arg(QLocale().toString(static_cast<int>(results->pairs.size()))),
            errors.join(QStringLiteral(", "))};
}

} // namespace widgets
