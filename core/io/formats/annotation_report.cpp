// SPDX-License-Identifier: MIT
#include "core/io/formats/annotation_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/dataset/sequence_pictures.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/gnuplot.h"
#include "core/rig/rig_findings.h"
#include "core/text/html_text.h"
#include "core/text/number_text.h"

namespace core {

namespace {

constexpr std::size_t kWorstJoints = 12;  ///< listed per sequence
constexpr std::size_t kMostFindings = 40; ///< listed per sequence and rater

const char* const kColours[] = {"#56B4E9", "#E69F00", "#009E73", "#CC79A7", "#D55E00", "#0072B2"};

std::string colour(std::size_t i) {
    return kColours[i % std::size(kColours)];
}

std::string count(int n) {
    return "<td>" + std::to_string(n) + "</td>";
}

std::string tableHead(std::initializer_list<const char*> columns) {
    std::string text = "<table>\n<thead><tr>";
    for (const char* const column : columns)
        text += "<th>" + std::string(column) + "</th>";
    return text + "</tr></thead>\n<tbody>\n";
}

/// A number that needs at least that many values behind it to mean anything.
std::string numberCell(double value, int digits, int values, int least = 1) {
    return htmlNumberCell(values < least ? std::nan("") : value, digits);
}

std::string limitsCell(const BlandAltman& axis, int values) {
    if (values == 0)
        return "<td></td>";
    const std::string limits =
        values == 1 ? "" : " (" + fixedText(axis.lowerMm(), 2) + " to " + fixedText(axis.upperMm(), 2) + ")";
    return "<td>" + fixedText(axis.biasMm, 2) + limits + "</td>";
}

constexpr const char* kTableEnd = "</tbody>\n</table>\n";

/// Stands in the rater's column of a sequence without marks.
std::string noRaterText(const AnnotationSummary& sequence) {
    return sequence.proposals == 0
               ? "no marks yet"
               : "no marks yet; " + std::to_string(sequence.proposals) + " proposed marks wait to be checked";
}

/// How far a rater's clicks scatter; "1 (assumed)" while that is not known, "given" where it was not asked for.
std::string sigmaCell(const RaterSummary& rater) {
    if (!rater.sigma)
        return htmlTextCell("given");
    return rater.sigma->isAssumed ? htmlTextCell("1 (assumed)") : htmlNumberCell(rater.sigma->clickPx, 2);
}

std::string progressHtml(const std::vector<AnnotationSummary>& sequences) {
    std::string text =
        "<h2>Progress</h2>\n" + tableHead({"sequence", "rater", "frames with marks", "of", "clicks", "accepted",
                                           "joints done", "partial", "bad", "occluded", "click &sigma;, px"});
    for (const AnnotationSummary& sequence : sequences) {
        if (sequence.empty()) {
            text += "<tr>" + htmlTextCell(sequence.sequence) + htmlTextCell(noRaterText(sequence)) + count(0) +
                    count(sequence.frameCount) +
                    "<td></td><td></td><td></td><td></td><td></td><td></td><td></td></tr>\n";
        }
        for (const RaterSummary& rater : sequence.raters) {
            text += "<tr>" + htmlTextCell(sequence.sequence) + htmlTextCell(rater.rater) + count(rater.frames) +
                    count(sequence.frameCount) + count(rater.clicks) + count(rater.accepted) +
                    count(rater.joints.done) + count(rater.joints.partial) + count(rater.joints.bad) +
                    count(rater.joints.occluded) + sigmaCell(rater) + "</tr>\n";
        }
    }
    return text + kTableEnd +
           "<p>Bad: a large reprojection error, a click that disagrees, or no 3D point from two or more clicks. Click "
           "&sigma;: how far this "
           "rater's clicks scatter per axis, estimated from how well they agree, the cameras' own errors taken "
           "off.</p>\n";
}

std::string agreementHtml(const std::vector<AnnotationSummary>& sequences) {
    std::string rows;
    for (const AnnotationSummary& sequence : sequences) {
        for (const RaterComparison& pair : sequence.agreement) {
            rows += "<tr>" + htmlTextCell(sequence.sequence) + htmlTextCell(pair.first) + htmlTextCell(pair.second) +
                    count(pair.all.count) + numberCell(pair.all.meanMm, 2, pair.all.count) +
                    numberCell(pair.all.medianMm, 2, pair.all.count) + numberCell(pair.all.maxMm, 2, pair.all.count);
            for (const BlandAltman& axis : pair.all.axes)
                rows += limitsCell(axis, pair.all.count);
            rows += count(pair.clicks) + numberCell(pair.clickRmsPx, 2, pair.clicks) + "</tr>\n";
        }
    }
    if (rows.empty()) {
        return "<h2>Agreement</h2>\n<p>No two raters have marked the same joint. A rater who marks a random part of "
               "the own work again can be "
               "compared with it, too.</p>\n";
    }
    return "<h2>Agreement</h2>\n" +
           tableHead({"sequence", "rater", "and", "joints", "mean, mm", "median", "largest", "x: bias (95 %), mm", "y",
                      "z", "clicks", "RMS, px"}) +
           rows + kTableEnd +
           "<p>Distances between the 3D joints of two raters; bias and 95 % limits of agreement per axis after Bland "
           "and Altman (1986); RMS "
           "distance between clicks of the same joint in the same view. &ldquo;(again)&rdquo; is a rater's second "
           "round.</p>\n";
}

std::string worstJointsHtml(const std::vector<AnnotationSummary>& sequences) {
    std::string text = "<h2>Worst joints</h2>\n" + tableHead({"sequence", "joint", "points", "error, px",
                                                              "expected distance, mm", "clicks that disagree"});
    for (const AnnotationSummary& sequence : sequences) {
        for (std::size_t i = 0; i < std::min(kWorstJoints, sequence.joints.size()); ++i) {
            const JointSummary& joint = sequence.joints[i];
            text += "<tr>" + htmlTextCell(sequence.sequence) + htmlTextCell(jointLabel(joint.joint)) +
                    count(joint.points) + htmlNumberCell(joint.meanRmsPx, 2) + htmlNumberCell(joint.meanSigmaMm, 3) +
                    count(joint.outliers) + "</tr>\n";
        }
    }
    return text + kTableEnd;
}

std::string findingRows(const std::string& sequence, const RaterSummary& rater) {
    std::string rows;
    for (std::size_t i = 0; i < std::min(kMostFindings, rater.findings.size()); ++i) {
        const QualityFinding& finding = rater.findings[i];
        rows += "<tr>" + htmlTextCell(sequence) + htmlTextCell(rater.rater) + count(finding.frame) +
                htmlTextCell(jointLabel(finding.joint)) + htmlTextCell(std::string(qualityKindName(finding.kind))) +
                htmlTextCell(finding.text) + "</tr>\n";
    }
    if (rater.findings.size() > kMostFindings) {
        rows += "<tr>" + htmlTextCell(sequence) + htmlTextCell(rater.rater) + "<td></td><td></td><td></td>" +
                htmlTextCell("and " + std::to_string(rater.findings.size() - kMostFindings) + " more") + "</tr>\n";
    }
    return rows;
}

std::string findingsHtml(const std::vector<AnnotationSummary>& sequences) {
    std::string rows;
    bool isCut = false;
    for (const AnnotationSummary& sequence : sequences) {
        for (const RaterSummary& rater : sequence.raters) {
            rows += findingRows(sequence.sequence, rater);
            isCut = isCut || rater.findings.size() > kMostFindings;
        }
    }
    if (rows.empty())
        return "<h2>Doubts</h2>\n<p class=\"yes\">Nothing stands out.</p>\n";
    return "<h2>Doubts</h2>\n" + tableHead({"sequence", "rater", "frame", "joint", "kind", "what"}) + rows + kTableEnd +
           (isCut ? "<p>All of a rater's doubts are listed in the window, under Quality, when it is opened with "
                    "<code>--rater</code> and the name.</p>\n"
                  : "");
}

/// Values counted in bins of `width` from 0 on, as boxes; the last bin takes the rest.
PlotLine histogram(const std::string& name, const std::string& lineColour, const std::vector<double>& values,
                   double width, int bins) {
    std::vector<int> counts(static_cast<std::size_t>(bins));
    for (const double value : values)
        ++counts[static_cast<std::size_t>(std::clamp(static_cast<int>(value / width), 0, bins - 1))];
    PlotLine line{name, lineColour, {}, "boxes fs solid 0.6 noborder"};
    for (int i = 0; i < bins; ++i)
        line.points.push_back({(i + 0.5) * width, static_cast<double>(counts[static_cast<std::size_t>(i)])});
    return line;
}

Figure progressFigure(const std::vector<AnnotationSummary>& sequences) {
    std::vector<PlotLine> lines;
    int first = std::numeric_limits<int>::max(), last = 0, most = 0;
    for (const AnnotationSummary& sequence : sequences) {
        for (const RaterSummary& rater : sequence.raters) {
            PlotLine line{sequence.sequence + ", " + rater.rater, colour(lines.size()), {}, "points pt 7 ps 0.6"};
            for (const auto& [frame, done] : rater.doneByFrame) {
                first = std::min(first, frame);
                last = std::max(last, frame);
                most = std::max(most, static_cast<int>(done));
                line.points.push_back({static_cast<double>(frame), static_cast<double>(done)});
            }
            lines.push_back(std::move(line));
        }
    }
    return {"progress", "Finished joints", "Joints of both hands that are done, per frame with marks.",
            gnuplotPreamble("progress", "frame", "joints done") + "set yrange [0:*]\nset offsets 0.5, 0.5, 0, 0\n" +
                gnuplotWholeTics("x", std::min(first, last), last) + gnuplotWholeTics("y", 0, most) +
                gnuplotPlot(lines)};
}

Figure errorFigure(const std::vector<AnnotationSummary>& sequences) {
    constexpr double kBinPx = 0.1;
    constexpr int kBins = 40;
    std::vector<double> all;
    for (const AnnotationSummary& sequence : sequences)
        all.insert(all.end(), sequence.rmsPx.begin(), sequence.rmsPx.end());
    return {"errors", "Reprojection errors",
            "How many 3D joints have which error over the views that they were made from; the last bar holds all "
            "larger ones.",
            gnuplotPreamble("errors", "error (px)", "joints") +
                "set yrange [0:*]\nset xrange [0:" + exactText(kBinPx * kBins) + "]\nset boxwidth " +
                exactText(0.9 * kBinPx) + "\n" + gnuplotPlot({histogram("", colour(0), all, kBinPx, kBins)})};
}

Figure uncertaintyFigure(const std::vector<AnnotationSummary>& sequences) {
    std::map<JointId, std::array<double, 2>> sums; // sum, count
    for (const AnnotationSummary& sequence : sequences) {
        for (const JointSummary& joint : sequence.joints) {
            sums[joint.joint][0] += joint.meanSigmaMm * joint.points;
            sums[joint.joint][1] += joint.points;
        }
    }
    std::vector<JointId> joints;
    PlotLine line{"", colour(0), {}, "boxes fs solid 0.6 noborder"};
    for (const auto& [joint, sum] : sums) {
        const std::size_t at = line.points.size();
        joints.push_back(joint);
        line.points.push_back({static_cast<double>(at), sum[0] / sum[1]});
    }
    return {"uncertainty", "Uncertainty per joint",
            "Expected distance of the 3D joint from its true place, mean over all frames and raters.",
            gnuplotPreamble("uncertainty", "", "expected distance (mm)") + "set yrange [0:*]\nset boxwidth 0.8\n" +
                gnuplotNamedTics(readableNames(joints)) + gnuplotPlot({line})};
}

/// What all clicks say of the cameras; empty while there are too few.
std::string rigHtml(const RigHealth& rig, const std::vector<AnnotationSummary>& sequences) {
    if (!rig.isKnown)
        return "";
    std::string text = "<h2>Cameras</h2>\n" + tableHead({"camera", "clicks", "rms, px", "mean dx, px", "mean dy, px",
                                                         "&plusmn;, px", "scatter, px"});
    for (const CameraHealth& camera : rig.cameras) {
        const double unknown = camera.isKnown ? 0 : std::nan("");
        text += "<tr>" + htmlTextCell(camera.camera) + count(camera.clicks) +
                numberCell(camera.rmsPx, 2, camera.clicks) + htmlNumberCell(camera.meanPx.x() + unknown, 2) +
                htmlNumberCell(camera.meanPx.y() + unknown, 2) + htmlNumberCell(camera.meanSigmaPx + unknown, 2) +
                htmlNumberCell(camera.scatterPx + unknown, 2) + "</tr>\n";
    }
    text += std::string(kTableEnd) + "<p>Clicked minus projected, over all clicks of the dataset; for the mean, each "
                                     "joint is placed by the other cameras.</p>\n";
    std::vector<std::string> names;
    for (const AnnotationSummary& sequence : sequences)
        names.push_back(sequence.sequence);
    const std::vector<std::string> findings = rigFindings(rig, names);
    if (!findings.empty()) {
        text += "<ul>\n";
        for (const std::string& sentence : findings)
            text += "<li>" + htmlEscaped(sentence) + "</li>\n";
        text += "</ul>\n";
    }
    return text;
}

} // namespace

std::vector<Figure> annotationFigures(const std::vector<AnnotationSummary>& sequences) {
    const auto has = [&](auto member) {
        return std::any_of(sequences.begin(), sequences.end(),
                           [&](const AnnotationSummary& sequence) { return !(sequence.*member).empty(); });
    };
    std::vector<Figure> figures;
    if (has(&AnnotationSummary::raters))
        figures.push_back(progressFigure(sequences));
    if (has(&AnnotationSummary::rmsPx)) {
        figures.push_back(errorFigure(sequences));
        figures.push_back(uncertaintyFigure(sequences));
    }
    return figures;
}

std::string annotationReportHtml(const std::string& dataset, const std::vector<AnnotationSummary>& sequences,
                                 const std::vector<Figure>& figures, const std::vector<std::string>* pictures,
                                 const RigHealth& rig) {
    std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Annotations of " +
                       htmlEscaped(dataset) + "</title>\n<style>\n" + std::string(kReportStyle) +
                       "</style>\n</head>\n<body>\n<h1>Annotations of " + htmlEscaped(dataset) + "</h1>\n";
    text += progressHtml(sequences);
    const bool hasBegun = std::any_of(sequences.begin(), sequences.end(),
                                      [](const AnnotationSummary& sequence) { return !sequence.empty(); });
    if (hasBegun) {
        text += rigHtml(rig, sequences) + agreementHtml(sequences) + worstJointsHtml(sequences) +
                findingsHtml(sequences) + figuresHtml(figures, pictures, "it takes as long as this time");
    }
    return text + "</body>\n</html>\n";
}

bool writeAnnotationReport(const Dataset& dataset, const std::filesystem::path& path,
                           const AnnotationReportOptions& options, std::stop_token stop,
                           const std::function<void(int done, int total)>& progress) {
    std::vector<AnnotationSummary> sequences;
    const std::vector<RigJoint> joints = readRigJoints(dataset);
    const RigResiduals residuals = computeRigResiduals(dataset.cameras, joints);
    std::optional<ClickSigmas> sigmas;
    if (options.estimateSigmas)
        sigmas = estimateClickSigmas(dataset.cameras, joints, residuals);
    for (const Sequence& sequence : dataset.sequences) {
        sequences.push_back(summariseAnnotations(sequence.name, sequence.frameCount, readAnnotations(dataset, sequence),
                                                 dataset.cameras, dataset.hands, options.badRmsPx, options.quality,
                                                 stop, pictureGaps(dataset, sequence), sigmas));
        if (stop.stop_requested())
            return false;
        if (progress)
            progress(static_cast<int>(sequences.size()), static_cast<int>(dataset.sequences.size()));
    }
    const std::vector<Figure> figures = annotationFigures(sequences);
    std::vector<std::string> programs;
    for (const Figure& figure : figures)
        programs.push_back(figure.gnuplot);
    const auto pictures = drawWithGnuplot(programs);
    const RigHealth rig = judgeRig(dataset.cameras, joints, residuals);
    writeFileAtomically(path,
                        annotationReportHtml(dataset.name, sequences, figures, pictures ? &*pictures : nullptr, rig));
    return true;
}

} // namespace core
