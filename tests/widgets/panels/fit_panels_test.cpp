// SPDX-License-Identifier: MIT
#include <QTableView>

#include "core/benchmark/pairs.h"
#include "core/error.h"
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/panels/benchmark_page.h"
#include "widgets/panels/fitting_panel.h"
#include "widgets/panels/inspect_page.h"

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
        bench.session.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
    }
    QLineEdit& differences() {
        const auto fields = benchmark.findChildren<QLineEdit*>();
        return **std::find_if(fields.begin(), fields.end(), [](const QLineEdit* field) { return field->text().startsWith(QStringLiteral("1, 5")); });
    }

    widgets::FittingPanel fitting{bench.selection, bench.fits};
    widgets::InspectPage inspect{bench};
    widgets::BenchmarkPage benchmark{bench};
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
    bench.session.openSequence(QStringLiteral("b"));
    settle();
    EXPECT_EQ(table.model()->rowCount(), 0);
    EXPECT_EQ(inspect.grid()->count(), 0);
}

TEST_F(FitPanelsTest, ColumnsLookAtTheHandsTogether) {
    fitting.fit({8, 12, {"ch", "best"}, widgets::FitTarget::Recorded});
    settle();
    widgets::CameraView& first = *inspect.grid()->view(0);
    const QRectF hands = bench.fits.outcome()->handsPx[0];
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
    bench.benchmarks.run(request);
    settle();
    ASSERT_TRUE(bench.benchmarks.results());
    auto tables = benchmark.findChildren<QTableView*>();
    std::sort(tables.begin(), tables.end(), [](const QTableView* a, const QTableView* b) { return a->model()->rowCount() < b->model()->rowCount(); });
    EXPECT_EQ(tables[0]->model()->rowCount(), 2); // start, dch-thres
    EXPECT_EQ(tables[1]->model()->rowCount(), static_cast<int>(bench.benchmarks.results()->rows.size()));
    const std::set<int> tests = benchmark.testFrames();
    std::set<int> ran;
    for (const core::FramePair& pair : bench.benchmarks.results()->pairs) {
        if (pair.sequence == "a")
            ran.insert(pair.test);
    }
    EXPECT_EQ(tests, ran);
    std::optional<widgets::FitRequest> opened;
    QObject::connect(&benchmark, &widgets::BenchmarkPage::pairOpened, [&](const QString&, const widgets::FitRequest& asked) { opened = asked; });
    QTest::qWait(20); // laid out
    QTest::mouseClick(tables[1]->viewport(), Qt::LeftButton, {}, tables[1]->visualRect(tables[1]->model()->index(0, 0)).center());
    QTest::mouseDClick(tables[1]->viewport(), Qt::LeftButton, {}, tables[1]->visualRect(tables[1]->model()->index(0, 0)).center());
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->methods, request.methods);
    const auto& pairs = bench.benchmarks.results()->pairs;
    EXPECT_TRUE(std::any_of(pairs.begin(), pairs.end(), [&](const core::FramePair& pair) { return pair.start == opened->start && pair.test == opened->test; }));
}

TEST_F(FitPanelsTest, HalfTypedDifferencesAreRefusedInWords) {
    reopen();
    differences().setText(QStringLiteral("1, x"));
    EXPECT_THROW(benchmark.request(), core::Error);
    EXPECT_TRUE(benchmark.testFrames().empty());
    const auto buttons = benchmark.findChildren<QPushButton*>();
    const auto run = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) { return button->text() == QStringLiteral("Run"); });
    ASSERT_NE(run, buttons.end());
    QTest::mouseClick(*run, Qt::LeftButton);
    EXPECT_TRUE(child<widgets::MessageBar>(benchmark)->message().contains(QStringLiteral("\u201cx\u201d")));
    EXPECT_FALSE(bench.benchmarks.isRunning());
}

} // namespace
