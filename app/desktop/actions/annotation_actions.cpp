// SPDX-License-Identifier: MIT
#include "app/desktop/actions/annotation_actions.h"

#include <algorithm>

#include <QLocale>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/actions/repeat_round.h"
#include "app/desktop/main_window.h"
#include "app/desktop/windows/range_window.h"
#include "core/annotation/edits.h"
#include "widgets/session/navigation.h"

namespace app {

namespace {

using widgets::Direction;

/// Makes the edit, or says why there is nothing to do.
void pushOrSay(MainWindow& window, const core::Edit& edit, const QString& otherwise) {
    if (edit.empty())
        window.statusLine().sayBriefly(otherwise);
    else
        window.session().document.push(edit);
}

void copyPrevious(MainWindow& window) {
    widgets::WindowSession& session = window.session();
    const auto from =
        widgets::nextAnnotatedFrame(session.coverage.frames(), session.selection.frame(), Direction::Back);
    if (!from || !session.opened.dataset()) {
        window.statusLine().sayBriefly(MainWindow::tr("No annotated frame before this one."));
        return;
    }
    pushOrSay(window,
              core::copyPoseEdit(session.document.annotations(), session.opened.dataset()->cameras, *from,
                                 session.selection.frame(), session.document.rater()),
              MainWindow::tr("Frame %1 has no 3D joint that is missing here.").arg(*from));
}

void interpolate(MainWindow& window, core::Interpolation kind) {
    widgets::WindowSession& session = window.session();
    const int frame = session.selection.frame();
    const auto before = widgets::nextAnnotatedFrame(session.coverage.frames(), frame, Direction::Back);
    const auto after = widgets::nextAnnotatedFrame(session.coverage.frames(), frame, Direction::Forward);
    if (!before || !after || !session.opened.dataset()) {
        window.statusLine().sayBriefly(MainWindow::tr("Annotate a frame before and a frame after this one first."));
        return;
    }
    pushOrSay(window,
              core::interpolateEdit(session.document.annotations(), session.opened.dataset()->cameras, *before, *after,
                                    session.document.rater(), kind),
              MainWindow::tr("No joint has a 3D point in both frame %1 and frame %2.").arg(*before).arg(*after));
}

void bindWholeFrames(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::WindowSession& session = window.session();
    const QString nothing = MainWindow::tr("There are no marks of yours there.");
    actions.bind(
        id("annotation.copyPrevious"), [&window] { copyPrevious(window); });
    actions.bind(
        id("annotation.interpolate"), [&window] { interpolate(window, core::Interpolation::Linear); });
    actions.bind(
        id("annotation.interpolateCubic"), [&window] { interpolate(window, core::Interpolation::Cubic); });
    actions.bind(id("annotation.swapHands"), [&window, &session, nothing] {
        pushOrSay(
            window,
            core::swapHandsEdit(session.document.annotations(), session.document.rater(), session.selection.frame()),
            nothing);
    });
    actions.bind(
        id("annotation.deleteFrame"),
        [&window, &session, nothing] {
            const int frame = session.selection.frame();
            pushOrSay(window,
                      core::deleteRangeEdit(session.document.annotations(), session.document.rater(), frame, frame),
                      nothing);
        });
    actions.bind(id("annotation.deleteRange"), [&window, &session, nothing] {
        auto* dialog = new RangeWindow(MainWindow::tr("Delete a range of frames"), MainWindow::tr("Delete"),
                                       session.selection.frame(), session.selection.frameCount(), &window);
        QObject::connect(dialog, &RangeWindow::chosen, &window, [&window, &session, nothing](int first, int last) {
            pushOrSay(window,
                      core::deleteRangeEdit(session.document.annotations(), session.document.rater(), first, last),
                      nothing);
        });
        dialog->show();
    });
}

void bindJointList(MainWindow& window) {
    using widgets::JointChoice;
    Actions& actions = window.actions();
    widgets::WindowSession& session = window.session();
    const std::vector<std::pair<QString, JointChoice>> choices = {
        {id("annotation.jointsFourteen"), JointChoice::Fourteen},
        {id("annotation.jointsTwentyOne"), JointChoice::TwentyOne},
        {id("annotation.jointsAll"), JointChoice::AllBones}};
    const auto show = [choices, &session, &actions] {
        for (const auto& [name, choice] : choices)
            actions.action(name)->setChecked(choice == session.joints.choice());
    };
    for (const auto& [name, choice] : choices) {
        actions.bind(
            name,
            [&session, show, choice = choice] {
                if (session.opened.dataset())
                    session.joints.setChoice(choice, *session.opened.dataset());
                show();
            });
    }
    QObject::connect(&session.joints, &widgets::JointList::changed, &window, show);
    show();
    const auto move = [&session](int rows) {
        const auto& joints = session.joints.joints();
        const auto at = std::find(joints.begin(), joints.end(), session.selection.joint());
        if (at != joints.end())
            session.joints.move(static_cast<int>(at - joints.begin()), rows);
    };
    actions.bind(
        id("annotation.jointUp"), [move] { move(-1); });
    actions.bind(id("annotation.jointDown"), [move] { move(1); });
}

void bindModel(MainWindow& window) {
    constexpr double kHopelessMm = 15; // no hand of another size is as far off
    widgets::WindowSession& session = window.session();
    window.actions().bind(id("annotation.propose"), [&session] { session.model.fitOnce(); });
    QObject::connect(&session.model, &widgets::HandModelFit::impossible, &window.statusLine(),
                     &widgets::StatusLine::sayBriefly);
    QObject::connect(
        &session.model, &widgets::HandModelFit::fitted, &window, [&window, &session](const widgets::ModelFit& fit) {
            std::vector<core::JointPoint> wanted;
            for (const core::JointPoint& proposal : fit.proposals) {
                if (session.joints.contains(proposal.joint))
                    wanted.push_back(proposal);
            }
            if (fit.rmsMm > kHopelessMm) {
                window.statusLine().sayBriefly(MainWindow::tr("The hand model misses the marked joints by %1 mm: are "
                                                              "units, joints and hands right? Nothing is proposed.")
                                                   .arg(QLocale().toString(fit.rmsMm, 'f', 1)));
                return;
            }
            window.statusLine().sayBriefly(
                MainWindow::tr("The hand model meets %n marked joint(s) within %1 mm.", nullptr, fit.joints)
                    .arg(QLocale().toString(fit.rmsMm, 'f', 1)));
            pushOrSay(
                window,
                core::proposeEdit(session.document.annotations(), session.opened.dataset()->cameras, fit.frame,
                                  session.document.rater(), wanted),
                MainWindow::tr("The hand model has nothing to add: every joint of the list that it knows has a mark."));
        });
}

void bindRaters(MainWindow& window) {
    widgets::Workspaces& spaces = window.workspaces();
    window.actions().bind(id("annotation.raters"), [&spaces] { spaces.raisePanel(spaces.ratersPanel()); });
    bindRepeatRound(window);
}

} // namespace

void bindAnnotationActions(MainWindow& window) {
    bindWholeFrames(window);
    bindJointList(window);
    bindModel(window);
    bindRaters(window);
}

} // namespace app
