// SPDX-License-Identifier: MIT
#include "app/desktop/actions/menus.h"

#include <map>
#include <string_view>

#include <QCoreApplication>
#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/desktop/actions/action_table.h"
#include "app/desktop/actions/mnemonics.h"
#include "app/desktop/main_window.h"

namespace app {

namespace {

constexpr int kToolIcon = 16; // logical pixels
const QString kToolbarSetting = QStringLiteral("window/toolbar");

/// What a newcomer needs, from making a mark to exporting it; null is a gap.
constexpr const char* kTools[] = {"edit.undo",
                                  "edit.redo",
                                  nullptr,
                                  "annotation.accept",
                                  "annotation.occluded",
                                  "annotation.unplaceable",
                                  "annotation.remove",
                                  nullptr,
                                  "view.frameHands",
                                  "view.fitAll",
                                  "view.loupe",
                                  nullptr,
                                  "annotation.propose",
                                  "view.modelOfMarks",
                                  "fit.run",
                                  nullptr,
                                  "go.nextBad",
                                  "file.export",
                                  "help.shortcuts"};

/// What works on marks: they are seen where one annotates.
constexpr const char* kMarkTools[] = {"annotation.accept", "annotation.occluded", "annotation.unplaceable",
                                      "annotation.remove"};

/// Their buttons alone are dimmed elsewhere: keys and scripts reach the actions everywhere.
void dimMarkTools(const QToolBar& bar, MainWindow& window) {
    const bool annotates = window.workspaces().current() == widgets::Workspaces::Kind::Annotate;
    for (const char* name : kMarkTools) {
        QAction* action = window.actions().action(QString::fromLatin1(name));
        bar.widgetForAction(action)->setEnabled(annotates && action->isEnabled());
    }
}

/// Recent datasets, made anew each time the menu opens.
void addRecentMenu(QMenu& file, QAction* before, MainWindow& window) {
    auto* recent = new QMenu(MainWindow::tr("Open &recent"), &file);
    file.insertMenu(before, recent);
    QObject::connect(recent, &QMenu::aboutToShow, recent, [recent, &window] {
        recent->clear();
        for (const QString& folder : window.settings().value(QStringLiteral("recentDatasets")).toStringList())
            recent->addAction(QDir::toNativeSeparators(folder), recent,
                              [folder, &window] { window.openDataset(folder); });
        if (recent->isEmpty())
            recent->addAction(MainWindow::tr("None yet"))->setEnabled(false);
    });
}

/// The menus by their titles. Parts of menus are put into theirs when the first action of the part comes.
class MenuTree {
public:
    explicit MenuTree(QMenuBar& bar) {
        for (const MenuRow& row : menuTable())
            if (row.parent)
                m_parents[row.title] = row.parent;
            else
                m_menus[row.title] = bar.addMenu(translated(row.title));
    }
    QMenu* menu(std::string_view title) const { return m_menus.at(title); }

    void add(const ActionRow& row, QAction* action) {
        const bool opensPart = m_menus.find(row.menu) == m_menus.end();
        QMenu* parent = opensPart ? m_menus.at(m_parents.at(row.menu)) : m_menus.at(row.menu);
        if (row.separatorBefore)
            parent->addSeparator();
        if (opensPart)
            m_menus[row.menu] = parent->addMenu(translated(row.menu));
        m_menus.at(row.menu)->addAction(action);
    }

private:
    static QString translated(const char* title) { return QCoreApplication::translate("app::ActionTable", title); }

    std::map<std::string_view, QMenu*> m_menus;
    std::map<std::string_view, std::string_view> m_parents;
};

} // namespace

void buildMenus(MainWindow& window) {
    MenuTree menus(*window.menuBar());
    for (const ActionRow& row : actionTable()) {
        if (std::string_view(row.id) == "file.demo")
            addRecentMenu(*menus.menu(row.menu), nullptr, window);
        if (row.inMenu)
            menus.add(row, window.actions().action(QString::fromLatin1(row.id)));
    }
    setDistinctMnemonics(*window.menuBar());
    for (QMenu* menu : window.menuBar()->findChildren<QMenu*>())
        setDistinctMnemonics(*menu);
}

void buildToolbar(MainWindow& window) {
    auto* bar = new QToolBar(MainWindow::tr("Toolbar"), &window);
    bar->setObjectName(QStringLiteral("toolbar"));
    bar->setIconSize({kToolIcon, kToolIcon});
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    for (const char* name : kTools)
        if (!name)
            bar->addSeparator();
        else
            bar->addAction(window.actions().action(QString::fromLatin1(name)));
    for (QToolButton* button : bar->findChildren<QToolButton*>())
        button->setFocusPolicy(Qt::NoFocus);
    window.addToolBar(Qt::LeftToolBarArea, bar);
    const auto dim = [bar, &window] { dimMarkTools(*bar, window); };
    QObject::connect(&window.workspaces(), &widgets::Workspaces::currentChanged, bar, dim);
    for (const char* name : kMarkTools) // the button takes its action's state over, after this
        QObject::connect(window.actions().action(QString::fromLatin1(name)), &QAction::changed, bar, dim,
                         Qt::QueuedConnection);
    QAction* shown = window.actions().action(QStringLiteral("view.toolbar"));
    shown->setChecked(window.settings().value(kToolbarSetting, true).toBool());
    bar->setVisible(shown->isChecked());
    window.actions().bindToggle(QStringLiteral("view.toolbar"), [bar, &window](bool on) {
        bar->setVisible(on);
        window.settings().setValue(kToolbarSetting, on);
    });
}

} // namespace app
