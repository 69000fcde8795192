// SPDX-License-Identifier: MIT
#include <QTableView>

#include "core/benchmark/pairs.h"
#include "core/contour/rasteriser.h"
#include "core/error.h"
#include "core/io/benchmark/benchmark_folder.h"
#include "core/io/dataset/frames.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"
#include "core/io/footage/image_file.h"
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/panels/fitting_panel.h"
#include "widgets/session/mask_attacher.h"
#include "widgets/workspaces/benchmark_page.h"
#include "widgets/workspaces/inspect_page.h"

namespace {

class FitPanelsTest : public test::PanelTest {
protected:
    FitPanelsTest() {
        for (QWidget* widget : std::initializer_list<QWidget*>{&fitting, &inspect, &benchmark}) {
            widget->resize(900, 700);
            widget->show();
        }
    }
    /// The page came after the dataset was opened: once more, so that it knows the sequences.
    void reopen() {
        session.opened.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
    }
    /// A run of all methods on some pairs, to its end.
    void runBenchmark() {
        reopen();
        for (QCheckBox* box : benchmark.findChildren<QCheckBox*>())
            box->setChecked(box->text() == QStringLiteral("dch-thres") || box->text() == QStringLiteral("ch"));
        differences().setText(QStringLiteral("1, 3"));
        child<QDoubleSpinBox>(benchmark)->setValue(5);
        session.benchmarks.run(benchmark.request());
        settle();
    }
    QTableView& benchmarkTable(const char* name) {
        return *benchmark.findChild<QTableView*>(QString::fromLatin1(name));
    }
    QLineEdit& differences() {
        const auto fields = benchmark.findChildren<QLineEdit*>();
        return **std::find_if(fields.begin(), fields.end(),
                              [](const QLineEdit* field) { return field->text().startsWith(QStringLiteral("1, 5")); });
    }

