// SPDX-License-Identifier: MIT
#include <fstream>
#include <random>

#include <QApplication>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QMimeData>
#include <QTabWidget>
#include <QtTest/QTest>

#include <nlohmann/json.hpp>

#include "app/desktop/script/real_input.h"
#include "core/io/dataset/frames.h"
#include "tests/app/no_room.h"
#include "tests/app/window_fixture.h"

namespace {

using core::Side;
using nlohmann::json;

using test::kIndex;

class WindowClicks : public test::WindowTest {
protected:
    WindowClicks() { session().selection.setJoint(kIndex); }

    Eigen::Vector2d pixel(int index) const { return *core::project(camera(index), truth(Side::Left, 1, 12)); }
    widgets::CameraView& view(int index) { return *window->workspaces().grid()->view(index); }
    void click(int index) {
        const Eigen::Vector2d px = pixel(index);
        input.click(view(index), {px.x(), px.y()}, Qt::LeftButton, Qt::NoModifier);
    }
    json exported() {
        EXPECT_EQ(play(R"({"do":"export","to":"handlens","path":"gt.json"})"), 0) << errors.str();
        std::ifstream file(path("out/gt.json").toStdString());
        return json::parse(file);
    }

    app::RealInput input{*window};
};

TEST_F(WindowClicks, BecomeGroundTruth) {
    for (const int index : {0, 3, 5})
        click(index);
    const json truthFile = exported();
    EXPECT_EQ(truthFile["format"], "handlens-ground-truth");
    ASSERT_EQ(truthFile["frames"].size(), 1u);
    EXPECT_EQ(truthFile["frames"][0]["frame"], 12);
    const json& rater = truthFile["frames"][0]["raters"][0];
    EXPECT_EQ(rater["rater"], "ann");
    const json& joint = rater["hands"]["left"]["joints"]["index_mcp"];
    const Eigen::Vector3d found(joint["xyz"][0], joint["xyz"][1], joint["xyz"][2]);
    EXPECT_LT((found - truth(Side::Left, 1, 12)).norm(), 0.02);
    ASSERT_EQ(joint["views"].size(), 3u);
    for (const json& view : joint["views"]) {
        const int index = view["camera"].get<std::string>().back() - '0';
        EXPECT_LT((Eigen::Vector2d(view["px"][0], view["px"][1]) - pixel(index)).norm(), 0.05);
        EXPECT_EQ(view["placement"], "manual");
    }
}

TEST_F(WindowClicks, KeysUndoAndRedo) {
    click(0);
    click(1);
    input.key(QStringLiteral("Ctrl+Z"), 0);
    EXPECT_EQ(session().document.annotations().marks.size(), 1u);
    input.key(QStringLiteral("Ctrl+Shift+Z"), 0);
    EXPECT_EQ(session().document.annotations().marks.size(), 2u);
    EXPECT_TRUE(window->actions().action(QStringLiteral("edit.undo"))->text().contains(QStringLiteral("index_mcp")));
}

TEST_F(WindowClicks, AreKeptWithTheirHistoryWhenTheWindowOpensAgain) {
    click(0);
    click(1);
    input.key(QStringLiteral("Ctrl+Z"), 0);
    const auto before = session().document.annotations();
    restart();
    EXPECT_EQ(session().document.annotations(), before);
    session().document.undoStack()->redo();
    EXPECT_EQ(session().document.annotations().marks.size(), 2u);
}

TEST_F(WindowClicks, AreNotLeftBehindOnAFullDisk) {
    {
        const test::NoRoom full;
        click(0);
        click(3);
        EXPECT_TRUE(session().document.hasUnsaved());
        session().opened.openSequence(QStringLiteral("b"));
        app::waitUntilIdle(*window);
        EXPECT_EQ(session().opened.sequence()->name, "a");
        EXPECT_FALSE(window->close()) << "the first time it only warns";
        EXPECT_TRUE(window->isVisible());
    }
    ASSERT_TRUE(session().document.saveNow());
    restart();
    EXPECT_EQ(exported()["frames"][0]["raters"][0]["hands"]["left"]["joints"]["index_mcp"]["views"].size(), 2u);
}

TEST_F(WindowClicks, CanBeGivenUpOnAFullDisk) {
    const test::NoRoom full;
    click(0);
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(window->close());
    window.reset();
}

TEST_F(WindowClicks, LandOnTheirPixelAtAnyZoom) {
    const Eigen::Vector2d px = pixel(2);
    input.wheel(view(2), {px.x(), px.y()}, 9);
    const QPointF target(px.x() + 0.37, px.y() - 0.21);
    input.click(view(2), target, Qt::LeftButton, Qt::NoModifier);
    const auto mark = core::markAt(session().document.annotations(), {12, "ann", kIndex, "cam2"});
    ASSERT_TRUE(mark);
    EXPECT_LT(std::hypot(mark->px.x() - target.x(), mark->px.y() - target.y()), 0.01);
}

TEST_F(WindowClicks, DragOfAMarkIsOneStep) {
    click(0);
    const Eigen::Vector2d px = pixel(0);
    input.drag(view(0), {px.x(), px.y()}, {px.x() + 30, px.y() + 20}, Qt::LeftButton, Qt::NoModifier, 8);
    const auto mark = core::markAt(session().document.annotations(), {12, "ann", kIndex, "cam0"});
    ASSERT_TRUE(mark);
    EXPECT_NEAR(mark->px.x(), px.x() + 30, 0.01);
    EXPECT_EQ(session().document.undoStack()->count(), 2);
}

TEST_F(WindowClicks, DoubleClickMaximisesAndPlacesNothing) {
    const Eigen::Vector2d px = pixel(4);
    input.doubleClick(view(4), {px.x(), px.y()});
    EXPECT_EQ(window->workspaces().grid()->maximised(), 4);
    EXPECT_TRUE(session().document.annotations().marks.empty());
    EXPECT_EQ(session().document.undoStack()->count(), 0);
    input.key(QStringLiteral("Esc"), 0);
    EXPECT_EQ(window->workspaces().grid()->maximised(), -1);
}

TEST_F(WindowClicks, ZoomStaysWhenTheFrameChanges) {
    const Eigen::Vector2d px = pixel(1);
    input.wheel(view(1), {px.x(), px.y()}, 5);
    const double scale = view(1).scale();
    const QPointF centre = view(1).viewportToImage({50, 60});
    input.key(QStringLiteral("D"), 0);
    app::waitUntilIdle(*window);
    EXPECT_EQ(session().selection.frame(), 13);
    EXPECT_DOUBLE_EQ(view(1).scale(), scale);
    EXPECT_LT(QLineF(view(1).viewportToImage({50, 60}), centre).length(), 1e-6);
}

TEST_F(WindowClicks, KeysStepAndHold) {
    session().joints.setChoice(widgets::JointChoice::AllBones, *session().opened.dataset());
    session().selection.setJoint({Side::Left, "forearm"});
    input.key(QStringLiteral("S"), 0);
    EXPECT_EQ(session().selection.joint(), kIndex);
    input.key(QStringLiteral("A"), 0);
    EXPECT_EQ(session().selection.frame(), 11);
    QAction* hide = window->actions().action(QStringLiteral("view.hideOverlays"));
    bool wasHidden = false;
    QObject::connect(hide, &QAction::toggled, hide, [&](bool on) { wasHidden = wasHidden || on; });
    input.key(QStringLiteral("H"), 20);
    EXPECT_TRUE(wasHidden);
    EXPECT_FALSE(hide->isChecked());
}

TEST_F(WindowClicks, PixelOutsideTheScreenIsRefused) {
    const Eigen::Vector2d px = pixel(1);
    input.wheel(view(1), {px.x(), px.y()}, 12);
    EXPECT_THROW(input.click(view(1), {px.x() - 100, px.y()}, Qt::LeftButton, Qt::NoModifier), std::exception);
    window->workspaces().grid()->setMaximised(0);
    EXPECT_THROW(input.click(view(1), {px.x(), px.y()}, Qt::LeftButton, Qt::NoModifier), std::exception);
}

class WindowAsAWhole : public test::WindowTest {};

TEST_F(WindowAsAWhole, OpensADroppedFolder) {
    session().opened.openSequence(QStringLiteral("b"));
    app::waitUntilIdle(*window);
    ASSERT_EQ(session().opened.sequence()->name, "b");
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(dataset().string()))});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.get(), &drop);
    app::waitUntilIdle(*window);
    EXPECT_EQ(session().opened.sequence()->name, "a");
}

