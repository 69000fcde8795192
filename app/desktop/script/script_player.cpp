// SPDX-License-Identifier: MIT
#include "app/desktop/script/script_player.h"

#include <ostream>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>

#include "app/desktop/script/script_steps.h"
#include "core/error.h"

namespace app {

namespace {

QJsonObject parsed(const QByteArray& line) {
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(line, &error);
    if (error.error != QJsonParseError::NoError)
        throw core::Error(core::ErrorCode::BadInput, {}, {}, "this is not JSON: " + error.errorString().toStdString());
    if (!document.isObject())
        throw core::Error(core::ErrorCode::BadInput, {}, {}, "expected a JSON object");
    return document.object();
}

void say(std::ostream& stream, const QJsonObject& answer) {
    stream << QJsonDocument(answer).toJson(QJsonDocument::Compact).constData() << std::endl;
}

/// Does one line; false if it could not be done.
bool playLine(ScriptSteps& steps, const QByteArray& line, int number, const QString& script, std::ostream& answers,
              std::ostream& errors) {
    QJsonObject answer;
    QString name;
    QElapsedTimer timer;
    timer.start();
    std::string failure;
    try {
        const QJsonObject step = parsed(line);
        name = step[QLatin1String("do")].toString();
        answer = steps.run(step);
    } catch (const std::exception& error) {
        failure = error.what();
    }
    answer[QStringLiteral("step")] = number;
    answer[QStringLiteral("do")] = name;
    answer[QStringLiteral("ok")] = failure.empty();
    answer[QStringLiteral("ms")] = static_cast<double>(timer.nsecsElapsed()) / 1e6;
    if (!failure.empty())
        answer[QStringLiteral("error")] = QString::fromStdString(failure);
    say(answers, answer);
    if (!failure.empty())
        errors << "handlens: " << script.toStdString() << ": line " << number << ": " << failure << std::endl;
    return failure.empty();
}

} // namespace

int playScript(MainWindow& window, const QString& script, const QString& outFolder, std::ostream& answers,
               std::ostream& errors) {
    QFile file(script);
    if (!file.open(QIODevice::ReadOnly)) {
        errors << "handlens: " << script.toStdString() << ": " << file.errorString().toStdString() << std::endl;
        return 1;
    }
    if (!QDir().mkpath(outFolder)) {
        errors << "handlens: " << outFolder.toStdString() << ": the folder cannot be made" << std::endl;
        return 1;
    }
    ScriptSteps steps(window, QDir(outFolder));
    int number = 0;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine().trimmed();
        ++number;
        if (!line.isEmpty() && !playLine(steps, line, number, script, answers, errors))
            return 1;
    }
    return 0;
}

} // namespace app
