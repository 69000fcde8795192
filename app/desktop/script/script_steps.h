// SPDX-License-Identifier: MIT
#pragma once

#include <QDir>
#include <QJsonObject>

#include "app/desktop/script/real_input.h"

namespace app {

class MainWindow;

/// Does single steps of a script in a window.
class ScriptSteps {
public:
    /// Relative paths in steps resolve against `out`.
    ScriptSteps(MainWindow& window, const QDir& out)
        : m_window(window)
        , m_out(out)
        , m_input(window) {}

    /// Does a step and returns when its effect is complete, with what it has to say; "said" holds what the window said
    /// about it. Throws core::Error if it cannot be done: also if a click or a drag was refused.
    QJsonObject run(const QJsonObject& step);

private:
    QJsonObject goTo(const QJsonObject& step);
    QJsonObject select(const QJsonObject& step);
    QJsonObject click(const QJsonObject& step);
    QJsonObject doubleClick(const QJsonObject& step);
    QJsonObject drag(const QJsonObject& step);
    QJsonObject wheel(const QJsonObject& step);
    QJsonObject key(const QJsonObject& step);
    QJsonObject action(const QJsonObject& step);
    QJsonObject fit(const QJsonObject& step);
    QJsonObject print(const QJsonObject& step);
    QJsonObject exportAnnotations(const QJsonObject& step);
    QJsonObject shot(const QJsonObject& step);
    QJsonObject resize(const QJsonObject& step);
    QJsonObject timing(const QJsonObject& step);
    QJsonObject iteration(const QJsonObject& step);
    QJsonObject layer(const QJsonObject& step);
    QJsonObject probe(const QJsonObject& step);
    QJsonObject workspace(const QJsonObject& step);
    QJsonObject results(const QJsonObject& step);
    QJsonObject pairs(const QJsonObject& step);
    QJsonObject report(const QJsonObject& step);
    QJsonObject film(const QJsonObject& step);
    QJsonObject picture(const QJsonObject& step);
    QJsonObject firstPass(const QJsonObject& step);
    QJsonObject columns(const QJsonObject& step);
    QJsonObject whatIf(const QJsonObject& step);

    QJsonObject printJoint(const QJsonObject& step);
    QJsonObject printResults();
    widgets::CameraView& cameraView(const QJsonObject& step) const;
    void bringIntoSight(const QJsonObject& step, const char* field) const;
    QString outPath(const QJsonObject& step) const;
    void settle();

    MainWindow& m_window;
    QDir m_out;
    RealInput m_input;
};

} // namespace app
