// SPDX-License-Identifier: MIT
#include "widgets/jobs/dataset_maker.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "core/error.h"
#include "core/io/calibration/calibration.h"
#include "core/io/dataset/attach_masks.h"
#include "core/io/demo/demo_dataset.h"
#include "widgets/text/footage_text.h"

namespace widgets {

namespace {

std::vector<core::Camera> camerasOf(const NewDatasetRequest& request) {
    core::CalibrationOptions options;
    options.mmPerUnit = request.mmPerUnit;
    try {
        return core::readCalibration(request.calibration, options);
    } catch (const core::Error&) {
        options.size = core::footageSize(request.footage);
        if (!options.size)
            throw;
    }
    return core::readCalibration(request.calibration, options);
}

/// Of the footage of each camera, as recorded; none where there is no footage or it cannot be read, which is said when
/// the dataset is made.
std::vector<std::optional<core::ImageSize>> pictureSizes(const std::vector<core::Camera>& cameras,
                                                         const std::vector<core::Footage>& footage) {
    std::vector<std::optional<core::ImageSize>> sizes(cameras.size());
    for (std::size_t i = 0; i < cameras.size(); ++i)
        for (const core::Footage& one : footage)
            if (one.camera == cameras[i].name)
                sizes[i] = core::footageSize({one});
    return sizes;
}

void takeHands(core::Dataset& dataset, const NewDatasetRequest& request) {
    if (request.demoHands) {
        dataset.hands = core::demoHands();
        dataset.handFiles = {"hands/left.json", "hands/right.json"};
    } else if (!request.handsFrom.empty()) {
        const core::Dataset other = core::readDataset(request.handsFrom);
        if (other.hands.empty())
            throw core::Error(core::ErrorCode::BadInput, request.handsFrom.string(), "hands",
                              "this dataset has no hands");
        dataset.hands = other.hands;
        dataset.handFiles = other.handFiles;
    }
}

/// Finds the camera's name where it is not part of a longer word or number: "cam1" is not in "cam10.mp4".
QRegularExpression nameIn(const QString& camera) {
    const QString before = camera.front().isDigit() ? QStringLiteral("(?<!\\d)") : QStringLiteral("(?<![A-Za-z])");
    const QString after = camera.back().isDigit() ? QStringLiteral("(?!\\d)") : QStringLiteral("(?![A-Za-z])");
    return QRegularExpression(before + QRegularExpression::escape(camera) + after,
                              QRegularExpression::CaseInsensitiveOption);
}

/// The one camera whose name stands there; the longest name if one holds another; empty if it is none or several.
QString cameraIn(QString text, QStringList cameras) {
    std::stable_sort(cameras.begin(), cameras.end(),
                     [](const QString& a, const QString& b) { return a.size() > b.size(); });
    QStringList found;
    for (const QString& camera : cameras) {
        if (camera.isEmpty() || !nameIn(camera).match(text).hasMatch())
            continue;
        found << camera;
        text.replace(nameIn(camera), QStringLiteral("/"));
    }
    return found.size() == 1 ? found.front() : QString();
}

} // namespace

QStringList CalibrationLook::names() const {
    QStringList names;
    for (const core::Camera& camera : cameras)
        names << QString::fromStdString(camera.name);
    return names;
}

DatasetMaker::DatasetMaker(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_job(pool)
    , m_lookJob(pool)
    , m_gatherJob(pool) {
    connect(&m_lookJob, &Job::failed, this, &DatasetMaker::lookFailed);
    connect(&m_gatherJob, &Job::failed, this, &DatasetMaker::failed);
    connect(&m_job, &Job::failed, this, &DatasetMaker::failed);
    for (const auto end : {&Job::finished, &Job::stopped})
        connect(&m_job, end, this, &DatasetMaker::idle);
    connect(&m_job, &Job::failed, this, &DatasetMaker::idle);
}

void DatasetMaker::gather(const QStringList& paths) {
    m_gatherJob.start([this, paths](const JobContext&) -> Job::Delivery {
        const GatheredFootage found = gatherFootage(paths);
        return [this, found] { emit gathered(found); };
    });
}

void DatasetMaker::readCameras(const NewDatasetRequest& request) {
    m_lookJob.start([this, request](const JobContext&) -> Job::Delivery {
        CalibrationLook look;
        look.kind = QString::fromStdString(core::sniffCalibration(request.calibration));
        look.cameras = camerasOf(request);
        look.faults = core::findCameraFaults(look.cameras, pictureSizes(look.cameras, request.footage));
        return [this, look] { emit camerasRead(look); };
    });
}

void DatasetMaker::make(const NewDatasetRequest& request) {
    m_job.start([this, request](const JobContext&) -> Job::Delivery {
        core::Dataset dataset;
        dataset.name = request.folder.filename().string();
        dataset.folder = request.folder;
        takeHands(dataset, request);
        const core::NewSequence made =
            core::makeSequence(request.sequence, camerasOf(request), request.footage, request.folder);
        dataset.cameras = made.cameras;
        dataset.sequences.push_back(made.sequence);
        QStringList notes = footageNotesInWords(made.notes);
        if (!request.masks.empty())
            for (const core::MaskNote& note : core::attachMasks(dataset, request.sequence, request.masks))
                notes << maskNoteInWords(note);
        core::writeDataset(dataset, {}, request.folder);
        return [this, folder = QString::fromStdString(request.folder.string()), notes] {
            emit this->made(folder, notes.join(QLatin1Char('\n')));
        };
    });
}

QStringList matchFootage(const QStringList& cameras, const QStringList& footage) {
    QStringList matches;
    for (const QString& path : footage) {
        const QFileInfo file(path);
        QString camera =
            cameraIn(file.completeBaseName().isEmpty() ? file.fileName() : file.completeBaseName(), cameras);
        if (camera.isEmpty())
            camera = cameraIn(file.dir().dirName(), cameras);
        matches << (matches.contains(camera) ? QString() : camera);
    }
    return matches;
}

} // namespace widgets
