// SPDX-License-Identifier: MIT
#include "core/text/gnuplot_text.h"
#include "core/text/html_text.h"
#include "core/text/shell_text.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

TEST(HtmlText, EscapesWhatHtmlMeans) {
    EXPECT_EQ(core::htmlEscaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
    EXPECT_EQ(core::htmlTextCell("<b>"), "<td class=\"text\">&lt;b&gt;</td>");
    EXPECT_EQ(core::htmlNumberCell(1.2345, 2), "<td>1.23</td>");
    EXPECT_EQ(core::htmlNumberCell(std::nan(""), 2), "<td></td>");
}

TEST(GnuplotText, HoldsTheDataOfEveryLine) {
    const std::string plot = core::gnuplotPlot(
        {{"it's", "#112233", {{1, 2}, {3, std::nan("")}, {4, 5}}}, {"", "#445566", {{0, 1}}, "lines"}});
    EXPECT_NE(plot.find("$d0 << EOD\n1 2.00000\n4 5.00000\nEOD\n"), std::string::npos) << plot;
    EXPECT_NE(plot.find("title 'it''s'"), std::string::npos);
    EXPECT_NE(plot.find("with lines lw 2 lc rgb '#445566' notitle"), std::string::npos);
}

TEST(GnuplotText, FiguresStandInAPageOrSayWhyNot) {
    const std::vector<core::Figure> figures{{"id", "A & B", "what < it", ""}};
    const std::vector<std::string> pictures{"<svg/>"};
    const std::string drawn = core::figuresHtml(figures, &pictures, "");
    EXPECT_NE(drawn.find("<h3>A &amp; B</h3>\n<svg/>"), std::string::npos);
    EXPECT_NE(drawn.find("what &lt; it"), std::string::npos);
    EXPECT_NE(core::figuresHtml(figures, nullptr, "it is quick").find("gnuplot is not installed"), std::string::npos);
}

TEST(ShellWord, IsQuotedOnlyWhereTheShellWouldTakeItApart) {
    EXPECT_EQ(core::shellWord("/data/a-1_b.json"), "/data/a-1_b.json");
    EXPECT_EQ(core::shellWord("two words"), "'two words'");
    EXPECT_EQ(core::shellWord("it's"), "'it'\\''s'");
    EXPECT_EQ(core::shellWord(""), "''");
}

} // namespace
