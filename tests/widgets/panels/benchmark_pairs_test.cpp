// SPDX-License-Identifier: MIT
// Results of a benchmark pair by pair: the table, its filter and order, the plots that follow it, and runs of chosen
// pairs.
#include <cmath>
#include <limits>

#include <QAbstractItemModelTester>
#include <QElapsedTimer>
#include <QHeaderView>

#include "core/io/benchmark/benchmark_folder.h"
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/views/joint_colours.h"
#include "widgets/workspaces/benchmark_page.h"

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Pairs 0-3 of two sequences; dch-dt3 has no result of pair 2. A is dch-thres, B is ch.
std::shared_ptr<const core::PairTable> fourPairs() {
    auto table = std::make_shared<core::PairTable>();
    table->methods = {"ch", "dch-thres", "dch-dt3"};
    table->pairs = {{"a", 19, 20}, {"a", 15, 20}, {"b", 5, 20}, {"b", 29, 30}};
    table->startErrorMm = {10, 20, 30, 40};
    table->columns = {{{1, 2, 3, 4}, {10, 11, 12, 13}, {0.5, 0.5, 0.5, 0.5}},
                      {{3, 2, 1, 9}, {5, 6, 7, 8}, {0.1, 0.2, 0.3, 0.4}},
                      {{3, 1, kMissing, 2}, {1, 1, kMissing, 1}, {1, 1, kMissing, 1}}};
    return table;
}

class PairsViewTest : public testing::Test {
protected:
    PairsViewTest() {
        qRegisterMetaType<std::size_t>("std::size_t");
        qRegisterMetaType<std::vector<std::size_t>>("std::vector<std::size_t>");
        view.resize(900, 300);
        view.show();
        view.setTable(fourPairs());
    }
    QString cell(int row, const core::PairQuantity& quantity) const {
        const int column = view.model().columnOf(quantity);
        return column < 0 ? QStringLiteral("no such column") : view.model().index(row, column).data().toString();
    }

    widgets::BenchmarkPairsView view;
    QAbstractItemModelTester tester{const_cast<widgets::PairTableModel*>(&view.model()),
                                    QAbstractItemModelTester::FailureReportingMode::Fatal};
};

using core::PairField;
using Shown = std::vector<std::size_t>;

TEST_F(PairsViewTest, HasARowPerPairAndTheLargestDifferenceFirst) {
    EXPECT_EQ(view.model().shown(), (Shown{3, 0, 1, 2})) << "+5, +2, 0, -2";
    EXPECT_EQ(cell(0, {PairField::ErrorDifferenceMm, 1, 0}), QStringLiteral("+5.00"));
    EXPECT_EQ(cell(3, {PairField::ErrorDifferenceMm, 1, 0}), QStringLiteral("-2.00"));
    EXPECT_EQ(cell(0, {PairField::Sequence, 0, 0}), QStringLiteral("b"));
    EXPECT_EQ(cell(0, {PairField::Seconds, 1, 0}), QStringLiteral("0.400"));
    EXPECT_EQ(cell(3, {PairField::ErrorMm, 2, 0}), QString()) << "it has no result";
    const int best = view.model().columnOf({PairField::ErrorMm, 2, 0});
    EXPECT_TRUE(view.model().index(0, best).data(Qt::FontRole).value<QFont>().bold()) << "2 is less than 4 and 9";
    EXPECT_FALSE(view.model().index(1, best).data(Qt::FontRole).value<QFont>().bold()) << "1 is less than 3";
}

TEST_F(PairsViewTest, AMethodsNameStandsBesideItsChip) {
    const int error = view.model().columnOf({PairField::ErrorMm, 1, 0});
    const auto head = [&](int column, int role) { return view.model().headerData(column, Qt::Horizontal, role); };
    EXPECT_FALSE(head(error, Qt::DecorationRole).value<QIcon>().isNull());
    EXPECT_TRUE(head(error, Qt::TextAlignmentRole).toInt() & Qt::AlignLeft) << "where styles draw the icon";
    EXPECT_TRUE(head(view.model().columnOf({PairField::Seconds, 1, 0}), Qt::TextAlignmentRole).toInt() &
                Qt::AlignRight);
}

