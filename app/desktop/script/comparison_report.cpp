// SPDX-License-Identifier: MIT
#include "app/desktop/script/comparison_report.h"

#include <algorithm>
#include <cmath>

#include <QBuffer>

#include "app/desktop/main_window.h"
#include "app/desktop/script/workspace_file.h"
#include "core/error.h"
#include "core/fitting/method_name.h"
#include "core/fitting/method_options.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"
#include "core/text/html_text.h"
#include "core/text/shell_text.h"
#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/presenters/inspect/inspected_poses.h"
#include "widgets/text/edit_text.h"
#include "widgets/text/local_text.h"
#include "widgets/workspaces/inspect_picture.h"

namespace app {

namespace {

using core::htmlEscaped;

constexpr widgets::LocalText words{"app::ComparisonReport"};
constexpr int kPictureWidth = 640; ///< of a view, pixels

constexpr const char* kPictureStyle = R"(
table.pictures td { padding: 2px; text-align: center; }
table.pictures img { width: 100%; display: block; }
figure { display: inline-block; width: 48%; margin: 0; }
figure img { width: 100%; }
pre { white-space: pre-wrap; }
)";

std::string escaped(const QString& text) {
    return htmlEscaped(text.toStdString());
}

std::string paragraph(const QString& text) {
    return "<p>" + escaped(text) + "</p>\n";
}

std::string heading(const QString& text) {
    return "<h2>" + escaped(text) + "</h2>\n";
}

std::string headerRow(const QStringList& names) {
    std::string row = "<thead><tr>";
    for (const QString& name : names)
        row += "<th>" + escaped(name) + "</th>";
    return row + "</tr></thead>\n";
}

std::string pngTag(const QImage& picture, const QString& what) {
    QByteArray data;
    QBuffer buffer(&data);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return "<img alt=\"" + escaped(what) + "\" src=\"data:image/png;base64," + data.toBase64().toStdString() + "\">";
}

std::string svgTag(const QByteArray& svg, const QString& what) {
    return "<img alt=\"" + escaped(what) + "\" src=\"data:image/svg+xml;base64," + svg.toBase64().toStdString() + "\">";
}

/// What the page is about.
struct Compared {
    MainWindow& window;
    const widgets::InspectPage& page;
    const widgets::FitOutcome& outcome;
    const std::vector<widgets::InspectColumn>& columns;

