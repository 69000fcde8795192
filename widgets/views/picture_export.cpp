// SPDX-License-Identifier: MIT
#include "widgets/views/picture_export.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSaveFile>
#include <QStatusTipEvent>
#include <QWidget>

namespace widgets {

namespace {

constexpr double kSavedScale = 2; // for print and slides

struct PictureExport {
    Q_DECLARE_TR_FUNCTIONS(widgets::PictureExport)
};

/// Up to the window, which says it.
void tell(QWidget* parent, const QString& text) {
    QStatusTipEvent tip(text);
    QCoreApplication::sendEvent(parent, &tip);
}

} // namespace

void askToSavePicture(QWidget* parent, const PictureSource& source) {
    QString filter = PictureExport::tr("PNG picture (*.png)");
    if (source.saveSvg)
        filter += QStringLiteral(";;") + PictureExport::tr("SVG drawing (*.svg)");
    if (source.savePdf)
        filter += QStringLiteral(";;") + PictureExport::tr("PDF page (*.pdf)");
    QString chosen;
    QString path = QFileDialog::getSaveFileName(parent, PictureExport::tr("Save picture"),
                                                source.fileName + QStringLiteral(".png"), filter, &chosen);
    if (path.isEmpty())
        return;
    if (QFileInfo(path).suffix().isEmpty())
        path += chosen.contains(QLatin1String("svg"))   ? QStringLiteral(".svg")
                : chosen.contains(QLatin1String("pdf")) ? QStringLiteral(".pdf")
                                                        : QStringLiteral(".png");
    const bool saved = savePicture(source, path);
    if (!saved && source.failed)
        source.failed(PictureExport::tr("%1 could not be written. Choose a folder that you may write to.").arg(path));
    else if (saved)
        tell(parent, PictureExport::tr("Saved to %1").arg(path));
}

void addPictureActions(QMenu& menu, QWidget* parent, const PictureSource& source) {
    QAction* copy = menu.addAction(QIcon::fromTheme(QStringLiteral("edit-copy")), PictureExport::tr("Copy picture"));
    QObject::connect(copy, &QAction::triggered, parent, [parent, source] {
        QApplication::clipboard()->setImage(source.image(1));
        tell(parent, PictureExport::tr("The picture is in the clipboard."));
    });
    QAction* save =
        menu.addAction(QIcon::fromTheme(QStringLiteral("document-save-as")), PictureExport::tr("Save picture..."));
    QObject::connect(save, &QAction::triggered, parent, [parent, source] { askToSavePicture(parent, source); });
}

bool savePicture(const PictureSource& source, const QString& path) {
    std::function<bool(const QString&)> drawing;
    if (path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive))
        drawing = source.saveSvg;
    else if (path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive))
        drawing = source.savePdf;
    if (drawing) {
        const QString beside = path + QStringLiteral(".part");
        if (!drawing(beside)) {
            QFile::remove(beside);
            return false;
        }
        QFile::remove(path);
        return QFile::rename(beside, path);
    }
    QSaveFile file(path);
    return file.open(QIODevice::WriteOnly) && source.image(kSavedScale).save(&file, "PNG") && file.commit();
}

} // namespace widgets
