// SPDX-License-Identifier: MIT
#include "app/desktop/file_actions.h"

#include <functional>

#include <QCoreApplication>
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

QString withSuffix(const QString& path, const char* suffix) {
    const QString ending = QLatin1Char('.') + QString::fromLatin1(suffix);
    return *suffix == '\0' || path.endsWith(ending) ? path : path + ending;
}

/// Shows a file dialog that does not block; `chosen` gets the path and the filter.
void askForFile(MainWindow& window, const QString& title, const QStringList& filters, bool toSave,
                const std::function<void(const QString& path, const QString& filter)>& chosen) {
    auto* dialog = new QFileDialog(&window, title);
    dialog->setNameFilters(filters);
    dialog->setAcceptMode(toSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(toSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::fileSelected, &window,
                     [dialog, chosen](const QString& path) { chosen(path, dialog->selectedNameFilter()); });
    dialog->open();
}

/// The kinds that can be written or read, and the same as filters, in one order.
struct FormatChoice {
    std::vector<std::string_view> kinds;
    QStringList filters;

    std::string_view kindOf(const QString& filter) const {
        const int index = filters.indexOf(filter);
        return kinds[static_cast<std::size_t>(std::max(0, index))];
    }
};

FormatChoice formatChoice(bool toImport) {
    FormatChoice choice;
    for (const core::AnnotationFormat& format : core::annotationFormats()) {
        if (toImport && !format.canImport)
            continue;
        choice.kinds.push_back(format.kind);
        const QString name = QCoreApplication::translate("app::FileActions", formatText(format.kind).text);
        choice.filters << (toImport ? QStringLiteral("%1 (*)").arg(name) : filterText(format));
    }
    return choice;
}

QString text(std::string_view kind) {
    return QString::fromUtf8(kind.data(), static_cast<int>(kind.size()));
}

void exportAnnotations(MainWindow& window) {
    const FormatChoice choice = formatChoice(false);
    askForFile(window, MainWindow::tr("Export annotations"), choice.filters, true, [&window, choice](const QString& path, const QString& filter) {
        const std::string_view kind = choice.kindOf(filter);
        window.workbench().files.exportTo(text(kind), withSuffix(path, formatText(kind).suffix));
    });
}

void importAnnotations(MainWindow& window) {
    const FormatChoice choice = formatChoice(true);
    askForFile(window, MainWindow::tr("Import annotations"), choice.filters, false, [&window, choice](const QString& path, const QString& filter) {
        window.workbench().files.importFrom(text(choice.kindOf(filter)), path);
    });
}

} // namespace

void bindFileActions(MainWindow& window) {
    Actions& actions = window.actions();
    actions.bind(id("file.export"), [&window] { exportAnnotations(window); });
    actions.bind(id("file.import"), [&window] { importAnnotations(window); });
    actions.bind(id("file.report"), [&window] {
        askForFile(window, MainWindow::tr("Report on the annotations"), {MainWindow::tr("Pages (*.html)")}, true,
                   [&window](const QString& path, const QString&) { window.workbench().files.report(withSuffix(path, "html"), window.workbench().coverage.badRmsPx()); });
    });
    actions.bind(id("file.savePicture"), [&window] {
        askForFile(window, MainWindow::tr("Save the views as a picture"), {MainWindow::tr("Pictures (*.png)")}, true, [&window](const QString& path, const QString&) {
            const QString file = withSuffix(path, "png");
            if (!window.workspaces().grid()->grabPicture(2).save(file))
                window.showMessage(MainWindow::tr("%1 could not be written.").arg(file));
        });
    });
    actions.bind(id("annotation.jointsFile"), [&window] {
        askForFile(window, MainWindow::tr("Joints from a file"), {MainWindow::tr("Lists of joints (*.json)")}, false,
                   [&window](const QString& path, const QString&) { window.workbench().files.readJoints(path); });
    });
}

} // namespace app