    QString title(std::size_t column) const { return widgets::columnTitle(columns[column]); }
    bool isMethod(std::size_t column) const { return columns[column].kind == widgets::InspectColumn::Kind::Method; }
    QStringList titles(const QStringList& before) const {
        QStringList all = before;
        for (std::size_t column = 0; column < columns.size(); ++column)
            all << title(column);
        return all;
    }
};

/// What the numbers beside it were found under, if that is not what was fitted.
std::string trialParagraph(const widgets::InspectPage& page) {
    const QString text = page.trialText();
    return text.isEmpty() ? std::string() : "<p><strong>" + escaped(text) + "</strong></p>\n";
}

std::string errorTable(const Compared& compared) {
    std::string text = "<table>\n" + headerRow({words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Method")),
                                                words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Start, mm")),
                                                words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Shown, mm")),
                                                words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Result, mm")),
                                                words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Iterations")),
                                                words(QT_TRANSLATE_NOOP("app::ComparisonReport", "End"))});
    text += "<tbody>\n";
    for (std::size_t column = 0; column < compared.columns.size(); ++column) {
        if (!compared.isMethod(column))
            continue;
        const widgets::MethodOutcome& method = compared.outcome.methods[column];
        const double shownMm = widgets::inspectedErrorMm(compared.outcome, method, compared.page.iteration());
        text += "<tr>" + core::htmlTextCell(method.method) + core::htmlNumberCell(compared.outcome.initialErrorMm, 2) +
                core::htmlNumberCell(shownMm, 2) + core::htmlNumberCell(method.errorMm, 2) +
                core::htmlNumberCell(static_cast<double>(method.result.history.size()), 0) +
                core::htmlTextCell(std::string(core::terminationName(method.result.termination))) + "</tr>\n";
    }
    return text + "</tbody>\n</table>\n";
}

std::string pictureTable(const Compared& compared) {
    const widgets::InspectGrid& views = *compared.page.views();
    std::string text = "<table class=\"pictures\">\n" + headerRow(compared.titles({QString()})) + "<tbody>\n";
    for (int view = 0; view < views.grid()->count(); ++view) {
        const widgets::CameraView& shown = *views.grid()->view(view);
        const QString camera = QString::fromStdString(shown.camera().name);
        if (views.columnOf(view) == 0)
            text += "<tr>" + core::htmlTextCell(camera.toStdString());
        const double scale = std::clamp(double(kPictureWidth) / std::max(1, shown.viewport()->width()), 1.0, 3.0);
        text += "<td>" +
                pngTag(shown.grabPicture(scale), camera + QLatin1Char(' ') + compared.title(views.columnOf(view))) +
                escaped(shown.title().error) + "</td>";
        if (views.columnOf(view) + 1 == compared.columns.size())
            text += "</tr>\n";
    }
    return text + "</tbody>\n</table>\n";
}

std::string curves(const Compared& compared) {
    const QString error = words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Error by iteration")),
                  cost = words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Cost by iteration"));
    return "<figure>" + svgTag(compared.page.errorPlot()->svg(), error) + "<figcaption>" + escaped(error) +
           "</figcaption></figure>\n<figure>" + svgTag(compared.page.costPlot()->svg(), cost) + "<figcaption>" +
           escaped(cost) + "</figcaption></figure>\n";
}

/// Of a joint, without the signs of its id.
std::string readableName(const core::JointId& joint) {
    return widgets::jointText(joint).replace(QLatin1Char('_'), QLatin1Char(' ')).toStdString();
}

std::string jointTable(const Compared& compared) {
    const core::Dataset& dataset = *compared.window.session().opened.dataset();
    std::vector<core::JointPositions> joints;
    for (std::size_t column = 0; column < compared.columns.size(); ++column)
        joints.push_back(widgets::inspectedJoints(dataset, compared.outcome, column, compared.page.iteration()));
    std::string text =
        "<table>\n" +
        headerRow(compared.titles({words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Joint, error in mm"))})) +
        "<tbody>\n";
    for (const core::JointId& id : core::jointNames(dataset.hands)) {
        const auto truth = compared.outcome.reference.find(id);
        if (truth == compared.outcome.reference.end())
            continue;
        text += "<tr>" + core::htmlTextCell(readableName(id));
        for (const core::JointPositions& found : joints) {
            const auto place = found.find(id);
            text +=
                core::htmlNumberCell(place == found.end() ? std::nan("") : (place->second - truth->second).norm(), 1);
        }
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table>\n";
}

/// What the option is in effect; 0 of bins and gate stands for what is usual for the distance.
std::string effectiveValue(const core::MethodOption& option, const core::Method& method) {
    if (option.key != "bins" && option.key != "gate")
        return option.print(method);
    const double value = widgets::optionValue(method, std::string(option.key));
    return std::isfinite(value) ? QString::number(value).toStdString() : "none";
}

/// Every option of every method: what is set, else its default.
std::string settingsTable(const Compared& compared) {
    std::string text = "<table>\n" +
                       headerRow({words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Method")),
                                  words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Option")),
                                  words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Value")),
                                  words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Default"))}) +
                       "<tbody>\n";
    for (std::size_t column = 0; column < compared.columns.size(); ++column) {
        if (!compared.isMethod(column))
            continue;
        const std::string& name = compared.outcome.methods[column].method;
        const core::Method method = core::parseMethod(name);
        for (const core::MethodOption& option : core::methodOptions())
            if (option.appliesTo(method))
                text += "<tr>" + core::htmlTextCell(name) + core::htmlTextCell(std::string(option.key)) +
                        core::htmlTextCell(effectiveValue(option, method)) +
                        core::htmlTextCell(std::string(option.defaultText)) + "</tr>\n";
    }
    return text + "</tbody>\n</table>\n";
}

std::string commandPart(const Compared& compared, const std::string& workspaceFile, const std::string& workspaceText) {
    const std::string folder = compared.window.session().opened.dataset()->folder.string();
    return heading(words(QT_TRANSLATE_NOOP("app::ComparisonReport", "To make this page again"))) + "<pre>" +
           htmlEscaped("handlens " + core::shellWord(folder) + " --workspace " + core::shellWord(workspaceFile) +
                       " --offscreen --out comparison") +
           "</pre>\n" +
           paragraph(words(QT_TRANSLATE_NOOP("app::ComparisonReport", "The file %1 holds:"))
                         .arg(QString::fromStdString(workspaceFile))) +
           "<pre>" + htmlEscaped(workspaceText) + "</pre>\n";
}

} // namespace

std::string comparisonReportHtml(MainWindow& window, const std::string& workspaceFile,
                                 const std::string& workspaceText) {
    const widgets::InspectPage& page = *window.workspaces().inspectPage();
    const auto outcome = page.columns()->outcome();
    if (!outcome)
        throw core::Error(core::ErrorCode::Usage, {}, "do", "nothing was fitted yet");
    const Compared compared{window, page, *outcome, page.columns()->columns()};
    const std::string title = escaped(widgets::pairText(page));
    std::string text = "<!DOCTYPE html>\n<html>\n<head>\n<meta charset=\"utf-8\">\n<title>" + title +
                       "</title>\n<style>" + core::kReportStyle + kPictureStyle + "</style>\n</head>\n<body>\n<h1>" +
                       title + "</h1>\n" + trialParagraph(page) + paragraph(page.iterationText()) +
                       errorTable(compared);
    text += heading(words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Views"))) + pictureTable(compared);
    text += heading(words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Curves"))) + curves(compared);
    text += heading(words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Error joint by joint"))) + jointTable(compared);
    text += heading(words(QT_TRANSLATE_NOOP("app::ComparisonReport", "Settings"))) + trialParagraph(page) +
            settingsTable(compared);
    return text + commandPart(compared, workspaceFile, workspaceText) + "</body>\n</html>\n";
}

void saveComparisonReport(MainWindow& window, const std::filesystem::path& page) {
    std::filesystem::path workspace = page;
    workspace.replace_extension(".json");
    writeWorkspace(workspace, currentWorkspace(window));
    core::writeFileAtomically(
        page, comparisonReportHtml(window, workspace.filename().string(), core::readTextFile(workspace)));
}

} // namespace app