    widgets::FittingPanel fitting{session.selection, session.fits};
    widgets::InspectPage inspect{session.fits, session.opened, session.selection, session.shownCameras, session.pool};
    widgets::BenchmarkPage benchmark{session.benchmarks, session.opened, session.document, session.coverage};
};

TEST_F(FitPanelsTest, AFitFillsTableAndColumns) {
    EXPECT_FALSE(child<QComboBox>(fitting)->isVisible()) << "there are no masks to choose";
    fitting.fit({8, 12, {"ch", "best"}, widgets::FitTarget::Recorded});
    settle();
    QTableView& table = *child<QTableView>(fitting);
    ASSERT_EQ(table.model()->rowCount(), 2);
    EXPECT_EQ(cell(table, 1, 0), QStringLiteral("best"));
    EXPECT_EQ(fitting.chosenMethods(), (std::vector<std::string>{"ch", "best"}));
    EXPECT_EQ(inspect.grid()->count(), 2 * 2); // two cameras to begin with
    EXPECT_EQ(inspect.iteration(), inspect.lastIteration());
    inspect.setIteration(0);
    EXPECT_EQ(inspect.iteration(), 0);
    inspect.setIteration(1000);
    EXPECT_EQ(inspect.iteration(), inspect.lastIteration());
    session.opened.openSequence(QStringLiteral("b"));
    settle();
    EXPECT_EQ(table.model()->rowCount(), 0);
    EXPECT_EQ(inspect.grid()->count(), 0);
}

TEST_F(FitPanelsTest, TheFirstFrameIsFittedFromALaterOne) {
    for (QCheckBox* box : fitting.findChildren<QCheckBox*>())
        box->setChecked(box->text() == QStringLiteral("ch"));
    session.selection.setFrame(0);
    fitting.fitCurrentFrame();
    settle();
    ASSERT_TRUE(session.fits.outcome());
    EXPECT_EQ(session.fits.outcome()->request.test, 0);
    EXPECT_EQ(session.fits.outcome()->request.start, 5);
}

TEST_F(FitPanelsTest, TheFieldsFollowTheFrameUntilAPairIsChosen) {
    const auto boxes = fitting.findChildren<QSpinBox*>();
    const auto pair = [&] { return std::pair(fitting.request().start, fitting.request().test); };
    session.selection.setFrame(17);
    EXPECT_EQ(pair(), std::pair(12, 17)) << "as the button of the empty workspace would fit";
    session.selection.setFrame(2);
    EXPECT_EQ(pair(), std::pair(0, 2));
    boxes[0]->setValue(1);
    session.selection.setFrame(17);
    EXPECT_EQ(pair(), std::pair(1, 2)) << "what a person has chosen stays";
    session.opened.openSequence(QStringLiteral("b"), 9);
    settle();
    EXPECT_EQ(pair(), std::pair(8, 9)) << "another sequence: as far apart as the last pair";
}

TEST_F(FitPanelsTest, ColumnsLookAtTheHandsTogether) {
    fitting.fit({8, 12, {"ch", "best"}, widgets::FitTarget::Recorded});
    settle();
    widgets::CameraView& first = *inspect.grid()->view(0);
    const QRectF hands = session.fits.outcome()->handsPx[0];
    EXPECT_NEAR(first.viewportToImage(QRectF(first.viewport()->rect()).center()).x(), hands.center().x(), 1);
    const double whole = std::min(first.viewport()->width() / 270.0, first.viewport()->height() / 480.0);
    EXPECT_GT(first.scale(), 1.2 * whole) << "the hands, not the whole image";
    first.zoomAt(QRectF(first.viewport()->rect()).center(), 2);
    EXPECT_DOUBLE_EQ(inspect.grid()->view(1)->scale(), first.scale());
}

TEST_F(FitPanelsTest, RefusedFitsSayWhyInThePanel) {
    fitting.fit({8, 12, {}, widgets::FitTarget::Recorded});
    const auto* bar = child<widgets::MessageBar>(fitting);
    EXPECT_TRUE(bar->message().contains(QStringLiteral("method")));
    fitting.fit({8, 12, {"ch"}, widgets::FitTarget::Recorded});
    settle();
    EXPECT_TRUE(bar->message().isEmpty());
}

TEST_F(FitPanelsTest, TheBenchmarkRunsWhatItsFieldsSay) {
    reopen();
    for (QCheckBox* box : benchmark.findChildren<QCheckBox*>())
        box->setChecked(box->text() == QStringLiteral("dch-thres"));
    differences().setText(QStringLiteral("1, 3"));
    child<QDoubleSpinBox>(benchmark)->setValue(5);
    const widgets::BenchmarkRequest request = benchmark.request();
    EXPECT_EQ(request.methods, (std::vector<std::string>{"dch-thres"}));
    EXPECT_EQ(request.pairs.differences, (std::vector<int>{1, 3}));
    EXPECT_NEAR(request.pairs.fraction, 0.05, 1e-12);
    session.benchmarks.run(request);
    settle();
    ASSERT_TRUE(session.benchmarks.results());
    const std::vector<QTableView*> tables{&benchmarkTable("benchmarkSummary"), &benchmarkTable("benchmarkPairs")};
    EXPECT_EQ(tables[0]->model()->rowCount(), 2); // start, dch-thres
    EXPECT_EQ(tables[1]->model()->rowCount(), static_cast<int>(session.benchmarks.results()->rows.size()));
    const std::set<int> tests = benchmark.testFrames();
    std::set<int> ran;
    for (const core::FramePair& pair : session.benchmarks.results()->pairs)
        if (pair.sequence == "a")
            ran.insert(pair.test);
    EXPECT_EQ(tests, ran);
    std::optional<widgets::FitRequest> opened;
    QObject::connect(&benchmark, &widgets::BenchmarkPage::pairOpened,
                     [&](const QString&, const widgets::FitRequest& asked) { opened = asked; });
    QTest::qWait(20); // laid out
    QTest::mouseClick(tables[1]->viewport(), Qt::LeftButton, {},
                      tables[1]->visualRect(tables[1]->model()->index(0, 0)).center());
    QTest::mouseDClick(tables[1]->viewport(), Qt::LeftButton, {},
                       tables[1]->visualRect(tables[1]->model()->index(0, 0)).center());
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->methods, request.methods);
    const auto& pairs = session.benchmarks.results()->pairs;
    EXPECT_TRUE(std::any_of(pairs.begin(), pairs.end(), [&](const core::FramePair& pair) {
        return pair.start == opened->start && pair.test == opened->test;
    }));
}

