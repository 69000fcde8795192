// SPDX-License-Identifier: MIT
#include "app/desktop/actions/dataset_actions.h"

#include <algorithm>
#include <array>

#include <QFileDialog>

#include "app/desktop/main_window.h"
#include "app/desktop/windows/new_dataset_window.h"
#include "widgets/jobs/footage_finder.h"

namespace app {

namespace {

/// Menus of actions about what is open, and the exceptions.
constexpr std::array kDatasetGroups = {"annotation.", "go.",        "fit.", "compare.",
                                       "view.",       "workspace.", "rig.", "subject."};
constexpr std::array kDatasetActions = {"file.import", "file.export", "file.report", "file.savePicture", "edit.note"};
constexpr std::array kWindowActions = {"view.light", "view.fullScreen", "view.toolbar"};

template <class List>
bool contains(const List& list, const QString& id) {
    return std::any_of(
        list.begin(), list.end(), [&](const char* one) { return id == QLatin1String(one); });
}

void enableAll(MainWindow& window, bool isOpen) {
    for (const ActionRow& row : actionTable()) {
        const QString id = QString::fromLatin1(row.id);
        if (needsDataset(id))
            window.actions().action(id)->setEnabled(isOpen);
    }
    window.setWorkspacesEnabled(isOpen);
}

void askWhereFootageIs(MainWindow& window, widgets::FootageFinder& finder) {
    const auto dataset = window.session().opened.dataset();
    if (!dataset || finder.isRunning())
        return;
    auto* dialog = new QFileDialog(
        &window, MainWindow::tr("Where are the videos and images now? Folders below are looked through, too."),
        QString::fromStdString(dataset->folder.parent_path().string()));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::fileSelected, &window,
                     [dataset, &finder](const QString& root) { finder.find(dataset, root); });
    dialog->open();
}

/// Opens the same dataset and frame again with the footage's new places.
void reopen(MainWindow& window, const QString& folder, int pieces, const QString& notes) {
    widgets::WindowSession& session = window.session();
    if (QString::fromStdString(session.opened.dataset()->folder.string()) != folder)
        return; // another one was opened meanwhile
    if (pieces == 0) {
        window.showMessage(MainWindow::tr("Nothing of the missing footage lies in that folder.") +
                           (notes.isEmpty() ? QString() : QLatin1Char('\n') + notes));
        return;
    }
    window.openDataset(folder, QString::fromStdString(session.opened.sequence()->name), session.selection.frame());
    window.statusLine().sayBriefly(
        MainWindow::tr("%n piece(s) of footage found; the dataset keeps the new places.", nullptr, pieces));
    if (!notes.isEmpty())
        window.showMessage(notes);
}

void bindFinder(MainWindow& window) {
    auto* finder = new widgets::FootageFinder(window.session().pool, &window);
    QObject::connect(
        &window.workspaces(), &widgets::Workspaces::footageWanted, &window,
        [&window, finder] { askWhereFootageIs(window, *finder); });
    QObject::connect(finder, &widgets::FootageFinder::started, &window,
                     [&window] { window.statusLine().showWork(MainWindow::tr("Looking for footage"), -1); });
    QObject::connect(finder, &widgets::FootageFinder::idle, &window.statusLine(), &widgets::StatusLine::hideWork);
    QObject::connect(&window.statusLine(), &widgets::StatusLine::stopRequested, finder, &widgets::FootageFinder::stop);
    QObject::connect(finder, &widgets::FootageFinder::failed, &window, &MainWindow::showMessage);
    QObject::connect(
        finder, &widgets::FootageFinder::found, &window,
        [&window](const QString& folder, int pieces, const QString& notes) { reopen(window, folder, pieces, notes); });
}

} // namespace

bool needsDataset(const QString& actionId) {
    const bool isAboutIt = std::any_of(kDatasetGroups.begin(), kDatasetGroups.end(),
                                       [&](const char* group) { return actionId.startsWith(QLatin1String(group)); });
    return contains(kDatasetActions, actionId) || (isAboutIt && !contains(kWindowActions, actionId));
}

void bindDatasetActions(MainWindow& window) {
    window.actions().bind(
        QStringLiteral("file.new"), [&window] { NewDatasetWindow::open(window, {}); });
    QObject::connect(
        &window, &MainWindow::footageDropped, &window,
        [&window](const QStringList& paths) { NewDatasetWindow::open(window, paths); });
    QObject::connect(&window.session(), &widgets::WindowSession::ready, &window,
                     [&window] { enableAll(window, true); });
    enableAll(window, false);
    bindFinder(window);
}

} // namespace app
