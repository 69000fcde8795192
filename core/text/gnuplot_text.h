// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

namespace core {

/// A figure as a program for gnuplot (5.2 or newer) with its data inside; it prints an SVG to standard output.
struct Figure {
    std::string id; ///< short, unique within a report
    std::string title;
    std::string caption; ///< what is drawn, and how to read it
    std::string gnuplot;
};

/// One line of a plot: gnuplot's columns 1 and 2, in this order. Points with a NaN are left out.
struct PlotLine {
    std::string name;   ///< empty: not in the key
    std::string colour; ///< #rrggbb
    std::vector<std::array<double, 2>> points;
    const char* style = "linespoints pt 7 ps 0.5";
};

/// Text as gnuplot's quoted string.
std::string gnuplotQuoted(const std::string& text);
/// The beginning of every program: the terminal, quiet axes, labels, the key beside the plot. `id` names the SVG's own
/// ids.
std::string gnuplotPreamble(const std::string& id, const std::string& xLabel, const std::string& yLabel);
/// Marks on an axis ("x" or "y") of whole numbers from `first` to `last`, such as frames: never a fraction, about ten
/// at most.
std::string gnuplotWholeTics(const std::string& axis, double first, double last);
/// Marks at 0, 1, 2, ... that are names, written upwards.
std::string gnuplotNamedTics(const std::vector<std::string>& names);
/// Data blocks and the plot command for lines.
std::string gnuplotPlot(const std::vector<PlotLine>& lines);

/// Figures as parts of a page; `pictures` are their SVGs, empty if gnuplot is not there to draw them: the page then
/// says what to install, and what running the command again costs.
std::string figuresHtml(const std::vector<Figure>& figures, const std::vector<std::string>* pictures,
                        const std::string& costOfAgain);

} // namespace core
