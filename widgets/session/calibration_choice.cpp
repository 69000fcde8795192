// SPDX-License-Identifier: MIT
#include "widgets/session/calibration_choice.h"

#include "core/io/derived/calibration_files.h"

namespace widgets {

CalibrationChoice::CalibrationChoice(DatasetSession& session, const Selection& selection, JobPool& pool,
                                     QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_selection(selection)
    , m_job(pool)
    , m_listing(pool) {
    for (const Job* job : {&m_job, &m_listing})
        connect(job, &Job::failed, this, &CalibrationChoice::failed);
    connect(&session, &DatasetSession::datasetOpened, this, [this] {
        m_files = QStringList{inUse()};
        emit listed();
    });
}

QString CalibrationChoice::inUse() const {
    return m_session.dataset() ? QString::fromStdString(m_session.dataset()->camerasFile) : QString();
}

void CalibrationChoice::list() {
    if (!m_session.dataset())
        return;
    m_listing.start([this, dataset = m_session.dataset()](const JobContext&) -> Job::Delivery {
        QStringList files;
        for (const std::string& file : core::calibrationFiles(*dataset))
            files << QString::fromStdString(file);
        return [this, dataset, files] {
            if (m_session.dataset() != dataset)
                return;
            m_files = files;
            emit listed();
        };
    });
}

void CalibrationChoice::add(const std::vector<core::Camera>& cameras) {
    change([cameras](const std::filesystem::path& folder) { return core::addCalibration(folder, cameras); });
}

void CalibrationChoice::use(const QString& file) {
    if (file == inUse())
        return;
    change([file = file.toStdString()](const std::filesystem::path& folder) {
        return core::useCalibration(folder, file);
    });
}

void CalibrationChoice::change(std::function<core::Dataset(const std::filesystem::path& folder)> write) {
    const auto open = m_session.dataset();
    if (!open || isRunning())
        return;
    if (m_session.isOpening()) {
        emit failed(tr("Wait until the sequence is open."));
        return;
    }
    m_job.start([this, open, write = std::move(write)](const JobContext&) -> Job::Delivery {
        auto changed = std::make_shared<const core::Dataset>(write(open->folder));
        return [this, open, changed] {
            if (m_session.dataset() != open) // another one was opened meanwhile: this one has changed on disk only
                return;
            m_session.takeCalibration(changed, m_selection.frame());
            list();
            emit used(inUse());
        };
    });
}

} // namespace widgets
