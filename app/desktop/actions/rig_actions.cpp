// SPDX-License-Identifier: MIT
#include "app/desktop/actions/rig_actions.h"

#include <QDir>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"
#include "app/desktop/windows/page_window.h"
#include "widgets/panels/quality/refinement_page.h"
#include "widgets/panels/quality/subject_page.h"
#include "widgets/text/rig_text.h"

namespace app {

namespace {

widgets::RefinementPage& showRefinement(MainWindow& window) {
    return showPage<widgets::RefinementPage>(
        window, MainWindow::tr("Refine the calibration"),
        [&window] { return new widgets::RefinementPage(window.session().rig, window.session().calibrations); });
}

widgets::SubjectPage& showSubject(MainWindow& window) {
    return showPage<widgets::SubjectPage>(
        window, MainWindow::tr("Measure this person's hands"),
        [&window] {
            auto* page = new widgets::SubjectPage(window.session().subject);
            QObject::connect(
                page, &widgets::SubjectPage::openRequested, &window,
                [&window, page](const QString& folder) {
                    page->window()->close();
                    window.openDataset(folder);
                });
            return page;
        });
}

void showHealth(MainWindow& window) {
    widgets::Workspaces& spaces = window.workspaces();
    spaces.raisePanel(spaces.qualityPanel());
    spaces.qualityPanel()->showCameras();
}

void bindRigItems(MainWindow& window) {
    Actions& actions = window.actions();
    actions.bind(
        id("rig.health"), [&window] { showHealth(window); });
    actions.bind(
        id("rig.refine"), [&window] { showRefinement(window).refine(); });
    actions.bind(
        id("rig.apply"),
        [&window] {
            if (window.session().rig.proposal())
                showRefinement(window).apply();
            else
                window.statusLine().sayBriefly(MainWindow::tr("Refine the calibration first."));
        });
    actions.bind(
        id("subject.measure"), [&window] { showSubject(window); });
    actions.bind(id("subject.run"), [&window] { showSubject(window).measure(); });
    widgets::ResidualArrows* arrows = window.workspaces().residuals();
    actions.bindToggle(id("view.residuals"), [&window, arrows](bool on) {
        arrows->setShown(on);
        const auto& state = window.session().rig.state();
        if (on && (!state || state->health.joints == 0))
            window.statusLine().sayBriefly(MainWindow::tr("No joint is clicked in two cameras yet."));
    });
    window.workspaces().qualityPanel()->cameras()->setArrowsAction(actions.action(id("view.residuals")));
    QObject::connect(window.workspaces().qualityPanel(), &widgets::QualityPanel::refineRequested,
                     actions.action(id("rig.refine")), &QAction::trigger);
}

/// What is wrong with the cameras stands in the status line, once, as long as it is so.
void announceRig(MainWindow& window) {
    widgets::RigStudy& rig = window.session().rig;
    QObject::connect(
        &rig, &widgets::RigStudy::changed, &window,
        [&window, &rig] {
            window.statusLine().setNotice(
                rig.state() ? widgets::rigNoticeText(rig.state()->health, rig.state()->sequences) : QString());
        });
    QObject::connect(
        &window.statusLine(), &widgets::StatusLine::noticeClicked, &window, [&window] { showHealth(window); });
    QObject::connect(&window.session().calibrations, &widgets::CalibrationChoice::used, &window,
                     [&window](const QString& file) {
                         window.statusLine().sayBriefly(
                             MainWindow::tr("The dataset uses %1 now; all joints were reconstructed anew.").arg(file));
                     });
}

/// Long work is seen in the status line, too: the window of its own may be closed.
void announceWork(MainWindow& window) {
    widgets::StatusLine& line = window.statusLine();
    widgets::RigStudy& rig = window.session().rig;
    widgets::SubjectStudy& subject = window.session().subject;
    QObject::connect(
        &rig, &widgets::RigStudy::refiningChanged, &line,
        [&line, &rig] {
            rig.isRefining() ? line.showWork(MainWindow::tr("Refining the calibration"), -1) : line.hideWork();
        });
    QObject::connect(
        &subject, &widgets::SubjectStudy::runningChanged, &line,
        [&line, &subject] {
            subject.isMeasuring() || subject.isSaving() ? line.showWork(MainWindow::tr("Measuring hands"), -1)
                                                        : line.hideWork();
        });
    QObject::connect(&subject, &widgets::SubjectStudy::progressed, &line,
                     [&line](double fraction, const QString& stage) {
                         line.showWork(MainWindow::tr("Measuring hands: %1").arg(stage), fraction);
                     });
    QObject::connect(&line, &widgets::StatusLine::stopRequested, &rig, &widgets::RigStudy::stop);
    QObject::connect(&line, &widgets::StatusLine::stopRequested, &subject, &widgets::SubjectStudy::stop);
}

} // namespace

void bindRigActions(MainWindow& window) {
    bindRigItems(window);
    announceRig(window);
    announceWork(window);
}

} // namespace app
