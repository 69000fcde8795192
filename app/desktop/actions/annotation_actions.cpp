// SPDX-License-Identifier: MIT
#include "app/desktop/actions/annotation_actions.h"

#include <algorithm>

#include <QLocale>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/actions/second_round.h"
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
        window.workbench().document.push(edit);
}

void copyPrevious(MainWindow& window) {
    widgets::Workbench& bench = window.workbench();
    const auto from = widgets::nextAnnotatedFrame(bench.coverage.frames(), bench.selection.frame(), Direction::Back);
    if (!from || !bench.session.dataset()) {
        window.statusLine().sayBriefly(MainWindow::tr("No annotated frame before this one."));
        return;
    }
    pushOrSay(window,
              core::copyPoseEdit(bench.document.annotations(), bench.session.dataset()->cameras, *from,
                                 bench.selection.frame(), bench.document.rater()),
              MainWindow::tr("Frame %1 has no 3D joint that is missing here.").arg(*from));
}

void interpolate(MainWindow& window, core::Interpolation kind) {
    widgets::Workbench& bench = window.workbench();
    const int frame = bench.selection.frame();
    const auto before = widgets::nextAnnotatedFrame(bench.coverage.frames(), frame, Direction::Back);
    const auto after = widgets::nextAnnotatedFrame(bench.coverage.frames(), frame, Direction::Forward);
    if (!before || !after || !bench.session.dataset()) {
        window.statusLine().sayBriefly(MainWindow::tr("Annotate a frame before and a frame after this one first."));
        return;
    }
    pushOrSay(window,
              core::interpolateEdit(bench.document.annotations(), bench.session.dataset()->cameras, *before, *after,
                                    bench.document.rater(), kind),
              MainWindow::tr("No joint has a 3D point in both frame %1 and frame %2.").arg(*before).arg(*after));
}

void bindWholeFrames(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::Workbench& bench = window.workbench();
    const QString nothing = MainWindow::tr("There are no marks of yours there.");
    actions.bind(
        id("annotation.copyPrevious"), [&window] { copyPrevious(window); });
    actions.bind(
        id("annotation.interpolate"), [&window] { interpolate(window, core::Interpolation::Linear); });
    actions.bind(
        id("annotation.interpolateCubic"), [&window] { interpolate(window, core::Interpolation::Cubic); });
    actions.bind(id("annotation.swapHands"), [&window, &bench, nothing] {
        pushOrSay(window,
                  core::swapHandsEdit(bench.document.annotations(), bench.document.rater(), bench.selection.frame()),
                  nothing);
    });
    actions.bind(
        id("annotation.deleteFrame"),
        [&window, &bench, nothing] {
            const int frame = bench.selection.frame();
            pushOrSay(window, core::deleteRangeEdit(bench.document.annotations(), bench.document.rater(), frame, frame),
                      nothing);
        });
    actions.bind(id("annotation.deleteRange"), [&window, &bench, nothing] {
        auto* dialog = new RangeWindow(MainWindow::tr("Delete a range of frames"), MainWindow::tr("Delete"),
                                       bench.selection.frame(), bench.selection.frameCount(), &window);
        QObject::connect(dialog, &RangeWindow::chosen, &window, [&window, &bench, nothing](int first, int last) {
            pushOrSay(window, core::deleteRangeEdit(bench.document.annotations(), bench.document.rater(), first, last),
                      nothing);
        });
        dialog->show();
    });
}

void bindJointList(MainWindow& window) {
    using widgets::JointChoice;
    Actions& actions = window.actions();
    widgets::Workbench& bench = window.workbench();
    const std::vector<std::pair<QString, JointChoice>> choices = {
        {id("annotation.jointsFourteen"), JointChoice::Fourteen},
        {id("annotation.jointsTwentyOne"), JointChoice::TwentyOne},
        {id("annotation.jointsAll"), JointChoice::AllBones}};
    const auto show = [choices, &bench, &actions] {
        for (const auto& [name, choice] : choices)
            actions.action(name)->setChecked(choice == bench.joints.choice());
    };
    for (const auto& [name, choice] : choices) {
        actions.bind(
            name,
            [&bench, show, choice = choice] {
                if (bench.session.dataset())
                    bench.joints.setChoice(choice, *bench.session.dataset());
                show();
            });
    }
    QObject::connect(&bench.joints, &widgets::JointList::changed, &window, show);
    show();
    const auto move = [&bench](int rows) {
        const auto& joints = bench.joints.joints();
        const auto at = std::find(joints.begin(), joints.end(), bench.selection.joint());
        if (at != joints.end())
            bench.joints.move(static_cast<int>(at - joints.begin()), rows);
    };
    actions.bind(
        id("annotation.jointUp"), [move] { move(-1); });
    actions.bind(id("annotation.jointDown"), [move] { move(1); });
}

void bindModel(MainWindow& window) {
    constexpr double kHopelessMm = 15; // no hand of another size is as far off
    widgets::Workbench& bench = window.workbench();
    window.actions().bind(id("annotation.propose"), [&bench] { bench.model.fitOnce(); });
    QObject::connect(&bench.model, &widgets::HandModelFit::impossible, &window.statusLine(),
                     &widgets::StatusLine::sayBriefly);
    QObject::connect(
        &bench.model, &widgets::HandModelFit::fitted, &window, [&window, &bench](const widgets::ModelFit& fit) {
            std::vector<core::JointPoint> wanted;
            for (const core::JointPoint& proposal : fit.proposals) {
                if (bench.joints.contains(proposal.joint))
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
                core::proposeEdit(bench.document.annotations(), bench.session.dataset()->cameras, fit.frame,
                                  bench.document.rater(), wanted),
                MainWindow::tr("The hand model has nothing to add: every joint of the list that it knows has a mark."));
        });
}

void bindRaters(MainWindow& window) {
    widgets::Workspaces& spaces = window.workspaces();
    window.actions().bind(id("annotation.raters"), [&spaces] { spaces.raisePanel(spaces.ratersPanel()); });
    bindSecondRound(window);
}

} // namespace

void bindAnnotationActions(MainWindow& window) {
    bindWholeFrames(window);
    bindJointList(window);
    bindModel(window);
    bindRaters(window);
}

} // namespace app
