// SPDX-License-Identifier: MIT
#include "widgets/jobs/dataset_maker.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "core/error.h"
#include "core/io/calibration/calibration.h"
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

DatasetMaker::DatasetMaker(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_job(pool) {
    connect(&m_job, &Job::failed, this, &DatasetMaker::failed);
    for (const auto end : {&Job::finished, &Job::stopped})
        connect(&m_job, end, this, &DatasetMaker::idle);
    connect(&m_job, &Job::failed, this, &DatasetMaker::idle);
}

void DatasetMaker::readCameras(const NewDatasetRequest& request) {
    m_job.start([this, request](const JobContext&) -> Job::Delivery {
        QStringList names;
        for (const core::Camera& camera : camerasOf(request))
            names << QString::fromStdString(camera.name);
        return [this, names] { emit camerasRead(names); };
    });
}

void DatasetMaker::make(const NewDatasetRequest& request) {
    m_job.start([this, request](const JobContext&) -> Job::Delivery {
        core::Dataset dataset;
        dataset.name = request.folder.filename().string();
        dataset.cameras = camerasOf(request);
        const core::NewSequence made =
            core::makeSequence(request.sequence, dataset.cameras, request.footage, request.folder);
        dataset.sequences.push_back(made.sequence);
        core::writeDataset(dataset, {}, request.folder);
        return [this, folder = QString::fromStdString(request.folder.string()), notes = made.notes] {
            emit this->made(folder, footageNotesInWords(notes).join(QLatin1Char('\n')));
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
