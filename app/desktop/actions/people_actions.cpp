// SPDX-License-Identifier: MIT
#include "app/desktop/actions/people_actions.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QToolButton>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/actions/footage_notice.h"
#include "app/desktop/main_window.h"
#include "widgets/panels/name_bar.h"
#include "widgets/presenters/other_marks.h"

namespace app {

namespace {

const QString kRaterSetting = QStringLiteral("rater");

/// Puts a bar below the message at the top of the window.
void addBar(MainWindow& window, QWidget* bar) {
    static_cast<QBoxLayout*>(window.centralWidget()->layout())->insertWidget(1, bar);
}

/// Under which name marks are made, all the time; a click changes it.
void showName(MainWindow& window) {
    constexpr int kMostCharacters = 24;
    auto* name = new QToolButton(&window.statusLine());
    name->setObjectName(QStringLiteral("rater"));
    name->setAutoRaise(true);
    name->setFocusPolicy(Qt::NoFocus);
    name->setToolTip(
        MainWindow::tr("The name that your marks are kept under (%1)")
            .arg(window.actions().action(id("edit.rater"))->shortcut().toString(QKeySequence::NativeText)));
    window.statusLine().layout()->addWidget(name);
    const auto refresh = [&window, name] {
        QString text = QString::fromStdString(window.session().document.rater());
        if (text.size() > kMostCharacters)
            text = text.left(kMostCharacters - 1) + QChar(0x2026);
        name->setText(text);
        name->setAccessibleName(MainWindow::tr("Your name: %1").arg(text));
    };
    QObject::connect(name, &QToolButton::clicked, window.actions().action(id("edit.rater")), &QAction::trigger);
    QObject::connect(&window.session().document, &widgets::AnnotationDocument::raterChanged, name, refresh);
    refresh();
}

void askForName(MainWindow& window) {
    auto* bar = new widgets::NameBar(window.centralWidget());
    addBar(window, bar);
    QObject::connect(bar, &widgets::NameBar::answered, &window, [&window](const QString& name) {
        window.settings().setValue(kRaterSetting, name);
        window.session().document.setRater(name.toStdString());
    });
    QObject::connect(&window.session().document, &widgets::AnnotationDocument::raterChanged, bar,
                     &QWidget::hide); // answered elsewhere
    bar->ask(QString::fromStdString(window.session().document.rater()));
}

/// Says whose marks the sequence holds besides the person's, and lets them be shown.
void announceOthers(MainWindow& window) {
    auto* bar = new widgets::MessageBar(window.centralWidget());
    bar->setObjectName(QStringLiteral("others"));
    addBar(window, bar);
    QAction* action = window.actions().action(id("view.otherRaters"));
    widgets::WindowSession& parts = window.session();
    auto* marks =
        new widgets::OtherMarks(parts.document, parts.selection, parts.raters, *window.workspaces().grid(), &window);
    QObject::connect(&parts, &widgets::WindowSession::ready, marks, &widgets::OtherMarks::refresh);
    window.actions().bindToggle(
        id("view.otherRaters"),
        [&window, marks, bar](bool on) {
            marks->setShown(on);
            if (on)
                bar->setMessage({});
            if (on && widgets::workOfOthers(window.session().document).empty())
                window.statusLine().sayBriefly(MainWindow::tr("No other person has marks in this sequence."));
        });
    const auto announce = [&window, bar, action] {
        const widgets::WindowSession& session = window.session();
        const bool mustNotKnow = session.raters.isRepeating();
        const QString text = mustNotKnow || action->isChecked()
                                 ? QString()
                                 : widgets::othersText(widgets::workOfOthers(session.document));
        bar->offer(text, {{MainWindow::tr("Show"), [action] { action->setChecked(true); }}},
                   widgets::MessageBar::Tone::Notice);
    };
    QObject::connect(&window.session(), &widgets::WindowSession::ready, &window, announce);
    QObject::connect(&window.session().document, &widgets::AnnotationDocument::raterChanged, &window, announce);
    QObject::connect(&window.session().files, &widgets::AnnotationFiles::imported, &window, announce);
}

/// "12 marks of anna and bob and 1 note in 3 frames"
QString replacedText(const core::ImportConflicts& conflicts) {
    QStringList parts, names;
    for (const std::string& rater : conflicts.raters)
        names << QString::fromStdString(rater);
    if (conflicts.marks > 0)
        parts << MainWindow::tr("%n mark(s) of %1", nullptr, conflicts.marks).arg(names.join(QStringLiteral(", ")));
    if (conflicts.notes > 0)
        parts << MainWindow::tr("%n note(s)", nullptr, conflicts.notes);
    return MainWindow::tr("%1 in %2")
        .arg(parts.join(MainWindow::tr(" and ")),
             MainWindow::tr("%n frame(s)", nullptr, static_cast<int>(conflicts.frames.size())));
}

/// What an import would replace, and labels that are of other videos, are asked about in place.
void askAboutImports(MainWindow& window) {
    constexpr int kMostVideos = 4;
    auto* bar = new widgets::MessageBar(window.centralWidget());
    bar->setObjectName(QStringLiteral("import"));
    addBar(window, bar);
    widgets::AnnotationFiles& files = window.session().files;
    const widgets::MessageAction cancel{MainWindow::tr("Cancel"), [&files] { files.cancelImport(); }};
    QObject::connect(
        &files, &widgets::AnnotationFiles::importConflicts, &window,
        [bar, &files, cancel](const QString& path, const core::ImportConflicts& conflicts) {
            bar->offer(
                MainWindow::tr("%1 would replace %2.").arg(QFileInfo(path).fileName(), replacedText(conflicts)),
                {{MainWindow::tr("Replace"), [&files] { files.finishImport(core::ImportMode::Replace); }},
                 {MainWindow::tr("Keep what is there"), [&files] { files.finishImport(core::ImportMode::Keep); }},
                 cancel},
                widgets::MessageBar::Tone::Notice);
        });
    QObject::connect(
        &files, &widgets::AnnotationFiles::otherVideosFound, &window,
        [bar, &files, cancel](const QString& kind, const QString& path, const QStringList& videos) {
            std::vector<widgets::MessageAction> actions;
            for (const QString& video : videos.mid(0, kMostVideos))
                actions.push_back({MainWindow::tr("Import %1").arg(video),
                                   [&files, kind, path, video] { files.importFrom(kind, path, {video}); }});
            actions.push_back(cancel);
            bar->offer(MainWindow::tr("%1 has labels of %2, but none of this sequence. Import them all the same?")
                           .arg(QFileInfo(path).fileName(), videos.join(QStringLiteral(", "))),
                       actions, widgets::MessageBar::Tone::Notice);
        });
    QObject::connect(bar, &widgets::MessageBar::dismissed, &files, &widgets::AnnotationFiles::cancelImport);
    QObject::connect(
        &files, &widgets::AnnotationFiles::importCancelled, bar,
        [&window, bar] {
            bar->setMessage({});
            window.statusLine().sayBriefly(MainWindow::tr("Nothing was imported."));
        });
    QObject::connect(&window.session().document, &widgets::AnnotationDocument::aboutToClose, bar,
                     [bar] { bar->setMessage({}); });
}

} // namespace

void bindPeopleActions(MainWindow& window, bool mayAsk) {
    showName(window);
    announceOthers(window);
    askAboutImports(window);
    bindFootageNotice(window);
    if (mayAsk && window.settings().value(kRaterSetting).toString().isEmpty())
        askForName(window);
}

} // namespace app
