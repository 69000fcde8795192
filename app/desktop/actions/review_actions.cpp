// SPDX-License-Identifier: MIT
#include "app/desktop/actions/review_actions.h"

#include <algorithm>

#include <QLocale>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"
#include "widgets/text/edit_text.h"
#include "widgets/text/review_text.h"

namespace app {

namespace {

widgets::ReviewPanel& showReview(MainWindow& window) {
    widgets::Workspaces& spaces = window.workspaces();
    spaces.raisePanel(spaces.reviewPanel());
    return *spaces.reviewPanel();
}

void lookAt(MainWindow& window, int frame) {
    window.session().selection.setFrame(frame);
    window.workspaces().framing()->showHands();
}

void goToNextReviewed(MainWindow& window) {
    widgets::WindowSession& session = window.session();
    if (const auto frame = session.review.next(session.selection.frame()))
        lookAt(window, *frame);
    else
        window.statusLine().sayBriefly(session.review.rows().empty()
                                           ? MainWindow::tr("No frame waits for a look.")
                                           : MainWindow::tr("This is the only frame that waits for a look."));
}

bool wasCorrected(const widgets::WindowSession& session, int frame) {
    const auto marks = core::marksOfFrame(session.document.annotations(), frame, session.document.rater());
    return std::any_of(marks.begin(), marks.end(), [](const auto& item) { return item.second.isEvidence(); });
}

/// Accepts the frame, goes on, and follows the hands from what was corrected.
void acceptFrame(MainWindow& window) {
    widgets::WindowSession& session = window.session();
    const int frame = session.selection.frame();
    const auto next = session.review.next(frame);
    if (!session.annotator.acceptProposals())
        return;
    session.review.dropFrame(frame);
    if (wasCorrected(session, frame))
        session.firstPass.followFrom(frame);
    if (next)
        lookAt(window, *next);
    else
        window.statusLine().sayBriefly(MainWindow::tr("Every frame of the first pass is reviewed."));
}

/// Selects the joint to click; from a frame that does not wait, in the one that comes first.
void correctFrame(MainWindow& window) {
    widgets::WindowSession& session = window.session();
    if (!session.review.find(session.selection.frame()))
        goToNextReviewed(window);
    const widgets::ReviewRow* row = session.review.find(session.selection.frame());
    if (!row)
        return;
    session.selection.setJoint(row->why.joint);
    window.statusLine().sayBriefly(MainWindow::tr("Click or drag %1 in two views, then accept the frame.")
                                       .arg(widgets::jointText(row->why.joint)));
}

void bindReviewItems(MainWindow& window) {
    Actions& actions = window.actions();
    actions.bind(
        id("annotation.firstPass"), [&window] { showReview(window).setFormShown(true); });
    actions.bind(
        id("firstPass.run"), [&window] { showReview(window).firstPass()->start(); });
    actions.bind(
        id("review.accept"), [&window] { acceptFrame(window); });
    actions.bind(
        id("review.correct"), [&window] { correctFrame(window); });
    actions.bind(
        id("review.next"), [&window] { goToNextReviewed(window); });
    actions.bind(
        id("review.show"), [&window] { showReview(window); });
    QObject::connect(window.workspaces().reviewPanel(), &widgets::ReviewPanel::frameChosen, &window,
                     [&window] { window.workspaces().framing()->showHands(); });
    window.workspaces().reviewPanel()->setActions(
        actions.action(id("review.accept")), actions.action(id("review.correct")), actions.action(id("review.next")),
        actions.action(id("annotation.firstPass")));
}

QString finishedText(const widgets::FirstPassResult& result) {
    const QString frames = QLocale().toString(result.frames);
    if (!result.isFinished)
        return MainWindow::tr("Stopped: %n mark(s) in %1 frames are proposed; the next start goes on from there.",
                              nullptr, result.proposed)
            .arg(frames);
    const QString text =
        MainWindow::tr("First pass: hands in %1 of %2 frames, %n mark(s) proposed.", nullptr, result.proposed)
            .arg(frames, QLocale().toString(result.wanted));
    if (result.camerasOffPx <= 0)
        return text;
    return text + QLatin1Char(' ') +
           MainWindow::tr("Silhouettes lie %1 px beside the hands: refine the calibration.")
               .arg(QLocale().toString(result.camerasOffPx, 'f', 1));
}

/// The run is seen in the status line; the queue comes to the front when it has something.
void announceFirstPass(MainWindow& window) {
    widgets::StatusLine& line = window.statusLine();
    widgets::FirstPass& pass = window.session().firstPass;
    QObject::connect(
        &pass, &widgets::FirstPass::runningChanged, &line,
        [&line, &pass] {
            if (pass.isInstalling())
                line.showWork(MainWindow::tr("Installing the hand detector"), -1);
            else if (pass.isRunning())
                line.showWork(MainWindow::tr("First pass"), 0);
            else if (pass.isRefitting())
                line.showWork(MainWindow::tr("Bringing the hands to the corrected joint"), -1);
            else if (pass.isFollowing())
                line.showWork(MainWindow::tr("Following the hands from the corrected frame"), -1);
            else
                line.hideWork();
        });
    QObject::connect(&pass, &widgets::FirstPass::progressed, &line,
                     [&line](core::PassStage stage, int done, int total) {
                         line.showWork(widgets::firstPassStageText(stage, done, total),
                                       static_cast<double>(done) / std::max(1, total));
                     });
    QObject::connect(&line, &widgets::StatusLine::stopRequested, &pass, &widgets::FirstPass::stop);
    QObject::connect(
        &pass, &widgets::FirstPass::finished, &window,
        [&window](const widgets::FirstPassResult& result) {
            window.statusLine().sayBriefly(finishedText(result));
            window.workspaces().framing()->showHands();
            if (result.proposed > 0 && window.workspaces().current() == widgets::Workspaces::Kind::Annotate)
                showReview(window).setFormShown(false);
        });
    QObject::connect(
        &pass, &widgets::FirstPass::followed, &window,
        [&window](int frame, int proposed) {
            window.statusLine().sayBriefly(
                MainWindow::tr("%n mark(s) around frame %1 are proposed anew.", nullptr, proposed).arg(frame));
        });
    QObject::connect(&pass, &widgets::FirstPass::refitted, &window, [&window](int frame, int proposed) {
        window.statusLine().sayBriefly(
            MainWindow::tr("%n mark(s) of frame %1 follow the corrected joint.", nullptr, proposed).arg(frame));
    });
    QObject::connect(&pass, &widgets::FirstPass::failed, &line, &widgets::StatusLine::sayBriefly);
}

} // namespace

void bindReviewActions(MainWindow& window) {
    bindReviewItems(window);
    announceFirstPass(window);
    const widgets::ReviewQueue& queue = window.session().review;
    QObject::connect(&queue, &widgets::ReviewQueue::changed, &window,
                     [&window, &queue] { window.framesBar().setProposedHands(queue.openHands()); });
}

} // namespace app
