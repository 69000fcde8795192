// SPDX-License-Identifier: MIT
#include "app/desktop/windows/annotation_format_text.h"

#include <stdexcept>
#include <string>

#include "widgets/text/local_text.h"

namespace app {

namespace {

struct FormatRow {
    const char* kind;
    const char* name;
    const char* holds;
    const char* readBy;
    const char* lost;
    const char* suffix;
};

constexpr FormatRow kFormats[] = {
    {"handlens", QT_TRANSLATE_NOOP("app::FileActions", "Handlens ground truth"),
     QT_TRANSLATE_NOOP(
         "app::FileActions",
         "3D joints with their uncertainty, every mark of every rater with its state and error, and the cameras."),
     QT_TRANSLATE_NOOP("app::FileActions", "Handlens and scripts of your own (JSON)"),
     QT_TRANSLATE_NOOP("app::FileActions", "Only proposals and the list of undo steps"), "json"},
    {"tzionas", QT_TRANSLATE_NOOP("app::FileActions", "Files of the method's authors"),
     QT_TRANSLATE_NOOP("app::FileActions", "Marks in whole pixels, a folder per camera and a text file per frame."),
     QT_TRANSLATE_NOOP("app::FileActions", "The programs of the method's authors"),
     QT_TRANSLATE_NOOP(
         "app::FileActions",
         "Fractions of pixels, 3D joints, joints beyond the 14 of a hand; occluded and missing are both 0 0"),
     ""},
    {"coco", QT_TRANSLATE_NOOP("app::FileActions", "COCO keypoints"),
     QT_TRANSLATE_NOOP("app::FileActions", "Marks per picture and hand, each visible, occluded or missing."),
     QT_TRANSLATE_NOOP("app::FileActions", "MMPose, Detectron2, CVAT, FiftyOne and most trainers of networks (JSON)"),
     QT_TRANSLATE_NOOP("app::FileActions", "3D joints, cameras, who clicked and who accepted"), "json"},
    {"anipose2d", QT_TRANSLATE_NOOP("app::FileActions", "Anipose, 2D"),
     QT_TRANSLATE_NOOP("app::FileActions", "Marks as a table per camera with a row per frame."),
     QT_TRANSLATE_NOOP("app::FileActions", "Anipose and aniposelib (CSV)"),
     QT_TRANSLATE_NOOP("app::FileActions", "3D joints and states: occluded marks look like visible ones"), ""},
    {"anipose3d", QT_TRANSLATE_NOOP("app::FileActions", "Anipose, 3D"),
     QT_TRANSLATE_NOOP("app::FileActions", "3D joints with error and number of cameras, a row per frame."),
     QT_TRANSLATE_NOOP("app::FileActions", "Anipose and what reads its results (CSV)"),
     QT_TRANSLATE_NOOP("app::FileActions", "The marks themselves, uncertainties and cameras"), "csv"},
    {"deeplabcut", QT_TRANSLATE_NOOP("app::FileActions", "DeepLabCut, Lightning Pose"),
     QT_TRANSLATE_NOOP("app::FileActions", "Marks as one CollectedData table per camera, a row per annotated frame."),
     QT_TRANSLATE_NOOP("app::FileActions", "DeepLabCut, Lightning Pose, napari-deeplabcut (CSV)"),
     QT_TRANSLATE_NOOP("app::FileActions", "3D joints and states: occluded marks look like visible ones"), ""},
    {"sleap", QT_TRANSLATE_NOOP("app::FileActions", "SLEAP"),
     QT_TRANSLATE_NOOP("app::FileActions", "Labels and guesses of a project (.slp) or of an analysis export (.h5)."),
     QT_TRANSLATE_NOOP("app::FileActions", "SLEAP and sleap-io (HDF5)"),
     QT_TRANSLATE_NOOP("app::FileActions", "Everything: it can be imported, not exported"), "slp"},
    {"label3d", QT_TRANSLATE_NOOP("app::FileActions", "Label3D, DANNCE"),
     QT_TRANSLATE_NOOP("app::FileActions", "Clicks and 3D points of a session, or the labels exported for DANNCE."),
     QT_TRANSLATE_NOOP("app::FileActions", "Label3D and DANNCE (MATLAB)"),
     QT_TRANSLATE_NOOP("app::FileActions", "Everything: it can be imported, not exported"), "mat"},
    {"trc", QT_TRANSLATE_NOOP("app::FileActions", "TRC, marker motion"),
     QT_TRANSLATE_NOOP("app::FileActions", "3D joints as moving markers, a row per frame of the sequence."),
     QT_TRANSLATE_NOOP("app::FileActions", "OpenSim, Mokka, Visual3D and other programs for motion"),
     QT_TRANSLATE_NOOP("app::FileActions",
                       "The marks themselves, uncertainties and cameras; it cannot be imported again"),
     "trc"},
    {"interhand", QT_TRANSLATE_NOOP("app::FileActions", "InterHand2.6M"),
     QT_TRANSLATE_NOOP("app::FileActions", "3D joints of both hands in that dataset's order, and the cameras."),
     QT_TRANSLATE_NOOP("app::FileActions", "Loaders written for InterHand2.6M (JSON)"),
     QT_TRANSLATE_NOOP("app::FileActions",
                       "The marks themselves, uncertainties and lens distortion; it cannot be imported again"),
     ""},
    {"freihand", QT_TRANSLATE_NOOP("app::FileActions", "FreiHAND, HanCo"),
     QT_TRANSLATE_NOOP("app::FileActions", "21 joints of a hand in metres and the cameras, a file per frame and hand."),
     QT_TRANSLATE_NOOP("app::FileActions", "Loaders written for FreiHAND or HanCo (JSON)"),
     QT_TRANSLATE_NOOP("app::FileActions",
                       "The marks themselves, uncertainties and lens distortion; it cannot be imported again"),
     ""},
    {"csv", QT_TRANSLATE_NOOP("app::FileActions", "Table of 3D joints"),
     QT_TRANSLATE_NOOP("app::FileActions",
                       "A row per 3D joint of every rater: millimetres, uncertainty, error, state."),
     QT_TRANSLATE_NOOP("app::FileActions", "Spreadsheets, R, pandas (CSV)"),
     QT_TRANSLATE_NOOP("app::FileActions", "The marks themselves and the cameras; it cannot be imported again"), "csv"},
    {"csv-marks", QT_TRANSLATE_NOOP("app::FileActions", "Table of marks"),
     QT_TRANSLATE_NOOP("app::FileActions",
                       "A row per mark of every rater: pixel, state, how it was placed; proposals, too."),
     QT_TRANSLATE_NOOP("app::FileActions", "Spreadsheets, R, pandas, and Handlens (CSV)"),
     QT_TRANSLATE_NOOP("app::FileActions", "3D joints and the cameras"), "csv"},
};

constexpr widgets::LocalText translated{"app::FileActions"};

} // namespace

AnnotationFormatText annotationFormatText(std::string_view kind) {
    for (const FormatRow& row : kFormats) {
        if (kind == row.kind)
            return {translated(row.name), translated(row.holds), translated(row.readBy), translated(row.lost),
                    QString::fromLatin1(row.suffix)};
    }
    throw std::out_of_range("no text for annotations of kind " + std::string(kind));
}

QString fileFilter(const core::AnnotationFormat& format) {
    const AnnotationFormatText text = annotationFormatText(format.kind);
    return format.isFolder
               ? translated(QT_TRANSLATE_NOOP("app::FileActions", "%1 \u2013 a new folder (*)")).arg(text.name)
               : QStringLiteral("%1 (*.%2)").arg(text.name, text.suffix);
}

} // namespace app
