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

namespace widgets {

namespace {

constexpr double kSavedScale = 2; // for print and slides

struct PictureExport {
    Q_DECLARE_TR_FUNCTIONS(widgets::PictureExport)
};

void askAndSave(QWidget* parent, const PictureSource& source) {
    QString filter = PictureExport::tr("PNG picture (*.png)");
    if (source.saveSvg) {
        filter += QStringLiteral(";;") + PictureExport::tr("SVG drawing (*.svg)");
    }
    QString chosen;
    QString path = QFileDialog::getSaveFileName(parent, PictureExport::tr("Save picture"),
                                                source.fileName + QStringLiteral(".png"), filter, &chosen);
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += chosen.contains(QLatin1String("svg")) ? QStringLiteral(".svg") : QStringLiteral(".png");
    }
    if (!savePicture(source, path) && source.failed) {
        source.failed(PictureExport::tr("%1 could not be written. Choose a folder that you may write to.").arg(path));
    }
}

} // namespace

void addPictureActions(QMenu& menu, QWidget* parent, const PictureSource& source) {
    QAction* copy = menu.addAction(QIcon::fromTheme(QStringLiteral("edit-copy")), PictureExport::tr("Copy picture"));
    QObject::connect(copy, &QAction::triggered, parent,
                     [source] { QApplication::clipboard()->setImage(source.image(1)); });
    QAction* save =
        menu.addAction(QIcon::fromTheme(QStringLiteral("document-save-as")), PictureExport::tr("Save picture..."));
    QObject::connect(save, &QAction::triggered, parent, [parent, source] { askAndSave(parent, source); });
}

bool savePicture(const PictureSource& source, const QString& path) {
    if (source.saveSvg && path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
        const QString beside = path + QStringLiteral(".part");
        if (!source.saveSvg(beside)) {
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
