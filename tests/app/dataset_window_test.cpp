// SPDX-License-Identifier: MIT
// The window without a dataset, how one is made, and footage that has moved.
#include <QComboBox>
#include <QCoreApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QImage>
#include <QMimeData>
#include <QPushButton>

#include "app/desktop/actions/dataset_actions.h"
#include "app/desktop/windows/new_dataset_window.h"
#include "core/io/calibration/calibration.h"
#include "core/io/dataset/frames.h"
#include "tests/app/window_fixture.h"

namespace {

constexpr int kFrames = 3;

/// A window with nothing open, two cameras' calibration and a folder of images of each.
class DatasetWindow : public testing::Test {
protected:
    DatasetWindow() {
        cameras = test::tinyDataset(2).cameras;
        core::writeCalibration(folder / "calibration.json", "handlens", cameras);
        for (const core::Camera& camera : cameras)
            writeImages(camera.name);
        window = app::makeMainWindow(settings, app::WindowOptions{"ann", false});
        window->setGeometry(0, 0, 1366, 768);
        window->show();
        window->activateWindow();
    }
    QString path(const char* name) const { return QString::fromStdString((folder / name).string()); }
    void writeImages(const std::string& camera) {
        std::filesystem::create_directories(folder / "footage" / camera);
        QImage image(270, 480, QImage::Format_RGB888);
        for (int frame = 0; frame < kFrames; ++frame) {
            image.fill(QColor(40 * frame, 90, 120));
            ASSERT_TRUE(image.save(QString::fromStdString(
                (folder / "footage" / camera / ("img_000" + std::to_string(frame) + ".png")).string())));
        }
    }
    app::NewDatasetWindow* dialog() const { return window->findChild<app::NewDatasetWindow*>(); }
    QString choiceIn(int row) const {
        return qobject_cast<QComboBox*>(dialog()->table()->cellWidget(row, 1))->currentText();
    }
    /// Drops files on the window.
    void drop(const QStringList& paths) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& one : paths)
            urls << QUrl::fromLocalFile(one);
        data.setUrls(urls);
        QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent dropped({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &dropped);
    }
    /// Makes a dataset of what was dropped and waits until it is open.
    void makeDataset() {
        drop({path("footage/cam1"), path("footage/cam0")});
        ASSERT_TRUE(dialog());
        dialog()->setCalibration(path("calibration.json"));
        dialog()->setFolder(path("dataset"));
        ASSERT_TRUE(app::waitUntilIdle(*window));
        ASSERT_TRUE(dialog()->makeButton()->isEnabled());
        dialog()->makeButton()->click();
        ASSERT_TRUE(app::waitFor(*window, [this] {
            return window->session().opened.sequence() || !dialog() || !dialog()->message().isEmpty();
        }));
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }

    test::TemporaryFolder folder;
    std::vector<core::Camera> cameras;
    QSettings settings{path("settings.ini"), QSettings::IniFormat};
    std::unique_ptr<app::MainWindow> window;
};

TEST_F(DatasetWindow, ActionsAboutADatasetWaitForOne) {
    const auto isEnabled = [&](const char* id) {
        return window->actions().action(QString::fromLatin1(id))->isEnabled();
    };
    const char* const waiting[] = {"go.nextFrame",   "annotation.accept", "fit.run",  "file.export",
                                   "view.maximise1", "workspace.inspect", "edit.note"};
    const char* const always[] = {"file.open",  "file.new",   "file.demo",     "file.quit",
                                  "edit.rater", "view.light", "help.shortcuts"};
    for (const char* id : waiting)
        EXPECT_FALSE(isEnabled(id)) << id;
    for (const char* id : always)
        EXPECT_TRUE(isEnabled(id)) << id;
    makeDataset();
    for (const char* id : waiting)
        EXPECT_TRUE(isEnabled(id)) << id;
}

TEST_F(DatasetWindow, IsMadeOfDroppedFootageThatIsMatchedByName) {
    makeDataset();
    const auto& dataset = window->session().opened.dataset();
    ASSERT_TRUE(dataset);
    EXPECT_EQ(dataset->folder, folder / "dataset");
    EXPECT_EQ(dataset->sequences.front().frameCount, kFrames);
    for (const core::ViewSource& view : dataset->sequences.front().views)
        EXPECT_NE(view.path.find(view.camera), std::string::npos) << view.path;
    EXPECT_FALSE(dialog()) << "it has closed";
    EXPECT_FALSE(window->session().frames.picture(0).isNull());
}

