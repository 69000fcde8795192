// SPDX-License-Identifier: MIT
#include "app/desktop/script/script_steps.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <QFileInfo>
#include <QJsonArray>
#include <QScreen>
#include <QWindow>

#include "app/desktop/main_window.h"
#include "app/desktop/script/benchmark_steps.h"
#include "app/desktop/script/compare_steps.h"
#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/inspect_steps.h"
#include "app/desktop/script/joint_json.h"
#include "app/desktop/script/review_steps.h"
#include "app/desktop/script/step_fields.h"
#include "app/desktop/script/workspace_file.h"
#include "core/error.h"
#include "core/numeric/median.h"
#include "widgets/text/error_text.h"
#include "widgets/text/local_text.h"

namespace app {

namespace {

core::Error refused(const char* field, const QString& why) {
    return {core::ErrorCode::Usage, {}, field, why.toStdString()};
}

/// Runs something that ends with one of two signals; returns the error's text, empty if it went well.
template <class Sender, class Done, class Failed>
QString outcomeOf(MainWindow& window, Sender* sender, Done done, Failed failed, const std::function<void()>& start) {
    QString error;
    bool ended = false;
    QObject scope;
    QObject::connect(sender, done, &scope, [&] { ended = true; });
    QObject::connect(sender, failed, &scope, [&](const QString& message) {
        error = widgets::withDetailBehind(message);
        ended = true;
    });
    start();
    if (!waitFor(window, [&] { return ended && window.session().pool.isIdle(); }))
        return QStringLiteral("no answer in time");
    return error;
}

} // namespace

QJsonObject ScriptSteps::run(const QJsonObject& step) {
    using Handler = QJsonObject (ScriptSteps::*)(const QJsonObject&);
    static const std::map<QString, Handler> kHandlers = {{QStringLiteral("goto"), &ScriptSteps::goTo},
                                                         {QStringLiteral("select"), &ScriptSteps::select},
                                                         {QStringLiteral("click"), &ScriptSteps::click},
                                                         {QStringLiteral("doubleclick"), &ScriptSteps::doubleClick},
                                                         {QStringLiteral("drag"), &ScriptSteps::drag},
                                                         {QStringLiteral("wheel"), &ScriptSteps::wheel},
                                                         {QStringLiteral("key"), &ScriptSteps::key},
                                                         {QStringLiteral("action"), &ScriptSteps::action},
                                                         {QStringLiteral("fit"), &ScriptSteps::fit},
                                                         {QStringLiteral("print"), &ScriptSteps::print},
                                                         {QStringLiteral("export"), &ScriptSteps::exportAnnotations},
                                                         {QStringLiteral("shot"), &ScriptSteps::shot},
                                                         {QStringLiteral("resize"), &ScriptSteps::resize},
                                                         {QStringLiteral("timing"), &ScriptSteps::timing},
                                                         {QStringLiteral("iteration"), &ScriptSteps::iteration},
                                                         {QStringLiteral("layer"), &ScriptSteps::layer},
                                                         {QStringLiteral("probe"), &ScriptSteps::probe},
                                                         {QStringLiteral("workspace"), &ScriptSteps::workspace},
                                                         {QStringLiteral("results"), &ScriptSteps::results},
                                                         {QStringLiteral("pairs"), &ScriptSteps::pairs},
                                                         {QStringLiteral("report"), &ScriptSteps::report},
                                                         {QStringLiteral("film"), &ScriptSteps::film},
                                                         {QStringLiteral("picture"), &ScriptSteps::picture},
                                                         {QStringLiteral("firstPass"), &ScriptSteps::firstPass},
                                                         {QStringLiteral("columns"), &ScriptSteps::columns},
                                                         {QStringLiteral("whatIf"), &ScriptSteps::whatIf}};
    const QString name = textField(step, "do");
    const auto handler = kHandlers.find(name);
    if (handler == kHandlers.end())
        throw refused("do", QStringLiteral("unknown step \"%1\"").arg(name));
    QString said, refusal;
    QObject scope;
    QObject::connect(
        &m_window.statusLine(), &widgets::StatusLine::said, &scope, [&said](const QString& text) { said = text; });
    QObject::connect(
        &m_window.session().annotator, &widgets::Annotator::nothingDone, &scope,
        [&refusal](const QString& why) { refusal = why; });
    QObject::connect(&m_window.session().document, &widgets::AnnotationDocument::refused, &scope,
                     [&](const QString& why) { said = refusal = why; });
    QJsonObject answer = (this->*handler->second)(step);
    settle();
    if (!refusal.isEmpty() && (name == QLatin1String("click") || name == QLatin1String("drag")))
        throw refused(name == QLatin1String("click") ? "px" : "to", refusal);
    if (!said.isEmpty())
        answer[QStringLiteral("said")] = said;
    return answer;
}

void ScriptSteps::settle() {
    if (!waitUntilIdle(m_window))
        throw refused("do", QStringLiteral("no answer in time"));
}

widgets::CameraView& ScriptSteps::cameraView(const QJsonObject& step) const {
    if (step.contains(QLatin1String("column")))
        return inspectedView(m_window, step);
    const QString name = textField(step, "camera");
    widgets::CameraView* view = m_window.workspaces().grid()->view(name);
    if (!view)
        throw refused("camera", QStringLiteral("unknown camera \"%1\"").arg(name));
    return *view;
}

/// The views show the hands when a sequence opens; a script that means another part of the picture gets the whole one.
void ScriptSteps::bringIntoSight(const QJsonObject& step, const char* field) const {
    widgets::CameraView& view = cameraView(step);
    const QPointF px = pointField(step, field);
    const bool isInSight = QRectF(view.viewport()->rect()).contains(view.imageToViewport(px));
    if (isInSight || view.home().isEmpty() || !core::isInside(view.camera().size, {px.x(), px.y()}))
        return;
    view.setHome({});
    view.fitImage();
}

QString ScriptSteps::outPath(const QJsonObject& step) const {
    return m_out.absoluteFilePath(textField(step, "path"));
}

QJsonObject ScriptSteps::goTo(const QJsonObject& step) {
    widgets::WindowSession& session = m_window.session();
    if (!session.opened.dataset())
        throw refused("do", QStringLiteral("no dataset is open"));
    const int frame = intField(step, "frame", 0);
    const QString sequence = step.contains(QLatin1String("sequence"))
                                 ? textField(step, "sequence")
                                 : QString::fromStdString(session.opened.sequence()->name);
    if (sequence != QString::fromStdString(session.opened.sequence()->name)) {
        const QString error =
            outcomeOf(m_window, &session.opened, &widgets::DatasetSession::sequenceOpened,
                      &widgets::DatasetSession::openFailed, [&] { session.opened.openSequence(sequence, frame); });
        if (!error.isEmpty())
            throw refused("sequence", error);
    }
    if (frame < 0 || frame >= session.selection.frameCount())
        throw refused("frame",
                      QStringLiteral("%1 is not within 0..%2").arg(frame).arg(session.selection.frameCount() - 1));
    session.selection.setFrame(frame);
    return {};
}

QJsonObject ScriptSteps::select(const QJsonObject& step) {
    const core::JointId joint = jointField(step);
    widgets::WindowSession& session = m_window.session();
    const auto& dataset = session.opened.dataset();
    const auto inModel = [&](const core::HandModel& hand) {
        return hand.side == joint.hand && hand.skeleton.boneIndex(joint.joint) >= 0;
    };
    if (!dataset ||
        (!session.joints.contains(joint) && std::none_of(dataset->hands.begin(), dataset->hands.end(), inModel)))
        throw refused("joint", QStringLiteral("unknown joint \"%1\"").arg(QString::fromStdString(joint.joint)));
    session.selection.setJoint(joint);
    return {};
}

QJsonObject ScriptSteps::click(const QJsonObject& step) {
    bringIntoSight(step, "px");
    m_input.click(cameraView(step), pointField(step, "px"), buttonField(step), modifiersField(step));
    return {};
}

QJsonObject ScriptSteps::doubleClick(const QJsonObject& step) {
    bringIntoSight(step, "px");
    m_input.doubleClick(cameraView(step), pointField(step, "px"));
    return {};
}

QJsonObject ScriptSteps::drag(const QJsonObject& step) {
    constexpr int kMoves = 12;
    bringIntoSight(step, "from");
    m_input.drag(cameraView(step), pointField(step, "from"), pointField(step, "to"), buttonField(step),
                 modifiersField(step), std::clamp(intField(step, "moves", kMoves), 1, 10000));
    return {};
}

QJsonObject ScriptSteps::wheel(const QJsonObject& step) {
    bringIntoSight(step, "px");
    m_input.wheel(cameraView(step), pointField(step, "px"), std::clamp(intField(step, "steps"), -1000, 1000));
    return {};
}

QJsonObject ScriptSteps::key(const QJsonObject& step) {
    m_input.key(textField(step, "keys"), std::clamp(intField(step, "hold", 0), 0, 60000));
    return {};
}

QJsonObject ScriptSteps::action(const QJsonObject& step) {
    const QString id = textField(step, "id");
    if (!m_window.actions().contains(id))
        throw refused("id", QStringLiteral("unknown action \"%1\"").arg(id));
    QAction* action = m_window.actions().action(id);
    if (!action->isEnabled())
        throw refused("id", QStringLiteral("\"%1\" is not possible now").arg(id));
    action->trigger();
    return {};
}

QJsonObject ScriptSteps::fit(const QJsonObject& step) {
    widgets::FitRequest request{intField(step, "start"), intField(step, "test"), {}, widgets::FitTarget::Recorded};
    for (const QString& method : textsField(step, "methods"))
        request.methods.push_back(method.toStdString());
    if (step.contains(QLatin1String("target"))) {
        const QString target = textField(step, "target");
        if (target != QLatin1String("recorded") && target != QLatin1String("masks"))
            throw refused("target", QStringLiteral("expected \"recorded\" or \"masks\""));
        request.target = target == QLatin1String("masks") ? widgets::FitTarget::Masks : widgets::FitTarget::Recorded;
    }
    widgets::FitRunner& fits = m_window.session().fits;
    const QString error = outcomeOf(m_window, &fits, &widgets::FitRunner::finished, &widgets::FitRunner::failed,
                                    [&] { m_window.workspaces().fittingPanel()->fit(request); });
    if (!error.isEmpty())
        throw refused("do", error);
    for (const widgets::MethodOutcome& method : fits.outcome()->methods)
        if (!method.failure.isEmpty())
            throw refused("methods", widgets::withDetailBehind(method.failure));
    m_window.session().selection.setFrame(request.test);
    return {};
}

QJsonObject ScriptSteps::print(const QJsonObject& step) {
    const QString what = textField(step, "what");
    if (what == QLatin1String("joint"))
        return printJoint(step);
    if (what == QLatin1String("results"))
        return printResults();
    if (what == QLatin1String("matches"))
        return printMatches(m_window, step);
    if (what == QLatin1String("review"))
        return printReview(m_window);
    if (what == QLatin1String("pairs"))
        return printPairs(m_window, step);
    if (what == QLatin1String("columns"))
        return printColumns(m_window);
    throw refused("what",
                  QStringLiteral("expected \"joint\", \"results\", \"matches\", \"columns\", \"review\" or \"pairs\""));
}

QJsonObject ScriptSteps::printJoint(const QJsonObject& step) {
    const core::JointId joint = jointField(step);
    widgets::WindowSession& session = m_window.session();
    session.rig.lookNow(); // what clicks are worth follows from the last ones, too
    if (!waitFor(m_window, [&session] { return session.rig.isUpToDate(); }))
        throw refused("do", QStringLiteral("no answer in time"));
    QJsonObject answer = jointJson(session.reconstructions.compute(session.selection.frame(), joint));
    answer[QStringLiteral("hand")] = widgets::toQString(core::sideName(joint.hand));
    answer[QStringLiteral("joint")] = QString::fromStdString(joint.joint);
    answer[QStringLiteral("frame")] = session.selection.frame();
    return answer;
}

QJsonObject ScriptSteps::printResults() {
    const auto& outcome = m_window.session().fits.outcome();
    if (!outcome)
        throw refused("what", QStringLiteral("nothing was fitted yet"));
    QJsonArray rows;
    for (const widgets::MethodOutcome& method : outcome->methods) {
        QJsonObject row;
        row[QStringLiteral("method")] = QString::fromStdString(method.method);
        row[QStringLiteral("initialErrorMm")] = outcome->initialErrorMm;
        row[QStringLiteral("errorMm")] = method.errorMm;
        row[QStringLiteral("iterations")] = static_cast<int>(method.result.history.size());
        row[QStringLiteral("seconds")] = method.result.seconds;
        row[QStringLiteral("termination")] = widgets::toQString(core::terminationName(method.result.termination));
        rows.append(row);
    }
    return {{QStringLiteral("start"), outcome->request.start},
            {QStringLiteral("test"), outcome->request.test},
            {QStringLiteral("results"), rows}};
}

QJsonObject ScriptSteps::iteration(const QJsonObject& step) {
    return showIteration(m_window, step);
}

QJsonObject ScriptSteps::layer(const QJsonObject& step) {
    return showLayer(m_window, step);
}

QJsonObject ScriptSteps::probe(const QJsonObject& step) {
    return probeAt(m_window, step);
}

QJsonObject ScriptSteps::results(const QJsonObject& step) {
    return openResults(m_window, m_out, step);
}

QJsonObject ScriptSteps::pairs(const QJsonObject& step) {
    return showPairs(m_window, step);
}

QJsonObject ScriptSteps::report(const QJsonObject& step) {
    return saveReport(m_window, outPath(step));
}

QJsonObject ScriptSteps::film(const QJsonObject& step) {
    return saveFilm(m_window, outPath(step));
}

QJsonObject ScriptSteps::picture(const QJsonObject& step) {
    return saveComparison(m_window, outPath(step));
}

QJsonObject ScriptSteps::firstPass(const QJsonObject& step) {
    return runFirstPass(m_window, step);
}

QJsonObject ScriptSteps::columns(const QJsonObject& step) {
    return chooseColumns(m_window, step);
}

QJsonObject ScriptSteps::whatIf(const QJsonObject& step) {
    return tryWhatIf(m_window, step);
}

QJsonObject ScriptSteps::workspace(const QJsonObject& step) {
    const QString path = outPath(step);
    writeWorkspace(path.toStdString(), currentWorkspace(m_window));
    return {{QStringLiteral("path"), path}};
}

QJsonObject ScriptSteps::exportAnnotations(const QJsonObject& step) {
    const QString kind = textField(step, "to");
    const QString path = outPath(step);
    widgets::AnnotationFiles& files = m_window.session().files;
    const QString error = outcomeOf(m_window, &files, &widgets::AnnotationFiles::exported,
                                    &widgets::AnnotationFiles::failed, [&] { files.exportTo(kind, path); });
    if (!error.isEmpty())
        throw refused("do", error);
    return {{QStringLiteral("path"), path}};
}

QJsonObject ScriptSteps::shot(const QJsonObject& step) {
    const QString name = textField(step, "of");
    QWidget* part = m_window.part(name);
    if (!part)
        throw refused("of", QStringLiteral("unknown part \"%1\"").arg(name));
    if (!part->isVisible())
        throw refused("of", QStringLiteral("\"%1\" is not shown now").arg(name));
    settle();
    if (!waitFor(m_window,
                 [this] { return m_window.session().checks.isUpToDate() && m_window.session().rig.isUpToDate(); }))
        throw refused("do", QStringLiteral("no answer in time"));
    m_window.workspaces().scene()->finishDrawing();
    drawNow(m_window);
    QImage picture;
    if (const auto* scene = qobject_cast<widgets::SceneView*>(part)) {
        picture = scene->grabPicture();
    } else {
        const QPoint corner = part->mapToGlobal(QPoint(0, 0));
        picture = m_window.screen()->grabWindow(0, corner.x(), corner.y(), part->width(), part->height()).toImage();
    }
    const QString path = outPath(step);
    if (picture.isNull() || !picture.convertToFormat(QImage::Format_RGB888).save(path, "PNG"))
        throw core::Error(core::ErrorCode::Io, path.toStdString(), {}, "the picture could not be written");
    return {{QStringLiteral("path"), path}, {QStringLiteral("size"), QJsonArray{picture.width(), picture.height()}}};
}

QJsonObject ScriptSteps::resize(const QJsonObject& step) {
    const QPointF size = pointField(step, "size");
    if (size.x() < 200 || size.y() < 200 || size.x() > 8000 || size.y() > 8000)
        throw refused("size", QStringLiteral("expected two numbers from 200 to 8000"));
    m_window.resize(size.toPoint().x(), size.toPoint().y());
    settle();
    return {{QStringLiteral("size"), QJsonArray{m_window.width(), m_window.height()}}};
}

QJsonObject ScriptSteps::timing(const QJsonObject&) {
    std::vector<double> times = m_input.takeFrameTimes();
    QJsonObject answer{{QStringLiteral("frames"), static_cast<int>(times.size())}};
    if (times.empty())
        return answer;
    std::sort(times.begin(), times.end());
    double sum = 0;
    for (const double ms : times)
        sum += ms;
    answer[QStringLiteral("meanMs")] = sum / static_cast<double>(times.size());
    answer[QStringLiteral("medianMs")] = core::medianOf(times);
    answer[QStringLiteral("p95Ms")] = times[std::min(times.size() - 1, times.size() * 95 / 100)];
    answer[QStringLiteral("maxMs")] = times.back();
    return answer;
}

} // namespace app