TEST_F(FitPanelsTest, HalfTypedDifferencesAreRefusedInWords) {
    reopen();
    differences().setText(QStringLiteral("1, x"));
    EXPECT_TRUE(benchmark.objection(benchmark.request()).contains(QStringLiteral("\u201cx\u201d")));
    EXPECT_TRUE(benchmark.testFrames().empty());
    const auto buttons = benchmark.findChildren<QPushButton*>();
    const auto run = std::find_if(buttons.begin(), buttons.end(),
                                  [](const QPushButton* button) { return button->text() == QStringLiteral("Run"); });
    ASSERT_NE(run, buttons.end());
    QTest::mouseClick(*run, Qt::LeftButton);
    EXPECT_TRUE(child<widgets::MessageBar>(benchmark)->message().contains(QStringLiteral("\u201cx\u201d")));
    EXPECT_FALSE(session.benchmarks.isRunning());
}

/// The image of a view without what is drawn over it.
QImage picture(widgets::CameraView& view) {
    view.setMeshLayers({});
    view.setSkeleton({});
    view.finishDrawing();
    return view.grabPicture();
}

TEST_F(FitPanelsTest, InspectShowsThePicturesOfItsOwnPair) {
    fitting.fit({8, 12, {"ch", "best"}, widgets::FitTarget::Recorded});
    settle();
    const core::FrameSource frames(*session.opened.dataset(), *session.opened.sequence(), *session.opened.motion());
    const auto expected = [&](const widgets::CameraView& like, int camera, int frame) {
        const cv::Mat image = frames.read(camera, frame);
        widgets::CameraView view;
        view.setCamera(like.camera());
        view.resize(like.size());
        view.show();
        view.setImage(QImage(image.data, image.cols, image.rows, static_cast<int>(image.step), QImage::Format_BGR888)
                          .convertToFormat(QImage::Format_RGB32));
        view.lookAt(like.viewportToImage(QRectF(like.viewport()->rect()).center()), like.scale());
        return view.grabPicture();
    };
    session.selection.setFrame(13);      // the key D
    session.selection.setCamera("cam1"); // the key E
    settle();
    for (int i = 0; i < inspect.grid()->count(); ++i) {
        widgets::CameraView& view = *inspect.grid()->view(i);
        const int camera = 1 + i / 2;
        ASSERT_EQ(view.camera().name, "cam" + std::to_string(camera));
        EXPECT_EQ(picture(view), expected(view, camera, 12)) << i;
        EXPECT_NE(picture(view), expected(view, camera, 13)) << "the current frame";
        EXPECT_NE(picture(view), expected(view, camera - 1, 12)) << "the camera that was there before";
    }
}

