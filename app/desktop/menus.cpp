// SPDX-License-Identifier: MIT
#include "app/desktop/menus.h"

#include <map>
#include <string_view>

#include <QCoreApplication>
#include <QDir>
#include <QMenu>
#include <QMenuBar>

#include "app/desktop/action_table.h"
#include "app/desktop/main_window.h"

namespace app {

namespace {

/// Recent datasets, made anew each time the menu opens.
void addRecentMenu(QMenu& file, QAction* before, MainWindow& window) {
    auto* recent = new QMenu(MainWindow::tr("Open &recent"), &file);
    file.insertMenu(before, recent);
    QObject::connect(recent, &QMenu::aboutToShow, recent, [recent, &window] {
        recent->clear();
        for (const QString& folder : window.settings().value(QStringLiteral("recentDatasets")).toStringList())
            recent->addAction(QDir::toNativeSeparators(folder), recent, [folder, &window] { window.openDataset(folder); });
        if (recent->isEmpty())
            recent->addAction(MainWindow::tr("None yet"))->setEnabled(false);
    });
}

} // namespace

void buildMenus(MainWindow& window) {
    std::map<std::string_view, QMenu*> menus;
    for (const char* title : menuTitles())
        menus[title] = window.menuBar()->addMenu(QCoreApplication::translate("app::ActionTable", title));
    for (const ActionRow& row : actionTable()) {
        QMenu* menu = menus.at(row.menu);
        if (row.separatorBefore)
            menu->addSeparator();
        QAction* action = window.actions().action(QString::fromLatin1(row.id));
        if (std::string_view(row.id) == "file.demo")
            addRecentMenu(*menu, nullptr, window);
        menu->addAction(action);
    }
}

} // namespace app