TEST_F(DatasetWindow, EveryStepSaysWhyItCannotGoOn) {
    using Step = app::NewDatasetWindow::Step;
    drop({path("footage/cam0"), path("footage/other.mp4")});
    ASSERT_TRUE(dialog());
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_FALSE(dialog()->makeButton()->isEnabled());
    EXPECT_EQ(dialog()->reason(), QStringLiteral("Choose the calibration of the cameras."));
    dialog()->setCalibration(path("calibration.json"));
    dialog()->setFolder(path("footage"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_EQ(choiceIn(0), QStringLiteral("cam0"));
    EXPECT_EQ(choiceIn(1), QStringLiteral("not used"));
    for (const Step step : {Step::Footage, Step::Calibration, Step::Hands, Step::Silhouettes})
        EXPECT_EQ(dialog()->problem(step), QString());
    EXPECT_FALSE(dialog()->makeButton()->isEnabled());
    EXPECT_TRUE(dialog()->reason().contains(QStringLiteral("not empty"))) << dialog()->reason().toStdString();
    qobject_cast<QComboBox*>(dialog()->table()->cellWidget(1, 1))->setCurrentText(QStringLiteral("cam0"));
    EXPECT_TRUE(dialog()->problem(Step::Footage).contains(QStringLiteral("cam0")));
    dialog()->handsPage()->setDataset(path("footage"));
    EXPECT_TRUE(dialog()->problem(Step::Hands).contains(QStringLiteral("dataset.json")));
    dialog()->masksPage()->setMasks(path("nowhere"));
    EXPECT_FALSE(dialog()->problem(Step::Silhouettes).isEmpty());
    dialog()->masksPage()->setMasks(path("masks/{camera}/{frame:06}.png"));
    EXPECT_TRUE(dialog()->problem(Step::Silhouettes).isEmpty());
}

TEST_F(DatasetWindow, SaysWhatIsWrongWithTheFootageAndStaysOpen) {
    drop({path("footage/cam0"), path("footage/cam1.mp4")});
    dialog()->setCalibration(path("calibration.json"));
    dialog()->setFolder(path("dataset"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_TRUE(dialog()->makeButton()->isEnabled());
    dialog()->makeButton()->click();
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_TRUE(dialog());
    EXPECT_TRUE(dialog()->message().contains(QStringLiteral("cam1.mp4"))) << dialog()->message().toStdString();
    EXPECT_TRUE(dialog()->makeButton()->isEnabled());
    EXPECT_FALSE(std::filesystem::exists(folder / "dataset"));
}

/// How many pixels of the drawing are of that colour.
int countColour(QWidget& widget, const QColor& colour) {
    const QImage picture = widget.grab().toImage();
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixelColor(x, y) == colour ? 1 : 0;
    return count;
}

TEST_F(DatasetWindow, DrawsTheCalibrationAndRefusesOneThatMakesNoSense) {
    using Step = app::NewDatasetWindow::Step;
    const QColor odd(0xE5, 0x5B, 0x5B);
    drop({path("footage"), path("calibration.json")});
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_TRUE(app::waitUntilIdle(*window)) << "the calibration, after what was dropped";
    EXPECT_EQ(dialog()->table()->rowCount(), 2) << "both folders in the one that was dropped";
    EXPECT_EQ(choiceIn(1), QStringLiteral("cam1"));
    dialog()->goTo(Step::Calibration);
    widgets::RigDrawing* drawing = dialog()->calibrationPage()->drawing();
    EXPECT_EQ(dialog()->problem(Step::Calibration), QString());
    EXPECT_EQ(countColour(*drawing, odd), 0);
    const QColor plain = drawing->palette().color(QPalette::WindowText);
    EXPECT_GT(countColour(*drawing, plain), 30) << "two cameras";
    for (const core::Camera& camera : cameras) {
        const auto at = drawing->place(camera.centreInWorld());
        ASSERT_TRUE(at);
        EXPECT_TRUE(QRectF(drawing->rect()).contains(*at));
    }
    const auto middle = drawing->place((cameras[0].centreInWorld() + cameras[1].centreInWorld()) / 2);
    const QImage before = drawing->grab().toImage();
    QMouseEvent press(QEvent::MouseButtonPress, *middle, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QMouseEvent move(QEvent::MouseMove, *middle + QPointF(40, 10), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(drawing, &press);
    QCoreApplication::sendEvent(drawing, &move);
    EXPECT_NE(drawing->grab().toImage(), before) << "a drag turns it";
    cameras[1].size = {480, 300}; // of another camera
    core::writeCalibration(folder / "other.json", "handlens", cameras);
    dialog()->setCalibration(path("other.json"));
    ASSERT_TRUE(app::waitFor(*window, [&] { return dialog()->problem(Step::Calibration).contains("cam1"); }));
    EXPECT_TRUE(dialog()->problem(Step::Calibration).contains(QStringLiteral("480 × 300")))
        << dialog()->problem(Step::Calibration).toStdString();
    EXPECT_GT(countColour(*drawing, odd), 10);
    EXPECT_FALSE(dialog()->makeButton()->isEnabled());
}

TEST_F(DatasetWindow, GetsHandsAndSilhouettes) {
    for (const core::Camera& camera : cameras) {
        std::filesystem::create_directories(folder / "masks" / camera.name);
        QImage mask(camera.size.width, camera.size.height, QImage::Format_Grayscale8);
        mask.fill(255);
        for (int frame = 0; frame < kFrames; ++frame)
            ASSERT_TRUE(mask.save(path(("masks/" + camera.name + "/00000" + std::to_string(frame) + ".png").c_str())));
    }
    drop({path("footage/cam1"), path("footage/cam0")});
    dialog()->setCalibration(path("calibration.json"));
    dialog()->setFolder(path("dataset"));
    dialog()->masksPage()->setMasks(path("masks"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_TRUE(dialog()->makeButton()->isEnabled()) << dialog()->reason().toStdString();
    dialog()->makeButton()->click();
    ASSERT_TRUE(app::waitFor(*window, [this] { return window->session().opened.sequence() != nullptr; }));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    const core::Dataset made = core::readDataset(folder / "dataset");
    EXPECT_EQ(made.hands.size(), 2u) << "the demo's";
    EXPECT_TRUE(std::filesystem::exists(core::maskFile(made.folder, made.sequences[0], "cam1", 2)));
}

TEST_F(DatasetWindow, FootageThatHasMovedIsFoundAgain) {
    makeDataset();
    std::filesystem::create_directories(folder / "elsewhere");
    std::filesystem::rename(folder / "footage", folder / "elsewhere" / "moved");
    window->openDataset(path("dataset"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    widgets::CameraView* view = window->workspaces().grid()->view(0);
    EXPECT_FALSE(view->message().isEmpty());
    QPushButton* find = nullptr;
    for (QPushButton* button : view->findChildren<QPushButton*>())
        find = button->text() == QStringLiteral("Find...") ? button : find;
    ASSERT_TRUE(find);
    find->click();
    auto* chooser = window->findChild<QFileDialog*>();
    ASSERT_TRUE(chooser);
    emit chooser->fileSelected(path("elsewhere"));
    chooser->close();
    ASSERT_TRUE(app::waitFor(*window, [this] { return !window->session().frames.picture(0).isNull(); }));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_TRUE(view->message().isEmpty()) << view->message().toStdString();
    const core::Dataset found = core::readDataset(folder / "dataset");
    for (const core::ViewSource& source : found.sequences.front().views)
        EXPECT_NE(source.path.find("elsewhere/moved"), std::string::npos) << source.path;
}

TEST(MatchFootage, GoesByTheCamerasNames) {
    const QStringList cameras{QStringLiteral("cam1"), QStringLiteral("cam10"), QStringLiteral("left"),
                              QStringLiteral("Left2")};
    const auto match = [&](const char* path) {
        return widgets::matchFootage(cameras, {QString::fromLatin1(path)}).front().toStdString();
    };
    EXPECT_EQ(match("/a/session_cam1.mp4"), "cam1");
    EXPECT_EQ(match("/a/cam10-take2.mp4"), "cam10");
    EXPECT_EQ(match("/a/CAM1.avi"), "cam1");
    EXPECT_EQ(match("/a/cam1/video.mp4"), "cam1") << "by the folder";
    EXPECT_EQ(match("/a/left2.mp4"), "Left2");
    EXPECT_EQ(match("/a/leftover.mp4"), "");
    EXPECT_EQ(match("/a/cam1_cam10.mp4"), "") << "two of them";
    EXPECT_EQ(widgets::matchFootage(cameras, {QStringLiteral("/a/cam1_a.mp4"), QStringLiteral("/a/cam1_b.mp4")}),
              (QStringList{QStringLiteral("cam1"), QString()}));
}

} // namespace
