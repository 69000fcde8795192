// SPDX-License-Identifier: MIT
#include "app/desktop/script/review_steps.h"

#include <QJsonArray>

#include "app/desktop/main_window.h"
#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/step_fields.h"
#include "core/error.h"
#include "widgets/text/review_text.h"

namespace app {

namespace {

constexpr int kLongestRunMs = 24 * 60 * 60 * 1000;

} // namespace

QJsonObject runFirstPass(MainWindow& window, const QJsonObject& step) {
    widgets::FirstPass& pass = window.session().firstPass;
    const int last = window.session().selection.frameCount() - 1;
    QString error;
    QJsonObject answer;
    bool ended = false;
    QObject scope;
    QObject::connect(&pass, &widgets::FirstPass::failed, &scope, [&](const QString& message) {
        error = message;
        ended = true;
    });
    QObject::connect(&pass, &widgets::FirstPass::finished, &scope, [&](const widgets::FirstPassResult& result) {
        answer[QStringLiteral("frames")] = result.frames;
        answer[QStringLiteral("proposed")] = result.proposed;
        ended = true;
    });
    if (!pass.isInstalled())
        throw core::Error(core::ErrorCode::NotFound, {}, "do", "the hand detector is not installed");
    window.actions().action(QStringLiteral("annotation.firstPass"))->trigger();
    widgets::FirstPassForm* form = window.workspaces().reviewPanel()->firstPass();
    form->setFrames(intField(step, "first", 0), intField(step, "last", last), intField(step, "step", 1));
    form->start();
    if (!pass.isRunning() && !ended)
        throw core::Error(core::ErrorCode::Usage, {}, "first", "must be frame numbers of the sequence, first to last");
    waitFor(
        window, [&ended] { return ended; }, kLongestRunMs);
    if (!error.isEmpty())
        throw core::Error(core::ErrorCode::Usage, {}, "do", error.toStdString());
    return answer;
}

QJsonObject printReview(MainWindow& window) {
    const widgets::ReviewQueue& queue = window.session().review;
    QJsonArray rows;
    for (const widgets::ReviewRow& row : queue.rows())
        rows.append(QJsonObject{{QStringLiteral("frame"), row.item.frame},
                                {QStringLiteral("doubt"), row.item.doubt},
                                {QStringLiteral("neighbours"), row.item.neighbours},
                                {QStringLiteral("reason"), widgets::doubtReasonText(row.why)}});
    QJsonObject answer{{QStringLiteral("review"), rows},
                       {QStringLiteral("left"), queue.progress().left},
                       {QStringLiteral("reviewed"), queue.reviewed()}};
    if (queue.progress().expectedErrorMm)
        answer[QStringLiteral("expectedErrorMm")] = *queue.progress().expectedErrorMm;
    return answer;
}

} // namespace app
