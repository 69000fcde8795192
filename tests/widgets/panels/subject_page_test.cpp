// SPDX-License-Identifier: MIT
// Measuring a person's hands in the window. Simulated clicks of the demo's hands, enlarged by 4 %.
#include <gtest/gtest.h>

#include <QFileDialog>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest/QTest>

#include "core/annotation/import_edit.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/store/annotation_store.h"
#include "tests/support/clicks.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"
#include "widgets/panels/quality/subject_page.h"

namespace {

constexpr double kScale = 1.04;

class SubjectPageTest : public testing::Test {
protected:
    SubjectPageTest() {
        static const core::NewDataset kDemo = core::makeDemoDataset(); // takes longer than a test
        core::NewDataset demo = kDemo;
        demo.dataset.sequences.resize(2);
        demo.motions.resize(2);
        core::writeDataset(demo.dataset, demo.motions, folder / "set");
        dataset = std::make_shared<core::Dataset>(core::readDataset(folder / "set"));
        auto random = test::randomFor("SubjectPage");
        core::AnnotationSet set;
        for (const int frame : {0, 10, 20, 30, 40}) {
            const core::HandPoses& poses = demo.motions[0][static_cast<std::size_t>(frame)];
            for (std::size_t h = 0; h < dataset->hands.size(); ++h) {
                const core::Skeleton& skeleton = dataset->hands[h].skeleton;
                const auto points = core::jointPositions(skeleton, poses[h]);
                for (std::size_t b = 0; b < points.size(); ++b)
                    test::clickEverywhere(set, dataset->cameras, frame, "ann",
                                          {dataset->hands[h].side, skeleton.bones[b].name}, kScale * points[b], 0.3,
                                          &random);
            }
        }
        auto store = core::AnnotationStore::open(core::annotationFile(*dataset, dataset->sequences[0]));
        store.commit(core::importEdit({}, set, "clicks"), "ann");
        study.setDataset(dataset);
        page.resize(520, 600);
        page.show();
        study.count();
        wait();
    }
    void wait() {
        ASSERT_TRUE(test::waitUntil([this] { return pool.isIdle(); }, 60000));
    }
    QPushButton* button(const char* text) {
        for (QPushButton* one : page.findChildren<QPushButton*>())
            if (one->text() == QLatin1String(text))
                return one;
        return nullptr;
    }
    bool says(const char* words) {
        const auto labels = page.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisibleTo(&page) && label->text().contains(QString::fromUtf8(words));
        });
    }
    QListWidget& sources() { return *page.findChild<QListWidget*>(); }

    test::TemporaryFolder folder;
    std::shared_ptr<const core::Dataset> dataset;
    widgets::JobPool pool;
    widgets::SubjectStudy study{pool};
    widgets::SubjectPage page{study};
};

TEST_F(SubjectPageTest, CountsTheAnnotatedFramesOfEverySequence) {
    ASSERT_EQ(sources().count(), 2);
    EXPECT_TRUE(sources().item(0)->text().contains(QStringLiteral("5 annotated frame"))) << "in the first";
    EXPECT_EQ(sources().item(0)->checkState(), Qt::Checked);
    EXPECT_FALSE(sources().item(1)->flags() & Qt::ItemIsEnabled) << "nothing to measure from";
    sources().item(0)->setCheckState(Qt::Unchecked);
    QTest::mouseClick(button("Measure"), Qt::LeftButton);
    EXPECT_TRUE(says("Choose a sequence"));
}

TEST_F(SubjectPageTest, MeasuresTheHandsAndSavesThemAsADatasetThatCanBeOpened) {
    EXPECT_FALSE(button("Save as a new dataset...")->isEnabled());
    QTest::mouseClick(button("Measure"), Qt::LeftButton);
    EXPECT_TRUE(button("Stop")->isVisible());
    EXPECT_FALSE(button("Measure")->isEnabled());
    wait();
    ASSERT_TRUE(study.result());
    for (const core::SubjectHand& hand : study.result()->result.hands)
        EXPECT_NEAR(hand.scale.value, kScale, 0.01);
    const QTableView& table = *page.findChild<QTableView*>();
    const auto& hands = study.result()->result.hands;
    ASSERT_EQ(table.model()->rowCount(), static_cast<int>(hands[0].bones.size() + hands[1].bones.size()));
    const auto number = [&](int row, int column) {
        return QLocale().toDouble(table.model()->index(row, column).data().toString());
    };
    EXPECT_NEAR(number(0, widgets::SubjectModel::LengthMm), hands[0].bones[0].lengthMm, 0.006);
    EXPECT_TRUE(says("Left hand: scale"));
    EXPECT_TRUE(says("5 annotated frame(s) were used"));
    EXPECT_TRUE(says("the girth stays the model's"));

    QTest::mouseClick(button("Save as a new dataset..."), Qt::LeftButton);
    auto* chooser = page.findChild<QFileDialog*>();
    ASSERT_TRUE(chooser);
    const QString path = QString::fromStdString((folder / "person").string());
    emit chooser->fileSelected(path);
    chooser->close();
    wait();
    ASSERT_TRUE(says("Saved in"));
    QSignalSpy opened(&page, &widgets::SubjectPage::openRequested);
    QTest::mouseClick(button("Open"), Qt::LeftButton);
    ASSERT_EQ(opened.count(), 1);
    EXPECT_EQ(opened[0][0].toString(), path);
    const core::Dataset person = core::readDataset(folder / "person");
    EXPECT_EQ(core::readAnnotations(person, person.sequences[0]).marks,
              core::readAnnotations(*dataset, dataset->sequences[0]).marks);
    EXPECT_NE(person.hands[0].mesh.vertices, dataset->hands[0].mesh.vertices);
}

TEST_F(SubjectPageTest, AStopLeavesNoResult) {
    page.measure();
    ASSERT_TRUE(study.isMeasuring());
    QTest::mouseClick(button("Stop"), Qt::LeftButton);
    EXPECT_FALSE(study.isMeasuring());
    wait();
    EXPECT_FALSE(study.result());
    EXPECT_TRUE(button("Measure")->isEnabled());
}

TEST_F(SubjectPageTest, SaysWhyAFolderCannotBeUsed) {
    page.measure();
    wait();
    ASSERT_TRUE(study.result());
    study.save(QString::fromStdString((folder / "set").string()));
    wait();
    EXPECT_TRUE(says("set")) << "it is not empty";
}

} // namespace
