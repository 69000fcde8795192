// SPDX-License-Identifier: MIT
#include "core/text/gnuplot_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/text/html_text.h"
#include "core/text/number_text.h"

namespace core {

std::string gnuplotQuoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? std::string("''") : std::string(1, c);
    return result + "'";
}

std::string gnuplotPreamble(const std::string& id, const std::string& xLabel, const std::string& yLabel) {
    std::string name = id; // gnuplot takes letters, digits and underscores only
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return "set encoding utf8\n"
           "set terminal svg size 760,430 dynamic enhanced background '#ffffff' font 'sans-serif,13' name " +
           gnuplotQuoted(name) +
           "\n"
           "set border 3 lc rgb '#888888'\nset tics nomirror out\nset grid ytics lc rgb '#e4e4e4' lw 1\n"
           "set key outside right top noenhanced samplen 2\n"
           "set xlabel " +
           gnuplotQuoted(xLabel) + "\nset ylabel " + gnuplotQuoted(yLabel) + "\n";
}

std::string gnuplotWholeTics(const std::string& axis, double first, double last) {
    constexpr double kMostTics = 10;
    const double least = std::max(1.0, (last - first) / kMostTics);
    const double power = std::pow(10, std::floor(std::log10(least)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        step = factor * power >= least ? factor * power : step;
    return "set " + axis + "tics " + std::to_string(static_cast<long long>(std::lround(step))) + "\n";
}

std::string gnuplotNamedTics(const std::vector<std::string>& names) {
    std::string tics;
    for (std::size_t i = 0; i < names.size(); ++i)
        tics += (i == 0 ? "" : ", ") + gnuplotQuoted(names[i]) + " " + std::to_string(i);
    return "set bmargin 8\nset xtics noenhanced rotate by 90 right font ',11' (" + tics + ")\n";
}

std::string gnuplotPlot(const std::vector<PlotLine>& lines) {
    std::string data;
    std::string plot;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string block = "$d" + std::to_string(i);
        data += block + " << EOD\n";
        for (const auto& [x, y] : lines[i].points)
            if (!std::isnan(y))
                data += exactText(x) + " " + fixedText(y, 5) + "\n";
        data += "EOD\n";
        const std::string title =
            lines[i].name.empty() ? std::string("notitle") : "title " + gnuplotQuoted(lines[i].name);
        plot += (i == 0 ? "plot " : ", ") + block;
        plot.append(" using 1:2 with ").append(lines[i].style);
        plot.append(" lw 2 lc rgb '").append(lines[i].colour).append("' ").append(title);
    }
    return data + plot + "\n";
}

std::string figuresHtml(const std::vector<Figure>& figures, const std::vector<std::string>* pictures,
                        const std::string& costOfAgain) {
    std::string text = "<h2>Figures</h2>\n";
    if (!pictures) {
        return text +
               "<p class=\"no\">gnuplot is not installed, so this report has no figures. Install the package "
               "gnuplot-nox and run the same command again: " +
               costOfAgain + ".</p>\n";
    }
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const Figure& figure = figures[i];
        text += "<figure id=\"figure-" + figure.id + "\">\n<h3>" + htmlEscaped(figure.title) + "</h3>\n" +
                (*pictures)[i] + "\n<figcaption>" + htmlEscaped(figure.caption) + "</figcaption>\n</figure>\n";
    }
    return text;
}

} // namespace core
