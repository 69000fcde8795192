// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "core/geometry/camera_faults.h"
#include "core/io/dataset/new_sequence.h"
#include "widgets/jobs/footage_gatherer.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// What a dataset is made of.
struct NewDatasetRequest {
    std::filesystem::path calibration;
    std::optional<double> mmPerUnit; ///< of the calibration; empty: what is usual for its kind
    std::vector<core::Footage> footage;
    std::string sequence = "1";
    bool demoHands = false;          ///< the demo's hands are taken
    std::filesystem::path handsFrom; ///< a dataset whose hands are taken; empty: none
    std::string masks;               ///< a folder or a pattern with {camera} and {frame}; empty: none
    std::filesystem::path folder;    ///< of the dataset; does not exist yet, or is empty
};

/// A calibration as it was read, and what is wrong with it.
struct CalibrationLook {
    QString kind; ///< "anipose", as the command line names it
    std::vector<core::Camera> cameras;
    std::vector<core::CameraFault> faults;

    QStringList names() const;
};

/// Makes datasets of a calibration and videos or images, in the background.
class DatasetMaker : public QObject {
    Q_OBJECT

public:
    explicit DatasetMaker(JobPool& pool, QObject* parent = nullptr);

    /// Reads a calibration and looks whether it makes sense, by itself and with the footage; camerasRead() or
    /// lookFailed() follows.
    void readCameras(const NewDatasetRequest& request);
    /// Makes the dataset; made() or failed() follows.
    void make(const NewDatasetRequest& request);
    /// Looks what lies in these files and folders; gathered() follows.
    void gather(const QStringList& paths);
    /// Whether a dataset is being made.
    bool isRunning() const { return m_job.isRunning(); }
    void stop() { m_job.stop(); }

signals:
    void camerasRead(const widgets::CalibrationLook& look);
    /// The calibration cannot be read.
    void lookFailed(const QString& message);
    void gathered(const widgets::GatheredFootage& footage);
    /// `notes` say what a person should know about the footage, one a line.
    void made(const QString& folder, const QString& notes);
    void failed(const QString& message);
    /// The work has ended, well or not; another can begin.
    void idle();

private:
    Job m_job, m_lookJob, m_gatherJob;
};

/// For each piece of footage the camera whose name stands in the file's name or, if there is none, in its folder's;
/// empty if no camera's name does, several do, or another piece of footage has taken it. Case does not matter; a number
/// is matched as a whole.
QStringList matchFootage(const QStringList& cameras, const QStringList& footage);

} // namespace widgets