TEST_F(FitPanelsTest, InspectDrawsMeshesAsItIsAskedTo) {
    fitting.fit({8, 12, {"ch"}, widgets::FitTarget::Recorded});
    settle();
    widgets::CameraView& view = *inspect.grid()->view(0);
    const auto shown = [&](const widgets::LayerLook& look, bool start, bool recorded) {
        inspect.setLook(look, start, recorded);
        view.finishDrawing();
        return view.grabPicture();
    };
    widgets::LayerLook look;
    look.opacity = 0.9;
    const QImage shaded = shown(look, false, false);
    EXPECT_NE(shown(look, false, true), shaded) << "the recorded silhouette";
    EXPECT_NE(shown(look, true, false), shaded) << "the start pose";
    look.opacity = 0.3;
    EXPECT_NE(shown(look, false, false), shaded) << "opacity";
    look.style = widgets::MeshStyle::Wireframe;
    const QImage wires = shown(look, false, false);
    EXPECT_NE(wires, shaded);
    look.style = widgets::MeshStyle::Off;
    const QImage off = shown(look, true, false);
    EXPECT_NE(off, wires);
    EXPECT_EQ(off, picture(view)) << "nothing over the picture";
    look = {};
    const QImage result = shown(look, false, false);
    inspect.setIteration(0);
    settle();
    view.finishDrawing();
    EXPECT_NE(view.grabPicture(), result) << "the iteration";
    const auto layers = inspect.posedLayers();
    ASSERT_EQ(layers.size(), 3u);
    EXPECT_EQ(layers[2].surfaces[0]->verticesInWorld, layers[0].surfaces[0]->verticesInWorld)
        << "before the first iteration: the start";
}

TEST_F(FitPanelsTest, AnEmptyInspectHasAButton) {
    auto* button = child<QPushButton>(inspect);
    ASSERT_TRUE(button->isVisible());
    bool asked = false;
    QObject::connect(&inspect, &widgets::InspectPage::fitRequested, [&] { asked = true; });
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(asked);
    fitting.fit({8, 12, {"ch"}, widgets::FitTarget::Recorded});
    settle();
    EXPECT_FALSE(button->isVisible());
}

TEST_F(FitPanelsTest, BenchmarkRowsAreShownWhileItRuns) {
    reopen();
    differences().setText(QStringLiteral("1, 3"));
    child<QDoubleSpinBox>(benchmark)->setValue(40);
    std::vector<std::size_t> rows; // at every update before the end
    bool tableShown = false;
    QObject::connect(&session.benchmarks, &widgets::BenchmarkRunner::updated, &benchmark, [&] {
        if (!session.benchmarks.isRunning() || !session.benchmarks.results())
            return;
        rows.push_back(session.benchmarks.results()->rows.size());
        tableShown = tableShown || benchmarkTable("benchmarkSummary").isVisible();
    });
    session.benchmarks.run(benchmark.request());
    settle();
    const std::size_t all = session.benchmarks.results()->rows.size();
    ASSERT_GE(rows.size(), 2u);
    EXPECT_TRUE(tableShown);
    EXPECT_LT(rows.front(), all);
    EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
    EXPECT_FALSE(session.benchmarks.results()->stopped);
}

TEST_F(FitPanelsTest, SavedResultsAreTheCommandsAndOpenAgain) {
    runBenchmark();
    const auto found = *session.benchmarks.results();
    ASSERT_FALSE(found.rows.empty());
    const QString out = QString::fromStdString((folder / "results").string());
    QSignalSpy saved(&session.benchmarks, &widgets::BenchmarkRunner::saved);
    session.benchmarks.save(out);
    settle();
    ASSERT_EQ(saved.count(), 1);
    for (const char* file : {"run.json", "pairs.json", "finished.jsonl", "results.csv", "joints.csv", "curves.csv",
                             "table.md", "table.tex", "report.html"})
        EXPECT_TRUE(std::filesystem::exists(folder / "results" / file)) << file;
    core::BenchmarkFolder again = core::readBenchmarkFolder(folder / "results");
    EXPECT_EQ(again.results.rows, found.rows);
    core::writeBenchmarkFolder(folder / "command", again);
    for (const char* file : {"results.csv", "joints.csv", "table.md"})
        EXPECT_EQ(core::readTextFile(folder / "results" / file), core::readTextFile(folder / "command" / file)) << file;

    reopen();
    ASSERT_FALSE(session.benchmarks.results());
    QSignalSpy opened(&session.benchmarks, &widgets::BenchmarkRunner::opened);
    session.benchmarks.open(out);
    settle();
    ASSERT_EQ(opened.count(), 1);
    EXPECT_TRUE(opened[0][1].toString().isEmpty()) << opened[0][1].toString().toStdString();
    EXPECT_EQ(session.benchmarks.results()->rows, found.rows);
    EXPECT_TRUE(benchmarkTable("benchmarkSummary").isVisible());
    EXPECT_EQ(benchmarkTable("benchmarkSummary").model()->rowCount(), 3) << "start, ch, dch-thres";
}