TEST_F(PairsViewTest, ComparesOtherMethodsAndSortsByAnyColumn) {
    ASSERT_TRUE(view.setCompared(QStringLiteral("dch-dt3"), QStringLiteral("ch")));
    EXPECT_EQ(view.model().shown(), (Shown{0, 1, 3, 2})) << "+2, -1, -2, none";
    EXPECT_FALSE(view.setCompared(QStringLiteral("best"), QStringLiteral("ch")));
    ASSERT_TRUE(view.sortBy({PairField::StartErrorMm, 0, 0}, Qt::AscendingOrder));
    EXPECT_EQ(view.model().shown(), (Shown{0, 1, 2, 3}));
    auto* table = view.findChild<QTableView*>();
    QHeaderView* header = table->horizontalHeader();
    const int seconds = view.model().columnOf({PairField::Seconds, 1, 0});
    emit header->sectionClicked(seconds);
    EXPECT_EQ(view.model().shown(), (Shown{3, 2, 1, 0})) << "the largest first";
    EXPECT_EQ(header->sortIndicatorSection(), seconds);
    emit header->sectionClicked(seconds);
    EXPECT_EQ(view.model().shown(), (Shown{0, 1, 2, 3}));
}

TEST_F(PairsViewTest, FiltersAndSaysWhatIsWrongWithAFilter) {
    QSignalSpy shown(&view, &widgets::BenchmarkPairsView::shownChanged);
    EXPECT_EQ(view.setFilter(QStringLiteral("A-B>1")), QString());
    EXPECT_EQ(view.model().shown(), (Shown{3, 0}));
    EXPECT_EQ(shown.count(), 1);
    EXPECT_EQ(view.setFilter(QStringLiteral("sequence=b difference>1")), QString());
    EXPECT_EQ(view.model().shown(), (Shown{2}));
    EXPECT_TRUE(view.setFilter(QStringLiteral("best>1")).contains(QStringLiteral("\u201cbest\u201d")));
    EXPECT_EQ(view.model().shown().size(), 4u) << "all of them";
    EXPECT_EQ(view.setFilter({}), QString());
}

TEST_F(PairsViewTest, TheSelectionStaysWithItsPairs) {
    view.select({0, 2});
    ASSERT_TRUE(view.sortBy({PairField::StartErrorMm, 0, 0}, Qt::AscendingOrder));
    EXPECT_EQ(view.selected(), (Shown{0, 2}));
    view.setTable(fourPairs()); // a run goes on
    EXPECT_EQ(view.selected(), (Shown{0, 2}));
    QSignalSpy asked(&view, &widgets::BenchmarkPairsView::runRequested);
    view.runSelected();
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked[0][0].value<std::vector<std::size_t>>(), (Shown{0, 2}));
    view.setFilter(QStringLiteral("sequence=b"));
    EXPECT_EQ(view.selected(), (Shown{2})) << "what is not shown is not selected";
}

TEST_F(PairsViewTest, AMethodThatIsAddedChangesNeitherFilterNorWhatIsCompared) {
    ASSERT_TRUE(view.setCompared(QStringLiteral("dch-dt3"), QStringLiteral("ch")));
    ASSERT_EQ(view.setFilter(QStringLiteral("A-B>-2")), QString());
    const Shown shown = view.model().shown();
    ASSERT_EQ(shown, (Shown{0, 1})) << "+2 and -1";
    view.select({0});
    auto more = std::make_shared<core::PairTable>(*fourPairs());
    more->methods.insert(more->methods.begin(), "best");
    more->columns.insert(more->columns.begin(), more->columns[0]);
    view.setTable(more);
    EXPECT_EQ(view.model().compared().a, 3u);
    EXPECT_EQ(view.model().compared().b, 1u);
    EXPECT_EQ(view.model().shown(), shown);
    EXPECT_EQ(view.selected(), (Shown{0}));
    auto others = std::make_shared<core::PairTable>(*fourPairs());
    others->methods = {"best", "dch-quant", "external"};
    view.setTable(others);
    EXPECT_EQ(view.model().shown().size(), 4u) << "other results: the filter is gone";
}

class PairPlotsTest : public PairsViewTest {
protected:
    PairPlotsTest() {
        plots.resize(1200, 260);
        plots.show();
        plots.showPairs(view.model());
    }
    static int pixelsOf(const QImage& picture, const QColor& colour) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixel(x, y) == colour.rgb() ? 1 : 0;
        return count;
    }
    static void click(QWidget& plot, QPointF place) { QTest::mouseClick(&plot, Qt::LeftButton, {}, place.toPoint()); }

    widgets::BenchmarkPairPlots plots;
};

