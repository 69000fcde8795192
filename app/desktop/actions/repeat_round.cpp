// SPDX-License-Identifier: MIT
#include "app/desktop/actions/repeat_round.h"

#include <QDateTime>
#include <QLocale>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"

namespace app {

namespace {

constexpr double kShare = 0.1;

void showPanel(MainWindow& window) {
    window.workspaces().raisePanel(window.workspaces().ratersPanel());
}

void begin(MainWindow& window) {
    showPanel(window);
    window.session().raters.beginRepeating(kShare, static_cast<unsigned>(QDateTime::currentSecsSinceEpoch()));
}

void end(MainWindow& window) {
    showPanel(window);
    window.session().raters.endRepeating();
}

/// Ends the round, or begins one after a question.
void toggle(MainWindow& window) {
    const widgets::RaterStudy& study = window.session().raters;
    if (study.isRepeating()) {
        end(window);
    } else if (!window.mayAsk()) {
        begin(window);
    } else {
        const QString question =
            study.openTasks() > 0
                ? MainWindow::tr("Continue the repeat round? Your first marks are hidden until you end it.")
                : MainWindow::tr("Start a repeat round? A random tenth of your finished joints is asked for once more, "
                                 "to see how well "
                                 "you repeat yourself. Your first marks are kept, and hidden until you end the round.");
        window.ask(question, {{MainWindow::tr("Start the repeat round"), [&window] { begin(window); }},
                              {MainWindow::tr("Not now"), [] {}}});
    }
}

void goToNext(MainWindow& window) {
    widgets::RaterStudy& study = window.session().raters;
    if (!study.goToNextTask())
        window.statusLine().sayBriefly(
            study.isRepeating() ? MainWindow::tr("Every joint of the round is marked: end it to see how you did.")
                                : MainWindow::tr("No repeat round is under way."));
}

/// The banner that says why the first marks are not there.
void showBanner(MainWindow& window) {
    const widgets::RaterStudy& study = window.session().raters;
    widgets::MessageBar& banner = window.banner();
    if (!study.isRepeating() || !window.session().document.isOpen()) {
        banner.setMessage({});
        return;
    }
    const QLocale locale;
    const QString text = MainWindow::tr("Repeat round: your first marks are hidden. %1 of %2 joints.")
                             .arg(locale.toString(study.tasks() - study.openTasks()), locale.toString(study.tasks()));
    if (text != banner.message())
        banner.offer(text, {{MainWindow::tr("Next"),
                             [&window] {
                                 goToNext(window);
                                 showBanner(window);
                             }},
                            {MainWindow::tr("End"), [&window] { end(window); }}});
}

} // namespace

void bindRepeatRound(MainWindow& window) {
    Actions& actions = window.actions();
    widgets::RaterStudy& study = window.session().raters;
    widgets::RatersPanel* panel = window.workspaces().ratersPanel();
    window.banner().setDismissible(false);
    const auto toggleRound = [&window] { toggle(window); };
    const auto next = [&window] { goToNext(window); };
    actions.bind(id("annotation.repeat"), toggleRound);
    actions.bind(id("annotation.repeatNext"), next);
    QObject::connect(panel, &widgets::RatersPanel::roundRequested, &window, toggleRound);
    QObject::connect(panel, &widgets::RatersPanel::nextTaskRequested, &window, next);
    QObject::connect(
        &study, &widgets::RaterStudy::roundChanged, &window, [&window] { showBanner(window); });
    QObject::connect(&study, &widgets::RaterStudy::nothingToRepeat, &window, [&window] {
        window.statusLine().sayBriefly(MainWindow::tr("Finish some joints first: there is nothing to mark again."));
    });
}

} // namespace app
