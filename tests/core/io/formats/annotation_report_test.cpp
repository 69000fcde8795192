// SPDX-License-Identifier: MIT
#include "core/io/formats/annotation_report.h"

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "core/annotation/import_edit.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/files/gnuplot.h"
#include "core/io/files/text_file.h"
#include "core/io/store/annotation_store.h"
#include "tests/support/clicks.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

using core::JointId;
using core::Side;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

class AnnotationReportTest : public testing::Test {
protected:
    AnnotationReportTest() {
        test::writeSmallDataset(m_folder / "set");
        m_dataset = core::readDataset(m_folder / "set");
    }
    void annotate() {
        auto store = core::AnnotationStore::open(core::annotationFile(m_dataset, m_dataset.sequences[0]));
        core::AnnotationSet set;
        for (const std::string rater : {"ann <first>", "bob"})
            test::clickEverywhere(set, m_dataset.cameras, 1, rater, {Side::Left, "index_mcp"}, {0, 0, 0}, 1, &m_random);
        store.commit(core::importEdit({}, set, ""), "ann");
    }
    std::string report() {
        core::writeAnnotationReport(m_dataset, m_folder / "report.html");
        return core::readTextFile(m_folder / "report.html");
    }

    test::TemporaryFolder m_folder;
    core::Dataset m_dataset;
    std::mt19937_64 m_random = test::randomFor("annotation report");
};

TEST_F(AnnotationReportTest, SequencesWithoutMarksSaySo) {
    EXPECT_TRUE(core::readAnnotations(m_dataset, m_dataset.sequences[0]).marks.empty());
    const std::string html = report();
    EXPECT_TRUE(contains(html, "no marks yet"));
    EXPECT_FALSE(contains(html, "<svg"));
    EXPECT_FALSE(contains(html, "Worst joints"));
}

TEST_F(AnnotationReportTest, ShowsRatersJointsAndFigures) {
    annotate();
    const std::string html = report();
    EXPECT_TRUE(contains(html, "ann &lt;first&gt;"));
    EXPECT_FALSE(contains(html, "ann <first>"));
    EXPECT_TRUE(contains(html, "left index_mcp"));
    EXPECT_TRUE(contains(html, "<h2>Agreement</h2>\n<table>"));
    for (const char* const reference : {"src=", "href=\"http", "url(http", "@import"})
        EXPECT_FALSE(contains(html, reference)) << "needs a network: " << reference;
    const bool drawn = core::drawWithGnuplot({}).has_value();
    EXPECT_EQ(contains(html, "<svg"), drawn);
    if (!drawn)
        GTEST_SKIP() << "gnuplot is not installed: figures not looked at";
    std::size_t figures = 0;
    for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1))
        ++figures;
    EXPECT_EQ(figures, 3u);
}

TEST_F(AnnotationReportTest, OneSharedClickGivesNoAgreementOfPoints) {
    auto store = core::AnnotationStore::open(core::annotationFile(m_dataset, m_dataset.sequences[0]));
    core::AnnotationSet set;
    const std::string camera = m_dataset.cameras[0].name;
    set.marks[{1, "ann", {Side::Left, "index_mcp"}, camera}] = {{100, 100}};
    set.marks[{1, "bob", {Side::Left, "index_mcp"}, camera}] = {{109, 100}};
    store.commit(core::importEdit({}, set, ""), "ann");
    EXPECT_TRUE(
        contains(report(), "<td>0</td><td></td><td></td><td></td><td></td><td></td><td></td><td>1</td><td>9.00</td>"))
        << report();
}

TEST_F(AnnotationReportTest, NothingIsWrittenOnceItIsToStop) {
    annotate();
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(core::writeAnnotationReport(m_dataset, m_folder / "report.html", {}, stop.get_token()));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "report.html"));
}

TEST_F(AnnotationReportTest, SequencesWithoutANamedFileHaveTheUsualOne) {
    core::Sequence sequence = m_dataset.sequences[0];
    sequence.annotations.clear();
    EXPECT_EQ(core::annotationFile(m_dataset, sequence),
              m_dataset.folder / "annotations" / (sequence.name + ".sqlite"));
}

} // namespace