TEST_F(PairPlotsTest, APointIsAPairAndClickingItSaysWhich) {
    const auto& points = plots.scatter()->points();
    ASSERT_EQ(points.size(), 4u);
    QSignalSpy clicked(&plots, &widgets::BenchmarkPairPlots::pairClicked);
    for (const widgets::ScatterPoint& point : points) {
        const auto& table = *view.model().table();
        EXPECT_EQ(point.value, QPointF(table.columns[1].errorMm[point.id], table.columns[0].errorMm[point.id]));
        click(*plots.scatter(), plots.scatter()->placeOf(point));
        ASSERT_EQ(clicked.count(), 1);
        EXPECT_EQ(clicked.takeFirst()[0].value<std::size_t>(), point.id);
    }
    click(*plots.scatter(), QPointF(2, 2));
    EXPECT_EQ(clicked.count(), 0);
}

TEST_F(PairPlotsTest, FollowTheFilterAndTheComparedMethods) {
    view.setFilter(QStringLiteral("sequence=a"));
    plots.showPairs(view.model());
    EXPECT_EQ(plots.scatter()->points().size(), 2u);
    EXPECT_EQ(plots.boxes()->series().size(), 2u);
    EXPECT_EQ(plots.boxes()->series()[0].boxes.size(), 2u) << "1 and 5 frames apart";
    view.setFilter({});
    view.setCompared(QStringLiteral("dch-dt3"), QStringLiteral("ch"));
    plots.showPairs(view.model());
    EXPECT_EQ(plots.scatter()->points().size(), 3u) << "one has no result of dch-dt3";
    int counted = 0;
    for (const int count : plots.histogram()->histogram().counts)
        counted += count;
    EXPECT_EQ(counted, 3);
}

TEST_F(PairPlotsTest, BarsAndBoxesFilterWhenTheyAreClicked) {
    QStringList conditions;
    QObject::connect(&plots, &widgets::BenchmarkPairPlots::conditionClicked,
                     [&](const QString& condition) { conditions << condition; });
    const std::size_t last = plots.histogram()->histogram().counts.size() - 1;
    click(*plots.histogram(), plots.histogram()->placeOf(last));
    click(*plots.boxes(), plots.boxes()->placeOf(2));
    ASSERT_EQ(conditions.size(), 2);
    EXPECT_EQ(conditions[1], QStringLiteral("difference=15"));
    view.setFilter(conditions[0]);
    EXPECT_EQ(view.model().shown(), (Shown{3})) << conditions[0].toStdString();
    view.setFilter(conditions[1]);
    EXPECT_EQ(view.model().shown(), (Shown{2}));
}

TEST_F(PairPlotsTest, DrawBarsAndBoxesInTheMethodsColours) {
    const QImage bars = plots.histogram()->grabPicture();
    EXPECT_GT(pixelsOf(bars, widgets::plotColour(widgets::methodColour("dch-thres"), Qt::white)), 200);
    EXPECT_GT(pixelsOf(bars, widgets::plotColour(widgets::methodColour("ch"), Qt::white)), 200);
    const QImage boxes = plots.boxes()->grabPicture();
    EXPECT_GT(pixelsOf(boxes, widgets::plotColour(widgets::methodColour("ch"), Qt::white)), 20);
    plots.scatter()->setHighlighted({3});
    const QImage ringed = plots.scatter()->grabPicture();
    plots.scatter()->setHighlighted({});
    EXPECT_NE(ringed, plots.scatter()->grabPicture());
}

class RunOfPairsTest : public test::PanelTest {
protected:
    RunOfPairsTest() {
        page.resize(1100, 800);
        page.show();
        session.opened.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
        core::BenchmarkFolder made;
        widgets::BenchmarkRequest request = page.request();
        request.methods = {"ch"};
        request.pairs.differences = {1, 3};
        request.pairs.fraction = 0.2;
        session.benchmarks.run(request);
        settle();
        before = *session.benchmarks.results();
    }
    void chooseMethods(const QStringList& names) {
        for (QCheckBox* box : page.findChildren<QCheckBox*>())
            box->setChecked(names.contains(box->text()));
    }

