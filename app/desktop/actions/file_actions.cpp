// SPDX-License-Identifier: MIT
#include "app/desktop/actions/file_actions.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <QCoreApplication>
#include <QDir>

#include "app/desktop/actions/action_id.h"
#include "app/desktop/main_window.h"
#include "app/desktop/script/workspace_player.h"
#include "app/desktop/windows/annotation_format_text.h"
#include "app/desktop/windows/ask_for_file.h"
#include "app/desktop/windows/export_window.h"
#include "core/error.h"
#include "core/io/formats/annotation_formats.h"
#include "widgets/text/error_text.h"
#include "widgets/text/local_text.h"

namespace app {

namespace {

/// The kinds of annotations that can be read.
struct FormatChoice {
    std::vector<std::string_view> kinds;
    std::vector<FileKind> files; ///< parallel to them
};

FormatChoice importChoice() {
    FormatChoice choice;
    for (const core::AnnotationFormat& format : core::annotationFormats()) {
        if (!format.canImport)
            continue;
        const AnnotationFormatText text = annotationFormatText(format.kind);
        choice.kinds.push_back(format.kind);
        choice.files.push_back({QStringLiteral("%1 (*)").arg(text.name), text.suffix});
    }
    return choice;
}

/// For the names of files.
QString sequenceName(MainWindow& window) {
    const core::Sequence* sequence = window.session().opened.sequence();
    return sequence ? QString::fromStdString(sequence->name) : QStringLiteral("handlens");
}

/// First what kind of file, then where to. The kind is remembered.
void exportAnnotations(MainWindow& window) {
    const QString setting = QStringLiteral("exportKind");
    auto* dialog = new ExportWindow(window.settings().value(setting).toString(), &window);
    QObject::connect(dialog, &ExportWindow::chosen, &window, [&window, setting](const QString& kind) {
        window.settings().setValue(setting, kind);
        const core::AnnotationFormat& format = core::annotationFormat(kind.toStdString());
        askForFile(window, MainWindow::tr("Export annotations"),
                   {{fileFilter(format), annotationFormatText(format.kind).suffix}}, sequenceName(window),
                   [&window, kind](const QString& path, std::size_t) { window.session().files.exportTo(kind, path); });
    });
    dialog->open();
}

void importAnnotations(MainWindow& window) {
    const FormatChoice choice = importChoice();
    askForFile(window, MainWindow::tr("Import annotations"), choice.files, {},
               [&window, choice](const QString& path, std::size_t kind) {
                   window.session().files.importFrom(widgets::toQString(choice.kinds[kind]), path);
               });
}

void bindComparisonFiles(MainWindow& window) {
    const FileKind kind{MainWindow::tr("Comparisons (*.json)"), QStringLiteral("json")};
    window.actions().bind(
        id("file.saveWorkspace"),
        [&window, kind] {
            if (!window.session().fits.outcome()) {
                window.statusLine().sayBriefly(MainWindow::tr("Fit a pair first."));
                return;
            }
            askForFile(
                window, MainWindow::tr("Save this comparison"), {kind}, sequenceName(window),
                [&window](const QString& path, std::size_t) {
                    try {
                        writeWorkspace(path.toStdString(), currentWorkspace(window));
                    } catch (const core::Error& error) {
                        window.showMessage(widgets::errorInWords(error));
                    }
                });
        });
    window.actions().bind(id("file.openWorkspace"), [&window, kind] {
        askForFile(window, MainWindow::tr("Open a comparison"), {kind}, {},
                   [&window](const QString& path, std::size_t) { openWorkspace(window, path.toStdString()); });
    });
}

} // namespace

void bindFileActions(MainWindow& window) {
    bindComparisonFiles(window);
    Actions& actions = window.actions();
    actions.bind(
        id("file.export"), [&window] { exportAnnotations(window); });
    actions.bind(
        id("file.import"), [&window] { importAnnotations(window); });
    actions.bind(
        id("file.report"),
        [&window] {
            askForFile(
                window, MainWindow::tr("Report on the annotations"),
                {{MainWindow::tr("Pages (*.html)"), QStringLiteral("html")}}, MainWindow::tr("report"),
                [&window](const QString& path, std::size_t) {
                    window.session().files.report(path, window.session().coverage.badRmsPx());
                });
        });
    actions.bind(
        id("file.savePicture"),
        [&window] {
            askForFile(
                window, MainWindow::tr("Save the views as a picture"),
                {{MainWindow::tr("Pictures (*.png)"), QStringLiteral("png")}}, sequenceName(window),
                [&window](const QString& path, std::size_t) {
                    if (window.workspaces().grid()->grabPicture(2).save(path, "PNG"))
                        window.statusLine().sayBriefly(
                            MainWindow::tr("Saved to %1").arg(QDir::toNativeSeparators(path)));
                    else
                        window.showMessage(MainWindow::tr("%1 could not be written.").arg(path));
                });
        });
    actions.bind(id("annotation.jointsFile"), [&window] {
        askForFile(window, MainWindow::tr("Joints from a file"),
                   {{MainWindow::tr("Lists of joints (*.json)"), QStringLiteral("json")}}, {},
                   [&window](const QString& path, std::size_t) { window.session().files.readJoints(path); });
    });
}

} // namespace app
