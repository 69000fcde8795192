// SPDX-License-Identifier: MIT
// The benchmark workspace with both setups: silhouettes of the recorded poses, and mask files with marked joints.
#include <QListWidget>

#include "core/contour/rasteriser.h"
#include "core/io/benchmark/benchmark_folder.h"
#include "core/io/files/text_file.h"
#include "core/io/footage/image_file.h"
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/workspaces/benchmark_page.h"

namespace {

class BothSetupsTest : public test::PanelTest {
protected:
    static constexpr int kFirst = 6, kLast = 9; ///< frames of "a" with masks and marks

    BothSetupsTest() {
        benchmark.resize(900, 700);
        benchmark.show();
        core::Dataset dataset = *session.opened.dataset();
        dataset.sequences[0].masks = "masks/{camera}/{frame:06}.png";
        const core::Motion motion = test::tinyMotion(kLast + 1);
        for (const core::Camera& camera : dataset.cameras) {
            std::filesystem::create_directories(dataset.folder / "masks" / camera.name);
            for (int frame = kFirst; frame <= kLast; ++frame)
                core::writePng(dataset.folder / "masks" / camera.name / ("00000" + std::to_string(frame) + ".png"),
                               core::renderHandsMask(camera, dataset.hands, motion[static_cast<std::size_t>(frame)]));
        }
        core::rewriteDatasetFile(dataset);
        for (int frame = kFirst; frame <= kLast; ++frame) {
            session.selection.setFrame(frame);
            for (const char* joint : {"index_mcp", "forearm"})
                for (int camera = 0; camera < 4; ++camera)
                    click({core::Side::Left, joint}, camera);
        }
        reopen();
        QListWidget& sequences = *child<QListWidget>(benchmark);
        sequences.item(1)->setCheckState(Qt::Unchecked); // it has no masks
        for (QCheckBox* box : benchmark.findChildren<QCheckBox*>())
            box->setChecked(box->text() == QStringLiteral("dch-thres") || box->text() == QStringLiteral("ch"));
        for (QLineEdit* field : benchmark.findChildren<QLineEdit*>())
            if (field->text().startsWith(QStringLiteral("1, 5")))
                field->setText(QStringLiteral("1, 3"));
        child<QDoubleSpinBox>(benchmark)->setValue(50);
        setupBox().setCurrentIndex(setupBox().findText(QStringLiteral("Both")));
    }
    /// The page came after the dataset was opened: once more, so that it knows the sequences.
    void reopen() {
        session.opened.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
    }
    QTableView& benchmarkTable(const char* name) {
        return *benchmark.findChild<QTableView*>(QString::fromLatin1(name));
    }
    QComboBox& box(const char* entry) {
        const auto all = benchmark.findChildren<QComboBox*>();
        return **std::find_if(all.begin(), all.end(),
                              [&](const QComboBox* one) { return one->findText(QLatin1String(entry)) >= 0; });
    }
    QComboBox& setupBox() { return box("Both"); }
    /// The one that chooses which results are shown.
    QComboBox* shownBox() {
        for (QComboBox* one : benchmark.findChildren<QComboBox*>())
            if (one != &setupBox() && one->findText(QStringLiteral("Realistic")) >= 0)
                return one;
        return nullptr;
    }
    void run() {
        session.benchmarks.run(benchmark.request());
        settle();
        ASSERT_TRUE(session.benchmarks.results());
    }

    widgets::BenchmarkPage benchmark{session.benchmarks, session.opened, session.document, session.coverage};
};

TEST_F(BothSetupsTest, RunOneAfterTheOtherAndEitherIsShown) {
    run();
    EXPECT_EQ(session.benchmarks.setups(),
              (std::vector{core::BenchmarkSetup::Synthetic, core::BenchmarkSetup::Realistic}));
    EXPECT_EQ(session.benchmarks.setup(), core::BenchmarkSetup::Synthetic);
    const core::BenchmarkResults synthetic = *session.benchmarks.results();
    EXPECT_FALSE(synthetic.stopped);
    ASSERT_TRUE(shownBox());
    ASSERT_TRUE(shownBox()->isVisible());
    emit shownBox()->activated(1);
    EXPECT_EQ(session.benchmarks.setup(), core::BenchmarkSetup::Realistic);
    const core::BenchmarkResults& realistic = *session.benchmarks.results();
    EXPECT_LT(realistic.joints.size(), synthetic.joints.size()) << "the marked joints";
    for (const core::PairResult& row : realistic.rows)
        EXPECT_TRUE(row.pair.test >= kFirst && row.pair.test <= kLast) << row.pair.test;
    EXPECT_EQ(benchmarkTable("benchmarkPairs").model()->rowCount(), static_cast<int>(realistic.pairs.size()));
    std::optional<widgets::FitRequest> opened;
    QObject::connect(&benchmark, &widgets::BenchmarkPage::pairOpened,
                     [&](const QString&, const widgets::FitRequest& asked) { opened = asked; });
    QTableView& pairs = benchmarkTable("benchmarkPairs");
    emit pairs.doubleClicked(pairs.model()->index(0, 0));
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->target, widgets::FitTarget::Masks);
}

TEST_F(BothSetupsTest, AreSavedAsOneFolderWithOnePageAndOpenAgain) {
    run();
    const QString out = QString::fromStdString((folder / "both").string());
    QSignalSpy saved(&session.benchmarks, &widgets::BenchmarkRunner::saved);
    session.benchmarks.save(out);
    settle();
    ASSERT_EQ(saved.count(), 1);
    ASSERT_TRUE(core::holdsBothSetups(folder / "both"));
    const std::string page = core::readTextFile(folder / "both/report.html");
    EXPECT_NE(page.find("Synthetic setup"), std::string::npos);
    EXPECT_NE(page.find("Realistic setup"), std::string::npos);
    QSignalSpy wanted(&benchmark, &widgets::BenchmarkPage::reportWanted);
    for (QPushButton* button : benchmark.findChildren<QPushButton*>())
        if (button->text() == QStringLiteral("Show the report"))
            QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_TRUE(std::filesystem::exists(wanted[0][0].toString().toStdString()));
    session.benchmarks.save(out); // the same results may be saved again
    settle();
    EXPECT_EQ(saved.count(), 2);
    reopen();
    session.benchmarks.open(out);
    settle();
    EXPECT_EQ(session.benchmarks.setups().size(), 2u);
}

TEST_F(BothSetupsTest, WithoutMasksNothingBegins) {
    child<QListWidget>(benchmark)->item(1)->setCheckState(Qt::Checked);
    QSignalSpy failed(&session.benchmarks, &widgets::BenchmarkRunner::failed);
    session.benchmarks.run(benchmark.request());
    settle();
    ASSERT_EQ(failed.count(), 1);
    EXPECT_FALSE(session.benchmarks.results());
}

} // namespace