    widgets::BenchmarkPage page{session.benchmarks, session.opened, session.document, session.coverage};
    core::BenchmarkResults before;
};

TEST_F(RunOfPairsTest, AddsWhatAnotherMethodMakesOfTheSelectedPairs) {
    ASSERT_GT(before.pairs.size(), 3u);
    chooseMethods({QStringLiteral("dch-thres")});
    page.results()->pairs()->select({0, 2});
    page.results()->pairs()->runSelected();
    EXPECT_TRUE(session.benchmarks.isRunning());
    settle();
    const core::BenchmarkResults& after = *session.benchmarks.results();
    EXPECT_EQ(after.methods, (std::vector<std::string>{"ch", "dch-thres"}));
    EXPECT_EQ(after.pairs, before.pairs);
    ASSERT_EQ(after.rows.size(), before.rows.size() + 2);
    for (const core::PairResult& row : before.rows)
        EXPECT_NE(std::find(after.rows.begin(), after.rows.end(), row), after.rows.end()) << "as it was";
    const core::PairTable& table = *session.benchmarks.pairTable();
    for (std::size_t pair = 0; pair < table.pairs.size(); ++pair)
        EXPECT_EQ(!std::isnan(table.columns[1].errorMm[pair]), pair == 0 || pair == 2) << pair;
    EXPECT_TRUE(after.stopped) << "not every pair has been run with both";
}

TEST_F(RunOfPairsTest, ReplacesWhatTheSameMethodFound) {
    chooseMethods({QStringLiteral("ch")});
    page.results()->pairs()->select({1});
    page.results()->pairs()->runSelected();
    settle();
    const core::BenchmarkResults& after = *session.benchmarks.results();
    ASSERT_EQ(after.rows.size(), before.rows.size());
    for (std::size_t i = 0; i < after.rows.size(); ++i) {
        EXPECT_EQ(after.rows[i].pair, before.rows[i].pair);
        EXPECT_EQ(after.rows[i].errorMm, before.rows[i].errorMm) << "the same fit";
    }
    EXPECT_FALSE(after.stopped);
}

TEST_F(RunOfPairsTest, RefusesResultsOfAnotherDataset) {
    core::BenchmarkFolder other{core::BenchmarkRunInfo{}, before};
    other.info.dataset = "elsewhere";
    other.info.fingerprint = "0123456789abcdef";
    other.info.methods = before.methods;
    other.info.pairs = before.pairs;
    other.info.joints = before.joints;
    core::writeBenchmarkFolder(folder / "other", other);
    session.benchmarks.open(QString::fromStdString((folder / "other").string()));
    settle();
    QSignalSpy failed(&session.benchmarks, &widgets::BenchmarkRunner::failed);
    page.results()->pairs()->select({0});
    page.results()->pairs()->runSelected();
    settle();
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("not of the open dataset")));
    EXPECT_EQ(session.benchmarks.results()->rows, before.rows);
}

TEST_F(RunOfPairsTest, OpensTenThousandResultsWhileTheWindowLives) {
    core::BenchmarkFolder many{core::BenchmarkRunInfo{}, before};
    many.info.fingerprint = "0123456789abcdef";
    many.info.joints = many.results.joints;
    many.results.rows.clear();
    many.info.pairs.clear();
    for (int i = 0; i < 10000; ++i) {
        core::PairResult row = before.rows[static_cast<std::size_t>(i) % before.rows.size()];
        row.pair = {"a", 100 + i, 101 + i + i % 15};
        row.errorMm = i;
        many.results.rows.push_back(row);
        many.info.pairs.push_back(row.pair);
    }
    many.info.methods = many.results.methods;
    many.results.pairs = many.info.pairs;
    core::writeRunInfo((std::filesystem::create_directories(folder / "many"), folder / "many"), many.info);
    core::writeFinishedRows(folder / "many", many.results.rows);
    QElapsedTimer timer;
    timer.start();
    session.benchmarks.open(QString::fromStdString((folder / "many").string()));
    EXPECT_LT(timer.elapsed(), 100) << "it is read in the background";
    settle();
    EXPECT_LT(timer.elapsed(), 5000);
    EXPECT_EQ(page.results()->pairs()->model().rowCount(), 10000);
}

} // namespace