TEST_F(WindowAsAWhole, KeepsWhatIsOpenWhenAnotherCannotBeOpened) {
    window->openDataset(path("nowhere"));
    app::waitUntilIdle(*window);
    ASSERT_TRUE(session().opened.sequence());
    EXPECT_EQ(session().opened.sequence()->name, "a");
    EXPECT_TRUE(session().document.isOpen());
}

/// Fit, look at it, then go on: what is inspected stays the fitted pair, in the views and in the scene.
TEST_F(WindowAsAWhole, InspectStaysWithItsPairWhenTheFrameAndTheViewChange) {
    ASSERT_EQ(play(R"({"do":"fit","start":5,"test":20,"methods":["ch","dch-thres"]})"), 0) << errors.str();
    app::RealInput input(*window);
    input.key(QStringLiteral("Ctrl+2"), 0);
    input.key(QStringLiteral("F4"), 0); // no mesh over the picture
    input.key(QStringLiteral("F7"), 0); // nor the recorded silhouette
    input.key(QStringLiteral("D"), 0);
    input.key(QStringLiteral("E"), 0);
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_EQ(session().selection.frame(), 21);
    ASSERT_EQ(session().selection.camera(), "cam1");
    const widgets::DatasetSession& opened = session().opened;
    const core::FrameSource frames(*opened.dataset(), *opened.sequence(), *opened.motion());
    widgets::CameraGrid& grid = *window->workspaces().inspectPage()->grid();
    ASSERT_EQ(grid.count(), 4);
    for (int index = 0; index < grid.count(); ++index) {
        widgets::CameraView& view = *grid.view(index);
        const int camera = 1 + index / 2;
        ASSERT_EQ(view.camera().name, "cam" + std::to_string(camera));
        const auto difference = [&](int seen, int frame) {
            const cv::Mat image = frames.read(seen, frame);
            const QImage shown = view.grabPicture();
            double sum = 0, count = 0;
            for (int y = 0; y < image.rows; ++y) {
                for (int x = 0; x < image.cols; ++x) {
                    const QPoint at = view.imageToViewport({double(x), double(y)}).toPoint();
                    if (!shown.rect().contains(at))
                        continue;
                    const QColor there = shown.pixelColor(at);
                    const cv::Vec3b here = image.at<cv::Vec3b>(y, x);
                    sum += std::abs(there.red() - here[2]) + std::abs(there.green() - here[1]) +
                           std::abs(there.blue() - here[0]);
                    ++count;
                }
            }
            return sum / std::max(1.0, count);
        };
        const double right = difference(camera, 20);
        EXPECT_LT(right, 0.75 * difference(camera, 21)) << "the current frame";
        EXPECT_LT(right, 0.5 * difference(camera - 1, 20)) << "the view that was there before";
    }
    EXPECT_TRUE(grid.view(0)->message().isEmpty());
    // In the scene stands one method, at the iteration that is shown, whatever the current frame.
    auto* choice = window->findChild<QComboBox*>(QStringLiteral("sceneChoice"));
    ASSERT_TRUE(choice->isVisible());
    EXPECT_EQ(choice->currentText(), QStringLiteral("ch"));
    input.key(QStringLiteral("F2"), 0);
    widgets::SceneView& scene = *window->workspaces().scene();
    const QImage first = scene.grabPicture();
    input.key(QStringLiteral(";"), 0);
    EXPECT_EQ(choice->currentText(), QStringLiteral("dch-thres"));
    EXPECT_NE(scene.grabPicture(), first) << "another colour";
    const QImage result = scene.grabPicture();
    input.key(QStringLiteral("F3"), 0);
    EXPECT_NE(scene.grabPicture(), result) << "wires";
    input.key(QStringLiteral("F2"), 0);
    window->workspaces().inspectPage()->setIteration(0);
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_NE(scene.grabPicture(), result) << "the start pose";
}

