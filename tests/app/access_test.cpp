// SPDX-License-Identifier: MIT
// How the window is found one's way in: menus, toolbar, preferences, hints, the export's explanations, small screens.
#include <functional>
#include <map>
#include <set>

#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>

#include "app/desktop/palettes.h"
#include "app/desktop/script/real_input.h"
#include "app/desktop/windows/annotation_format_text.h"
#include "app/desktop/windows/export_window.h"
#include "app/desktop/windows/preferences_window.h"
#include "tests/app/window_fixture.h"

namespace {

class Access : public test::WindowTest {
protected:
    QAction* action(const char* id) { return window->actions().action(QString::fromLatin1(id)); }
    /// Every action below a menu, with the menu's title.
    void collect(const QMenu& menu, std::map<QAction*, QStringList>& found) const {
        for (QAction* entry : menu.actions())
            if (entry->menu())
                collect(*entry->menu(), found);
            else if (!entry->isSeparator())
                found[entry] << menu.title();
    }
    std::map<QAction*, QStringList> menus() const {
        std::map<QAction*, QStringList> found;
        for (const QAction* entry : window->menuBar()->actions())
            collect(*entry->menu(), found);
        return found;
    }
    /// What a dialog's file dialog is asked for; it is closed again.
    QStringList closeFileDialogs() {
        QStringList filters;
        for (QFileDialog* dialog : window->findChildren<QFileDialog*>()) {
            filters << dialog->nameFilters();
            dialog->close();
        }
        return filters;
    }
    app::RealInput input{*window};
};

TEST_F(Access, EveryActionStandsInOneMenu) {
    const auto found = menus();
    for (const app::ActionRow& row : app::actionTable()) {
        const auto at = found.find(action(row.id));
        EXPECT_EQ(at == found.end() ? 0 : at->second.size(), row.inMenu ? 1 : 0) << row.id;
    }
    std::map<QString, int> texts;
    for (const app::ActionRow& row : app::actionTable())
        EXPECT_EQ(++texts[window->actions().plainText(QString::fromLatin1(row.id)) + QLatin1Char('|') +
                          QString::fromLatin1(row.menu)],
                  1)
            << row.id;
}

TEST_F(Access, MenusAreShortAndRatersAreTogether) {
    std::function<void(const QMenu&)> check = [&](const QMenu& menu) {
        int entries = 0, run = 0, longest = 0;
        for (const QAction* entry : menu.actions()) {
            run = entry->isSeparator() ? 0 : run + 1;
            entries += !entry->isSeparator();
            longest = std::max(longest, run);
            if (entry->menu())
                check(*entry->menu());
        }
        EXPECT_LE(entries, 20) << menu.title().toStdString();
        EXPECT_LE(longest, 9) << menu.title().toStdString() << ": groups are separated";
        if (menu.isEmpty())
            return; // it is filled when it opens
        EXPECT_FALSE(menu.actions().front()->isSeparator()) << menu.title().toStdString();
    };
    for (const QAction* entry : window->menuBar()->actions())
        check(*entry->menu());
    const auto found = menus();
    for (const char* id : {"edit.rater", "annotation.raters", "annotation.repeat", "annotation.repeatNext"})
        EXPECT_EQ(found.at(action(id)).front(), found.at(action("annotation.raters")).front()) << id;
    for (const char* id : {"compare.previousIteration", "compare.lastIteration"})
        EXPECT_EQ(found.at(action(id)).front(), found.at(action("fit.run")).front()) << id;
}

TEST_F(Access, TheToolbarHasIconsWithTextsAndCanBeHidden) {
    app::applyLook(*qApp, app::Look::Dark); // names the icons' theme
    restart();
    auto* bar = window->findChild<QToolBar*>();
    ASSERT_TRUE(bar && bar->isVisible());
    EXPECT_LE(std::min(bar->width(), bar->height()), 36) << "slim";
    std::set<QString> ids;
    for (QToolButton* button : bar->findChildren<QToolButton*>()) {
        const QAction* shown = button->defaultAction();
        if (!shown) // the button for what does not fit
            continue;
        ids.insert(shown->objectName());
        EXPECT_FALSE(shown->icon().isNull()) << shown->objectName().toStdString();
        EXPECT_TRUE(button->toolTip().startsWith(window->actions().plainText(shown->objectName())))
            << button->toolTip().toStdString();
        EXPECT_TRUE(button->toolTip().contains(shown->shortcut().toString(QKeySequence::NativeText)));
    }
    for (const char* id :
         {"edit.undo", "edit.redo", "annotation.accept", "annotation.occluded", "annotation.unplaceable",
          "view.frameHands", "view.loupe", "view.fitAll", "view.modelOfMarks", "fit.run", "file.export"})
        EXPECT_TRUE(ids.count(QString::fromLatin1(id))) << id;
    app::RealInput(*window).key(QStringLiteral("Ctrl+Shift+T"), 0); // this window, not the one before
    EXPECT_FALSE(bar->isVisible());
    restart();
    EXPECT_FALSE(window->findChild<QToolBar*>()->isVisible()) << "it stays hidden";
}

TEST_F(Access, ToolsForMarksAreDimmedWhereNothingCanBeMarked) {
    app::applyLook(*qApp, app::Look::Dark);
    QPixmap square(16, 16);
    square.fill(Qt::lightGray);
    const QImage dimmed = QIcon(square).pixmap(square.size(), QIcon::Disabled).toImage();
    EXPECT_LT(dimmed.pixelColor(8, 8).alphaF(), 0.5) << "icons of one colour, too";
    const auto* bar = window->findChild<QToolBar*>();
    const auto isLit = [&](const char* id) { return bar->widgetForAction(action(id))->isEnabled(); };
    const auto go = [&](const char* workspace) {
        action(workspace)->trigger();
        app::waitUntilIdle(*window);
    };
    for (const char* id : {"annotation.accept", "annotation.occluded", "annotation.unplaceable", "annotation.remove"}) {
        go("workspace.annotate");
        EXPECT_TRUE(isLit(id)) << id;
        for (const char* workspace : {"workspace.inspect", "workspace.benchmark"}) {
            go(workspace);
            EXPECT_FALSE(isLit(id)) << id << " in " << workspace;
            action(id)->setStatusTip(QString::fromLatin1(workspace)); // the button takes over what changes
            app::waitUntilIdle(*window);
            EXPECT_FALSE(isLit(id)) << id << " in " << workspace << ", still";
            EXPECT_TRUE(action(id)->isEnabled()) << "keys and scripts go on";
        }
    }
    go("workspace.inspect");
    EXPECT_TRUE(isLit("fit.run"));
}

TEST_F(Access, KeysFrameTheHandsAndShowWholeImages) {
    widgets::CameraView& view = *window->workspaces().grid()->view(0);
    const double framed = view.scale();
    input.key(QStringLiteral("0"), 0);
    EXPECT_LT(view.scale(), 0.9 * framed);
    input.key(QStringLiteral("9"), 0);
    EXPECT_DOUBLE_EQ(view.scale(), framed);
}

TEST_F(Access, ScriptsReachEveryPixelOfAFramedView) {
    widgets::CameraView& view = *window->workspaces().grid()->view(0);
    ASSERT_FALSE(QRectF(view.viewport()->rect()).contains(view.imageToViewport({3, 4})));
    ASSERT_EQ(play(R"({"do":"select","hand":"left","joint":"index_mcp"}
{"do":"click","camera":"cam0","px":[3.25,4.5]})"),
              0)
        << errors.str();
    const auto mark =
        core::markAt(session().document.annotations(), {12, "ann", {core::Side::Left, "index_mcp"}, "cam0"});
    ASSERT_TRUE(mark);
    EXPECT_LT((mark->px - Eigen::Vector2d(3.25, 4.5)).norm(), 0.5);
}

TEST_F(Access, OneKeyHidesAHandWithItsMesh) {
    const auto& look = window->workspaces().layers()->look();
    input.key(QStringLiteral("Shift+F5"), 0);
    EXPECT_FALSE(look.leftShown);
    EXPECT_TRUE(look.rightShown);
    EXPECT_EQ(window->workspaces().grid()->view(0)->handLabels().size(), 1u);
    input.key(QStringLiteral("Shift+F5"), 0);
    EXPECT_TRUE(look.leftShown);
    input.key(QStringLiteral("F6"), 0);
    EXPECT_FALSE(look.rightShown);
    input.key(QStringLiteral("Shift+F6"), 0);
    input.key(QStringLiteral("Shift+F6"), 0);
    EXPECT_FALSE(look.rightShown) << "its mesh alone was hidden before";
}

TEST_F(Access, HintsCloseWithEscape) {
    window->showHints();
    auto* hints = window->findChild<widgets::Hints*>();
    ASSERT_TRUE(hints && hints->isVisible());
    window->workspaces().grid()->setMaximised(1);
    input.key(QStringLiteral("Esc"), 0);
    EXPECT_FALSE(hints->isVisible());
    EXPECT_EQ(window->workspaces().grid()->maximised(), 1) << "one thing at a time";
    EXPECT_TRUE(settings->value(QStringLiteral("hintsSeen")).toBool());
    input.key(QStringLiteral("Esc"), 0);
    EXPECT_EQ(window->workspaces().grid()->maximised(), -1);
}

TEST_F(Access, PreferencesAreKept) {
    input.key(QStringLiteral("Ctrl+,"), 0);
    auto* page = window->findChild<app::PreferencesWindow*>();
    ASSERT_TRUE(page && page->isVisible());
    const auto choose = [&](const char* name, const QString& data) {
        auto* box = page->findChild<QComboBox*>(QString::fromLatin1(name));
        const int index = box->findData(data);
        ASSERT_GE(index, 0) << name;
        box->setCurrentIndex(index);
        emit box->activated(index);
    };
    choose("language", QStringLiteral("de"));
    EXPECT_EQ(settings->value(QStringLiteral("language")).toString(), QStringLiteral("de"));
    choose("colours", QStringLiteral("light"));
    EXPECT_TRUE(action("view.light")->isChecked());
    EXPECT_EQ(QApplication::palette().color(QPalette::Window),
              app::paletteFor(app::Look::Light).color(QPalette::Window));
    choose("colours", QStringLiteral("system"));
    EXPECT_EQ(app::lookFromName(settings->value(QStringLiteral("look")).toString()), app::Look::System);
    choose("colours", QStringLiteral("dark"));
    auto* name = page->findChild<QLineEdit*>(QStringLiteral("name"));
    EXPECT_EQ(name->text(), QStringLiteral("ann"));
    name->setText(QStringLiteral(" bea "));
    emit name->editingFinished();
    EXPECT_EQ(session().document.rater(), "bea");
    page->findChild<QSpinBox*>(QStringLiteral("memory"))->setValue(2048);
    EXPECT_EQ(settings->value(QStringLiteral("pictureMemoryMb")).toInt(), 2048);
    action("edit.shortcuts")->trigger();
    EXPECT_EQ(page->findChild<QTabWidget*>()->currentIndex(), 1) << "the keys";
    EXPECT_EQ(window->findChildren<app::PreferencesWindow*>().size(), 1);
}

TEST_F(Access, TheExportExplainsEveryFormat) {
    std::set<QString> names;
    for (const core::AnnotationFormat& format : core::annotationFormats()) {
        const app::AnnotationFormatText text = app::annotationFormatText(format.kind);
        EXPECT_TRUE(names.insert(text.name).second) << format.kind;
        for (const QString& part : {text.holds, text.readBy, text.lost})
            EXPECT_GT(part.size(), 8) << format.kind;
        EXPECT_TRUE(text.holds.endsWith(QLatin1Char('.'))) << format.kind;
        EXPECT_EQ(text.suffix.isEmpty(), format.isFolder) << format.kind;
    }
    input.key(QStringLiteral("Ctrl+E"), 0);
    auto* dialog = window->findChild<app::ExportWindow*>();
    ASSERT_TRUE(dialog && dialog->isVisible());
    auto* list = dialog->findChild<QListWidget*>();
    std::vector<std::string_view> kinds;
    for (const core::AnnotationFormat& format : core::annotationFormats())
        if (format.canExport)
            kinds.push_back(format.kind);
    ASSERT_EQ(list->count(), static_cast<int>(kinds.size()));
    const auto says = [&](const QString& text) {
        const auto labels = dialog->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->text() == text; });
    };
    for (int row = 0; row < list->count(); ++row) {
        list->setCurrentRow(row);
        const auto text = app::annotationFormatText(kinds[static_cast<std::size_t>(row)]);
        EXPECT_TRUE(says(text.holds) && says(text.readBy) && says(text.lost)) << text.name.toStdString();
    }
    list->setCurrentRow(2);
    ASSERT_EQ(dialog->kind(), QStringLiteral("coco"));
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
        if (button->isDefault())
            button->click();
    EXPECT_EQ(closeFileDialogs(), QStringList{QStringLiteral("COCO keypoints (*.json)")});
}

/// 1920 logical pixels are 1097 at 175 % and 960 at 200 %.
TEST_F(Access, TheWindowFitsSmallScreens) {
    EXPECT_LE(window->minimumSizeHint().width(), 960);
    EXPECT_LE(window->minimumSizeHint().height(), 540);
    for (const QSize& size : {QSize(1366, 768), QSize(1097, 617), QSize(960, 540)}) {
        for (const char* workspace : {"workspace.inspect", "workspace.benchmark", "workspace.annotate"}) {
            action(workspace)->trigger();
            window->resize(size);
            ASSERT_TRUE(app::waitUntilIdle(*window));
            EXPECT_EQ(window->size(), size) << workspace;
        }
        const QTableView& table = *window->workspaces().jointsPanel()->table();
        EXPECT_GE(table.columnWidth(widgets::JointTableModel::Joint),
                  static_cast<const QAbstractItemView&>(table).sizeHintForColumn(widgets::JointTableModel::Joint))
            << size.width();
        EXPECT_GE(window->workspaces().grid()->width(), size.width() * 2 / 5) << "the views come first";
    }
}

} // namespace
