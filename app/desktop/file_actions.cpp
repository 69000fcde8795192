// SPDX-License-Identifier: MIT
#include "app/desktop/file_actions.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>

#include "app/desktop/main_window.h"
#include "core/io/annotation_formats.h"

namespace app {

namespace {

QString id(const char* text) {
    return QString::fromLatin1(text);
}

/// What a person calls a kind of annotation file.
struct FormatText {
    const char* kind;
    const char* text;
    const char* suffix; ///< of the files that are written; empty for folders
};
constexpr FormatText kFormats[] = {
    {"handlens", QT_TRANSLATE_NOOP("app::FileActions", "Handlens ground truth"), "json"},
    {"tzionas", QT_TRANSLATE_NOOP("app::FileActions", "Files of the method's authors"), ""},
    {"coco", QT_TRANSLATE_NOOP("app::FileActions", "COCO keypoints"), "json"},
    {"anipose2d", QT_TRANSLATE_NOOP("app::FileActions", "Anipose, 2D"), ""},
    {"anipose3d", QT_TRANSLATE_NOOP("app::FileActions", "Anipose, 3D"), "csv"},
    {"deeplabcut", QT_TRANSLATE_NOOP("app::FileActions", "DeepLabCut, Lightning Pose"), ""},
    {"trc", QT_TRANSLATE_NOOP("app::FileActions", "TRC, marker motion"), "trc"},
    {"interhand", QT_TRANSLATE_NOOP("app::FileActions", "InterHand2.6M"), "json"},
    {"freihand", QT_TRANSLATE_NOOP("app::FileActions", "FreiHAND, HanCo"), "json"},
    {"csv", QT_TRANSLATE_NOOP("app::FileActions", "Table of 3D joints"), "csv"},
    {"csv-marks", QT_TRANSLATE_NOOP("app::FileActions", "Table of marks"), "csv"},
};

const FormatText& formatText(std::string_view kind) {
    for (const FormatText& format : kFormats) {
        if (kind == format.kind)
            return format;
    }
    return kFormats[0];
}

/// A filter of a file dialog, such as "COCO keypoints (*.json)"; folders have none.
QString filterText(const core::AnnotationFormat& format) {
    const FormatText& text = formatText(format.kind);
    const QString name = QCoreApplication::translate("app::FileActions", text.text);
    return format.isFolder ? QCoreApplication::translate("app::FileActions", "%1 \u2013 a new folder (*)").arg(name)
                           : QStringLiteral("%1 (*.%2)").arg(name, QString::fromLatin1(text.suffix));
}

/// A filter of a file dialog, and the ending that a name without one gets; empty for folders.
struct FileKind {
    QString filter, suffix;
};

/// Shows a file dialog that does not block, to save a file if a name is proposed; `chosen` gets the path and which of the kinds it is.
void askForFile(MainWindow& window, const QString& title, const std::vector<FileKind>& kinds, const QString& proposedName,
                const std::function<void(const QString& path, std::size_t kind)>& chosen) {
    auto* dialog = new QFileDialog(&window, title);
    QStringList filters;
    for (const FileKind& kind : kinds)
        filters << kind.filter;
    dialog->setNameFilters(filters);
    const bool toSave = !proposedName.isEmpty();
    dialog->setAcceptMode(toSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(toSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const auto kindOf = [filters](const QString& filter) { return static_cast<std::size_t>(std::max(0, filters.indexOf(filter))); };
    const auto setSuffix = [dialog, kinds, kindOf](const QString& filter) { // before the dialog asks whether to overwrite
        dialog->setDefaultSuffix(kinds[kindOf(filter)].suffix);
    };
    setSuffix(filters.front());
    if (toSave)
        dialog->selectFile(proposedName);
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, setSuffix);
    QObject::connect(dialog, &QFileDialog::fileSelected, &window,
                     [dialog, chosen, kindOf](const QString& path) { chosen(path, kindOf(dialog->selectedNameFilter())); });
    dialog->open();
}

/// The kinds of annotations that can be written or read.
struct FormatChoice {
    std::vector<std::string_view> kinds;
    std::vector<FileKind> files; ///< parallel to them
};

FormatChoice formatChoice(bool toImport) {
    FormatChoice choice;
    for (const core::AnnotationFormat& format : core::annotationFormats()) {
        if (toImport && !format.canImport)
            continue;
        choice.kinds.push_back(format.kind);
        const FormatText& text = formatText(format.kind);
        const QString name = QCoreApplication::translate("app::FileActions", text.text);
        choice.files.push_back({toImport ? QStringLiteral("%1 (*)").arg(name) : filterText(format), QString::fromLatin1(text.suffix)});
    }
    return choice;
}

/// For the names of files.
QString sequenceName(MainWindow& window) {
    const core::Sequence* sequence = window.workbench().session.sequence();
    return sequence ? QString::fromStdString(sequence->name) : QStringLiteral("handlens");
}

QString text(std::string_view kind) {
    return QString::fromUtf8(kind.data(), static_cast<int>(kind.size()));
}

void exportAnnotations(MainWindow& window) {
    const FormatChoice choice = formatChoice(false);
    askForFile(window, MainWindow::tr("Export annotations"), choice.files, sequenceName(window),
               [&window, choice](const QString& path, std::size_t kind) { window.workbench().files.exportTo(text(choice.kinds[kind]), path); });
}

void importAnnotations(MainWindow& window) {
    const FormatChoice choice = formatChoice(true);
    askForFile(window, MainWindow::tr("Import annotations"), choice.files, {},
               [&window, choice](const QString& path, std::size_t kind) { window.workbench().files.importFrom(text(choice.kinds[kind]), path); });
}

} // namespace

void bindFileActions(MainWindow& window) {
    Actions& actions = window.actions();
    actions.bind(id("file.export"), [&window] { exportAnnotations(window); });
    actions.bind(id("file.import"), [&window] { importAnnotations(window); });
    actions.bind(id("file.report"), [&window] {
        askForFile(window, MainWindow::tr("Report on the annotations"), {{MainWindow::tr("Pages (*.html)"), QStringLiteral("html")}}, MainWindow::tr("report"),
                   [&window](const QString& path, std::size_t) { window.workbench().files.report(path, window.workbench().coverage.badRmsPx()); });
    });
    actions.bind(id("file.savePicture"), [&window] {
        askForFile(window, MainWindow::tr("Save the views as a picture"), {{MainWindow::tr("Pictures (*.png)"), QStringLiteral("png")}}, sequenceName(window),
                   [&window](const QString& path, std::size_t) {
                       if (window.workspaces().grid()->grabPicture(2).save(path, "PNG"))
                           window.statusLine().sayBriefly(MainWindow::tr("Saved to %1").arg(QDir::toNativeSeparators(path)));
                       else
                           window.showMessage(MainWindow::tr("%1 could not be written.").arg(path));
                   });
    });
    actions.bind(id("annotation.jointsFile"), [&window] {
        askForFile(window, MainWindow::tr("Joints from a file"), {{MainWindow::tr("Lists of joints (*.json)"), QStringLiteral("json")}}, {},
                   [&window](const QString& path, std::size_t) { window.workbench().files.readJoints(path); });
    });
}

} // namespace app