TEST_F(WindowAsAWhole, WordsFitTheWorkspace) {
    const auto says = [&](const QString& text) {
        for (const QLabel* label : window->statusLine().findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(text))
                return true;
        return false;
    };
    session().selection.setJoint(kIndex);
    auto* tabs = window->workspaces().findChild<QTabWidget*>();
    const auto tabOf = [&](QWidget* panel) { // panels scroll: the tab holds the panel's scroll area
        while (panel && tabs->indexOf(panel) < 0)
            panel = panel->parentWidget();
        return panel;
    };
    const auto tabShown = [&](QWidget* panel) { return tabs->isTabVisible(tabs->indexOf(tabOf(panel))); };
    EXPECT_TRUE(says(QStringLiteral("index_mcp")));
    tabs->setCurrentWidget(tabOf(window->workspaces().viewPanel()));
    app::RealInput input(*window);
    input.key(QStringLiteral("Ctrl+2"), 0);
    EXPECT_FALSE(says(QStringLiteral("index_mcp")));
    EXPECT_TRUE(says(QStringLiteral("Fit the current frame")));
    EXPECT_EQ(tabs->currentWidget(), tabOf(window->workspaces().fittingPanel()));
    EXPECT_FALSE(tabShown(window->workspaces().qualityPanel()));
    EXPECT_FALSE(tabShown(window->workspaces().ratersPanel()));
    ASSERT_EQ(play(R"({"do":"fit","start":8,"test":12,"methods":["ch"]})"), 0) << errors.str();
    EXPECT_TRUE(says(QStringLiteral("Frame 12 from frame 8")));
    EXPECT_TRUE(says(QStringLiteral("ch ")));
    input.key(QStringLiteral("Ctrl+3"), 0);
    EXPECT_FALSE(says(QStringLiteral("index_mcp")));
    EXPECT_TRUE(says(QStringLiteral("Choose methods and sequences")));
    input.key(QStringLiteral("Ctrl+1"), 0);
    EXPECT_TRUE(says(QStringLiteral("index_mcp")));
    EXPECT_TRUE(tabShown(window->workspaces().qualityPanel()));
    EXPECT_EQ(tabs->currentWidget(), tabOf(window->workspaces().viewPanel())) << "as it was left";
}