TEST_F(FitPanelsTest, SavingReplacesNoOtherResults) {
    runBenchmark();
    QSignalSpy failed(&session.benchmarks, &widgets::BenchmarkRunner::fileFailed);
    std::filesystem::create_directories(folder / "mine");
    core::writeFileAtomically(folder / "mine/table.md", "mine");
    session.benchmarks.save(QString::fromStdString((folder / "mine").string()));
    settle();
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(core::readTextFile(folder / "mine/table.md"), "mine");
    session.benchmarks.open(QString::fromStdString((folder / "mine").string()));
    settle();
    EXPECT_EQ(failed.count(), 2) << "it holds no results";
    EXPECT_FALSE(child<widgets::MessageBar>(benchmark)->message().isEmpty());
}

TEST_F(FitPanelsTest, APairOpensWithAllOfItsMethods) {
    runBenchmark();
    std::optional<widgets::FitRequest> opened;
    QObject::connect(&benchmark, &widgets::BenchmarkPage::pairOpened,
                     [&](const QString&, const widgets::FitRequest& asked) { opened = asked; });
    QTest::qWait(20); // laid out
    QTableView& pairs = benchmarkTable("benchmarkPairs");
    const QPoint first = pairs.visualRect(pairs.model()->index(0, 0)).center();
    QTest::mouseClick(pairs.viewport(), Qt::LeftButton, {}, first);
    QTest::mouseDClick(pairs.viewport(), Qt::LeftButton, {}, first);
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->methods, (std::vector<std::string>{"ch", "dch-thres"}));
}

TEST_F(FitPanelsTest, FootageWithoutSilhouettesSaysWhatItNeedsAndTakesAFolder) {
    core::Dataset bare = *session.opened.dataset();
    for (core::Sequence& sequence : bare.sequences) {
        sequence.motion.clear();
        for (core::ViewSource& view : sequence.views)
            view.kind = core::ViewKind::None;
    }
    core::rewriteDatasetFile(bare);
    reopen();
    session.fits.run(fitting.request());
    EXPECT_TRUE(child<widgets::MessageBar>(fitting)->message().contains(
        QStringLiteral("needs silhouettes: attach a folder of masks, or make them")));
    const auto buttons = fitting.findChildren<QPushButton*>();
    const auto attach = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
        return button->text() == QStringLiteral("Attach masks...");
    });
    ASSERT_NE(attach, buttons.end());
    EXPECT_TRUE((*attach)->isVisible());
    QSignalSpy asked(&fitting, &widgets::FittingPanel::masksRequested);
    QTest::mouseClick(*attach, Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);

    for (const core::Camera& camera : bare.cameras) {
        std::filesystem::create_directories(folder / "masks" / camera.name);
        core::writePng(folder / "masks" / camera.name / "000012.png",
                       core::renderHandsMask(camera, bare.hands, test::tinyMotion(13).back()));
    }
    widgets::MaskAttacher attacher(session.opened, session.selection, session.pool);
    QSignalSpy failed(&attacher, &widgets::MaskAttacher::failed);
    attacher.attach(QString::fromStdString((folder / "masks").string()));
    settle();
    ASSERT_EQ(failed.count(), 0) << failed[0][0].toString().toStdString();
    EXPECT_TRUE(session.fits.hasMasks());
    EXPECT_FALSE((*attach)->isVisible());
    EXPECT_EQ(session.selection.frame(), 12) << "the same place";
    EXPECT_TRUE(core::hasMasks(core::readDataset(folder / "dataset").sequences[0])) << "kept in the file";
    attacher.attach(QString::fromStdString((folder / "nowhere").string()));
    settle();
    EXPECT_EQ(failed.count(), 1);
}

} // namespace