TEST_F(WindowAsAWhole, EmptyInspectFitsTheFrameWithItsButton) {
    app::RealInput input(*window);
    input.key(QStringLiteral("Ctrl+2"), 0);
    auto* page = window->workspaces().inspectPage();
    auto* button = page->findChild<QPushButton*>();
    ASSERT_TRUE(button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_TRUE(session().fits.outcome());
    EXPECT_EQ(session().fits.outcome()->request.test, 12);
    EXPECT_GT(page->grid()->count(), 0);
    EXPECT_TRUE(page->grid()->isVisible());
}

/// Every action that opens no file dialog and does not quit, one after the other, in every workspace.
TEST_F(WindowAsAWhole, EveryActionCanBeTriggered) {
    for (const char* workspace : {"workspace.annotate", "workspace.inspect", "workspace.benchmark"}) {
        for (const app::ActionRow& row : app::actionTable()) {
            const QString id = QString::fromLatin1(row.id);
            if (id.startsWith(QLatin1String("file.")))
                continue;
            window->actions().action(QString::fromLatin1(workspace))->trigger();
            window->actions().action(id)->trigger();
            for (QWidget* popup : QApplication::topLevelWidgets())
                if (popup != window.get() && popup->isVisible())
                    popup->close();
        }
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
    EXPECT_TRUE(window->isVisible());
}

/// Keys at random, as fast as they go, over everything that has a shortcut.
TEST_F(WindowAsAWhole, RandomKeysNeitherCrashNorLoseEdits) {
    std::vector<QString> keys{QStringLiteral("Tab"), QStringLiteral("Return"), QStringLiteral("Esc"),
                              QStringLiteral("7"), QStringLiteral("Backspace")};
    for (const app::ActionRow& row : app::actionTable())
        if (const QString id = QString::fromLatin1(row.id);
            *row.shortcut && !id.startsWith(QLatin1String("file.")) && id != QLatin1String("benchmark.run"))
            keys.push_back(QString::fromLatin1(row.shortcut));
    std::mt19937 random(5);
    app::RealInput input(*window);
    constexpr int kPresses = 1200;
    for (int pressed = 1; pressed <= kPresses; ++pressed) {
        input.key(keys[random() % keys.size()], 0);
        if (pressed % 7 == 0) {
            widgets::CameraView& view = *window->workspaces().grid()->view(static_cast<int>(random() % 8));
            try {
                input.click(view, {double(random() % 270), double(random() % 480)}, Qt::LeftButton, Qt::NoModifier);
            } catch (const std::exception&) { // not on the screen now
            }
        }
        if (pressed % 50 == 0)
            app::waitMs(1);
    }
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_TRUE(window->isVisible());
    const auto inMemory = session().document.annotations();
    EXPECT_FALSE(session().document.hasUnsaved());
    const auto onDisk =
        core::AnnotationStore::open(dataset() / "annotations" / (session().opened.sequence()->name + ".sqlite"),
                                    core::StoreAccess::ReadOnly)
            .annotations();
    EXPECT_EQ(inMemory, onDisk);
}

} // namespace
